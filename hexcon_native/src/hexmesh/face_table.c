/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "face_table.h"

#include <string.h>

#include "hex_tables.h"

hexcon_status face_table_new(hexcon_context *context, size_t hex_count, face_table *out) {
  memset(out, 0, sizeof *out);
  out->opposite = context_allocate(context, 6 * hex_count, sizeof *out->opposite);
  return out->opposite ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

void face_table_free(hexcon_context *context, face_table *table) {
  context_free(context, table->opposite);
  memset(table, 0, sizeof *table);
}

void face_of_hex(const int32_t *hexes, int32_t side, int32_t corners[4]) {
  const int32_t *hex = hexes + 8 * (size_t)(side / 6);
  for (int i = 0; i < 4; i++)
    corners[i] = hex[hex_faces[side % 6][i]];
}

/** Number of a side of the star in the whole mesh. */
static int32_t side_in_mesh(const point_star *star, size_t side) {
  int32_t corner = star->corners[side / 3];
  return 6 * (corner / 8) + hex_corner_faces[corner % 8][side % 3];
}

void face_table_enter(face_table *table, const point_star *star) {
  for (size_t side = 0; side < 3 * star->count; side++) {
    int32_t ids[3], opposite = star->opposite[side];
    point_star_side(star, side, ids);
    if (ids[0] < star->point || ids[1] < star->point || ids[2] < star->point)
      continue;
    table->opposite[side_in_mesh(star, side)] =
        opposite >= 0 ? side_in_mesh(star, (size_t)opposite) : -1;
    table->crowded_count += opposite == STAR_CROWDED;
    table->boundary_count += opposite == STAR_BOUNDARY;
    table->face_count += opposite == STAR_BOUNDARY || opposite > (int32_t)side;
  }
}
