/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * Canonical codes of small quadrangulations of the sphere: equal for isomorphic ones, mirror images
 * included.
 *
 * A walk begins with a half-edge and numbers the points in the order in which it meets them: point
 * after point, it goes round all neighbours, counter-clockwise seen from outside, or clockwise if
 * mirrored, from the neighbour by which it came. It writes a letter for each, 'a' + number, and a
 * dot after each point. The least such text of all walks is the code.
 */
#ifndef HEXCON_SURFACE_CANONICAL_CODE_H
#define HEXCON_SURFACE_CANONICAL_CODE_H

#include "half_edges.h"

enum {
  CODE_MOST_QUADS = 16,
  CODE_MOST_POINTS = CODE_MOST_QUADS + 2,
  CODE_ROOM = 4 * CODE_MOST_QUADS + CODE_MOST_POINTS + 1,
  CODE_MOST_WALKS = 2 * 4 * CODE_MOST_QUADS
};

typedef struct canonical_code {
  char text[CODE_ROOM];
  bool mirrored;                   /**< the walk that gives it is */
  int32_t order[CODE_MOST_POINTS]; /**< [point_count] points in the order of that walk */
} canonical_code;

/** One walk. @param s connected, of genus 0, all points used, at most CODE_MOST_QUADS quads */
void surface_walk(const surface *s, int32_t half_edge, bool mirrored, canonical_code *walk);

/** Where a walk begins. */
typedef struct walk_start {
  int32_t half_edge;
  bool mirrored;
} walk_start;

/**
 * All least walks: as many as the surface has symmetries, if mirror images count. Those that are
 * not mirrored come first.
 * @return how many. Cost: quadratic in the quads.
 */
size_t surface_canonical_walks(const surface *s, walk_start starts[CODE_MOST_WALKS]);

#endif
