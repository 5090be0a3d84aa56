/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * A surface numbered by its shape alone, so that what is made of it does not depend on how the
 * caller numbered it.
 */
#ifndef HEXCON_SURFACE_NUMBERING_H
#define HEXCON_SURFACE_NUMBERING_H

#include "half_edges.h"

/** The caller's ids of what a canonical surface numbers anew. */
typedef struct numbering {
  size_t point_count, quad_count;
  const double *given_points; /**< [point_count][3] the caller's */
  int32_t *given_quads; /**< [quad_count][4] in the caller's numbering and order, turned outward */
  int32_t *points;      /**< [point_count] the caller's id of each point */
  int32_t *quads;       /**< [quad_count] the caller's id of each quad */
  int32_t *quad_ranks;  /**< [quad_count] the canonical id of each of the caller's quads */
} numbering;

/**
 * Number a surface anew: points along a Morton curve through their bounding box, then by their
 * coordinates; quads by their corners, each from its lowest corner on; components by their first
 * quad. Neighbours get ids that lie near each other. The same for every numbering of a surface, as
 * long as no two of its points coincide: those keep the caller's order.
 * @param given      with points; its quads are taken from it, the rest may be freed
 * @param canonical  filled; its `names` is `out`; free with surface_free and then numbering_free,
 *                   also after an error. Its points are its own
 * Errors: OUT_OF_MEMORY, CANCELLED, OUT_OF_TIME. Cost: linear, but for the points that fall in one
 * cell of 2^21 a side: their count times its logarithm.
 * Source: Morton, A computer oriented geodetic data base (1966).
 */
hexcon_status numbering_new(hexcon_context *context, surface *given, numbering *out,
                            surface *canonical);
void numbering_free(hexcon_context *context, numbering *names, surface *canonical);

/** The caller's id of a quad, for words. */
int32_t numbering_quad_name(const surface *s, int32_t quad);

/** Turn ids of canonical points into the caller's; ids from point_count on stay. */
void numbering_name_points(const numbering *names, int32_t *ids, size_t count);

/** Turn the offending ids of an error, as far as they are points or quads of the surface, into the
 * caller's: paths and pairs in their order, sets of quads ascending. */
void numbering_name_elements(hexcon_context *context, const numbering *names, hexcon_status status);

/** @param ranks  [point_count] receives the canonical ids of the caller's points */
void numbering_rank_points(const numbering *names, int32_t *ranks);

/** [count] the canonical ids of the caller's quads; ids that do not exist stay. */
void numbering_rank_quads(const numbering *names, const int32_t *ids, size_t count, int32_t *ranks);

#endif
