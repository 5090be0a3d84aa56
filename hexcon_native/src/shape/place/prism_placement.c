/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "prism_placement.h"

#include <math.h>

enum { HEXAGON = 6 };

void prism_weights(const double corners[12][3], const double place[3], double weights[12]) {
  double tangents[HEXAGON], sum = 0;
  for (int i = 0; i < HEXAGON; i++) { /* of half the angles under which the sides are seen */
    const double *a = corners[i], *b = corners[(i + 1) % HEXAGON];
    double ax = a[0] - place[0], ay = a[1] - place[1], bx = b[0] - place[0], by = b[1] - place[1];
    tangents[i] = tan(0.5 * atan2(ax * by - ay * bx, ax * bx + ay * by));
  }
  for (int i = 0; i < HEXAGON; i++) {
    double distance = hypot(corners[i][0] - place[0], corners[i][1] - place[1]);
    weights[i] = (tangents[(i + HEXAGON - 1) % HEXAGON] + tangents[i]) / distance;
    sum += weights[i];
  }
  double low = (place[2] - corners[0][2]) / (corners[HEXAGON][2] - corners[0][2]);
  for (int i = 0; i < HEXAGON; i++) {
    double weight = weights[i] / sum;
    weights[i] = weight * (1 - low);
    weights[HEXAGON + i] = weight * low;
  }
}
