/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The start of a pairing: heaviest edges first. */
#ifndef HEXCON_PAIRING_PAIR_GREEDY_H
#define HEXCON_PAIRING_PAIR_GREEDY_H

#include "pair_state.h"

/**
 * Pair quads across edges in order of descending weight, of equal ones the lowest half-edge first,
 * wherever both are free. Linear: an edge that is the first at both its quads can be taken at once,
 * whatever goes on elsewhere.
 * Source: Preis, Linear time 1/2-approximation algorithm for maximum weighted matching in general
 * graphs (1999), in the form of Manne and Bisseling (2007).
 * @return OUT_OF_MEMORY, CANCELLED
 */
hexcon_status pair_greedily(pair_state *p);

#endif
