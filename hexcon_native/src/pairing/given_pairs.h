/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Pairs of quads that the caller chose. */
#ifndef HEXCON_PAIRING_GIVEN_PAIRS_H
#define HEXCON_PAIRING_GIVEN_PAIRS_H

#include "surface/half_edges.h"

/**
 * Find the edges across which given pairs lie; where two quads share several, the lowest half-edge
 * of the first is taken.
 * @param pairs             [pair_count][2] quads
 * @param half_edge_of_quad [quad_count] receives them; -1 for quads of no pair
 * @return BAD_PAIRING with the quads that do not exist, share no edge or are in two pairs. Linear.
 */
hexcon_status surface_read_pairs(hexcon_context *context, const surface *s, const int32_t *pairs,
                                 size_t pair_count, int32_t *half_edge_of_quad);

#endif
