/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "ball.h"

#include <string.h>

#include "hexes.h"

const uint8_t flip_sides[FLIP_SORTS] = {0, 1, 3, 5, 7, 15};

static bool glued(flip f, int side) {
  return flip_sides[f.sort] >> (side & 3) & 1;
}

/** Of the roots that name the same flip, is this the one to use? */
static bool root_is_first(const sphere *s, flip f) {
  const int quad = f.root >> 2, side = f.root & 3, twin = s->twin[f.root];
  const int second = s->twin[dart_turned(f.root, 1)] >> 2;
  switch (f.sort) {
  case 1:
    return f.root < twin;
  case 2: /* three quads around a vertex */
    return quad < twin >> 2 && quad < second;
  case 3:
    return side < 2;
  case 4: /* the quad across the middle side could be below as well */
    return quad < second;
  default:
    return side == 0;
  }
}

/** Corners 0 .. 3 are those of the quad below; k + 4 lies above k. */
static void find_corners(const sphere *s, flip f, uint8_t corners[8]) {
  memset(corners, NONE, 8);
  for (int k = 0; k < 4; k++) {
    const int dart = dart_turned(f.root, k);
    corners[k] = s->corner[dart];
    if (glued(f, k)) {
      corners[4 + k] = s->corner[dart_turned(s->twin[dart], 2)];
      corners[4 + ((k + 1) & 3)] = s->corner[dart_turned(s->twin[dart], 3)];
    }
  }
}

static bool all_different(const uint8_t corners[8]) {
  uint64_t seen = 0;
  for (int i = 0; i < 8; i++) {
    if (corners[i] == NONE)
      continue;
    if (seen >> corners[i] & 1)
      return false;
    seen |= UINT64_C(1) << corners[i];
  }
  return true;
}

bool flip_find(const sphere *s, flip f, flip_disc *disc) {
  if (!root_is_first(s, f))
    return false;
  disc->quad_count = 1;
  disc->quads[0] = f.root >> 2;
  for (int k = 0; k < 4; k++) {
    if (!glued(f, k))
      continue;
    /* Two neighbouring sides of a hex have an edge in common. */
    if (glued(f, k + 1) && s->degree[s->corner[dart_turned(f.root, (k + 1) & 3)]] != 3)
      return false;
    disc->quads[disc->quad_count++] = s->twin[dart_turned(f.root, k)] >> 2;
  }
  find_corners(s, f, disc->corners);
  return all_different(disc->corners);
}

bool flip_respects_marks(const ball *b, flip f) {
  for (int k = 0; k < 4; k++) {
    const int dart = dart_turned(f.root, k);
    if (!glued(f, k))
      continue;
    if (!b->marked[dart])
      return false;
    /* From the end of side k, up to the corner above it. */
    if (glued(f, k + 1) && !b->marked[dart_turned(b->surface.twin[dart], 3)])
      return false;
  }
  return true;
}

int flip_growth(const flip_disc *disc) {
  return 6 - 2 * disc->quad_count;
}

/** Vertices of the hex that are new get numbers and points. */
static bool number_new_vertices(flip_disc *disc, ball *after) {
  for (int i = 4; i < 8; i++)
    if (disc->corners[i] == NONE) {
      if (after->surface.vertex_count == MOST_VERTICES || after->point_count == MOST_POINTS)
        return false;
      after->point[after->surface.vertex_count] = (uint8_t)after->point_count++;
      disc->corners[i] = (uint8_t)after->surface.vertex_count++;
    }
  return true;
}

/** Copy the quads outside the disc. @return how many */
static int keep_quads(const ball *before, const flip_disc *disc, ball *after) {
  uint32_t gone = 0;
  int kept = 0;
  for (int i = 0; i < disc->quad_count; i++)
    gone |= UINT32_C(1) << disc->quads[i];
  for (int q = 0; q < before->surface.quad_count; q++) {
    if (gone >> q & 1)
      continue;
    memcpy(&after->surface.corner[4 * kept], &before->surface.corner[4 * q], 4);
    memcpy(&after->marked[4 * kept], &before->marked[4 * q], 4 * sizeof *after->marked);
    kept++;
  }
  return kept;
}

