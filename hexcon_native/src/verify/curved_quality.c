/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "curved_quality.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "curved_box.h"
#include "curved_jacobian.h"
#include "hexmesh/hex_arrays.h"
#include "serendipity.h"

enum {
  SIDE = 5, /* coefficients of degree 4 in a direction .. */
  SQUARES = SIDE * SIDE * SIDE,
  MAX_DEPTH = 24,   /* bisections along the deepest path */
  LOOK_DEPTH = 3,   /* the same of hexes that are not positive: 27 places */
  MAX_BOXES = 1000, /* in all; then what is bounded already must do */
  PATIENCE = 1 << 9 /* hexes between two questions whether to go on */
};

/** The determinant on a box, and |X_a|^2 of the three half derivatives, not below the truth. */
typedef struct quality_box {
  curved_box determinant;
  double squares[3][SQUARES]; /* of degree 4 in each direction, at 25 i + 5 j + k */
} quality_box;

static const int strides[3] = {SIDE * SIDE, SIDE, 1};

/** Of degree 4, by i; and of degree 2 raised to it: out[i] = sum of weights[i][j] in[j]. */
static const double binomials_of_4[SIDE] = {1, 4, 6, 4, 1};
static const double from_2_to_4[SIDE][3] = {
    {1, 0, 0}, {0.5, 0.5, 0}, {1.0 / 6, 4.0 / 6, 1.0 / 6}, {0, 0.5, 0.5}, {0, 0, 1}};

size_t curved_quality_room(void) {
  size_t boxes = (MAX_DEPTH + 2) * sizeof(quality_box), proof = curved_jacobian_room();
  return boxes > proof ? boxes : proof;
}

/* ------------------------------------------------------------------------------ squared lengths */

/** The square of what curved_derive gave: degree 2 along `axis`, 4 in the others, times binomials;
 * at 25 i + 5 j + k. */
static void square_derivative(double derivative[3][18], int axis, double out[SQUARES]) {
  int sizes[3] = {3, 3, 3}, at[18], n = 0;
  sizes[axis] = 2;
  memset(out, 0, SQUARES * sizeof *out);
  for (int i = 0; i < sizes[0]; i++)
    for (int j = 0; j < sizes[1]; j++)
      for (int k = 0; k < sizes[2]; k++)
        at[n++] = strides[0] * i + strides[1] * j + k;
  for (int a = 0; a < n; a++)
    for (int b = 0; b <= a; b++) {
      double product = derivative[0][a] * derivative[0][b] + derivative[1][a] * derivative[1][b] +
                       derivative[2][a] * derivative[2][b];
      out[at[a] + at[b]] += a == b ? product : 2 * product;
    }
}

/** From degree 2 with binomials to degree 4 along an axis, the others over their binomials. */
static void raise_degree(double values[SQUARES], int axis) {
  const int along = strides[axis], other = strides[(axis + 1) % 3], last = strides[(axis + 2) % 3];
  for (int i = 0; i < SIDE; i++)
    for (int j = 0; j < SIDE; j++) {
      double *line = values + i * other + j * last;
      const double weight = 1 / (binomials_of_4[i] * binomials_of_4[j]);
      const double of_2[3] = {weight * line[0], weight * line[along] / 2, weight * line[2 * along]};
      for (int k = 0; k < SIDE; k++)
        line[k * along] =
            from_2_to_4[k][0] * of_2[0] + from_2_to_4[k][1] * of_2[1] + from_2_to_4[k][2] * of_2[2];
    }
}

/**
 * With M the largest entry: entries are off by at most e = 200 eps (see coefficient_error of
 * curved_box.c), which changes a coefficient, a mean of scalar products, by 3 (2 M e + e^2) at
 * most; some 60 roundings here and 5 at each of MAX_DEPTH bisections are of at most 3 M^2.
 */
static double square_error(double largest) {
  const double entry = 200 * DBL_EPSILON;
  return 3 * (2 * largest * entry + entry * entry) + 600 * DBL_EPSILON * largest * largest;
}

