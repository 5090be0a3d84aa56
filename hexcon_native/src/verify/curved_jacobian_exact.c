/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "curved_jacobian_exact.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "exact_bisection.h"
#include "serendipity.h"

enum {
  COEFFICIENTS = 216,
  MAX_DEPTH = 48, /* bisections along the deepest path: boxes of 2^-16 of the hex */
  MAX_OPEN = 20,  /* boxes not yet decided */
  MAX_BOXES = 256 /* in all */
};

/** What the coefficients are made from: derivatives' coefficients times their binomials, and the
 * cross product of two of them. */
typedef struct exact_room {
  expansion values[MAX_OPEN * COEFFICIENTS]; /* times 1000, at 36 i + 6 j + k */
  box_place places[MAX_OPEN];
  exact_vector controls[27], derivatives[3][18], cross[80];
} exact_room;

static const int strides[3] = {36, 6, 1};

size_t exact_curved_room(void) {
  return sizeof(exact_room);
}

/** Whether a node is of the edge, face or hex whose middle is a control point: its place agrees
 * wherever the control point is not in the middle. */
static bool belongs(int place, int control) {
  for (int axis = 0; axis < 3; axis++) {
    int there = control / box_strides[axis] % 3;
    if (there != 1 && place / box_strides[axis] % 3 != there)
      return false;
  }
  return true;
}

static int count_middles(int place) {
  return (place / 9 == 1) + (place / 3 % 3 == 1) + (place % 3 == 1);
}

static void add_weighted(expansion *sum, double value, double weight) {
  expansion term = expansion_difference(value, 0), factor = expansion_difference(weight, 0);
  term = expansion_product(&term, &factor);
  *sum = expansion_sum(sum, &term);
}

/** The weights of serendipity.h: another road to the control points than the filter's. */
static void make_controls(double nodes[20][3], exact_vector controls[27]) {
  memset(controls, 0, 27 * sizeof *controls);
  for (int b = 0; b < 27; b++) {
    int middles = count_middles(b);
    for (int n = 0; n < 20; n++) {
      double weight =
          n < 8 ? serendipity_corner_weights[middles] : serendipity_middle_weights[middles];
      for (int c = 0; weight != 0 && c < 3 && belongs(serendipity_places[n], b); c++)
        add_weighted(&controls[b].x[c], nodes[n][c], weight);
    }
  }
}

/** As derive in curved_jacobian.c: degrees (1, 2, 2), (2, 1, 2) or (2, 2, 1). */
static void derive(const exact_vector controls[27], int axis, exact_vector out[18]) {
  int n = 0;
  for (int place = 0; place < 27; place++) {
    if (place / box_strides[axis] % 3 == 2)
      continue;
    int middles = count_middles(place) - (place / box_strides[axis] % 3 == 1);
    for (int c = 0; c < 3; c++) {
      expansion minus = expansion_scaled(&controls[place].x[c], -1);
      expansion entry = expansion_sum(&controls[place + box_strides[axis]].x[c], &minus);
      out[n].x[c] = expansion_scaled(&entry, ldexp(1, middles));
    }
    n++;
  }
}

static void make_coefficients(exact_room *room) {
  memset(room->values, 0, COEFFICIENTS * sizeof *room->values);
  memset(room->cross, 0, sizeof room->cross);
  for (int a = 0; a < 18; a++)
    for (int b = 0; b < 18; b++)
      exact_add_cross(
          &room->derivatives[1][a], &room->derivatives[2][b],
          &room->cross[16 * (a / 6 + b / 6) + 4 * (a / 3 % 2 + b / 2 % 3) + a % 3 + b % 2]);
  for (int x = 0; x < 80; x++)
    for (int a = 0; a < 18; a++)
      exact_add_dot(
          &room->derivatives[0][a], &room->cross[x],
          &room->values[36 * (x / 16 + a / 9) + 6 * (x / 4 % 4 + a / 3 % 3) + x % 4 + a % 3]);
  for (int i = 0; i < COEFFICIENTS; i++) {
    expansion weight = expansion_difference(
        serendipity_tenths[i / 36] * serendipity_tenths[i / 6 % 6] * serendipity_tenths[i % 6], 0);
    room->values[i] = expansion_product(&room->values[i], &weight);
  }
}

/** Twice the derivative at corner p of an edge with middle m and other end q, but for its sign:
 * 4 m - 3 p - q. */
static void derive_at_corner(const double p[3], const double m[3], const double q[3], double sign,
                             exact_vector *out) {
  for (int c = 0; c < 3; c++) {
    expansion far = expansion_difference(4 * m[c], q[c]);
    expansion near = expansion_difference(-2 * p[c], p[c]);
    expansion sum = expansion_sum(&far, &near);
    out->x[c] = expansion_scaled(&sum, sign);
  }
}

int nonpositive_curved_corner(double nodes[20][3], unsigned corners) {
  double scaled[20][3];
  int node_at[27];
  memcpy(scaled, nodes, sizeof scaled);
  if (!exact_scale(scaled, 20))
    return -1;
  for (int n = 0; n < 20; n++)
    node_at[serendipity_places[n]] = n;
  for (int corner = 0; corner < 8; corner++) {
    const int place = box_corners[corner];
    exact_vector arms[3], cross = {0};
    expansion value = {0};
    if (!(corners >> corner & 1))
      continue;
    for (int axis = 0; axis < 3; axis++) {
      const int sign = corner >> (2 - axis) & 1 ? -1 : 1, step = sign * box_strides[axis];
      derive_at_corner(scaled[node_at[place]], scaled[node_at[place + step]],
                       scaled[node_at[place + 2 * step]], sign, &arms[axis]);
    }
    exact_add_cross(&arms[1], &arms[2], &cross);
    exact_add_dot(&arms[0], &cross, &value);
    if (!value.lost && expansion_sign(&value) <= 0)
      return corner;
  }
  return -1;
}

/** de Casteljau at 1/2 along one axis, the upper half in place. */
static void bisect(expansion *values, box_place *place, expansion *low, box_place *low_place) {
  int axis = box_axis(place), stride = strides[axis], across = strides[(axis + 1) % 3],
      along = strides[(axis + 2) % 3];
  for (int i = 0; i < 6; i++)
    for (int j = 0; j < 6; j++) {
      expansion *high = values + i * across + j * along;
      expansion *to = low + i * across + j * along;
      for (int level = 0; level < 6; level++) {
        to[level * stride] = high[0];
        for (int k = 0; k < 5 - level; k++) {
          expansion sum = expansion_sum(&high[k * stride], &high[(k + 1) * stride]);
          high[k * stride] = expansion_scaled(&sum, 0.5);
        }
      }
    }
  box_place whole = *place;
  box_halve(&whole, low_place, place);
}

jacobian_sign prove_curved_jacobian_exactly(double nodes[20][3], void *memory, double witness[3]) {
  exact_room *room = memory;
  double scaled[20][3];
  memcpy(scaled, nodes, sizeof scaled);
  if (!exact_scale(scaled, 20))
    return JACOBIAN_UNDECIDED;
  make_controls(scaled, room->controls);
  for (int axis = 0; axis < 3; axis++)
    derive(room->controls, axis, room->derivatives[axis]);
  make_coefficients(room);
  room->places[0] = (box_place){0};
  exact_boxes boxes = {.values = room->values,
                       .places = room->places,
                       .coefficients = COEFFICIENTS,
                       .corners = serendipity_corners,
                       .open = MAX_OPEN,
                       .deepest = MAX_DEPTH,
                       .most = MAX_BOXES,
                       .halve = bisect};
  return prove_by_bisection(&boxes, witness);
}
