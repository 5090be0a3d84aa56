/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Boxes of a hex's local coordinates [0, 1]^3, halved along the first, second, third direction in
 * turn, and the coefficients of 8-node hexes on them: of degree 2 in each direction, at
 * 9 i + 3 j + k. */
#ifndef HEXCON_VERIFY_BOX_PLACE_H
#define HEXCON_VERIFY_BOX_PLACE_H

typedef struct box_place {
  double low[3]; /**< the lowest corner: dyadic, hence exact */
  int depth;     /**< how often halved */
} box_place;

/** How far apart coefficients are along each direction. */
static const int box_strides[3] = {9, 3, 1};

/** The coefficients that are values at the corners. */
static const int box_corners[8] = {0, 2, 6, 8, 18, 20, 24, 26};

/** The direction in which the box is halved next. */
int box_axis(const box_place *place);

/** Halve; `low` may be the place itself. */
void box_halve(const box_place *place, box_place *low, box_place *high);

/** Local coordinates of a corner. @param corner 0 .. 7, as in box_corners: the third direction
 * runs fastest */
void box_corner_point(const box_place *place, int corner, double point[3]);

#endif
