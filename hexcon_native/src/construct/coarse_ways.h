/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** All ways to read a surface as a subdivision, shell by shell. */
#ifndef HEXCON_CONSTRUCT_COARSE_WAYS_H
#define HEXCON_CONSTRUCT_COARSE_WAYS_H

#include "coarse_surface.h"

typedef struct coarse_ways {
  size_t count;       /**< at most COARSE_WAYS */
  uint8_t *of_shells; /**< [count][component_count] as coarse_surface_read takes them */
} coarse_ways;

/**
 * All ways to read a surface, the best first: those of triangles only, which take the fewest hexes,
 * then those whose middles and centres lie straightest. Several shells are read each in its own
 * best way, then each in its next best, as far as it has one.
 * @param out  free with coarse_ways_free, also after an error
 * Errors: as coarse_surface_read where a shell has none, with the faults of its way that has the
 * fewest. Linear, four times.
 */
hexcon_status coarse_ways_find(hexcon_context *context, const surface *s, coarse_ways *out);
void coarse_ways_free(hexcon_context *context, coarse_ways *ways);

#endif
