/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * Canonical codes of quadrangulations of the sphere: equal for isomorphic ones, mirror images
 * included.
 *
 * A walk from a dart, in one of the two senses, numbers all vertices in the order in which it meets
 * them and writes down the neighbours of each: the code. The least code of all walks is canonical;
 * the walks that give it differ by the automorphisms.
 */
#ifndef TEMPLATE_SEARCH_CANONICAL_H
#define TEMPLATE_SEARCH_CANONICAL_H

#include "sphere.h"

enum { MOST_EDGES = 2 * MOST_QUADS };

/** Where a walk begins: twice the dart, plus one if mirrored. */
typedef uint16_t walk_start;

typedef struct canonical {
  uint64_t key; /**< of the code: 64 bits, so different classes hardly ever have equal ones */
  int start_count;
  walk_start starts[2 * MOST_DARTS]; /**< all walks that give the canonical code */
} canonical;

void canonical_find(const sphere *s, canonical *c);

/** What a walk finds. */
typedef struct walk {
  uint8_t number[MOST_VERTICES]; /**< of each vertex */
  uint8_t edges[MOST_EDGES];     /**< a dart of each edge, in the order of the walk */
} walk;

void walk_from(const sphere *s, walk_start start, walk *w);

/** Marks of darts as bits, in the order of a walk. */
uint64_t walk_marks(const sphere *s, const walk *w, const bool marked[MOST_DARTS]);

#endif
