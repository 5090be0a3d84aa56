/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "ellipse.h"

#include <math.h>

/** The root t >= -1 of (r z0 / (t + r))^2 + (z1 / (t + 1))^2 = 1, the scaled equation (14) of the
 * paper, with r = (longer / shorter)^2; both z >= 0, z1 > 0. The function falls throughout. */
static double find_root(double ratio, const double z[2]) {
  double scaled = ratio * z[0], low = z[1] - 1, high = hypot(scaled, z[1]) - 1;
  for (int i = 0; i < 200 && low < high; i++) {
    double t = low + (high - low) / 2, a = scaled / (t + ratio), b = z[1] / (t + 1);
    double excess = a * a + b * b - 1;
    if (t == low || t == high || excess == 0)
      return t;
    *(excess > 0 ? &low : &high) = t;
  }
  return low;
}

void ellipse_nearest(const double half_axes[2], const double point[2], double angle[2]) {
  int longer = half_axes[0] >= half_axes[1] ? 0 : 1, shorter = 1 - longer;
  const double a = half_axes[longer], b = half_axes[shorter];
  const double x = fabs(point[longer]), y = fabs(point[shorter]), ratio = (a / b) * (a / b);
  double cosine, sine;
  if (y > 0) {
    const double z[2] = {x / a, y / b};
    double t = find_root(ratio, z);
    cosine = ratio * z[0] / (t + ratio);
    sine = z[1] / (t + 1);
  } else { /* on the longer axis, or, if the ellipse is a circle, at its centre */
    double denominator = a * a - b * b, numerator = a * x;
    cosine = denominator > 0 ? fmin(numerator / denominator, 1) : 1;
    sine = sqrt(fmax(1 - cosine * cosine, 0));
  }
  double length = hypot(cosine, sine);
  angle[longer] = copysign(cosine / length, point[longer]);
  angle[shorter] = copysign(sine / length, point[shorter]);
}
