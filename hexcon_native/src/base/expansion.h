/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * Exact sums and products of doubles, as expansions: sums of non-overlapping doubles.
 * Source: Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric
 * predicates (1997), sections 2.3 to 2.5 and 2.8.
 */
#ifndef HEXCON_BASE_EXPANSION_H
#define HEXCON_BASE_EXPANSION_H

#include <stdbool.h>

enum { EXPANSION_TERMS = 24 };

/**
 * The value is the sum of the terms, smallest first, none of them zero. `lost` tells that it was
 * too wide for EXPANSION_TERMS, or that a product underflowed: then the value is not exact, and
 * neither is what is computed from it.
 */
typedef struct expansion {
  int count;
  bool lost;
  double terms[EXPANSION_TERMS];
} expansion;

expansion expansion_difference(double a, double b);
expansion expansion_sum(const expansion *a, const expansion *b);
expansion expansion_product(const expansion *a, const expansion *b);
/** Times a power of two. */
expansion expansion_scaled(const expansion *a, double power_of_two);
/** -1, 0 or 1: the sign of the last, largest term. Meaningless if lost. */
int expansion_sign(const expansion *a);

#endif
