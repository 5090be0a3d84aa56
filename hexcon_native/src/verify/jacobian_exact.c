/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "jacobian_exact.h"

#include <math.h>
#include <string.h>

#include "exact_bisection.h"
#include "hexmesh/hex_tables.h"

enum {
  MAX_DEPTH = 96,  /* bisections along the deepest path: coefficients within 2^-64 of the values */
  MAX_OPEN = 20,   /* boxes not yet decided; some 100 kB */
  MAX_BOXES = 2048 /* in all */
};

/** The edge along `axis` whose place across it is given by the bits of m, lower axis first. */
static void exact_edge(double corners[8][3], int axis, int m, exact_vector *edge) {
  int low = axis == 0 ? 1 : 0, high = axis == 2 ? 1 : 2;
  int start = ((m & 1) << low) | ((m >> 1) << high);
  for (int i = 0; i < 3; i++)
    edge->x[i] = expansion_difference(corners[start | (1 << axis)][i], corners[start][i]);
}

/** The sum of jacobian_sign.c's sum_coefficients, exactly. */
static void exact_coefficients(double corners[8][3], expansion value[27]) {
  exact_vector along[4], b_edge, c_edge;
  memset(value, 0, 27 * sizeof *value);
  for (int a = 0; a < 4; a++)
    exact_edge(corners, 0, a, &along[a]);
  for (int b = 0; b < 4; b++)
    for (int c = 0; c < 4; c++) {
      exact_edge(corners, 1, b, &b_edge);
      exact_edge(corners, 2, c, &c_edge);
      exact_vector cross = {0};
      exact_add_cross(&b_edge, &c_edge, &cross);
      for (int a = 0; a < 4; a++)
        exact_add_dot(
            &along[a], &cross,
            &value[9 * ((b & 1) + (c & 1)) + 3 * ((a & 1) + (c >> 1)) + (a >> 1) + (b >> 1)]);
    }
  for (int i = 0; i < 27; i++) {
    int middles = (i / 9 == 1) + (i / 3 % 3 == 1) + (i % 3 == 1);
    value[i] = expansion_scaled(&value[i], ldexp(1, -middles));
  }
}

static expansion average(const expansion *a, const expansion *b) {
  expansion sum = expansion_sum(a, b);
  return expansion_scaled(&sum, 0.5);
}

/** de Casteljau at 1/2 along one axis, the lower half in place. */
static void bisect(expansion value[27], box_place *place, expansion high[27],
                   box_place *high_place) {
  int axis = box_axis(place), stride = box_strides[axis], across = box_strides[(axis + 1) % 3],
      along = box_strides[(axis + 2) % 3];
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) {
      int at = i * across + j * along;
      expansion left = value[at], middle = value[at + stride], right = value[at + 2 * stride];
      expansion first = average(&left, &middle), second = average(&middle, &right);
      value[at] = left;
      value[at + stride] = first;
      value[at + 2 * stride] = high[at] = average(&first, &second);
      high[at + stride] = second;
      high[at + 2 * stride] = right;
    }
  box_halve(place, place, high_place);
}

/** The smallest coefficient, up to rounding. */
static double smallest_value(const expansion value[27]) {
  double smallest = INFINITY;
  for (int i = 0; i < 27; i++)
    smallest = fmin(smallest, value[i].count ? value[i].terms[value[i].count - 1] : 0);
  return smallest;
}

/** The half that looks positive is looked at first, and is soon done with: so a path can go deep
 * while few boxes wait. */
static void bisect_in_order(expansion *value, box_place *place, expansion *other,
                            box_place *other_place) {
  expansion kept[27];
  bisect(value, place, other, other_place);
  if (smallest_value(value) <= smallest_value(other))
    return;
  memcpy(kept, value, sizeof kept);
  memcpy(value, other, sizeof kept);
  memcpy(other, kept, sizeof kept);
  box_place place_kept = *place;
  *place = *other_place;
  *other_place = place_kept;
}

jacobian_sign prove_jacobian_sign_exactly(const double *points, const int32_t *hex,
                                          double witness[3]) {
  double corners[8][3];
  for (size_t c = 0; c < 8; c++)
    memcpy(corners[hex_corner_bits[c]], points + 3 * (size_t)hex[c], sizeof corners[0]);
  if (!exact_scale(corners, 8))
    return JACOBIAN_UNDECIDED;
  expansion values[MAX_OPEN * 27];
  box_place places[MAX_OPEN] = {{{0}, 0}};
  exact_coefficients(corners, values);
  exact_boxes boxes = {.values = values,
                       .places = places,
                       .coefficients = 27,
                       .corners = box_corners,
                       .open = MAX_OPEN,
                       .deepest = MAX_DEPTH,
                       .most = MAX_BOXES,
                       .halve = bisect_in_order};
  return prove_by_bisection(&boxes, witness);
}