/** The top of the hex and those of its sides that are not glued. */
static void add_quads(flip f, const uint8_t corners[8], ball *after, int kept) {
  int count = kept;
  memcpy(&after->surface.corner[4 * count++], corners + 4, 4);
  for (int k = 0; k < 4; k++)
    if (!glued(f, k)) {
      const int n = (k + 1) & 3;
      const uint8_t side[4] = {corners[k], corners[n], corners[4 + n], corners[4 + k]};
      memcpy(&after->surface.corner[4 * count++], side, 4);
    }
  after->surface.quad_count = count;
}

/** Close the gaps in the numbers of vertices. */
static void renumber(ball *b) {
  sphere *s = &b->surface;
  uint8_t number[MOST_VERTICES] = {0};
  uint64_t used = 0;
  int count = 0;
  for (int d = 0; d < 4 * s->quad_count; d++)
    used |= UINT64_C(1) << s->corner[d];
  for (int v = 0; v < s->vertex_count; v++)
    if (used >> v & 1) {
      b->point[count] = b->point[v];
      number[v] = (uint8_t)count++;
    }
  for (int d = 0; d < 4 * s->quad_count; d++)
    s->corner[d] = number[s->corner[d]];
  s->vertex_count = count;
}

static void mark_rim(ball *b, int kept) {
  for (int d = 4 * kept; d < 4 * b->surface.quad_count; d++) {
    const int twin = b->surface.twin[d];
    b->marked[d] = twin < 4 * kept;
    if (b->marked[d])
      b->marked[twin] = true;
  }
}

bool ball_glue(const ball *before, flip f, const flip_disc *disc, ball *after) {
  flip_disc placed = *disc;
  if (before->hex_count == MOST_HEXES ||
      before->surface.quad_count + flip_growth(disc) > MOST_QUADS)
    return false;
  after->surface.vertex_count = before->surface.vertex_count;
  after->point_count = before->point_count;
  memcpy(after->point, before->point, sizeof after->point);
  if (!number_new_vertices(&placed, after))
    return false;
  const int kept = keep_quads(before, disc, after);
  add_quads(f, placed.corners, after, kept);
  uint8_t hex[8];
  for (int i = 0; i < 8; i++)
    hex[i] = after->point[placed.corners[i]];
  renumber(after);
  if (after->surface.vertex_count != after->surface.quad_count + 2 ||
      !sphere_link(&after->surface) || !sphere_three_connected(&after->surface))
    return false;
  mark_rim(after, kept);
  memcpy(after->hexes, before->hexes, 8 * (size_t)before->hex_count);
  memcpy(after->hexes[before->hex_count], hex, 8);
  after->hex_count = before->hex_count + 1;
  return true;
}

/** Does a hex before the last one have both ends of an edge, or all corners of a quad? */
static bool inside_already(const ball *b, const uint8_t *points, int count) {
  for (int h = 0; h < b->hex_count - 1; h++) {
    int found = 0;
    while (found < count && memchr(b->hexes[h], points[found], 8))
      found++;
    if (found == count)
      return true;
  }
  return false;
}

/** Are quads of the last hex, and the edges between them, nowhere else? Their points may be old. */
static bool skin_is_new(const ball *b) {
  const sphere *s = &b->surface;
  const uint8_t *last = b->hexes[b->hex_count - 1];
  bool of_last[MOST_QUADS] = {false};
  for (int q = 0; q < s->quad_count; q++) {
    uint8_t points[4];
    int found = 0;
    for (int k = 0; k < 4; k++) {
      points[k] = b->point[s->corner[4 * q + k]];
      found += memchr(last, points[k], 8) != NULL;
    }
    of_last[q] = found == 4;
    if (of_last[q] && inside_already(b, points, 4))
      return false;
  }
  for (int d = 0; d < 4 * s->quad_count; d++) {
    const int twin = s->twin[d];
    const uint8_t ends[2] = {b->point[s->corner[d]], b->point[s->corner[twin]]};
    if (d < twin && of_last[d >> 2] && of_last[twin >> 2] && inside_already(b, ends, 2))
      return false;
  }
  return true;
}

bool ball_last_hex_proper(const ball *b) {
  const int last = b->hex_count - 1;
  for (int i = 0; i < last; i++)
    if (!hexes_meet_properly(b->hexes[i], b->hexes[last]))
      return false;
  return skin_is_new(b);
}

void ball_single_hex(ball *b) {
  *b = (ball){.point_count = 8, .hex_count = 1};
  sphere_cube(&b->surface);
  for (uint8_t i = 0; i < 8; i++)
    b->point[i] = b->hexes[0][i] = i;
}
