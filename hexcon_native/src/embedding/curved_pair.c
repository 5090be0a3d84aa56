/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * The proofs look at differences. Along a straight line between two places of a cell its
 * derivatives stay in the hulls of their control points, differences of neighbours; so what two
 * places differ by is a sum of multiples, none negative, of vectors from those hulls and their
 * negatives. Where along some direction all of these go forward no such sum vanishes.
 */
#include "curved_pair.h"

#include <string.h>

#include "cell_search.h"
#include "cell_sharing.h"
#include "curved_patch.h"
#include "hulls.h"
#include "patch_crossing.h"

typedef struct curved_pair {
  curved_patch a, b;
  patch straight_a, straight_b; /* on the corners; set if joint */
  int partner[4];               /* of each corner of a: the same corner in b, or -1 */
  bool joint, itself;           /* itself: b is a */
} curved_pair;

typedef ball control_points[CURVED_CONTROLS][3];

static void difference(const ball a[3], const ball b[3], double sign, ball out[3]) {
  for (int k = 0; k < 3; k++) {
    out[k] = ball_subtract(a[k], b[k]);
    if (sign < 0)
      out[k] = ball_negated(out[k]);
  }
}

/** From a shared corner the one cell lies in the cone of its control points, the other one too. */
static bool corners_part(control_points a, int corner_a, control_points b, int corner_b) {
  ball vectors[2 * CURVED_CONTROLS - 2][3];
  const int at_a = curved_corner_place(corner_a), at_b = curved_corner_place(corner_b);
  int count = 0;
  for (int n = 0; n < CURVED_CONTROLS; n++) {
    if (n != at_a)
      difference(a[n], a[at_a], 1, vectors[count++]);
    if (n != at_b)
      difference(b[n], b[at_b], -1, vectors[count++]);
  }
  return all_forward(vectors, count);
}

/** The derivative along the first parameter on a side, up to a factor: 2 vectors. */
static void derive_along(control_points c, double sign, ball out[2][3]) {
  for (int i = 0; i < 2; i++)
    difference(c[3 * (i + 1)], c[3 * i], sign, out[i]);
}

/** (c(t, w) - c(t, 0)) / w: of degree 2 in t and 1 in w; 6 vectors, up to factors. */
static void derive_inwards(control_points c, double sign, ball out[6][3]) {
  for (int i = 0; i < 3; i++)
    for (int j = 1; j < 3; j++)
      difference(c[3 * i + j], c[3 * i], sign, out[2 * i + j - 1]);
}

/** They share a side, from which both are seen: a place of the one less a place of the other is a
 * multiple of the side's derivative, w times a vector into a, less w' times one into b. */
static bool sides_part(control_points a, control_points b) {
  ball vectors[14][3];
  derive_inwards(a, 1, vectors + 2);
  derive_inwards(b, -1, vectors + 8);
  for (int sign = -1; sign <= 1; sign += 2) {
    derive_along(a, sign, vectors);
    if (!all_forward(vectors, 14))
      return false;
  }
  return true;
}

/** (c(u, v) - c(u, 0) - c(0, v) + c(0, 0)) / (u v): of degree 1 in each; 4 vectors, up to factors.
 */
static void derive_twist(control_points c, double sign, ball out[4][3]) {
  for (int i = 1; i < 3; i++)
    for (int j = 1; j < 3; j++) {
      ball far[3], near[3];
      difference(c[3 * i + j], c[3 * i], 1, far);
      difference(c[j], c[0], 1, near);
      difference(far, near, sign, out[2 * (i - 1) + j - 1]);
    }
}

/** They share the two sides at a corner, from which both are seen. */
static bool two_sides_part(control_points a, control_points b) {
  ball vectors[12][3], across[CURVED_CONTROLS][3];
  derive_twist(a, 1, vectors + 4);
  derive_twist(b, -1, vectors + 8);
  for (int n = 0; n < CURVED_CONTROLS; n++)
    memcpy(across[n], a[3 * (n % 3) + n / 3], sizeof across[n]);
  for (int signs = 0; signs < 4; signs++) {
    derive_along(a, signs & 1 ? 1 : -1, vectors);
    derive_along(across, signs & 2 ? 1 : -1, vectors + 2);
    if (!all_forward(vectors, 12))
      return false;
  }
  return true;
}

/** No place of the cell twice: what two of its places differ by are multiples of both derivatives.
 */
static bool cell_is_simple(control_points c) {
  ball vectors[12][3];
  for (int sign = -1; sign <= 1; sign += 2) {
    for (int i = 0; i < 2; i++)
      for (int j = 0; j < 3; j++) {
        difference(c[3 * (i + 1) + j], c[3 * i + j], 1, vectors[3 * i + j]);
        difference(c[3 * j + i + 1], c[3 * j + i], sign, vectors[6 + 3 * i + j]);
      }
    if (!all_forward(vectors, 12))
      return false;
  }
  return true;
}

/** The three control points of a side. */
static void side_controls(control_points c, int side, ball out[3][3]) {
  const int start = curved_corner_place(side), end = curved_corner_place((side + 1) & 3);
  memcpy(out[0], c[start], sizeof out[0]);
  memcpy(out[1], c[(start + end) / 2], sizeof out[1]);
  memcpy(out[2], c[end], sizeof out[2]);
}

