/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The boundary to be filled, from a template file, and which fillings it takes. */
#ifndef TEMPLATE_SEARCH_TARGET_H
#define TEMPLATE_SEARCH_TARGET_H

#include "ball.h"

enum { MOST_TARGET_POINTS = MOST_QUADS + 2 };

typedef enum edge_sort { NO_EDGE, SHARP_EDGE, FLAT_EDGE } edge_sort;

typedef struct target {
  int point_count, quad_count;
  double points[MOST_TARGET_POINTS][3];
  uint8_t quads[MOST_QUADS][4]; /**< outward */
  /** Flat: its quads make an angle of 180 degrees or more inside, and no hex may have both. */
  uint8_t edges[MOST_TARGET_POINTS][MOST_TARGET_POINTS];
} target;

/** Read the lines `v` (without `int`) and `q` of a template file, or stop. */
void target_read(target *t, const char *path);

/** The empty ball inside: its surface faces inward, towards the hexes that will come. */
void target_cavity(const target *t, ball *cavity);

/** Could this hex be positive, as far as its points on the boundary tell? */
bool target_allows(const target *t, const uint8_t hex[8]);

/**
 * Is this a proper filling: boundary exact, every face in at most two hexes, Euler characteristic
 * 1, any two hexes meeting properly, at least three hexes at each inner edge and two at flat ones?
 */
bool target_filled(const target *t, const uint8_t (*hexes)[8], int count);

#endif
