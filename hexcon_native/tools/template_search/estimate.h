/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** How many hexes a cavity will take: a linear guess learned from a table of balls. */
#ifndef TEMPLATE_SEARCH_ESTIMATE_H
#define TEMPLATE_SEARCH_ESTIMATE_H

#include "table.h"

enum { FEATURES = 5 };

typedef struct estimate {
  double weights[FEATURES];
} estimate;

/** Least squares over a sample of the entries. */
void estimate_learn(const table *t, estimate *e);

/** @param needed  by dart: edges that need two hexes or more from the filling */
double estimate_hexes(const estimate *e, const sphere *s, const bool *needed);

#endif
