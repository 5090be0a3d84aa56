/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** From fillings of some boundaries to fillings of others: as balls that a table grows from. */
#ifndef TEMPLATE_SEARCH_SPREAD_H
#define TEMPLATE_SEARCH_SPREAD_H

#include "beam.h"

/** A filling as a ball: its boundary is what is met by one hex only, its marks are counted.
 * @return false unless that is a three-connected sphere of at most MOST_QUADS quads */
bool ball_of_filling(const filling *f, ball *b);

/** Up to `keep` fillings of every class with few quads, fewest hexes first. */
void visit_smallest(const table *t, int most_quads, int keep, filling_visitor visit, void *user);

#endif