static void make_squares(double at[27][3], double squares[3][SQUARES]) {
  for (int axis = 0; axis < 3; axis++) {
    double derivative[3][18], error = square_error(curved_derive(at, axis, derivative));
    square_derivative(derivative, axis, squares[axis]);
    raise_degree(squares[axis], axis);
    for (int n = 0; n < SQUARES; n++)
      squares[axis][n] += error;
  }
}

/** As curved_box_bisect, without its account of rounding. */
static void halve_squares(double values[SQUARES], int axis, double low[SQUARES]) {
  const int along = strides[axis], other = strides[(axis + 1) % 3], last = strides[(axis + 2) % 3];
  for (int i = 0; i < SIDE; i++)
    for (int j = 0; j < SIDE; j++) {
      double *high = values + i * other + j * last, *to = low + i * other + j * last;
      for (int level = 0; level < SIDE; level++) {
        to[level * along] = high[0];
        for (int k = 0; k < SIDE - 1 - level; k++)
          high[k * along] = (high[k * along] + high[(k + 1) * along]) / 2;
      }
    }
}

/* --------------------------------------------------------------------------------------- bounds */

/** The mean x of the header: x / 6 is the sum of |X_a|^2 / m_a^2, less 1 each. @param product
 * receives m_r m_s m_t */
static void mean_excess(double squares[3][SQUARES], double out[SQUARES], double *product) {
  double weights[3];
  *product = 1;
  for (int axis = 0; axis < 3; axis++) {
    double sum = 0;
    for (int n = 0; n < SQUARES; n++)
      sum += squares[axis][n];
    weights[axis] = SQUARES / sum;
    *product *= sqrt(sum / SQUARES);
  }
  for (int n = 0; n < SQUARES; n++)
    out[n] =
        (weights[0] * squares[0][n] + weights[1] * squares[1][n] + weights[2] * squares[2][n] - 3) /
        6;
}

/** In place of (1 + x)^3 its chord, not below it where x is above -1/2, as it is. */
static void cube_by_chord(double values[SQUARES]) {
  double low = values[0], high = values[0];
  for (int n = 1; n < SQUARES; n++) {
    low = values[n] < low ? values[n] : low;
    high = values[n] > high ? values[n] : high;
  }
  const double a = 1 + fmax(low, -0.5), b = 1 + fmax(high, -0.5), slope = a * a + a * b + b * b;
  for (int n = 0; n < SQUARES; n++)
    values[n] = (a * a * a + slope * (values[n] + 1 - a)) * (1 + 64 * DBL_EPSILON);
}

/** From degree 4 to 5 of values `step` apart. */
static void raise_line(const double *in, int step, double *out) {
  out[0] = in[0];
  for (int k = 1; k < SIDE; k++)
    out[k * step] = 0.2 * k * in[(k - 1) * step] + (1 - 0.2 * k) * in[k * step];
  out[SIDE * step] = in[(SIDE - 1) * step];
}

/** From degree 4 to 5 in each direction: at 36 i + 6 j + k. */
static void raise_to_5(const double values[SQUARES], double out[CURVED_COEFFICIENTS]) {
  double first[6 * 5 * 5], second[6 * 6 * 5];
  for (int jk = 0; jk < 25; jk++)
    raise_line(values + jk, 25, first + jk);
  for (int i = 0; i < 6; i++)
    for (int k = 0; k < 5; k++)
      raise_line(first + 25 * i + k, 5, second + 30 * i + k);
  for (int ij = 0; ij < 36; ij++)
    raise_line(second + 5 * ij, 1, out + 6 * ij);
}

/** @param unit  what the determinant is divided by @return not above the quotient on the box, 0 if
 * nothing is known */
static double bound_below(quality_box *box, double unit) {
  double excess[SQUARES], lengths[CURVED_COEFFICIENTS], product, bound = 1;
  mean_excess(box->squares, excess, &product);
  cube_by_chord(excess);
  raise_to_5(excess, lengths);
  for (int n = 0; n < CURVED_COEFFICIENTS; n++) {
    double least = (box->determinant.value[n] - box->determinant.error) / unit;
    if (!(least > 0))
      return 0;
    if (least < bound * (product * lengths[n]))
      bound = least / (product * lengths[n]);
  }
  return bound * (1 - 256 * DBL_EPSILON);
}

