/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "patch_cell.h"

void patch_set(patch *p, const double *const corners[4], const double origin[3]) {
  for (int c = 0; c < 4; c++)
    for (int k = 0; k < 3; k++) {
      p->corners[c][k] = ball_difference(corners[c][k], origin[k]);
      p->sides[c][k] = ball_difference(corners[(c + 1) & 3][k], corners[c][k]);
    }
}

/** (1 - t) a + t b, for a dyadic t of few bits. */
static void interpolate(const ball a[3], const ball b[3], double t, ball out[3]) {
  for (int k = 0; k < 3; k++)
    out[k] = t == 0   ? a[k]
             : t == 1 ? b[k]
                      : ball_add(ball_scaled(a[k], 1 - t), ball_scaled(b[k], t));
}

static void negate(const ball a[3], ball out[3]) {
  for (int k = 0; k < 3; k++)
    out[k] = ball_negated(a[k]);
}

/** The derivative along the first (axis 0) or second parameter, which depends on the other one. */
static void derivative(const patch *p, int axis, double other, ball out[3]) {
  ball reversed[3];
  negate(p->sides[axis == 0 ? 2 : 3], reversed);
  if (axis == 0)
    interpolate(p->sides[0], reversed, other, out);
  else
    interpolate(reversed, p->sides[1], other, out);
}

static void corner_parameters(const cell *c, int corner, double parameters[2]) {
  parameters[0] = ldexp(c->i + cell_corner_steps[corner][0], -c->depth);
  parameters[1] = ldexp(c->j + cell_corner_steps[corner][1], -c->depth);
}

void cell_corners(const patch *p, const cell *c, ball corners[4][3]) {
  for (int corner = 0; corner < 4; corner++) {
    double at[2];
    ball low[3], high[3];
    corner_parameters(c, corner, at);
    interpolate(p->corners[0], p->corners[1], at[0], low);
    interpolate(p->corners[3], p->corners[2], at[0], high);
    interpolate(low, high, at[1], corners[corner]);
  }
}

/** From corner `from` towards the next or the previous one `to`, at the place of `at`. */
static void step(const patch *p, const cell *c, int from, int to, int at, ball out[3]) {
  double parameters[2];
  int axis = cell_corner_steps[from][0] == cell_corner_steps[to][0] ? 1 : 0;
  corner_parameters(c, at, parameters);
  derivative(p, axis, parameters[1 - axis], out);
  if (cell_corner_steps[from][axis] > cell_corner_steps[to][axis])
    negate(out, out);
}

void cell_cone(const patch *p, const cell *c, int corner, ball arms[3][3]) {
  int next = (corner + 1) & 3, last = (corner + 3) & 3;
  ball onwards[3];
  step(p, c, corner, next, corner, arms[0]);
  step(p, c, corner, last, corner, arms[1]);
  step(p, c, corner, last, next, onwards);
  for (int k = 0; k < 3; k++)
    arms[2][k] = ball_add(arms[0][k], onwards[k]);
}

void cell_rulings(const patch *p, const cell *c, int side, ball along[3], ball inwards[2][3]) {
  int end = (side + 1) & 3;
  step(p, c, side, end, side, along);
  step(p, c, side, (side + 3) & 3, side, inwards[0]);
  step(p, c, end, (end + 1) & 3, end, inwards[1]);
}

void patch_twist(const patch *p, ball twist[3]) {
  for (int k = 0; k < 3; k++)
    twist[k] = ball_negated(ball_add(p->sides[0][k], p->sides[2][k]));
}
