/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Few pairs that remove a surface's self-crossings. */
#ifndef HEXCON_PAIRING_PAIR_CROSSINGS_H
#define HEXCON_PAIRING_PAIR_CROSSINGS_H

#include "surface/half_edges.h"

/**
 * Few pairs of neighbours after whose transition no loop crosses itself; none where no loop does.
 *
 * All quads paired always do (Carbonera and Shepherd, theorem 2): from there, and on surfaces of up
 * to some thousand quads from no pairs too, simulated annealing makes and breaks pairs; what it
 * finds is never worse than all quads paired. Nothing says that there are not fewer. Deterministic.
 * Cost: a fixed amount of walking along loops, quadratic in quad_count up to 150 quads, constant up
 * to 4000, about linear beyond 10^6: some seconds, a minute for 8 * 10^5. Memory linear.
 *
 * @param half_edge_of_quad  [quad_count] receives the half-edge across which the partner lies, -1
 *                           of quads that have none; two quads may share several edges
 * @return where some loop crosses itself the errors of surface_pair; OUT_OF_MEMORY, CANCELLED
 */
hexcon_status surface_pair_crossings(hexcon_context *context, const surface *s,
                                     int32_t *half_edge_of_quad, size_t *pair_count);

#endif