/** Of the curve at 5/16 of the first parameter. */
static void inner_curve(control_points c, ball out[3][3]) {
  static const double at = 0.3125, weights[3] = {(1 - at) * (1 - at), 2 * at * (1 - at), at * at};
  for (int j = 0; j < 3; j++)
    for (int k = 0; k < 3; k++) {
      ball sum = ball_add(ball_scaled(c[j][k], weights[0]), ball_scaled(c[3 + j][k], weights[1]));
      out[j][k] = ball_add(sum, ball_scaled(c[6 + j][k], weights[2]));
    }
}

/**
 * A curve passes through a cell. While both become straight the curve's ends stay off the cell, and
 * the curve off the cell's rim, so that the number of crossings stays odd or even; of the segment
 * with the bilinear patch it is odd.
 */
static bool curve_crosses(ball curve[3][3], control_points c) {
  ball rim[3][3], corners[4][3];
  for (int end = 0; end < 3; end += 2) {
    const hull_pair hulls = {curve + end, c, 1, CURVED_CONTROLS};
    if (!plane_parts(&hulls, 1))
      return false;
  }
  for (int side = 0; side < 4; side++) {
    side_controls(c, side, rim);
    memcpy(corners[side], rim[0], sizeof corners[side]);
    const hull_pair hulls = {curve, rim, 3, 3};
    if (!plane_parts(&hulls, 1))
      return false;
  }
  return segment_crosses_patch(curve[0], curve[2], corners);
}

/** A side of a cell, or a curve between opposite sides, passes through another cell. Curves
 * between, because sides of cells of two like patches may cross in one place. */
static bool curves_cross(control_points a, control_points b) {
  ball curve[3][3], turned[CURVED_CONTROLS][3];
  for (int side = 0; side < 4; side++) {
    side_controls(a, side, curve);
    if (curve_crosses(curve, b))
      return true;
  }
  inner_curve(a, curve);
  if (curve_crosses(curve, b))
    return true;
  curved_controls_from(a, 0, 3, turned);
  inner_curve(turned, curve);
  return curve_crosses(curve, b);
}

static meeting judge_distinct(const curved_pair *p, const cells *c, control_points a,
                              control_points b) {
  ball straight_a[4][3], straight_b[4][3];
  hull_pair hulls[HULL_PAIRS] = {{a, b, CURVED_CONTROLS, CURVED_CONTROLS},
                                 {straight_a, straight_b, 4, 4}};
  if (p->joint) {
    cell_corners(&p->straight_a, &c->a, straight_a);
    cell_corners(&p->straight_b, &c->b, straight_b);
  } else if (boxes_part(hulls)) {
    return MEETING_NONE;
  }
  if (plane_parts(hulls, p->joint ? 2 : 1))
    return MEETING_NONE;
  return curves_cross(a, b) || curves_cross(b, a) ? MEETING_PROVED : MEETING_OPEN;
}

static bool neighbours_part(const shared *s, control_points a, control_points b) {
  control_points from_a, from_b;
  if (s->count == 1)
    return corners_part(a, s->a[0], b, s->b[0]);
  int middle = s->count == 3 ? shared_middle(s) : 0, next = s->count == 3 ? (middle + 1) % 3 : 1;
  if (middle < 0 || cell_side_of(s->a[middle], s->a[next]) < 0 ||
      cell_side_of(s->b[middle], s->b[next]) < 0)
    return false;
  curved_controls_from(a, s->a[middle], s->a[next], from_a);
  curved_controls_from(b, s->b[middle], s->b[next], from_b);
  return s->count == 2 ? sides_part(from_a, from_b) : two_sides_part(from_a, from_b);
}

static meeting judge(void *pair, const cells *c) {
  const curved_pair *p = pair;
  control_points a, b;
  shared s;
  curved_cell_controls(&p->a, &c->a, a);
  if (p->itself && cells_are_same(c))
    return cell_is_simple(a) ? MEETING_NONE : MEETING_OPEN;
  curved_cell_controls(&p->b, &c->b, b);
  if (p->itself)
    shared_find_within(&c->a, &c->b, &s);
  else
    shared_find(p->partner, &c->a, &c->b, &s);
  if (s.count == 0)
    return judge_distinct(p, c, a, b);
  return s.count < 4 && neighbours_part(&s, a, b) ? MEETING_NONE : MEETING_OPEN;
}

static void nodes_of(const double *points, const int32_t ids[8], const double *nodes[8]) {
  for (int n = 0; n < 8; n++)
    nodes[n] = points + 3 * (size_t)ids[n];
}

meeting curved_patches_meet(const double *points, const int32_t a[8], const int32_t b[8],
                            bool joint, int patience) {
  curved_pair p = {.joint = joint};
  const double *nodes_a[8], *nodes_b[8], *origin = points + 3 * (size_t)a[0];
  nodes_of(points, a, nodes_a);
  nodes_of(points, b, nodes_b);
  for (int i = 0; i < 4; i++) {
    p.partner[i] = shared_partner(a[i], b);
    if (p.partner[i] >= 0)
      origin = nodes_a[i];
  }
  curved_patch_set(&p.a, nodes_a, origin);
  curved_patch_set(&p.b, nodes_b, origin);
  if (joint) {
    patch_set(&p.straight_a, nodes_a, origin);
    patch_set(&p.straight_b, nodes_b, origin);
  }
  return cell_search(judge, &p, p.itself, patience);
}

meeting curved_patch_meets_itself(const double *points, const int32_t ids[8], int patience) {
  curved_pair p = {.itself = true};
  const double *nodes[8];
  nodes_of(points, ids, nodes);
  curved_patch_set(&p.a, nodes, nodes[0]);
  p.b = p.a;
  return cell_search(judge, &p, p.itself, patience);
}
