/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * A ball filled with hexes, by its boundary: and how gluing a hex to it changes that.
 *
 * A hex is glued to a quad of the boundary and to some of the four quads around it. Up to rotation
 * there are six sorts: none, one, two neighbouring, two opposite, three, and all four. What was
 * like part of a cube becomes like the rest of that cube: a flip.
 *
 * History matters for proper meshes, in which every inner edge has at least three hexes. An edge of
 * the boundary is *marked* when two or more hexes are behind it. A flip needs all edges inside its
 * disc marked; edges on the rim of the disc become marked, new edges are not.
 */
#ifndef TEMPLATE_SEARCH_BALL_H
#define TEMPLATE_SEARCH_BALL_H

#include "sphere.h"

enum { MOST_HEXES = 96, MOST_POINTS = 250, FLIP_SORTS = 6 };

typedef struct ball {
  sphere surface;
  bool marked[MOST_DARTS];
  uint8_t point[MOST_VERTICES]; /**< id in the mesh of each vertex of the surface */
  int point_count;              /**< ids given out */
  int hex_count;
  uint8_t hexes[MOST_HEXES][8]; /**< points, VTK order */
} ball;

/** A flip by name: few bytes, and the same again when a history is replayed. */
typedef struct flip {
  uint8_t root; /**< dart: the first side of the quad below the hex */
  uint8_t sort; /**< number in flip_sides */
} flip;

/** Bit k: the quad across side k, counted from the root, is glued too. */
extern const uint8_t flip_sides[FLIP_SORTS];

/** The quads that a flip takes away, and the corners of its hex as vertices (NONE: new). */
typedef struct flip_disc {
  int quad_count;
  uint8_t quads[5];
  uint8_t corners[8];
} flip_disc;

/** @return false if there is no such flip; each flip is found at one root only */
bool flip_find(const sphere *s, flip f, flip_disc *disc);

/** Are all edges inside the disc marked? */
bool flip_respects_marks(const ball *b, flip f);

/** The change in the number of quads. */
int flip_growth(const flip_disc *disc);

/**
 * Glue the hex. `after` must not be `before`.
 * @return false if the boundary would not be simple and three-connected, or ids run out
 */
bool ball_glue(const ball *before, flip f, const flip_disc *disc, ball *after);

/** The last hex meets all others in nothing, a point, an edge or a face, and its new faces and
 * edges are not those of others. */
bool ball_last_hex_proper(const ball *b);

/** One hex. */
void ball_single_hex(ball *b);

#endif
