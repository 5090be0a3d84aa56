/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Placement of inner points after a model: a mesh of the same hexes elsewhere. */
#ifndef HEXCON_SHAPE_PLACE_MODEL_PLACEMENT_H
#define HEXCON_SHAPE_PLACE_MODEL_PLACEMENT_H

#include "base/context.h"

/** Hexes whose first points are on the boundary and known. */
typedef struct placed_mesh {
  size_t boundary_count, point_count, hex_count;
  const int32_t *hexes; /**< [hex_count][8] */
  double *points;       /**< [point_count][3] the first boundary_count are given */
} placed_mesh;

/**
 * Put the inner points where the affine map that fits the boundaries best takes the model's.
 * Linear.
 * @param model  [point_count][3]
 */
void model_placement_affine(const placed_mesh *m, const double *model);

/**
 * How well a model suits a boundary: the mean square distance of its points from where such a map
 * takes the model's. Linear.
 * @param points, model  [count][3]
 */
double model_placement_misfit(const double *points, size_t count, const double *model);

/**
 * Take a valid model to the boundary: its affine image, and then a homotopy, valid all the way.
 * @param arrived  receives whether it went all the way; the inner points are as far as it went
 * @return OUT_OF_MEMORY, CANCELLED. Cost: that of untangling the mesh as a whole, per step.
 */
hexcon_status model_placement_homotopy(hexcon_context *context, const placed_mesh *m,
                                       const double *model, bool *arrived);

/** Put the inner points in the mean of their neighbours along edges, starting from the mean of the
 * boundary: Gauss-Seidel, a fixed number of sweeps. For small meshes: quadratic. */
void mean_placement(const placed_mesh *m);

#endif
