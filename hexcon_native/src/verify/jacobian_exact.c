/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "jacobian_exact.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "expansion.h"
#include "hex_tables.h"

enum {
  MAX_DEPTH = 18,  /* bisections along the deepest path: boxes of 1/64 of the hex */
  MAX_BOXES = 2048 /* in all */
};

typedef struct exact_vector {
  expansion x[3];
} exact_vector;

/** Bernstein coefficients of degree 2 in each direction, at 9 i + 3 j + k. */
typedef struct exact_box {
  expansion value[27];
  int depth;
} exact_box;

/** A power of two that brings the longest edge near 1; 0 if there is none. */
static double choose_scale(const double *points, const int32_t *hex) {
  double largest = 0;
  for (int e = 0; e < 12; e++)
    for (int i = 0; i < 3; i++)
      largest = fmax(largest, fabs(points[3 * (size_t)hex[hex_edges[e][1]] + (size_t)i] -
                                   points[3 * (size_t)hex[hex_edges[e][0]] + (size_t)i]));
  int exponent;
  (void)frexp(largest, &exponent);
  return largest > 0 && isfinite(largest) && exponent > -1000 ? ldexp(1, -exponent) : 0;
}

/** Coordinates times a power of two: not exact where they become subnormal. */
static bool scale_corners(const double *points, const int32_t *hex, double scale,
                          double corners[8][3]) {
  bool exact = true;
  for (int c = 0; c < 8; c++)
    for (int i = 0; i < 3; i++) {
      double coordinate = points[3 * (size_t)hex[c] + (size_t)i], scaled = coordinate * scale;
      exact &= isfinite(scaled) && (coordinate == 0 || fabs(scaled) >= DBL_MIN);
      corners[hex_corner_bits[c]][i] = scaled;
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

/** Smallest sign of the coefficients with all indices even (values at corners), or of all. */
static int smallest_sign(const exact_box *box, bool corners_only) {
  int smallest = 1;
  for (int i = 0; i < 27; i++) {
    bool corner = i / 9 != 1 && i / 3 % 3 != 1 && i % 3 != 1;
    int sign = corner || !corners_only ? expansion_sign(&box->value[i]) : 1;
    smallest = sign < smallest ? sign : smallest;
  }
  return smallest;
}

static expansion average(const expansion *a, const expansion *b) {
  expansion sum = expansion_sum(a, b);
  return expansion_scaled(&sum, 0.5);
}

/** de Casteljau at 1/2 along one axis; `low` may be the box itself. */
static void bisect(const exact_box *box, exact_box *low, exact_box *high) {
  static const int strides[3] = {9, 3, 1};
  int stride = strides[box->depth % 3], across = strides[(box->depth + 1) % 3],
      along = strides[(box->depth + 2) % 3];
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
  low->depth = high->depth = box->depth + 1;
}

static jacobian_sign prove_by_bisection(exact_box stack[MAX_DEPTH + 1]) {
  int top = 1;
  for (int boxes = 0; top > 0; boxes++) {
    exact_box *box = &stack[top - 1];
    if (boxes == MAX_BOXES || is_lost(box))
      return JACOBIAN_UNDECIDED;
    if (smallest_sign(box, true) <= 0)
      return JACOBIAN_NONPOSITIVE;
    if (smallest_sign(box, false) > 0) {
      top--;
    } else if (box->depth == MAX_DEPTH) {
      return JACOBIAN_UNDECIDED;
    } else {
      bisect(box, box, box + 1);
      top++;
    }
  }
  return JACOBIAN_POSITIVE;
}

jacobian_sign prove_jacobian_sign_exactly(const double *points, const int32_t *hex) {
  double corners[8][3], scale = choose_scale(points, hex);
  if (scale == 0 || !scale_corners(points, hex, scale, corners))
    return JACOBIAN_UNDECIDED;
  exact_box stack[MAX_DEPTH + 1]; /* one sibling per level; some 100 kB */
  exact_coefficients(corners, &stack[0]);
  return prove_by_bisection(stack);
}
