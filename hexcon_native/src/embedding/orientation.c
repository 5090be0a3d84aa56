/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "orientation.h"

#include "ball.h"
#include "base/expansion.h"

static expansion minor_of(const expansion a[3], const expansion b[3], int j, int k) {
  expansion plus = expansion_product(&a[j], &b[k]), minus = expansion_product(&a[k], &b[j]);
  minus = expansion_scaled(&minus, -1);
  return expansion_sum(&plus, &minus);
}

static int sign_of(const expansion *value) {
  return value->lost ? ORIENTATION_LOST : expansion_sign(value);
}

static int exact_in_space(const double *a, const double *b, const double *c, const double *d) {
  expansion edges[3][3], sum = {0};
  for (int k = 0; k < 3; k++) {
    edges[0][k] = expansion_difference(b[k], a[k]);
    edges[1][k] = expansion_difference(c[k], a[k]);
    edges[2][k] = expansion_difference(d[k], a[k]);
  }
  for (int k = 0; k < 3; k++) {
    expansion minor = minor_of(edges[1], edges[2], (k + 1) % 3, (k + 2) % 3);
    minor = expansion_product(&edges[0][k], &minor);
    sum = expansion_sum(&sum, &minor);
  }
  return sign_of(&sum);
}

int orientation_in_space(const double a[3], const double b[3], const double c[3],
                         const double d[3]) {
  ball edges[3][3];
  for (int k = 0; k < 3; k++) {
    edges[0][k] = ball_difference(b[k], a[k]);
    edges[1][k] = ball_difference(c[k], a[k]);
    edges[2][k] = ball_difference(d[k], a[k]);
  }
  int sign = ball_sign(ball_determinant(edges[0], edges[1], edges[2]));
  return sign ? sign : exact_in_space(a, b, c, d);
}

int orientation_along(int axis, const double a[3], const double b[3], const double c[3]) {
  int j = (axis + 1) % 3, k = (axis + 2) % 3;
  ball x = ball_multiply(ball_difference(b[j], a[j]), ball_difference(c[k], a[k]));
  ball y = ball_multiply(ball_difference(b[k], a[k]), ball_difference(c[j], a[j]));
  int sign = ball_sign(ball_subtract(x, y));
  if (sign)
    return sign;
  expansion edges[2][3];
  for (int i = 0; i < 3; i++) {
    edges[0][i] = expansion_difference(b[i], a[i]);
    edges[1][i] = expansion_difference(c[i], a[i]);
  }
  expansion value = minor_of(edges[0], edges[1], j, k);
  return sign_of(&value);
}
