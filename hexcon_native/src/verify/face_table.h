/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The faces of a hex mesh, and which hexes meet in them. */
#ifndef HEXCON_VERIFY_FACE_TABLE_H
#define HEXCON_VERIFY_FACE_TABLE_H

#include "base/context.h"

/** Side 6 * hex + face of the hex mesh. */
typedef struct face_table {
  size_t face_count;     /**< different faces */
  size_t boundary_count; /**< of them in one hex only */
  size_t crowded_count;  /**< sides beyond the second of some face, or against its direction */
  int32_t *opposite;     /**< [6 * hex_count] the side of the other hex, -1 at the boundary */
  int32_t *face_of_side; /**< [6 * hex_count] number of the face: its first side's */
} face_table;

/** Expected linear (hashing). @param out free with face_table_free, also after an error */
hexcon_status face_table_build(hexcon_context *context, const int32_t *hexes, size_t hex_count,
                               face_table *out);
void face_table_free(hexcon_context *context, face_table *table);

/** The ids of a side, counter-clockwise seen from outside its hex. */
void face_of_hex(const int32_t *hexes, int32_t side, int32_t corners[4]);

/** Hash of a face, whatever its first corner and direction. */
uint64_t face_hash(const int32_t corners[4]);

/** True if b is a turned by some rotation (`against` false), or reversed and turned (true). */
bool face_same_cycle(const int32_t a[4], const int32_t b[4], bool against);

#endif
