/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** What the exact proofs of 8-node and of 20-node hexes share: vectors, scaling, bisection. */
#ifndef HEXCON_VERIFY_EXACT_BISECTION_H
#define HEXCON_VERIFY_EXACT_BISECTION_H

#include <stdbool.h>
#include <stddef.h>

#include "base/expansion.h"
#include "box_place.h"
#include "jacobian_verdict.h"

typedef struct exact_vector {
  expansion x[3];
} exact_vector;

/** Add the scalar product of two vectors to a sum. */
void exact_add_dot(const exact_vector *a, const exact_vector *b, expansion *sum);

/** Add the cross product of two vectors to a sum. */
void exact_add_cross(const exact_vector *a, const exact_vector *b, exact_vector *sum);

/** Multiply each coordinate of a hex's nodes, in place, by a power of two of its own that brings
 * the largest difference near 1, which leaves the sign of the Jacobian.
 * @return whether that is exact: not where a coordinate becomes subnormal */
bool exact_scale(double (*nodes)[3], size_t count);

/** Boxes not yet decided, the next one last; the first is the whole hex at the start. */
typedef struct exact_boxes {
  expansion *values;       /**< [open * coefficients] those of each box */
  box_place *places;       /**< [open] */
  int coefficients;        /**< of a box */
  const int *corners;      /**< [8] which are values at corners, in the order of box_corners */
  int open, deepest, most; /**< boxes that fit; bisections along a path; boxes in all */
  /** Of a box make two: the second is looked at first. */
  void (*halve)(expansion *values, box_place *place, expansion *second, box_place *second_place);
} exact_boxes;

/** The sign of a Jacobian from its Bernstein coefficients. @param witness  where it is not
 * positive, if that is proved */
jacobian_sign prove_by_bisection(exact_boxes *boxes, double witness[3]);

#endif
