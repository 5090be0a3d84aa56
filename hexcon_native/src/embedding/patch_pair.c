/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "patch_pair.h"

#include <string.h>

#include "base/vector.h"
#include "patch_crossing.h"
#include "patch_neighbours.h"
#include "patch_quadric.h"
#include "separation.h"

enum { CHILDREN = 16, MAX_WAITING = CHILDREN * (CELL_MAX_DEPTH + 1) };

typedef struct pair {
  patch a, b;
  patch_quadric a_seen_by_b, b_seen_by_a;
  int partner[4]; /* of each corner of a: the same corner in b, or -1 */
  bool has_quadrics;
} pair;

typedef struct cells {
  cell a, b;
} cells;

/** Corners that two cells share. */
typedef struct shared {
  int count, a[4], b[4];
} shared;

/* ----------------------------------------------------------------------------- what they share */

static bool is_next(int corner, int other) {
  return ((corner + 1) & 3) == other || ((other + 1) & 3) == corner;
}

/** The place of b's grid that is the same as a place of a's, on a shared corner or side. */
static bool partner_place(const pair *p, int32_t i, int32_t j, int32_t width, int32_t out[2]) {
  for (int from = 0; from < 4; from++) {
    int to = (from + 1) & 3;
    const int32_t *start = cell_corner_steps[from], *end = cell_corner_steps[to];
    int axis = start[0] == end[0] ? 1 : 0;
    int32_t here[2] = {i, j};
    if (p->partner[from] < 0 || here[1 - axis] != width * start[1 - axis])
      continue;
    int32_t passed = start[axis] < end[axis] ? here[axis] : width - here[axis];
    bool side = p->partner[to] >= 0 && is_next(p->partner[from], p->partner[to]);
    if (passed != 0 && !side)
      continue;
    const int32_t *first = cell_corner_steps[p->partner[from]];
    const int32_t *second = passed ? cell_corner_steps[p->partner[to]] : first;
    for (int k = 0; k < 2; k++)
      out[k] = first[k] * (width - passed) + second[k] * passed;
    return true;
  }
  return false;
}

static void find_shared(const pair *p, const cells *c, shared *out) {
  const int32_t width = (int32_t)1 << c->a.depth;
  out->count = 0;
  for (int corner = 0; corner < 4; corner++) {
    int32_t place[2];
    if (!partner_place(p, c->a.i + cell_corner_steps[corner][0],
                       c->a.j + cell_corner_steps[corner][1], width, place))
      continue;
    for (int other = 0; other < 4; other++)
      if (place[0] == c->b.i + cell_corner_steps[other][0] &&
          place[1] == c->b.j + cell_corner_steps[other][1]) {
        out->a[out->count] = corner;
        out->b[out->count++] = other;
      }
  }
}

/* ---------------------------------------------------------------------------- cells that are apart
 */

static bool boxes_part(ball a[4][3], ball b[4][3]) {
  for (int k = 0; k < 3; k++) {
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int c = 0; c < 4; c++) {
      low[0] = fmin(low[0], ball_low(a[c][k]));
      low[1] = fmin(low[1], ball_low(b[c][k]));
      high[0] = fmax(high[0], ball_high(a[c][k]));
      high[1] = fmax(high[1], ball_high(b[c][k]));
    }
    if (high[0] < low[1] || high[1] < low[0])
      return true;
  }
  return false;
}

static bool plane_parts(ball a[4][3], ball b[4][3]) {
  double vectors[16][3], normal[3], most = -INFINITY, least = INFINITY;
  for (int i = 0; i < 16; i++)
    for (int k = 0; k < 3; k++)
      vectors[i][k] = b[i / 4][k].mid - a[i % 4][k].mid;
  if (!separation_direction((const double(*)[3])vectors, 16, normal))
    return false;
  for (int c = 0; c < 4; c++) {
    most = fmax(most, ball_high(ball_dot_exact(normal, a[c])));
    least = fmin(least, ball_low(ball_dot_exact(normal, b[c])));
  }
  return most < least;
}

