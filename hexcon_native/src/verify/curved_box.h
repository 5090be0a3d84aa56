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
 * Nodes from the first corner, each coordinate scaled by a power of two of its own so that the
 * largest is in [1/2, 1).
 * @param nodes  [20][3], VTK_QUADRATIC_HEXAHEDRON order
 * @param at     receives them at their control points' places, see serendipity.h; others are left
 * @param scale  receives what each coordinate is multiplied by, powers of two
 * @return false where differences of coordinates overflow or are no numbers
 */
bool curved_nodes_place(double nodes[20][3], double at[27][3], double scale[3]);

/** The Jacobian of placed nodes at the hex's corners, in the order of box_corners, as of
 * curved_box_make. @param error  receives a bound on the absolute error of any */
void curved_corner_values(double at[27][3], double values[8], double *error);

/**
 * The whole hex: 1000 times the determinant of half the derivatives, of the scaled map.
 * @param at  placed nodes; becomes the map's control points
 */
void curved_box_make(double at[27][3], curved_box *whole);

/** Half the derivative along `axis` of the map of control points, coefficients times their
 * binomials, component by component: [c][n] with n counting degrees (1, 2, 2), (2, 1, 2) or
 * (2, 2, 1), the third direction fastest.
 * @return the largest entry, without binomials */
double curved_derive(double at[27][3], int axis, double out[3][18]);

/** The smallest coefficient. @param largest  receives the largest absolute value */
double curved_box_smallest(const curved_box *box, double *largest);

/** Halve along box_axis: the upper half stays in place. @param largest  as of curved_box_smallest
 */
void curved_box_bisect(curved_box *box, double largest, curved_box *low);

#endif
