/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "patch_crossing.h"

#include "base/vector.h"

static void middle(const ball a[3], double out[3]) {
  for (int k = 0; k < 3; k++)
    out[k] = a[k].mid;
}

/** Whether the ends lie on either side of a slab that holds the corners. */
static bool slab_parts(const ball a[3], const ball b[3], ball corners[4][3]) {
  double places[4][3], diagonals[2][3], normal[3], low = INFINITY, high = -INFINITY;
  for (int c = 0; c < 4; c++)
    middle(corners[c], places[c]);
  vector_subtract(places[2], places[0], diagonals[0]);
  vector_subtract(places[3], places[1], diagonals[1]);
  vector_cross(diagonals[0], diagonals[1], normal);
  for (int c = 0; c < 4; c++) {
    ball height = ball_dot_exact(normal, corners[c]);
    low = fmin(low, ball_low(height));
    high = fmax(high, ball_high(height));
  }
  ball first = ball_dot_exact(normal, a), second = ball_dot_exact(normal, b);
  return (ball_high(first) < low && ball_low(second) > high) ||
         (ball_high(second) < low && ball_low(first) > high);
}

/** The side on which the line from a to b passes the line from p to q; 0: not certain. */
static int passes(const ball a[3], const ball b[3], const ball p[3], const ball q[3]) {
  ball along[3], to_p[3], to_q[3];
  for (int k = 0; k < 3; k++) {
    along[k] = ball_subtract(b[k], a[k]);
    to_p[k] = ball_subtract(p[k], a[k]);
    to_q[k] = ball_subtract(q[k], a[k]);
  }
  return ball_sign(ball_determinant(along, to_p, to_q));
}

/** 1: the line goes through the triangle; 0: it does not; -1: not certain. */
static int goes_through(int x, int y, int z) {
  if (x && x == y && y == z)
    return 1;
  return x * y < 0 || y * z < 0 || z * x < 0 ? 0 : -1;
}

bool segment_crosses_patch(const ball a[3], const ball b[3], ball corners[4][3]) {
  if (!slab_parts(a, b, corners))
    return false;
  int sides[4];
  for (int i = 0; i < 4; i++)
    sides[i] = passes(a, b, corners[i], corners[(i + 1) & 3]);
  for (int i = 0; i < 2; i++) {
    int diagonal = passes(a, b, corners[i], corners[i + 2]);
    int one = goes_through(sides[i], sides[i + 1], -diagonal);
    int other = goes_through(sides[i + 2], sides[(i + 3) & 3], diagonal);
    if (one >= 0 && other >= 0 && one + other == 1)
      return true;
  }
  return false;
}
