/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "jacobian_sign.h"

#include <float.h>
#include <stdbool.h>
#include <string.h>

#include "base/vector.h"
#include "box_place.h"
#include "hexmesh/hex_tables.h"
#include "jacobian_exact.h"

enum {
  MAX_DEPTH = 24,     /* bisections along the deepest path: boxes of 1/256 of the hex */
  MAX_BOXES = 1 << 16 /* in all; only a Jacobian that all but vanishes on a surface needs more */
};

/** Bernstein coefficients on a box of the hex, [i][j][k] of degree 2 each, and a bound on the
 * absolute error of any of them. */
typedef struct box_coefficients {
  double value[3][3][3];
  double error;
  box_place place;
} box_coefficients;

/** As fmax, without a call. */
static double larger(double a, double b) {
  return b > a ? b : a;
}

/** edges[axis][m]: the edge along `axis` whose position across it is given by the bits of m, lower
 * axis first. @param largest  receives the largest entry of each coordinate
 * @return false if some edge vector overflows or is no number */
static bool collect_edges(const double *points, const int32_t *hex, double edges[3][4][3],
                          double largest[3]) {
  double corners[8][3];
  for (int i = 0; i < 8; i++)
    memcpy(corners[hex_corner_bits[i]], points + 3 * (size_t)hex[i], sizeof corners[0]);
  bool finite = true;
  memset(largest, 0, 3 * sizeof *largest);
  for (int axis = 0; axis < 3; axis++) {
    int low = axis == 0 ? 1 : 0, high = axis == 2 ? 1 : 2;
    for (int m = 0; m < 4; m++) {
      int start = ((m & 1) << low) | ((m >> 1) << high);
      vector_subtract(corners[start | (1 << axis)], corners[start], edges[axis][m]);
      for (int i = 0; i < 3; i++) {
        finite &= isfinite(edges[axis][m][i]) != 0; /* `larger` drops what is no number */
        largest[i] = larger(largest[i], fabs(edges[axis][m][i]));
      }
    }
  }
  return finite;
}

/** Scale each coordinate by a power of two of its own, exactly: that leaves the sign, makes flat
 * hexes as good as cubes, and lets products neither over- nor underflow in any way that matters.
 * Returns the product of the largest entries per axis. */
static double normalise_edges(double edges[3][4][3], const double largest[3]) {
  double scale[3], product = 1;
  for (int i = 0; i < 3; i++) {
    int exponent;
    (void)frexp(largest[i], &exponent);
    scale[i] = ldexp(1, exponent < -1000 ? 1000 : -exponent);
  }
  for (int axis = 0; axis < 3; axis++) {
    double axis_largest = 0;
    for (int m = 0; m < 4; m++)
      for (int i = 0; i < 3; i++) {
        edges[axis][m][i] *= scale[i];
        axis_largest = larger(axis_largest, fabs(edges[axis][m][i]));
      }
    product *= axis_largest;
  }
  return product;
}

/** Coefficients of det(X_r(s,t), X_s(r,t), X_t(r,s)): the factors are bilinear, and a product of
 * two linear Bernstein polynomials b_a b_b is b_(a+b) of degree 2 over binomial(2, a+b). */
static void sum_coefficients(double edges[3][4][3], double value[3][3][3]) {
  memset(value, 0, 27 * sizeof(double));
  for (int b = 0; b < 4; b++)     /* X_s edge at (r, t) = (b & 1, b >> 1) */
    for (int c = 0; c < 4; c++) { /* X_t edge at (r, s) = (c & 1, c >> 1) */
      double cross[3];
      vector_cross(edges[1][b], edges[2][c], cross);
      for (int a = 0; a < 4; a++) /* X_r edge at (s, t) = (a & 1, a >> 1) */
        value[(b & 1) + (c & 1)][(a & 1) + (c >> 1)][(a >> 1) + (b >> 1)] +=
            vector_dot(edges[0][a], cross);
    }
  static const double weight[3] = {1, 0.5, 1};
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      for (int k = 0; k < 3; k++)
        value[i][j][k] *= weight[i] * weight[j] * weight[k];
}

/**
 * Rounding of sum_coefficients. Each edge entry carries a relative error of one unit u = eps / 2.
 * A determinant is a sum of 6 products of 3 entries, |product| <= P = product of the axes' largest
 * entries; with the entries' errors, the two products of the cross product and its difference, the
 * third product and the two sums, each is off by at most 9 u P (1 + O(u)): 54 u P in all. At most
 * 8 determinants are added (8 more roundings of at most 48 P): (8 * 54 + 8 * 48) u P < 820 u P; the
 * weight is at least 1/8 and multiplies the error as well as the value, so 820 u P holds for all.
 * DBL_MIN covers underflow of single products.
 */
