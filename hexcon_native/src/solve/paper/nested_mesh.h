/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** A mesh that grows inward from a surface, topology and points together. */
#ifndef HEXCON_SOLVE_PAPER_NESTED_MESH_H
#define HEXCON_SOLVE_PAPER_NESTED_MESH_H

#include "construct/paired_transition.h"
#include "construct/split_front.h"
#include "shape/place/nested_placement.h"
#include "surface/loops.h"
#include "thin_columns.h"

typedef struct nested_mesh {
  growing_mesh grown;
  double *points;        /**< [grown.point_count][3] */
  double *anchor_places; /**< what layers are drawn to: the centre, or without one a row for every
                            point that the surface and the layers have */
  double center[3];      /**< the star centre, or the mean of the points */
  bool star_shaped;      /**< the centre sees the whole surface */
  thin_columns *thin;    /**< the caller's, kept up to date where it is not NULL */
} nested_mesh;

/** Begin with a surface's points. @param out free with nested_mesh_free, also after an error.
 * Expected linear. */
hexcon_status nested_mesh_new(hexcon_context *context, const surface *s, nested_mesh *out);
void nested_mesh_free(hexcon_context *context, nested_mesh *mesh);

/** Lay two hexes on each pair. @param out what then is to be filled; free with paired_quads_free,
 * also after an error */
hexcon_status nested_mesh_pair(hexcon_context *context, const surface *s, const int32_t *partner,
                               nested_mesh *mesh, paired_quads *out);

/** Lay a split layer along every family.
 * @param added  [family_count] receives the hexes of each layer */
hexcon_status nested_mesh_split(hexcon_context *context, split_front *front, split_kind kind,
                                const surface_loops *loops, const int32_t *family_of_loop,
                                size_t family_count, nested_mesh *mesh, size_t *added);

/** Where the points of surface and layers are drawn to; valid until the mesh grows. */
anchors nested_mesh_anchors(const nested_mesh *mesh);

/** Room for the points that `grown` counts. */
hexcon_status nested_mesh_grow_points(hexcon_context *context, nested_mesh *mesh);

/** Pillow what is in the thin columns. */
hexcon_status nested_mesh_pillow(hexcon_context *context, nested_mesh *mesh);

#endif
