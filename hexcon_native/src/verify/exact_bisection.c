/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "exact_bisection.h"

#include <float.h>
#include <math.h>

void exact_add_dot(const exact_vector *a, const exact_vector *b, expansion *sum) {
  for (int i = 0; i < 3; i++) {
    expansion product = expansion_product(&a->x[i], &b->x[i]);
    *sum = expansion_sum(sum, &product);
  }
}

void exact_add_cross(const exact_vector *a, const exact_vector *b, exact_vector *sum) {
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    expansion plus = expansion_product(&a->x[j], &b->x[k]);
    expansion minus = expansion_product(&a->x[k], &b->x[j]);
    minus = expansion_scaled(&minus, -1);
    plus = expansion_sum(&plus, &minus);
    sum->x[i] = expansion_sum(&sum->x[i], &plus);
  }
}

/** What brings the largest difference of coordinates along an axis near 1. */
static double scale_along(double (*nodes)[3], size_t count, int axis) {
  double lowest = INFINITY, highest = -INFINITY;
  for (size_t n = 0; n < count; n++) { /* halves, as the difference may overflow */
    lowest = fmin(lowest, nodes[n][axis] / 2);
    highest = fmax(highest, nodes[n][axis] / 2);
  }
  int exponent = 0; /* frexp leaves it if there is infinity or no number */
  (void)frexp(highest - lowest, &exponent);
  return ldexp(1, exponent < -1000 ? 1000 : -1 - exponent);
}

bool exact_scale(double (*nodes)[3], size_t count) {
  bool exact = true;
  for (int axis = 0; axis < 3; axis++) {
    const double scale = scale_along(nodes, count, axis);
    for (size_t n = 0; n < count; n++) {
      const double given = nodes[n][axis], scaled = given * scale;
      exact &= isfinite(scaled) && (given == 0 || fabs(scaled) >= DBL_MIN);
      nodes[n][axis] = scaled;
    }
  }
  return exact;
}

static bool is_lost(const exact_boxes *b, const expansion *values) {
  bool lost = false;
  for (int i = 0; i < b->coefficients; i++)
    lost |= values[i].lost;
  return lost;
}

static bool all_positive(const exact_boxes *b, const expansion *values) {
  for (int i = 0; i < b->coefficients; i++)
    if (expansion_sign(&values[i]) <= 0)
      return false;
  return true;
}

/** A corner that is not positive, by its place in corners; -1 if there is none. */
static int nonpositive_corner(const exact_boxes *b, const expansion *values) {
  for (int i = 0; i < 8; i++)
    if (expansion_sign(&values[b->corners[i]]) <= 0)
      return i;
  return -1;
}

jacobian_sign prove_by_bisection(exact_boxes *b, double witness[3]) {
  int top = 1;
  for (int boxes = 0; top > 0; boxes++) {
    expansion *values = b->values + (size_t)(top - 1) * (size_t)b->coefficients;
    box_place *place = &b->places[top - 1];
    if (boxes == b->most || is_lost(b, values))
      return JACOBIAN_UNDECIDED;
    int corner = nonpositive_corner(b, values);
    if (corner >= 0) {
      box_corner_point(place, corner, witness);
      return JACOBIAN_NONPOSITIVE;
    }
    if (all_positive(b, values)) {
      top--;
    } else if (place->depth == b->deepest || top == b->open) {
      return JACOBIAN_UNDECIDED;
    } else {
      b->halve(values, place, values + b->coefficients, place + 1);
      top++;
    }
  }
  return JACOBIAN_POSITIVE;
}
