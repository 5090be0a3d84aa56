/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** How well two neighbouring quads make a pair. */
#ifndef HEXCON_PAIRING_PAIR_WEIGHTS_H
#define HEXCON_PAIRING_PAIR_WEIGHTS_H

#include "surface/half_edges.h"

/**
 * Weights for surface_pair: 0 for two coplanar quads of one size that make a square, less for
 *  - a fold: the fourth power of the bend in right angles, so a box's edge costs 1 and folds
 *    sharper than that more than a few such edges;
 *  - quads of different size: a quarter of the squared binary logarithm of the ratio of areas;
 *  - an elongated pair: an eighth of the same of its height over its width.
 * Linear.
 * @param s        with points
 * @param weights  [4 * quad_count] receives them, finite, not above 0, equal on twins bit for bit
 */
void surface_pair_weights(const surface *s, double *weights);

#endif
