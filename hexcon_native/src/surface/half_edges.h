/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * Adjacency of a closed quad surface.
 *
 * Half-edge h = 4 * quad + side runs from corner `side` of the quad to the next corner.
 */
#ifndef HEXCON_SURFACE_HALF_EDGES_H
#define HEXCON_SURFACE_HALF_EDGES_H

#include "base/context.h"

typedef struct surface {
  size_t point_count, quad_count;
  const double *points; /**< [point_count][3], the caller's; NULL where only topology matters */
  int32_t *quads;       /**< [quad_count][4] consistently oriented, outward if points are known */
  int32_t *twins;       /**< [4 * quad_count] the half-edge on the other side of each edge */
  int32_t *component_of_quad; /**< [quad_count] */
  size_t component_count;
  size_t cavity_count; /**< components that bound cavities; 0 where points are not known */
  uint8_t *is_cavity;  /**< [component_count]; NULL where points are not known */
  bool turned;         /**< quads faced into the solid and were turned, of all shells or of some */
  const struct numbering *names; /**< the caller's ids, where this numbering is not the caller's */
} surface;

static inline int32_t half_edge_quad(int32_t h) {
  return h >> 2;
}

/** One component of genus 0: its Euler characteristic tells. */
static inline bool surface_is_sphere(const surface *s) {
  return s->component_count == 1 && s->point_count == s->quad_count + 2;
}

/** The half-edge `steps` further counter-clockwise in the same quad; steps may be -3 .. 3. */
static inline int32_t half_edge_turn(int32_t h, int steps) {
  return (h & ~3) | ((h + steps) & 3);
}

static inline int32_t half_edge_start(const surface *s, int32_t h) {
  return s->quads[h];
}

static inline int32_t half_edge_end(const surface *s, int32_t h) {
  return s->quads[half_edge_turn(h, 1)];
}

/**
 * Find the twins, the components and one consistent orientation of quads whose arrays are checked.
 * @param s  with its counts, quads, and room for twins and component_of_quad. Linear
 * @param turning  turn quads that are oriented against most of their component; else they are
 *                 INCONSISTENT_ORIENTATION
 * @return NON_MANIFOLD_EDGE, NOT_CLOSED, NOT_ORIENTABLE, INCONSISTENT_ORIENTATION,
 *         NON_MANIFOLD_VERTEX, OUT_OF_MEMORY, CANCELLED, OUT_OF_TIME
 */
hexcon_status surface_connect(hexcon_context *context, surface *s, bool turning);

/** Reverse a quad, its first corner kept, and its own row of twins with it; not what the twins of
 * others say of it. */
void half_edge_reverse(int32_t quad[4], int32_t twins[4]);
void surface_free(hexcon_context *context, surface *s);

/** Largest id in quads plus one; 0 if there is none that is valid. */
size_t surface_used_point_count(const int32_t *quads, size_t quad_count);

#endif
