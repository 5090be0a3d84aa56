/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "flat_quads.h"

#include <stdbool.h>

#include "orientation.h"

static meeting meeting_if(bool meet) {
  return meet ? MEETING_PROVED : MEETING_NONE;
}

/* ----------------------------------------------------------------------------------------- forms
 */

/** Turns at the corners seen along an axis, counted by their signs; false if one is lost. */
static bool count_turns(const flat_quad *quad, int axis, int counts[3], int *apex) {
  for (int c = 0; c < 4; c++) {
    int turn = orientation_along(axis, quad->corners[(c + 3) & 3], quad->corners[c],
                                 quad->corners[(c + 1) & 3]);
    if (turn == ORIENTATION_LOST)
      return false;
    counts[turn + 1]++;
    if (turn)
      *apex = c;
  }
  return true;
}

/** A quad with one flat corner still has the Jacobian of its map positive within. */
static quad_form form_in_plane(flat_quad *quad) {
  for (int axis = 0; axis < 3; axis++) {
    int counts[3] = {0, 0, 0};
    if (!count_turns(quad, axis, counts, &quad->apex))
      return QUAD_UNKNOWN;
    if (counts[1] == 4)
      continue;
    quad->axis = axis;
    quad->turn = counts[2] > counts[0] ? 1 : -1;
    return counts[quad->turn + 1] >= 3 && counts[1 - quad->turn] == 0 ? QUAD_CONVEX : QUAD_FOLDED;
  }
  return QUAD_FOLDED;
}

void flat_quad_set(flat_quad *quad, const double *points, const int32_t ids[4]) {
  *quad = (flat_quad){.form = QUAD_WARPED};
  for (int c = 0; c < 4; c++) {
    quad->ids[c] = ids[c];
    quad->corners[c] = points + 3 * (size_t)ids[c];
  }
  int sign =
      orientation_in_space(quad->corners[0], quad->corners[1], quad->corners[2], quad->corners[3]);
  if (sign == ORIENTATION_LOST)
    quad->form = QUAD_UNKNOWN;
  else if (sign == 0)
    quad->form = form_in_plane(quad);
}

/* --------------------------------------------------------------------------- a side and a polygon
 */

/** A segment, with the corners of the polygon that its ends are, or -1. */
typedef struct segment {
  const double *ends[2];
  int corner[2];
} segment;

static int corner_with_id(const flat_quad *quad, int32_t id) {
  for (int c = 0; c < 4; c++)
    if (quad->ids[c] == id)
      return c;
  return -1;
}

/** The side of the polygon's side from corner c on which a point of its plane lies: 1 inside. */
static int within(const flat_quad *quad, int c, const double *place) {
  int sign = orientation_along(quad->axis, quad->corners[c], quad->corners[(c + 1) & 3], place);
  return sign == ORIENTATION_LOST ? sign : sign * quad->turn;
}

/** A point of the plane of the polygon is in it, or on its border. */
static meeting place_meets(const flat_quad *quad, const double *place) {
  bool open = false;
  for (int c = 0; c < 4; c++) {
    int sign = within(quad, c, place);
    if (sign < 0)
      return MEETING_NONE;
    open |= sign == ORIENTATION_LOST;
  }
  return open ? MEETING_OPEN : MEETING_PROVED;
}

static bool overlap_along(const double *const a[2], const double *const b[2], int k) {
  return (a[0][k] <= b[0][k] || a[0][k] <= b[1][k] || a[1][k] <= b[0][k] || a[1][k] <= b[1][k]) &&
         (a[0][k] >= b[0][k] || a[0][k] >= b[1][k] || a[1][k] >= b[0][k] || a[1][k] >= b[1][k]);
}

