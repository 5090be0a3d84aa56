/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * Where layers and Geodes leave doublets: under the coarse points that only two quads meet at, as
 * the feet of every paired transition. From such a point down to the triangulation the two quads'
 * hexes share two faces all along. Pillowing the column under one of the two quads, with the hex
 * of the pair that stands on it, takes all of them away.
 */
#ifndef HEXCON_SOLVE_PAPER_THIN_COLUMNS_H
#define HEXCON_SOLVE_PAPER_THIN_COLUMNS_H

#include "construct/growing_mesh.h"
#include "construct/split_front.h"

typedef struct thin_columns {
  size_t count;
  int32_t *corners; /**< [count] half-edges that start at such a point, in the quad of the column */
  int32_t *line;    /**< [count] the mesh's point that the line down from it has come to */
  int32_t *numbers; /**< [count] parts: columns that stand on one hex are one */
  size_t hex_count, room;
  int32_t *hexes, *parts; /**< [hex_count] what they hold; a hex may be named twice */
} thin_columns;

/** Find them. @param hexes_behind  [quad_count] the hex on which a quad stands, -1: none
 * @param out  free with thin_columns_free, also after an error. Linear. */
hexcon_status thin_columns_find(hexcon_context *context, const surface *coarse,
                                const int32_t *hexes_behind, thin_columns *out);
void thin_columns_free(hexcon_context *context, thin_columns *columns);

/** Go down one stage: collect the hexes over each column's quad that touch its line.
 * @param starts  [quad_count + 1] first hex of this stage over every quad
 * @param ends    point of the mesh at which the line of each coarse point leaves the stage */
hexcon_status thin_columns_go_down(hexcon_context *context, thin_columns *columns,
                                   const surface *coarse, const growing_mesh *mesh,
                                   const size_t *starts, const int32_t *ends);

/** Drop what is named twice. @param mesh_hex_count of the mesh */
hexcon_status thin_columns_sort_out(hexcon_context *context, thin_columns *columns,
                                    size_t mesh_hex_count);

#endif
