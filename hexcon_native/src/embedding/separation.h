/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** A direction that may separate two sets: a good guess, which others prove. */
#ifndef HEXCON_EMBEDDING_SEPARATION_H
#define HEXCON_EMBEDDING_SEPARATION_H

#include <stdbool.h>

/**
 * Look for a direction in which all vectors go forward: towards the point of their hull that is
 * nearest to the origin. Source: Gilbert, Johnson and Keerthi, A fast procedure for computing the
 * distance between complex objects in three-dimensional space (1988).
 * @param vectors    [count][3], count >= 1
 * @param direction  receives it
 * @return false where the hull holds the origin, as far as rounding can tell
 */
bool separation_direction(const double (*vectors)[3], int count, double direction[3]);

#endif