meeting segments_meet_along(int axis, const double *const a[2], const double *const b[2]) {
  int signs[4] = {
      orientation_along(axis, a[0], a[1], b[0]), orientation_along(axis, a[0], a[1], b[1]),
      orientation_along(axis, b[0], b[1], a[0]), orientation_along(axis, b[0], b[1], a[1])};
  for (int i = 0; i < 4; i++)
    if (signs[i] == ORIENTATION_LOST)
      return MEETING_OPEN;
  if (signs[0] == 0 && signs[1] == 0 && signs[2] == 0 && signs[3] == 0)
    return meeting_if(overlap_along(a, b, (axis + 1) % 3) && overlap_along(a, b, (axis + 2) % 3));
  return meeting_if(signs[0] * signs[1] <= 0 && signs[2] * signs[3] <= 0);
}

/** From a shared corner the segment goes into the polygon, or along one of its sides. */
static meeting enters_at(const flat_quad *quad, int corner, const double *towards) {
  int next = within(quad, corner, towards), last = within(quad, (corner + 3) & 3, towards);
  if (next < 0 || last < 0)
    return MEETING_NONE;
  return next == ORIENTATION_LOST || last == ORIENTATION_LOST ? MEETING_OPEN : MEETING_PROVED;
}

/** A segment in the plane of the polygon. */
static meeting meet_in_plane(const segment *s, const flat_quad *quad) {
  if (s->corner[0] >= 0 && s->corner[1] >= 0)
    return meeting_if(((s->corner[0] - s->corner[1]) & 3) == 2);
  for (int end = 0; end < 2; end++)
    if (s->corner[end] >= 0)
      return enters_at(quad, s->corner[end], s->ends[1 - end]);
  meeting found = place_meets(quad, s->ends[0]);
  for (int c = 0; found == MEETING_NONE && c < 4; c++) {
    const double *const side[2] = {quad->corners[c], quad->corners[(c + 1) & 3]};
    found = segments_meet_along(quad->axis, s->ends, side);
  }
  return found;
}

/** A segment whose ends lie on either side of the plane. */
static meeting meet_across(const segment *s, const flat_quad *quad) {
  int seen[3] = {0, 0, 0};
  bool open = false;
  for (int c = 0; c < 4; c++) {
    int sign =
        orientation_in_space(s->ends[0], s->ends[1], quad->corners[c], quad->corners[(c + 1) & 3]);
    open |= sign == ORIENTATION_LOST;
    if (sign != ORIENTATION_LOST)
      seen[sign + 1]++;
  }
  if (seen[0] > 0 && seen[2] > 0)
    return MEETING_NONE;
  return open ? MEETING_OPEN : MEETING_PROVED;
}

meeting side_meets_flat_quad(const flat_quad *a, int side, const flat_quad *b) {
  segment s;
  int heights[2];
  for (int end = 0; end < 2; end++) {
    int corner = (side + end) & 3;
    s.ends[end] = a->corners[corner];
    s.corner[end] = corner_with_id(b, a->ids[corner]);
    heights[end] = s.corner[end] >= 0
                       ? 0
                       : orientation_in_space(b->corners[(b->apex + 3) & 3], b->corners[b->apex],
                                              b->corners[(b->apex + 1) & 3], s.ends[end]);
    if (heights[end] == ORIENTATION_LOST)
      return MEETING_OPEN;
  }
  if (heights[0] == 0 && heights[1] == 0)
    return meet_in_plane(&s, b);
  if (heights[0] * heights[1] < 0)
    return meet_across(&s, b);
  if (heights[0] * heights[1] > 0)
    return MEETING_NONE;
  int touching = heights[0] == 0 ? 0 : 1;
  return s.corner[touching] >= 0 ? MEETING_NONE : place_meets(b, s.ends[touching]);
}

/** What two convex polygons have in common is convex, and each of its corners lies on a side of one
 * of them: so it is more than what they share only if a side meets the other polygon elsewhere. */
meeting flat_quads_meet(const flat_quad *a, const flat_quad *b) {
  meeting found = MEETING_NONE;
  for (int i = 0; i < 8; i++) {
    meeting here = i < 4 ? side_meets_flat_quad(a, i, b) : side_meets_flat_quad(b, i - 4, a);
    if (here == MEETING_PROVED)
      return here;
    if (here == MEETING_OPEN)
      found = here;
  }
  return found;
}
