/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Breadth-first search over the classes of three-connected quadrangulations that flips reach. */
#ifndef TEMPLATE_SEARCH_CLASSES_H
#define TEMPLATE_SEARCH_CLASSES_H

#include <stddef.h>

#include "sphere.h"

/**
 * Without regard to history: meshes found so are conforming, not proper.
 * @param counts  [MOST_QUADS + 1], receives the number of classes by quads
 * @param hexes   [MOST_QUADS + 1], receives the most hexes that a class with so many quads takes
 */
void count_classes(int most_quads, size_t counts[MOST_QUADS + 1], int hexes[MOST_QUADS + 1]);

#endif
