/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "box_place.h"

#include <math.h>
#include <stdbool.h>

static double width_along(const box_place *place, int axis) {
  return ldexp(1, -((place->depth + 2 - axis) / 3));
}

int box_axis(const box_place *place) {
  return place->depth % 3;
}

void box_halve(const box_place *place, box_place *low, box_place *high) {
  int axis = box_axis(place);
  double half = width_along(place, axis) / 2;
  *low = *high = *place;
  high->low[axis] += half;
  low->depth = ++high->depth;
}

void box_corner_point(const box_place *place, int corner, double point[3]) {
  for (int axis = 0; axis < 3; axis++) {
    bool far = corner >> (2 - axis) & 1;
    point[axis] = place->low[axis] + (far ? width_along(place, axis) : 0);
  }
}
