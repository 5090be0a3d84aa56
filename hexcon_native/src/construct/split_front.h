/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * Split layers: hexes that split the quads which a family of disjoint dual loops crosses.
 *
 * The front is what still has to be filled: the quads of a coarse surface, some of them split in
 * two or four. Every layer splits it along one more family and moves it inward; after all of them
 * every coarse quad is split in four.
 * Source: Carbonera and Shepherd (2006), section 4.2, theorem 3.
 */
#ifndef HEXCON_CONSTRUCT_SPLIT_FRONT_H
#define HEXCON_CONSTRUCT_SPLIT_FRONT_H

#include "growing_mesh.h"
#include "surface/half_edges.h"

typedef enum split_kind {
  SPLIT_ORIGINAL,   /**< 3 hexes on a crossed quad, 2 to the left of the loops, 1 to the right */
  SPLIT_ALTERNATIVE /**< 1 hex on crossed quads and those to the left: Mitchell's */
} split_kind;

/** Nodes are the coarse points, then the coarse edges' middles, then the coarse quads' centres.
 * Points of the mesh that no coarse quad has are nodes without a point. */
typedef struct split_front {
  const surface *s;  /**< the coarse surface */
  int32_t *edges;    /**< [4 * quad_count] number of every half-edge's edge, in the order of the
                          lower half-edges */
  size_t edge_count; /**< 2 * quad_count */
  int32_t *corners; /**< [point_count] number of every coarse point that a quad has; -1: none has */
  size_t corner_count;
  size_t node_count; /**< point_count + edge_count + quad_count */
  int32_t *points;   /**< [node_count] the mesh's point at every node; -1: not split there */
} split_front;

static inline size_t split_edge_node(const split_front *f, int32_t half_edge) {
  return f->s->point_count + (size_t)f->edges[half_edge];
}

static inline size_t split_center_node(const split_front *f, size_t quad) {
  return f->s->point_count + f->edge_count + quad;
}

/** The front before any layer: coarse points have their own ids. Linear.
 * @param out  free with split_front_free, also after an error; keeps `s` */
hexcon_status split_front_new(hexcon_context *context, const surface *s, split_front *out);
void split_front_free(hexcon_context *context, split_front *front);

/**
 * Add a layer.
 * @param crossed  [4 * quad_count] half-edges that the family crosses: of every quad none, or two
 *                 opposite ones; none where the front is split already
 * @param sides    [point_count] of the coarse points, 0 and 1: the layer is thicker on the side
 *                 that takes fewer hexes
 * @param mesh     grows
 * @param starts   [quad_count + 1] receives the first hex over every coarse quad; NULL: not wanted
 * @param points   receives where the new points lie; points->means is to be freed by the caller,
 *                 also after an error
 * Errors: OUT_OF_MEMORY, TOO_LARGE. Linear.
 */
hexcon_status split_front_add_layer(hexcon_context *context, split_front *front, split_kind kind,
                                    const uint8_t *crossed, const uint8_t *sides,
                                    growing_mesh *mesh, size_t *starts, mean_points *points);

#endif
