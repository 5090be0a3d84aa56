/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "patch_neighbours.h"

#include "base/vector.h"
#include "hulls.h"
#include "separation.h"

/** Of length 1, turned round if sign is -1. */
static void direction_of(const ball arm[3], double sign, double out[3]) {
  double length = 0;
  for (int k = 0; k < 3; k++)
    length += arm[k].mid * arm[k].mid;
  length = sqrt(length);
  for (int k = 0; k < 3; k++)
    out[k] = length > 0 ? sign * arm[k].mid / length : 0;
}

bool corner_parts(const placed_cell *a, int corner_a, const placed_cell *b, int corner_b) {
  ball arms[6][3];
  cell_cone(a->patch, &a->cell, corner_a, arms);
  cell_cone(b->patch, &b->cell, corner_b, arms + 3);
  for (int i = 3; i < 6; i++)
    for (int k = 0; k < 3; k++)
      arms[i][k] = ball_negated(arms[i][k]);
  return all_forward(arms, 6);
}

/** What is left of a vector across another. */
static void take_across(const double along[3], double vector[3]) {
  double part = vector_dot(along, vector) / vector_dot(along, along);
  vector_add_scaled(vector, -part, along);
}

bool side_parts(const placed_cell *a, int side_a, const placed_cell *b, int side_b) {
  ball along[3], unused[3], inwards[4][3], helper[3];
  double axis[3], vectors[4][3], normal[3], across[3];
  cell_rulings(a->patch, &a->cell, side_a, along, inwards);
  cell_rulings(b->patch, &b->cell, side_b, unused, inwards + 2);
  direction_of(along, 1, axis);
  if (!(vector_dot(axis, axis) > 0))
    return false;
  for (int i = 0; i < 4; i++) {
    direction_of(inwards[i], i < 2 ? 1 : -1, vectors[i]);
    take_across(axis, vectors[i]);
    double length = vector_length(vectors[i]);
    for (int k = 0; k < 3; k++)
      vectors[i][k] = length > 0 ? vectors[i][k] / length : 0;
  }
  if (!separation_direction((const double(*)[3])vectors, 4, normal))
    return false;
  /* a normal that is exactly across the side: the side times the vector `across` */
  vector_cross(normal, axis, across);
  for (int k = 0; k < 3; k++)
    helper[k] = ball_exact(across[k]);
  for (int i = 0; i < 4; i++)
    if (ball_sign(ball_determinant(inwards[i], along, helper)) != (i < 2 ? 1 : -1))
      return false;
  return true;
}

/** A cell at a corner: e and f from it, and the twist there. */
typedef struct corner_form {
  ball e[3], f[3], twist[3];
} corner_form;

static void set_form(const placed_cell *c, int corner, corner_form *form) {
  ball arms[3][3];
  cell_cone(c->patch, &c->cell, corner, arms);
  patch_twist(c->patch, form->twist);
  for (int k = 0; k < 3; k++) {
    form->e[k] = arms[0][k];
    form->f[k] = arms[1][k];
    ball twist = ball_scaled(form->twist[k], ldexp(1, -c->cell.depth));
    form->twist[k] = corner % 2 == 0 ? twist : ball_negated(twist);
  }
}

/**
 * In the basis e, f, e x f let the twists be (p1, p2, p3) of the higher and (q1, q2, q3) of the
 * lower patch, p3 > q3 > 0. Places s e + t f + s t p and u e + v f + u v q are the same only if s t
 * p3 = u v q3, s = u (1 - v G) and t = v (1 - u H), where G = q3 p1 / p3 - q1 and H alike: so only
 * if (1 - v G) (1 - u H) = q3 / p3, unless u v = 0. What is bilinear in u and v is least at a
 * corner of the unit square.
 */
static bool ratio_exceeds(const ball high[3], const ball low[3], ball square) {
  ball bound = ball_multiply(low[2], square), sides[2];
  for (int i = 0; i < 2; i++) {
    ball bend = ball_subtract(ball_multiply(low[2], high[i]), ball_multiply(high[2], low[i]));
    sides[i] = ball_subtract(ball_multiply(high[2], square), bend);
    if (ball_sign(ball_subtract(sides[i], bound)) <= 0)
      return false;
  }
  ball least = ball_multiply(sides[0], sides[1]);
  ball most = ball_multiply(bound, ball_multiply(high[2], square));
  return ball_sign(ball_subtract(least, most)) > 0;
}

/** Components of a twist along e and f, times the square of e x f, and along e x f. */
static void resolve(const corner_form *form, const ball normal[3], const ball twist[3],
                    ball out[3]) {
  out[0] = ball_determinant(twist, form->f, normal);
  out[1] = ball_determinant(form->e, twist, normal);
  out[2] = ball_dot(twist, normal);
}

bool two_sides_part(const placed_cell *a, int corner_a, const placed_cell *b, int corner_b) {
  corner_form one, other;
  ball normal[3], first[3], second[3];
  set_form(a, corner_a, &one);
  set_form(b, corner_b, &other);
  ball_cross(one.e, one.f, normal);
  resolve(&one, normal, one.twist, first);
  resolve(&one, normal, other.twist, second);
  int up = ball_sign(first[2]), down = ball_sign(second[2]);
  if (up == 0 || down == 0)
    return false;
  if (up != down)
    return true;
  if (up < 0) {
    first[2] = ball_negated(first[2]);
    second[2] = ball_negated(second[2]);
  }
  ball square = ball_dot(normal, normal);
  int higher = ball_sign(ball_subtract(first[2], second[2]));
  if (higher == 0)
    return false;
  return higher > 0 ? ratio_exceeds(first, second, square) : ratio_exceeds(second, first, square);
}
