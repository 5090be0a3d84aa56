/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "edge_rotation.h"

#include <string.h>

enum { LEAST_DEGREE = 3 };

/** The next half-edge with the same start. */
static int32_t next_around(const surface *s, int32_t half_edge) {
  return s->twins[half_edge_turn(half_edge, 3)];
}

size_t surface_degree(const surface *s, int32_t half_edge) {
  size_t degree = 0;
  int32_t h = half_edge;
  do {
    degree++;
    h = next_around(s, h);
  } while (h != half_edge);
  return degree;
}

/** The hexagon's sides: half-edges of its quads, counter-clockwise. */
static void find_sides(const surface *s, int32_t half_edge, int32_t sides[6]) {
  int32_t twin = s->twins[half_edge];
  for (int k = 0; k < 3; k++) {
    sides[k] = half_edge_turn(half_edge, k + 1);
    sides[3 + k] = half_edge_turn(twin, k + 1);
  }
}

void rotation_hexagon(const surface *s, int32_t half_edge, int32_t corners[6]) {
  int32_t sides[6];
  find_sides(s, half_edge, sides);
  for (int k = 0; k < 6; k++)
    corners[k] = half_edge_start(s, sides[k]);
}

/** Six different corners, with no side between the two quads. */
static bool is_hexagon(const surface *s, const int32_t quads[2], const int32_t sides[6],
                       const int32_t corners[6]) {
  for (int i = 0; i < 6; i++) {
    int32_t outside = half_edge_quad(s->twins[sides[i]]);
    if (outside == quads[0] || outside == quads[1])
      return false;
    for (int j = 0; j < i; j++)
      if (corners[i] == corners[j])
        return false;
  }
  return true;
}

/** Split the hexagon between corners `step` and step + 3. */
static void split(surface *s, const int32_t quads[2], const int32_t outside[6],
                  const int32_t corners[6], int step) {
  for (int half = 0; half < 2; half++) {
    int32_t first = 4 * quads[half];
    for (int k = 0; k < 4; k++)
      s->quads[first + k] = corners[(step + 3 * half + k) % 6];
    for (int k = 0; k < 3; k++) {
      int32_t twin = outside[(step + 3 * half + k) % 6];
      s->twins[first + k] = twin;
      s->twins[twin] = first + k;
    }
    s->twins[first + 3] = 4 * quads[1 - half] + 3;
  }
}

/** Does no other quad about the half-edge's start have `opposite` too? */
static bool is_alone_with(const surface *s, int32_t half_edge, int32_t opposite) {
  for (int32_t h = next_around(s, half_edge); h != half_edge; h = next_around(s, h))
    if (half_edge_end(s, h) == opposite || half_edge_end(s, half_edge_turn(h, 1)) == opposite)
      return false;
  return true;
}

/** The new edge joins points that no other edge joins, and quads meet in an edge at most. */
static bool is_proper(const surface *s, const int32_t quads[2]) {
  int32_t edge = 4 * quads[0] + 3;
  for (int32_t h = next_around(s, edge); h != edge; h = next_around(s, h))
    if (half_edge_end(s, h) == half_edge_end(s, edge))
      return false;
  for (int half = 0; half < 2; half++)
    for (int k = 0; k < 2; k++) {
      int32_t h = 4 * quads[half] + k;
      if (!is_alone_with(s, h, half_edge_start(s, half_edge_turn(h, 2))))
        return false;
    }
  return true;
}

bool surface_rotation_is_proper(const surface *s, const int32_t quads[2]) {
  for (int half = 0; half < 2; half++)
    for (int k = 0; k < 4; k++)
      if (surface_degree(s, 4 * quads[half] + k) < LEAST_DEGREE)
        return false;
  return is_proper(s, quads);
}

bool surface_rotate_unchecked(surface *s, edge_rotation r, rotation_undo *undo) {
  int32_t sides[6], corners[6], outside[6];
  undo->quads[0] = half_edge_quad(r.half_edge);
  undo->quads[1] = half_edge_quad(s->twins[r.half_edge]);
  find_sides(s, r.half_edge, sides);
  rotation_hexagon(s, r.half_edge, corners);
  if (!is_hexagon(s, undo->quads, sides, corners))
    return false;
  for (int half = 0; half < 2; half++) {
    memcpy(undo->corners + 4 * half, s->quads + 4 * undo->quads[half], 4 * sizeof *s->quads);
    memcpy(undo->twins + 4 * half, s->twins + 4 * undo->quads[half], 4 * sizeof *s->twins);
  }
  for (int k = 0; k < 6; k++)
    outside[k] = s->twins[sides[k]];
  split(s, undo->quads, outside, corners, r.step);
  return true;
}

bool surface_rotate(surface *s, edge_rotation r, rotation_undo *undo) {
  if (surface_degree(s, r.half_edge) <= LEAST_DEGREE ||
      surface_degree(s, s->twins[r.half_edge]) <= LEAST_DEGREE ||
      !surface_rotate_unchecked(s, r, undo))
    return false;
  if (is_proper(s, undo->quads))
    return true;
  surface_rotate_back(s, undo);
  return false;
}

void surface_rotate_back(surface *s, const rotation_undo *undo) {
  for (int half = 0; half < 2; half++) {
    int32_t first = 4 * undo->quads[half];
    memcpy(s->quads + first, undo->corners + 4 * half, 4 * sizeof *s->quads);
    memcpy(s->twins + first, undo->twins + 4 * half, 4 * sizeof *s->twins);
  }
  for (int half = 0; half < 2; half++)
    for (int k = 0; k < 4; k++)
      s->twins[undo->twins[4 * half + k]] = 4 * undo->quads[half] + k;
}