/** The least quotient at the box's corners; -1 where a derivative vanishes. */
static double least_at_corners(const quality_box *box, double unit) {
  double least = 1;
  for (int corner = 0; corner < 8; corner++) {
    const int i = corner >> 2, j = corner >> 1 & 1, k = corner & 1;
    const int n = (SIDE - 1) * (strides[0] * i + strides[1] * j + k);
    double lengths = sqrt(box->squares[0][n]) * sqrt(box->squares[1][n]) * sqrt(box->squares[2][n]);
    double value = box->determinant.value[serendipity_corners[corner]] / unit;
    least = fmin(least, lengths > 0 ? fmax(value / lengths, -1) : -1);
  }
  return least;
}

static void halve(quality_box *box, quality_box *low) {
  const int axis = box_axis(&box->determinant.place);
  double largest;
  (void)curved_box_smallest(&box->determinant, &largest);
  curved_box_bisect(&box->determinant, largest, &low->determinant);
  for (int a = 0; a < 3; a++)
    halve_squares(box->squares[a], axis, low->squares[a]);
}

/** Depth-first. @return a bound from below, by boxes that are within the tolerance of some value
 * that was found; of hexes that are not `positive` the least value found */
static double search(quality_box *stack, bool positive, double unit) {
  double bound = 1, found = 1;
  int top = 1;
  for (int boxes = 0; top > 0; boxes++) {
    quality_box *box = &stack[top - 1];
    const int depth = box->determinant.place.depth;
    found = fmin(found, least_at_corners(box, unit));
    double here = positive ? bound_below(box, unit) : 0;
    bool done = positive ? here >= found - HEXCON_CURVED_QUALITY_TOLERANCE || depth == MAX_DEPTH ||
                               boxes >= MAX_BOXES
                         : depth == LOOK_DEPTH;
    if (done) {
      bound = fmin(bound, here);
      top--;
    } else {
      halve(box, box + 1);
      top++;
    }
  }
  return positive ? bound : found;
}

double curved_scaled_jacobian(double nodes[20][3], void *room) {
  quality_box *stack = room;
  double at[27][3], scale[3], witness[3];
  bool positive = prove_curved_jacobian_sign(nodes, room, witness) == JACOBIAN_POSITIVE;
  if (!curved_nodes_place(nodes, at, scale))
    return -1;
  curved_box_make(at, &stack->determinant);
  double least = fmin(scale[0], fmin(scale[1], scale[2])), unit = 1000;
  for (int c = 0; c < 3; c++) { /* the hex as a whole is of any size */
    const double factor = scale[c] / least;
    unit *= factor;
    for (int control = 0; control < 27; control++)
      at[control][c] /= factor;
  }
  make_squares(at, stack->squares);
  double quality = search(stack, positive, unit);
  return positive ? quality : fmin(quality, 0);
}

hexcon_status curved_qualities(hexcon_context *context, const double *points, const int32_t *hexes,
                               size_t hex_count, double *qualities) {
  void *room = context_allocate(context, curved_quality_room(), 1);
  hexcon_status status = room ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  for (size_t h = 0; !status && h < hex_count; h++) {
    double nodes[20][3];
    for (size_t n = 0; n < 20; n++)
      memcpy(nodes[n], points + 3 * (size_t)hexes[20 * h + n], sizeof nodes[n]);
    qualities[h] = curved_scaled_jacobian(nodes, room);
    if ((h + 1) % PATIENCE == 0)
      status = context_ask(context);
  }
  context_free(context, room);
  return status;
}

hexcon_status hexcon_quality_second_order(hexcon_context *context, const double *points,
                                          size_t point_count, const int32_t *hexes,
                                          size_t hex_count, double *qualities) {
  context_clear(context);
  hexcon_status status = check_second_order_arrays(context, points, point_count, hexes, hex_count);
  return status ? status : curved_qualities(context, points, hexes, hex_count, qualities);
}
