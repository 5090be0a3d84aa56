/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Affine maps between rims. */
#ifndef HEXCON_SHAPE_PLACE_AFFINE_FIT_H
#define HEXCON_SHAPE_PLACE_AFFINE_FIT_H

#include <stddef.h>
#include <stdint.h>

/** A rim at one level, as its affine fit sees it. */
typedef struct rim_pose {
  double center[3]; /**< mean of the rim points */
  double normal[3]; /**< along the rim's vector area, as long as its square root */
} rim_pose;

/** x -> target center + matrix (x - source center). */
typedef struct affine_map {
  double matrix[3][3], source[3], target[3];
} affine_map;

/**
 * @param rim    [count] cap points on the rim
 * @param edges  [edge_count][2] cap points, the rim's edges in the direction of the cap's quads
 * @param ids    rows of points by cap point
 */
rim_pose rim_measure(const double *points, const int32_t *ids, const int32_t *rim, size_t count,
                     const int32_t *edges, size_t edge_count);

/** Least-squares fit of the rim points and, so that a flat rim leaves no freedom, of the normal. */
affine_map affine_fit(const double *points, const int32_t *from, const rim_pose *from_pose,
                      const int32_t *to, const rim_pose *to_pose, const int32_t *rim, size_t count);

void affine_apply(const affine_map *map, const double in[3], double out[3]);

#endif
