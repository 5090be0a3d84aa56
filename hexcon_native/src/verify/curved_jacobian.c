/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "curved_jacobian.h"

#include <math.h>
#include <stdbool.h>

#include "curved_box.h"
#include "curved_jacobian_exact.h"
#include "serendipity.h"

enum {
  MAX_DEPTH = 24,     /* bisections along the deepest path: boxes of 1/256 of the hex */
  MAX_BOXES = 1 << 13 /* in all; only a Jacobian that all but vanishes on a surface needs more */
};

/** Corner coefficients are values of the Jacobian. @param corner receives which is the smallest */
static double smallest_corner(const curved_box *box, int *corner) {
  *corner = 0;
  for (int i = 1; i < 8; i++)
    if (box->value[serendipity_corners[i]] < box->value[serendipity_corners[*corner]])
      *corner = i;
  return box->value[serendipity_corners[*corner]];
}

/** Depth-first over boxes; the stack holds one sibling per level. Once some point is undecided,
 * only boxes that may hold a negative value are looked at. */
static jacobian_sign prove_by_bisection(curved_box *stack, double witness[3]) {
  int top = 1;
  bool undecided = false;
  for (int boxes = 0; top > 0; boxes++) {
    curved_box *box = &stack[top - 1];
    double largest, smallest = curved_box_smallest(box, &largest);
    int lowest;
    double corner = smallest_corner(box, &lowest);
    if (corner < -box->error) {
      box_corner_point(&box->place, lowest, witness);
      return JACOBIAN_NONPOSITIVE;
    }
    if (boxes == MAX_BOXES)
      return JACOBIAN_UNDECIDED;
    bool positive = smallest > box->error, deepest = box->place.depth == MAX_DEPTH;
    undecided |= !positive && (corner <= box->error || deepest);
    if (positive || deepest || (undecided && smallest >= -box->error)) {
      top--;
    } else {
      curved_box_bisect(box, largest, box + 1);
      top++;
    }
  }
  return undecided ? JACOBIAN_UNDECIDED : JACOBIAN_POSITIVE;
}

size_t curved_jacobian_room(void) {
  size_t filter = (MAX_DEPTH + 2) * sizeof(curved_box), exact = exact_curved_room();
  return filter > exact ? filter : exact;
}

/** At the hex's corners alone: POSITIVE there, NONPOSITIVE with a witness, or open. */
static jacobian_sign prove_corners(double nodes[20][3], double at[27][3], double witness[3]) {
  static const box_place whole = {{0, 0, 0}, 0};
  double values[8], error;
  curved_corner_values(at, values, &error);
  unsigned open = 0;
  for (int corner = 0; corner < 8; corner++) {
    if (values[corner] < -error) {
      box_corner_point(&whole, corner, witness);
      return JACOBIAN_NONPOSITIVE;
    }
    open |= (unsigned)!(values[corner] > error) << corner;
  }
  if (open == 0)
    return JACOBIAN_POSITIVE;
  int corner = nonpositive_curved_corner(nodes, open);
  if (corner < 0)
    return JACOBIAN_UNDECIDED;
  box_corner_point(&whole, corner, witness);
  return JACOBIAN_NONPOSITIVE;
}

jacobian_sign prove_curved_jacobian_sign(double nodes[20][3], void *room, double witness[3]) {
  curved_box *stack = room;
  witness[0] = witness[1] = witness[2] = NAN;
  jacobian_sign sign = JACOBIAN_UNDECIDED;
  double at[27][3], scale[3];
  if (curved_nodes_place(nodes, at, scale)) {
    if (prove_corners(nodes, at, witness) == JACOBIAN_NONPOSITIVE)
      return JACOBIAN_NONPOSITIVE;
    curved_box_make(at, stack);
    sign = prove_by_bisection(stack, witness);
  }
  return sign == JACOBIAN_UNDECIDED ? prove_curved_jacobian_exactly(nodes, room, witness) : sign;
}
