/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The Jacobian of a hex of 20 nodes on a box of its local coordinates, in Bernstein coefficients.
 */
#ifndef HEXCON_VERIFY_CURVED_BOX_H
#define HEXCON_VERIFY_CURVED_BOX_H

#include <stdbool.h>

#include "box_place.h"

enum { CURVED_COEFFICIENTS = 216 };

/** Coefficients of degree 5 in each direction, at 36 i + 6 j + k, and a bound on the absolute error
 * of any of them. */
typedef struct curved_box {
  double value[CURVED_COEFFICIENTS];
  double error;
  box_place place;
} curved_box;

/**
 * The whole hex: 1000 times the determinant of half the derivatives, of the map whose coordinates
 * are scaled.
 * @param nodes  [20][3], VTK_QUADRATIC_HEXAHEDRON order
 * @param at     receives the scaled map's control points, see serendipity.h
 * @param scale  receives what each coordinate is multiplied by, powers of two
 * @return false where differences of coordinates overflow or are no numbers
 */
bool curved_box_make(double nodes[20][3], curved_box *whole, double at[27][3], double scale[3]);

/** The smallest coefficient. @param largest  receives the largest absolute value */
double curved_box_smallest(const curved_box *box, double *largest);

/** Halve along box_axis: the upper half stays in place. @param largest  as of curved_box_smallest
 */
void curved_box_bisect(curved_box *box, double largest, curved_box *low);

#endif
