/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * Quadrangulations of the sphere, small enough for ids in a byte.
 *
 * Quad q has the darts 4q .. 4q + 3; dart d goes from corner[d] to the corner of the next dart of
 * its quad, counter-clockwise seen from outside. There are always quad_count + 2 vertices.
 */
#ifndef TEMPLATE_SEARCH_SPHERE_H
#define TEMPLATE_SEARCH_SPHERE_H

#include <stdbool.h>
#include <stdint.h>

/** One vertex more than there are quads for: a flip adds its new ones before the old ones go. */
enum { MOST_QUADS = 32, MOST_VERTICES = MOST_QUADS + 3, MOST_DARTS = 4 * MOST_QUADS, NONE = 255 };

typedef struct sphere {
  int quad_count, vertex_count;
  uint8_t corner[MOST_DARTS];
  uint8_t twin[MOST_DARTS];      /**< the same edge, the other way */
  uint8_t degree[MOST_VERTICES]; /**< edges at a vertex */
} sphere;

/** The dart that is `steps` further in the same quad, 0 <= steps <= 3. */
static inline int dart_turned(int dart, int steps) {
  return (dart & ~3) | ((dart + steps) & 3);
}

/** The next dart with the same origin, in one of the two senses. */
static inline int dart_rotated(const sphere *s, int dart, bool mirrored) {
  return mirrored ? dart_turned(s->twin[dart], 1) : s->twin[dart_turned(dart, 3)];
}

/**
 * Fill twins and degrees from the corners.
 * @return false unless every edge joins two different vertices once and lies between two quads
 */
bool sphere_link(sphere *s);

/** Three-connected, given a linked sphere: no two quads have a pair of opposite corners in common.
 */
bool sphere_three_connected(const sphere *s);

/** Of arbitrary linked quads: is it one sphere, every vertex with one fan of quads? */
bool sphere_is_sphere(const sphere *s);

/** Of the cube, its quads in the order of hex_faces, its vertices the hex's corners. */
void sphere_cube(sphere *s);

#endif
