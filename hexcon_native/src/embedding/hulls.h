/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Proofs that hulls of a few points are apart, or that vectors all go forward. */
#ifndef HEXCON_EMBEDDING_HULLS_H
#define HEXCON_EMBEDDING_HULLS_H

#include <stdbool.h>

#include "ball.h"

enum { HULL_MOST = 9 /* points of a hull */, HULL_PAIRS = 2, FORWARD_MOST = 16 /* vectors */ };

/** The hulls of the points a[count_a] and b[count_b]. */
typedef struct hull_pair {
  ball (*a)[3], (*b)[3];
  int count_a, count_b;
} hull_pair;

/** Their boxes along the axes are apart. */
bool boxes_part(const hull_pair *hulls);

/** Planes part the hulls of each pair: all with one normal, a below and b above. */
bool plane_parts(const hull_pair *pairs, int pair_count);

/** Along some direction every vector goes forward: no sum of multiples of them, none negative and
 * not all zero, vanishes. */
bool all_forward(ball (*vectors)[3], int count);

#endif