/** The side that two of a cell's corners end; -1 if they are opposite. */
static int side_of(int corner, int other) {
  if (((corner + 1) & 3) == other)
    return corner;
  return ((other + 1) & 3) == corner ? other : -1;
}

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
      int side_a = side_of(s->a[i], s->a[j]), side_b = side_of(s->b[i], s->b[j]);
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
  if (boxes_part(a, b) || plane_parts(a, b) || quadrics_part(p, c, none))
    return MEETING_NONE;
  return lines_cross(a, b) || lines_cross(b, a) ? MEETING_PROVED : MEETING_OPEN;
}

/* ------------------------------------------------------------------------------------- recursion
 */

/** Of three corners, given by their indices, the one whose neighbours the others are. */
static int middle_of_three(const shared *s) {
  for (int i = 0; i < 3; i++)
    if (is_next(s->a[i], s->a[(i + 1) % 3]) && is_next(s->a[i], s->a[(i + 2) % 3]))
      return i;
  return -1;
}

static meeting judge(pair *p, const cells *c) {
  shared s;
  find_shared(p, c, &s);
  placed_cell a = {&p->a, c->a}, b = {&p->b, c->b};
  bool parted = false;
  if (s.count == 0)
    return judge_distinct(p, c, &s);
  if (s.count == 4)
    return MEETING_PROVED;
  if (s.count == 1)
    parted = corner_parts(&a, s.a[0], &b, s.b[0]);
  if (s.count == 2) {
    int side_a = side_of(s.a[0], s.a[1]), side_b = side_of(s.b[0], s.b[1]);
    parted = side_a >= 0 && side_b >= 0 && side_parts(&a, side_a, &b, side_b);
  }
  if (s.count == 3) {
    int middle = middle_of_three(&s);
    parted = middle >= 0 && two_sides_part(&a, s.a[middle], &b, s.b[middle]);
  }
  return parted || quadrics_part(p, c, &s) ? MEETING_NONE : MEETING_OPEN;
}

static cell child_of(const cell *c, int index) {
  return (cell){2 * c->i + (index & 1), 2 * c->j + (index >> 1), c->depth + 1};
}

static meeting search(pair *p, int patience) {
  cells waiting[MAX_WAITING];
  int count = 1;
  waiting[0] = (cells){{0, 0, 0}, {0, 0, 0}};
  meeting found = MEETING_NONE;
  for (int looked_at = 1; count > 0; looked_at++) {
    cells now = waiting[--count];
    meeting here = judge(p, &now);
    if (here == MEETING_PROVED)
      return here;
    if (here == MEETING_NONE)
      continue;
    if (looked_at >= patience)
      return MEETING_OPEN;
    if (now.a.depth == CELL_MAX_DEPTH) {
      found = MEETING_OPEN;
      continue;
    }
    for (int child = 0; child < CHILDREN; child++)
      waiting[count++] = (cells){child_of(&now.a, child & 3), child_of(&now.b, child >> 2)};
  }
  return found;
}

meeting patches_meet(const double *points, const int32_t a[4], const int32_t b[4], int patience) {
  pair p = {.has_quadrics = false};
  const double *corners_a[4], *corners_b[4], *origin = points + 3 * (size_t)a[0];
  for (int i = 0; i < 4; i++) {
    corners_a[i] = points + 3 * (size_t)a[i];
    corners_b[i] = points + 3 * (size_t)b[i];
    p.partner[i] = -1;
    for (int j = 0; j < 4; j++)
      if (a[i] == b[j]) {
        p.partner[i] = j;
        origin = corners_a[i];
      }
  }
  patch_set(&p.a, corners_a, origin);
  patch_set(&p.b, corners_b, origin);
  return search(&p, patience);
}
