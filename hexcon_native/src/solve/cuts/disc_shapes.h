/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Which grid of quads suits the angles of a rim? */
#ifndef HEXCON_SOLVE_CUTS_DISC_SHAPES_H
#define HEXCON_SOLVE_CUTS_DISC_SHAPES_H

#include "construct/disc_pattern.h"
#include "surface/half_edges.h"

/** Shapes that are looked at closely for one ring. */
enum { DISC_SHAPES_MOST = 3 };

/**
 * The grids whose four corners lie where both rails of a ring turn by a right angle and which are
 * straight elsewhere, as far as there are such; then one with a ring of quads around, for rails
 * that turn everywhere alike. The best of each first; among equals the squarest.
 * @param ring    [length] entries; length even and at least 4
 * @param shapes  [DISC_SHAPES_MOST] @param count  receives their number
 * Errors: OUT_OF_MEMORY, CANCELLED, OUT_OF_TIME. Cost: quadratic in the ring.
 */
hexcon_status disc_shapes_find(hexcon_context *context, const surface *s, const int32_t *ring,
                               size_t length, disc_shape *shapes, size_t *count);

#endif
