/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The faces of a hex mesh, and which hexes meet in them. */
#ifndef HEXCON_HEXMESH_FACE_TABLE_H
#define HEXCON_HEXMESH_FACE_TABLE_H

#include "point_star.h"

/** Side 6 * hex + face of the hex mesh. */
typedef struct face_table {
  size_t face_count;     /**< different faces */
  size_t boundary_count; /**< of them in one hex only */
  size_t crowded_count;  /**< sides beyond the second of some face, or against its direction */
  int32_t *opposite;     /**< [6 * hex_count] the side of the other hex, -1 if there is none */
} face_table;

/** @param out  filled by the stars of all points; free with face_table_free, also after an error */
hexcon_status face_table_new(hexcon_context *context, size_t hex_count, face_table *out);
void face_table_free(hexcon_context *context, face_table *table);

/** Enter the faces of which the star's point is the lowest. */
void face_table_enter(face_table *table, const point_star *star);

/** The ids of a side, counter-clockwise seen from outside its hex. */
void face_of_hex(const int32_t *hexes, int32_t side, int32_t corners[4]);

#endif