static double coefficient_error(double product) {
  return 410 * DBL_EPSILON * 1.01 * product + 100 * DBL_MIN;
}

static double smallest_value(const box_coefficients *box, double *largest) {
  const double *v = &box->value[0][0][0];
  double smallest = v[0];
  *largest = fabs(v[0]);
  for (int i = 1; i < 27; i++) {
    smallest = v[i] < smallest ? v[i] : smallest;
    *largest = larger(*largest, fabs(v[i]));
  }
  return smallest;
}

/** Corner coefficients are values of the Jacobian: one surely negative decides, one too close to
 * zero cannot be proved positive. @param corner receives which it is */
static double smallest_corner(const box_coefficients *box, int *corner) {
  const double *v = &box->value[0][0][0];
  *corner = 0;
  for (int i = 1; i < 8; i++)
    if (v[box_corners[i]] < v[box_corners[*corner]])
      *corner = i;
  return v[box_corners[*corner]];
}

/** de Casteljau at 1/2 along one axis. Averages of values below `largest`: each of the two
 * levels of averaging rounds once or twice, by at most u * 2 * largest in all per level. */
static void bisect(const box_coefficients *box, double largest, box_coefficients *low,
                   box_coefficients *high) {
  int axis = box_axis(&box->place), stride = box_strides[axis],
      across = box_strides[(axis + 1) % 3], along = box_strides[(axis + 2) % 3];
  const double *v = &box->value[0][0][0];
  double *l = &low->value[0][0][0], *h = &high->value[0][0][0];
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) {
      int at = i * across + j * along;
      double first = (v[at] + v[at + stride]) / 2;
      double second = (v[at + stride] + v[at + 2 * stride]) / 2;
      l[at] = v[at];
      l[at + stride] = first;
      l[at + 2 * stride] = h[at] = (first + second) / 2;
      h[at + stride] = second;
      h[at + 2 * stride] = v[at + 2 * stride];
    }
  low->error = high->error = box->error + 4 * DBL_EPSILON * largest;
  box_halve(&box->place, &low->place, &high->place);
}

/** Depth-first over boxes; the stack holds one sibling per level. Once some point is undecided,
 * only boxes that may hold a negative value are looked at. */
static jacobian_sign prove_by_bisection(const box_coefficients *whole, double witness[3]) {
  box_coefficients stack[MAX_DEPTH + 2];
  int top = 0, boxes = 0;
  stack[top++] = *whole;
  bool undecided = false;
  while (top > 0) {
    box_coefficients box = stack[--top];
    double largest, smallest = smallest_value(&box, &largest);
    if (smallest > box.error)
      continue;
    int lowest;
    double corner = smallest_corner(&box, &lowest);
    if (corner < -box.error) {
      box_corner_point(&box.place, lowest, witness);
      return JACOBIAN_NONPOSITIVE;
    }
    undecided |= corner <= box.error || box.place.depth == MAX_DEPTH;
    if (++boxes == MAX_BOXES)
      return JACOBIAN_UNDECIDED;
    if (box.place.depth == MAX_DEPTH || (undecided && smallest >= -box.error))
      continue;
    bisect(&box, largest, &stack[top], &stack[top + 1]);
    top += 2;
  }
  return undecided ? JACOBIAN_UNDECIDED : JACOBIAN_POSITIVE;
}

/** The filter: nearly every hex is decided here. */
static jacobian_sign prove_in_doubles(const double *points, const int32_t *hex, double witness[3]) {
  double edges[3][4][3], largest[3];
  if (!collect_edges(points, hex, edges, largest))
    return JACOBIAN_UNDECIDED;
  double product = normalise_edges(edges, largest);
  box_coefficients whole = {.error = coefficient_error(product)};
  sum_coefficients(edges, whole.value);
  return prove_by_bisection(&whole, witness);
}

jacobian_sign prove_jacobian_sign_at(const double *points, const int32_t *hex, double witness[3]) {
  witness[0] = witness[1] = witness[2] = NAN;
  jacobian_sign sign = prove_in_doubles(points, hex, witness);
  return sign == JACOBIAN_UNDECIDED ? prove_jacobian_sign_exactly(points, hex, witness) : sign;
}

jacobian_sign prove_jacobian_sign(const double *points, const int32_t *hex) {
  double witness[3];
  return prove_jacobian_sign_at(points, hex, witness);
}
