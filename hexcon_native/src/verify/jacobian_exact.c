/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "jacobian_exact.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "base/expansion.h"
#include "box_place.h"
#include "hexmesh/hex_tables.h"

enum {
  MAX_DEPTH = 96,  /* bisections along the deepest path: coefficients within 2^-64 of the values */
  MAX_OPEN = 20,   /* boxes not yet decided; some 100 kB */
  MAX_BOXES = 2048 /* in all */
};

typedef struct exact_vector {
  expansion x[3];
} exact_vector;

/** Bernstein coefficients of degree 2 in each direction, at 9 i + 3 j + k. */
typedef struct exact_box {
  expansion value[27];
  box_place place;
} exact_box;

/** A power of two that brings the largest difference of a coordinate near 1; halves first, as the
 * difference itself may overflow. */
static double choose_scale(const double *points, const int32_t *hex, int coordinate) {
  double lowest = INFINITY, highest = -INFINITY;
  for (int c = 0; c < 8; c++) {
    double half = points[3 * (size_t)hex[c] + (size_t)coordinate] / 2;
    lowest = fmin(lowest, half);
    highest = fmax(highest, half);
  }
  int exponent = 0; /* frexp leaves it if there is infinity or no number */
  (void)frexp(highest - lowest, &exponent);
  return ldexp(1, exponent < -1000 ? 1000 : -1 - exponent);
}

/** Each coordinate times a power of two of its own, which leaves the sign of the Jacobian. Returns
 * whether that is exact: not where a coordinate becomes subnormal. */
static bool scale_corners(const double *points, const int32_t *hex, double corners[8][3]) {
  bool exact = true;
  for (int i = 0; i < 3; i++) {
    double scale = choose_scale(points, hex, i);
    for (int c = 0; c < 8; c++) {
      double coordinate = points[3 * (size_t)hex[c] + (size_t)i], scaled = coordinate * scale;
      exact &= isfinite(scaled) && (coordinate == 0 || fabs(scaled) >= DBL_MIN);
      corners[hex_corner_bits[c]][i] = scaled;
    }
  }
  return exact;
}

/** The edge along `axis` whose place across it is given by the bits of m, lower axis first. */
static void exact_edge(double corners[8][3], int axis, int m, exact_vector *edge) {
  int low = axis == 0 ? 1 : 0, high = axis == 2 ? 1 : 2;
  int start = ((m & 1) << low) | ((m >> 1) << high);
  for (int i = 0; i < 3; i++)
    edge->x[i] = expansion_difference(corners[start | (1 << axis)][i], corners[start][i]);
}

static void exact_cross(const exact_vector *a, const exact_vector *b, exact_vector *out) {
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    expansion plus = expansion_product(&a->x[j], &b->x[k]);
    expansion minus = expansion_product(&a->x[k], &b->x[j]);
    minus = expansion_scaled(&minus, -1);
    out->x[i] = expansion_sum(&plus, &minus);
  }
}

static void add_dot(const exact_vector *a, const exact_vector *b, expansion *sum) {
  for (int i = 0; i < 3; i++) {
    expansion product = expansion_product(&a->x[i], &b->x[i]);
    *sum = expansion_sum(sum, &product);
  }
}

/** The sum of jacobian_sign.c's sum_coefficients, exactly. */
static void exact_coefficients(double corners[8][3], exact_box *box) {
  exact_vector along[4], b_edge, c_edge, cross;
  memset(box, 0, sizeof *box);
  for (int a = 0; a < 4; a++)
    exact_edge(corners, 0, a, &along[a]);
  for (int b = 0; b < 4; b++)
    for (int c = 0; c < 4; c++) {
      exact_edge(corners, 1, b, &b_edge);
      exact_edge(corners, 2, c, &c_edge);
      exact_cross(&b_edge, &c_edge, &cross);
      for (int a = 0; a < 4; a++)
        add_dot(
            &along[a], &cross,
            &box->value[9 * ((b & 1) + (c & 1)) + 3 * ((a & 1) + (c >> 1)) + (a >> 1) + (b >> 1)]);
    }
  for (int i = 0; i < 27; i++) {
    int middles = (i / 9 == 1) + (i / 3 % 3 == 1) + (i % 3 == 1);
    box->value[i] = expansion_scaled(&box->value[i], ldexp(1, -middles));
  }
}

