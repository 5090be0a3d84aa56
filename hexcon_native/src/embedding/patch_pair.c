/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "patch_pair.h"

#include <string.h>

#include "cell_search.h"
#include "cell_sharing.h"
#include "hulls.h"
#include "patch_crossing.h"
#include "patch_neighbours.h"
#include "patch_quadric.h"

typedef struct pair {
  patch a, b;
  patch_quadric a_seen_by_b, b_seen_by_a;
  int partner[4]; /* of each corner of a: the same corner in b, or -1 */
  bool has_quadrics;
} pair;

/* ---------------------------------------------------------------------------- cells that are apart
 */

/** What of one cell is the other's, too: a side is, if its ends are those of a side there. */
typedef struct shared_parts {
  bool corners[4], sides[4];
} shared_parts;

static void find_parts(const shared *s, shared_parts *a, shared_parts *b) {
  memset(a, 0, sizeof *a);
  memset(b, 0, sizeof *b);
  for (int i = 0; i < s->count; i++) {
    a->corners[s->a[i]] = b->corners[s->b[i]] = true;
    for (int j = 0; j < i; j++) {
      int side_a = cell_side_of(s->a[i], s->a[j]), side_b = cell_side_of(s->b[i], s->b[j]);
      if (side_a >= 0 && side_b >= 0)
        a->sides[side_a] = b->sides[side_b] = true;
    }
  }
}

static bool quadrics_part(pair *p, const cells *c, const shared *s) {
  shared_parts a, b;
  find_parts(s, &a, &b);
  if (!p->has_quadrics) {
    patch_quadric_set(&p->a_seen_by_b, &p->a, &p->b);
    patch_quadric_set(&p->b_seen_by_a, &p->b, &p->a);
    p->has_quadrics = true;
  }
  return patch_quadric_clears(&p->a_seen_by_b, &c->b, b.corners, b.sides) ||
         patch_quadric_clears(&p->b_seen_by_a, &c->a, a.corners, a.sides);
}

/** A place on a side of a cell, which is straight. */
static void place_on_side(ball corners[4][3], int side, ball out[3]) {
  const double t = 0.3125;
  for (int k = 0; k < 3; k++)
    out[k] =
        ball_add(ball_scaled(corners[side][k], 1 - t), ball_scaled(corners[(side + 1) & 3][k], t));
}

/** A side, or a ruling between opposite sides, of the one goes through the other. Rulings, because
 * sides of cells of two like patches may lie exactly over each other. */
static bool lines_cross(ball a[4][3], ball b[4][3]) {
  for (int side = 0; side < 4; side++)
    if (segment_crosses_patch(a[side], a[(side + 1) & 3], b))
      return true;
  for (int side = 0; side < 2; side++) {
    ball reversed[4][3], from[3], to[3];
    for (int c = 0; c < 4; c++)
      memcpy(reversed[c], a[3 - c], sizeof reversed[c]);
    place_on_side(a, side, from);
    place_on_side(reversed, side == 0 ? 0 : 3, to);
    if (segment_crosses_patch(from, to, b))
      return true;
  }
  return false;
}

static meeting judge_distinct(pair *p, const cells *c, const shared *none) {
  ball a[4][3], b[4][3];
  cell_corners(&p->a, &c->a, a);
  cell_corners(&p->b, &c->b, b);
  const hull_pair hulls = {a, b, 4, 4};
  if (boxes_part(&hulls) || plane_parts(&hulls, 1) || quadrics_part(p, c, none))
    return MEETING_NONE;
  return lines_cross(a, b) || lines_cross(b, a) ? MEETING_PROVED : MEETING_OPEN;
}

static meeting judge(void *patches, const cells *c) {
  pair *p = patches;
  shared s;
  shared_find(p->partner, &c->a, &c->b, &s);
  placed_cell a = {&p->a, c->a}, b = {&p->b, c->b};
  bool parted = false;
  if (s.count == 0)
    return judge_distinct(p, c, &s);
  if (s.count == 4)
    return MEETING_PROVED;
  if (s.count == 1)
    parted = corner_parts(&a, s.a[0], &b, s.b[0]);
  if (s.count == 2) {
    int side_a = cell_side_of(s.a[0], s.a[1]), side_b = cell_side_of(s.b[0], s.b[1]);
    parted = side_a >= 0 && side_b >= 0 && side_parts(&a, side_a, &b, side_b);
  }
  if (s.count == 3) {
    int middle = shared_middle(&s);
    parted = middle >= 0 && two_sides_part(&a, s.a[middle], &b, s.b[middle]);
  }
  return parted || quadrics_part(p, c, &s) ? MEETING_NONE : MEETING_OPEN;
}

meeting patches_meet(const double *points, const int32_t a[4], const int32_t b[4], int patience) {
  pair p = {.has_quadrics = false};
  const double *corners_a[4], *corners_b[4], *origin = points + 3 * (size_t)a[0];
  for (int i = 0; i < 4; i++) {
    corners_a[i] = points + 3 * (size_t)a[i];
    corners_b[i] = points + 3 * (size_t)b[i];
    p.partner[i] = shared_partner(a[i], b);
    if (p.partner[i] >= 0)
      origin = corners_a[i];
  }
  patch_set(&p.a, corners_a, origin);
  patch_set(&p.b, corners_b, origin);
  return cell_search(judge, &p, false, patience);
}
