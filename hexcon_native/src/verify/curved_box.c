/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "curved_box.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "base/vector.h"
#include "serendipity.h"

static const int strides[3] = {36, 6, 1};

static double larger(double a, double b) {
  return b > a ? b : a;
}

/** The differences from the first corner are off by one unit u = eps / 2. */
bool curved_nodes_place(double nodes[20][3], double at[27][3], double scale[3]) {
  bool finite = true;
  for (int c = 0; c < 3; c++) {
    double largest = 0;
    for (int n = 0; n < 20; n++) {
      double from = nodes[n][c] - nodes[0][c];
      finite &= isfinite(from) != 0; /* `larger` drops what is no number */
      largest = larger(largest, fabs(from));
      at[serendipity_places[n]][c] = from;
    }
    int exponent;
    (void)frexp(largest, &exponent);
    scale[c] = ldexp(1, exponent < -1000 ? 1000 : -exponent);
    for (int n = 0; n < 20; n++)
      at[serendipity_places[n]][c] *= scale[c];
  }
  return finite;
}

/** The control point in the middle of a square of control points, `a` and `b` apart. */
static void square_middle(double at[27][3], int middle, int a, int b) {
  for (int c = 0; c < 3; c++) {
    double edges =
        (at[middle - a][c] + at[middle + a][c]) + (at[middle - b][c] + at[middle + b][c]);
    double corners = (at[middle - a - b][c] + at[middle + a + b][c]) +
                     (at[middle - a + b][c] + at[middle + a - b][c]);
    at[middle][c] = (2 * edges - corners) / 4;
  }
}

/** Nodes to control points, in place; see serendipity.h. */
static void make_controls(double at[27][3]) {
  static const unsigned char edges[12][2] = {{1, 1},  {7, 1},  {19, 1}, {25, 1}, {3, 3},  {5, 3},
                                             {21, 3}, {23, 3}, {9, 9},  {11, 9}, {15, 9}, {17, 9}};
  static const unsigned char squares[7][3] = {{4, 3, 1},  {22, 3, 1}, {10, 9, 1}, {16, 9, 1},
                                              {12, 9, 3}, {14, 9, 3}, {13, 9, 3}};
  for (int e = 0; e < 12; e++) {
    int middle = edges[e][0], step = edges[e][1];
    for (int c = 0; c < 3; c++)
      at[middle][c] = 2 * at[middle][c] - (at[middle - step][c] + at[middle + step][c]) / 2;
  }
  for (int s = 0; s < 7; s++)
    square_middle(at, squares[s][0], squares[s][1], squares[s][2]);
}

double curved_derive(double at[27][3], int axis, double out[3][18]) {
  double largest = 0;
  int sizes[3] = {3, 3, 3}, n = 0;
  sizes[axis] = 2;
  for (int i = 0; i < sizes[0]; i++)
    for (int j = 0; j < sizes[1]; j++)
      for (int k = 0; k < sizes[2]; k++, n++) {
        int place = 9 * i + 3 * j + k, index[3] = {i, j, k};
        index[axis] = 0; /* of degree 1 there: binomials 1 */
        double binomials = serendipity_binomials[index[0]] * serendipity_binomials[index[1]] *
                           serendipity_binomials[index[2]];
        for (int c = 0; c < 3; c++) {
          double entry = at[place + box_strides[axis]][c] - at[place][c];
          largest = larger(largest, fabs(entry));
          out[c][n] = binomials * entry;
        }
      }
  return largest;
}

/** X_s x X_t: degrees (2, 1, 2) and (2, 2, 1) give (4, 3, 3), at 16 i + 4 j + k. */
static void cross_product(double s[3][18], double t[3][18], double out[3][80]) {
  memset(out, 0, 3 * sizeof *out);
  for (int c = 0; c < 3; c++) {
    const double *s1 = s[(c + 1) % 3], *s2 = s[(c + 2) % 3];
    const double *t1 = t[(c + 1) % 3], *t2 = t[(c + 2) % 3];
    for (int a = 0; a < 18; a++)
      for (int b = 0; b < 9; b++) {
        int from = 16 * (a / 6 + b / 3) + 4 * (a / 3 % 2 + b % 3) + a % 3;
        for (int k = 0; k < 2; k++)
          out[c][from + k] += s1[a] * t2[2 * b + k] - s2[a] * t1[2 * b + k];
      }
  }
}

/** X_r . (X_s x X_t): degrees (1, 2, 2) and (4, 3, 3) give (5, 5, 5). */
static void dot_product(double r[3][18], double cross[3][80], double out[CURVED_COEFFICIENTS]) {
  memset(out, 0, CURVED_COEFFICIENTS * sizeof *out);
  for (int i = 0; i < 5; i++)
    for (int j = 0; j < 4; j++)
      for (int a = 0; a < 6; a++) {
        double *to = out + 36 * (i + a / 3) + 6 * (j + a % 3);
        for (int c = 0; c < 3; c++) {
          const double *x = cross[c] + 16 * i + 4 * j, *y = r[c] + 3 * a;
          for (int k = 0; k < 4; k++) {
            to[k] += y[0] * x[k];
            to[k + 1] += y[1] * x[k];
            to[k + 2] += y[2] * x[k];
          }
        }
      }
}

