/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Pairing of a surface's quads: a perfect matching of neighbours, of high weight. */
#ifndef HEXCON_PAIRING_PAIRING_H
#define HEXCON_PAIRING_PAIRING_H

#include "surface/half_edges.h"

/**
 * Pair every quad with a neighbour across an edge. Two quads may share several edges: half-edges
 * tell which one is meant. Only `quad_count` and `twins` of the surface are read.
 *
 * Greedy by weight, then augmenting paths until all quads are paired, then alternating cycles of
 * positive gain, found by a bounded search, until there are none: close to the greatest total
 * weight, not always there. Near-linear in practice. Deterministic.
 *
 * A surface as surface_build makes it has a pairing wherever every component is even: an edge cut
 * of its dual graph is a set of closed edge cycles, of 4 edges at least (no two edges have the same
 * ends, and in a graph where all degrees are even all cuts are even); so a set of k quads, which
 * has 4 k edges at most to the rest, leaves at most k odd parts: Tutte's condition.
 *
 * @param weights            [4 * quad_count] of every half-edge, finite, equal on twins; NULL: all
 *                           are equal
 * @param half_edge_of_quad  [quad_count] receives the half-edge across which the partner lies
 * @return ODD, NO_PAIRING with the quads left over, OUT_OF_MEMORY, CANCELLED
 */
hexcon_status surface_pair(hexcon_context *context, const surface *s, const double *weights,
                           int32_t *half_edge_of_quad);

/**
 * As surface_pair without weights, but only quads that share one edge are paired, wherever that is
 * possible at all. Cost: as surface_pair, at most twice.
 */
hexcon_status surface_pair_across_single_edges(hexcon_context *context, const surface *s,
                                               int32_t *half_edge_of_quad);

#endif
