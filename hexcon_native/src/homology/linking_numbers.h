/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** How often a surface's cycles wind round those just outside it, modulo 2. */
#ifndef HEXCON_HOMOLOGY_LINKING_NUMBERS_H
#define HEXCON_HOMOLOGY_LINKING_NUMBERS_H

#include "bit_matrix.h"
#include "handle_cycles.h"

/**
 * Row i, column j: the linking number modulo 2 of cycle i with ring j pushed a little out of the
 * solid. Seen along some direction, it is how often the ring passes over the cycle.
 *
 * Every closed curve outside is homologous to a sum of such rings (Mayer-Vietoris), and a cycle
 * bounds inside if and only if it links none of them (Alexander duality); likewise with rings
 * pushed inward and cycles that bound outside. As ring j meets cycle i on the surface if and only
 * if i = j, pushing inward gives the same matrix plus the unit matrix. So the matrix is a
 * projection: it keeps what bounds outside and takes what bounds inside to zero, and has half its
 * size as its rank. Both are checked, which finds curves that were misjudged and some surfaces
 * that cross themselves.
 *
 * @param s      with points, turned outward; taken as flat over triangles from the middle of each
 *               quad to its edges
 * @param known  false if it could not be told: curves that touch as far as rounding can tell in all
 *               directions tried, a surface that was found to cross itself, or more work than
 *               LINKING_MOST_BOXES and LINKING_MOST_CYCLES; `out` is then empty
 * @param out    free with bit_matrix_free, also after an error
 * Cost: pairs of pieces of 32 edges, one of a cycle and one of a ring, and of edges where their
 * boxes overlap: near-linear in the quads for a given genus, quadratic in the genus.
 * @return OUT_OF_MEMORY, CANCELLED, OUT_OF_TIME
 */
hexcon_status linking_numbers_find(hexcon_context *context, const surface *s,
                                   const handle_cycles *cycles, bit_matrix *out, bool *known);

/**
 * handle_cycles_find, then linking_numbers_find of these.
 * @param cycles   free with handle_cycles_free, also after an error
 * @param linking  free with bit_matrix_free, also after an error
 * @param known    false if either could not be told
 * @return OUT_OF_MEMORY, CANCELLED, OUT_OF_TIME
 */
hexcon_status linked_cycles_find(hexcon_context *context, const surface *s, handle_cycles *cycles,
                                 bit_matrix *linking, bool *known);

#define LINKING_MOST_BOXES 2e10
#define LINKING_MOST_CYCLES ((size_t)4096)

#endif