/** Scaled Bernstein coefficients over their binomials (5, i)(5, j)(5, k), times 1000: small
 * integers. */
static void divide_binomials(double value[CURVED_COEFFICIENTS]) {
  for (int i = 0; i < 6; i++)
    for (int j = 0; j < 6; j++)
      for (int k = 0; k < 6; k++)
        value[36 * i + 6 * j + k] *=
            serendipity_tenths[i] * serendipity_tenths[j] * serendipity_tenths[k];
}

/**
 * Error of the coefficients (times 1000), u = eps / 2.
 * Entries: nodes are below 1 and off by u. An edge's control point is below 3 and off by 3 u from
 * the nodes and at most 4 u by rounding: 7 u. A face's is below (2 * 4 * 3 + 4) / 4 = 7, off by
 * (2 * 4 * 7 + 4) / 4 u = 15 u and by at most 8 roundings of 7: 71 u. The centre's is below
 * (2 * 4 * 7 + 4 * 3) / 4 = 17, off by (2 * 4 * 71 + 4 * 7) / 4 u = 149 u and 8 * 17 u: 285 u. A
 * difference of two is off by (285 + 71 + 24) u = 380 u: `entry` below, rounded up.
 * Products: with M_a the largest entry along axis a, each coefficient is a mean, by products of
 * binomials, of determinants of 6 products of at most M_0 M_1 M_2. The entries' errors e change
 * each by at most (M_0 + e)(M_1 + e)(M_2 + e) - M_0 M_1 M_2. Rounding: 2 in a cross product, at
 * most 3 * 2 * 2 sums in its convolution, 1 for the last product, at most 3 * 2 * 3 * 3 sums, 1 for
 * the weight: 70, each of at most 6 M_0 M_1 M_2 (1 + O(u)). 1.01 covers the O(u), 1e-280 what
 * underflows.
 */
static double coefficient_error(const double m[3]) {
  const double entry = 200 * DBL_EPSILON;
  double product = m[0] * m[1] * m[2];
  double by_entries = entry * (m[0] * m[1] + m[0] * m[2] + m[1] * m[2]) +
                      entry * entry * (m[0] + m[1] + m[2] + entry);
  return 1000 * 6 * 1.01 * (by_entries + 35 * DBL_EPSILON * product) + 1e-280;
}

/** As an entry of curved_derive at a corner is: 2 m - (p + q) / 2 - p, of nodes below 1 and off by
 * u. So the bound above holds with what is largest among these. */
void curved_corner_values(double at[27][3], double values[8], double *error) {
  double largest[3] = {0, 0, 0};
  for (int corner = 0; corner < 8; corner++) {
    double arms[3][3];
    for (int axis = 0; axis < 3; axis++) {
      const int place = box_corners[corner], high = corner >> (2 - axis) & 1;
      const int step = high ? -box_strides[axis] : box_strides[axis];
      for (int c = 0; c < 3; c++) {
        double p = at[place][c], edge = 2 * at[place + step][c] - (p + at[place + 2 * step][c]) / 2;
        arms[axis][c] = high ? p - edge : edge - p;
        largest[axis] = larger(largest[axis], fabs(arms[axis][c]));
      }
    }
    values[corner] = 1000 * vector_determinant(arms[0], arms[1], arms[2]);
  }
  *error = coefficient_error(largest);
}

void curved_box_make(double at[27][3], curved_box *whole) {
  double derivatives[3][3][18], cross[3][80], largest[3];
  memset(whole, 0, sizeof *whole);
  make_controls(at);
  for (int axis = 0; axis < 3; axis++)
    largest[axis] = curved_derive(at, axis, derivatives[axis]);
  cross_product(derivatives[1], derivatives[2], cross);
  dot_product(derivatives[0], cross, whole->value);
  divide_binomials(whole->value);
  whole->error = coefficient_error(largest);
}

double curved_box_smallest(const curved_box *box, double *largest) {
  double smallest = box->value[0];
  *largest = fabs(smallest);
  for (int i = 1; i < CURVED_COEFFICIENTS; i++) {
    smallest = box->value[i] < smallest ? box->value[i] : smallest;
    *largest = larger(*largest, fabs(box->value[i]));
  }
  return smallest;
}

/** de Casteljau at 1/2 along one axis, the upper half in place. Five levels of averages below
 * `largest`, each rounded once: at most 5 u * largest in all. */
void curved_box_bisect(curved_box *box, double largest, curved_box *low) {
  int axis = box_axis(&box->place), stride = strides[axis], across = strides[(axis + 1) % 3],
      along = strides[(axis + 2) % 3];
  for (int i = 0; i < 6; i++)
    for (int j = 0; j < 6; j++) {
      double *high = box->value + i * across + j * along;
      double *to = low->value + i * across + j * along;
      for (int level = 0; level < 6; level++) {
        to[level * stride] = high[0];
        for (int k = 0; k < 5 - level; k++)
          high[k * stride] = (high[k * stride] + high[(k + 1) * stride]) / 2;
      }
    }
  low->error = box->error = box->error + 3 * DBL_EPSILON * largest;
  box_place whole = box->place;
  box_halve(&whole, &low->place, &box->place);
}
