/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Closed paths of an odd number of edges that bound a surface inside the solid. */
#ifndef HEXCON_HOMOLOGY_ODD_CYCLES_H
#define HEXCON_HOMOLOGY_ODD_CYCLES_H

#include "surface/half_edges.h"

/** Closed paths that together bound inside and have an odd number of edges in all. */
typedef struct odd_cycles {
  hexcon_fillable fillable; /**< NO: there are such paths */
  size_t path_count;        /**< NO: mostly one */
  size_t point_count;
  int32_t *points; /**< those of the first path in order, then those of the next */
} odd_cycles;

/**
 * Whether a hex mesh with this surface for its boundary exists, as a complex: a surface with an
 * even number of quads round each body has one if and only if no closed path, or sum of several,
 * bounds inside and is odd. Source: Erickson, Efficiently hex-meshing things with topology (2014).
 * Where the points can be 2-coloured along edges there is none. Else the cycles that bound are
 * found by linking numbers.
 * @param s    with points, turned outward; one that does not cross itself
 * @param out  filled; free with odd_cycles_free, also after an error
 * Cost: linear if 2-coloured, as on spheres; else that of handle_cycles_find and
 * linking_numbers_find. UNKNOWN where those leave it open.
 * @return OUT_OF_MEMORY, CANCELLED, OUT_OF_TIME
 */
hexcon_status odd_cycles_find(hexcon_context *context, const surface *s, odd_cycles *out);
void odd_cycles_free(hexcon_context *context, odd_cycles *found);

#endif
