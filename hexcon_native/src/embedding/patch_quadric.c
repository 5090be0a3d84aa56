/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "patch_quadric.h"

void patch_quadric_set(patch_quadric *quadric, const patch *of, const patch *other) {
  ball e[3], f[3], twist[3], from[3];
  patch_twist(of, twist);
  for (int k = 0; k < 3; k++) {
    e[k] = of->sides[0][k];
    f[k] = ball_negated(of->sides[3][k]);
  }
  quadric->volume = ball_determinant(e, f, twist);
  for (int corner = 0; corner < 4; corner++) {
    for (int k = 0; k < 3; k++)
      from[k] = ball_subtract(other->corners[corner][k], of->corners[0][k]);
    quadric->u[corner] = ball_determinant(from, f, twist);
    quadric->w[corner] = ball_determinant(e, from, twist);
    quadric->z[corner] = ball_determinant(e, f, from);
  }
}

static ball between(ball a, ball b, double t) {
  return ball_add(ball_scaled(a, 1 - t), ball_scaled(b, t));
}

/** A function that is bilinear on the patch, at the corners of a cell: [along u][along v]. */
static void restrict_to(const ball values[4], const cell *c, ball at[2][2]) {
  for (int i = 0; i < 2; i++) {
    double u = ldexp(c->i + i, -c->depth);
    ball low = between(values[0], values[1], u), high = between(values[3], values[2], u);
    for (int j = 0; j < 2; j++)
      at[i][j] = between(low, high, ldexp(c->j + j, -c->depth));
  }
}

/** Coefficient (i, j) of the product of two bilinear functions, times the ways to get there. */
static ball product_coefficient(ball a[2][2], ball b[2][2], int i, int j) {
  ball sum = {0, 0};
  for (int k = i / 2; k <= (i + 1) / 2; k++)
    for (int l = j / 2; l <= (j + 1) / 2; l++)
      sum = ball_add(sum, ball_multiply(a[k][l], b[i - k][j - l]));
  return sum;
}

/** The same of one bilinear function, raised in degree. */
static ball raised_coefficient(ball a[2][2], int i, int j) {
  ball sum = {0, 0};
  for (int k = i / 2; k <= (i + 1) / 2; k++)
    for (int l = j / 2; l <= (j + 1) / 2; l++)
      sum = ball_add(sum, a[k][l]);
  return sum;
}

/** Whether coefficient (i, j) belongs to a shared corner, or to the middle of a shared side. */
static bool is_shared(const bool corners[4], const bool sides[4], int i, int j) {
  for (int corner = 0; corner < 4; corner++) {
    const int32_t *here = cell_corner_steps[corner], *next = cell_corner_steps[(corner + 1) & 3];
    if ((corners[corner] && i == 2 * here[0] && j == 2 * here[1]) ||
        (sides[corner] && i == here[0] + next[0] && j == here[1] + next[1]))
      return true;
  }
  return false;
}

bool patch_quadric_clears(const patch_quadric *quadric, const cell *other, const bool corners[4],
                          const bool sides[4]) {
  ball u[2][2], w[2][2], z[2][2];
  int sign = 0;
  restrict_to(quadric->u, other, u);
  restrict_to(quadric->w, other, w);
  restrict_to(quadric->z, other, z);
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) {
      if (is_shared(corners, sides, i, j))
        continue;
      ball curved = ball_multiply(quadric->volume, raised_coefficient(z, i, j));
      int here = ball_sign(ball_subtract(product_coefficient(u, w, i, j), curved));
      if (here == 0 || here == -sign)
        return false;
      sign = here;
    }
  return true;
}