static bool is_lost(const exact_box *box) {
  bool lost = false;
  for (int i = 0; i < 27; i++)
    lost |= box->value[i].lost;
  return lost;
}

static bool all_positive(const exact_box *box) {
  for (int i = 0; i < 27; i++)
    if (expansion_sign(&box->value[i]) <= 0)
      return false;
  return true;
}

/** A corner that is not positive, by its place in box_corners; -1 if there is none. */
static int nonpositive_corner(const exact_box *box) {
  for (int i = 0; i < 8; i++)
    if (expansion_sign(&box->value[box_corners[i]]) <= 0)
      return i;
  return -1;
}

static expansion average(const expansion *a, const expansion *b) {
  expansion sum = expansion_sum(a, b);
  return expansion_scaled(&sum, 0.5);
}

/** de Casteljau at 1/2 along one axis; `low` may be the box itself. */
static void bisect(const exact_box *box, exact_box *low, exact_box *high) {
  int axis = box_axis(&box->place), stride = box_strides[axis],
      across = box_strides[(axis + 1) % 3], along = box_strides[(axis + 2) % 3];
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) {
      int at = i * across + j * along;
      expansion left = box->value[at], middle = box->value[at + stride],
                right = box->value[at + 2 * stride];
      expansion first = average(&left, &middle), second = average(&middle, &right);
      low->value[at] = left;
      low->value[at + stride] = first;
      low->value[at + 2 * stride] = high->value[at] = average(&first, &second);
      high->value[at + stride] = second;
      high->value[at + 2 * stride] = right;
    }
  box_halve(&box->place, &low->place, &high->place);
}

/** The smallest coefficient, up to rounding. */
static double smallest_value(const exact_box *box) {
  double smallest = INFINITY;
  for (int i = 0; i < 27; i++) {
    const expansion *value = &box->value[i];
    smallest = fmin(smallest, value->count ? value->terms[value->count - 1] : 0);
  }
  return smallest;
}

/** The half that looks positive goes on top, and is soon off the stack: so a path can go deep while
 * few boxes wait. */
static void order_halves(exact_box halves[2]) {
  if (smallest_value(&halves[0]) <= smallest_value(&halves[1]))
    return;
  exact_box other = halves[0];
  halves[0] = halves[1];
  halves[1] = other;
}

static jacobian_sign prove_by_bisection(exact_box stack[MAX_OPEN], double witness[3]) {
  int top = 1;
  for (int boxes = 0; top > 0; boxes++) {
    exact_box *box = &stack[top - 1];
    if (boxes == MAX_BOXES || is_lost(box))
      return JACOBIAN_UNDECIDED;
    int corner = nonpositive_corner(box);
    if (corner >= 0) {
      box_corner_point(&box->place, corner, witness);
      return JACOBIAN_NONPOSITIVE;
    }
    if (all_positive(box)) {
      top--;
    } else if (box->place.depth == MAX_DEPTH || top == MAX_OPEN) {
      return JACOBIAN_UNDECIDED;
    } else {
      bisect(box, box, box + 1);
      order_halves(box);
      top++;
    }
  }
  return JACOBIAN_POSITIVE;
}

jacobian_sign prove_jacobian_sign_exactly(const double *points, const int32_t *hex,
                                          double witness[3]) {
  double corners[8][3];
  if (!scale_corners(points, hex, corners))
    return JACOBIAN_UNDECIDED;
  exact_box stack[MAX_OPEN];
  exact_coefficients(corners, &stack[0]);
  return prove_by_bisection(stack, witness);
}
