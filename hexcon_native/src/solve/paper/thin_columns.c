/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "thin_columns.h"

static hexcon_status add_hex(hexcon_context *context, thin_columns *columns, int32_t hex,
                             int32_t part) {
  if (columns->hex_count == columns->room) {
    size_t room = 2 * columns->room + 64;
    int32_t *hexes = context_grow(context, columns->hexes, room, sizeof *hexes);
    if (!hexes)
      return HEXCON_OUT_OF_MEMORY;
    columns->hexes = hexes;
    int32_t *parts = context_grow(context, columns->parts, room, sizeof *parts);
    if (!parts)
      return HEXCON_OUT_OF_MEMORY;
    columns->parts = parts;
    columns->room = room;
  }
  columns->hexes[columns->hex_count] = hex;
  columns->parts[columns->hex_count++] = part;
  return HEXCON_OK;
}

/** Whether just two quads meet where a half-edge starts, and this is the lower one of them. */
static bool is_column(const surface *s, int32_t h) {
  int32_t other = s->twins[half_edge_turn(h, -1)];
  return s->twins[half_edge_turn(other, -1)] == h && other > h;
}

static hexcon_status begin(hexcon_context *context, const surface *coarse,
                           const int32_t *hexes_behind, thin_columns *out) {
  hexcon_status status = HEXCON_OK;
  for (int32_t h = 0; !status && h < (int32_t)(4 * coarse->quad_count); h++) {
    int32_t behind = hexes_behind[half_edge_quad(h)];
    if (!is_column(coarse, h))
      continue;
    out->corners[out->count] = h;
    out->line[out->count] = half_edge_start(coarse, h);
    out->numbers[out->count] = behind >= 0 ? behind : -1 - h;
    if (behind >= 0)
      status = add_hex(context, out, behind, behind);
    out->count++;
  }
  return status;
}

hexcon_status thin_columns_find(hexcon_context *context, const surface *coarse,
                                const int32_t *hexes_behind, thin_columns *out) {
  memset(out, 0, sizeof *out);
  size_t most = coarse->point_count;
  out->corners = context_allocate(context, most, sizeof *out->corners);
  out->line = context_allocate(context, most, sizeof *out->line);
  out->numbers = context_allocate(context, most, sizeof *out->numbers);
  if (!out->corners || !out->line || !out->numbers)
    return HEXCON_OUT_OF_MEMORY;
  return begin(context, coarse, hexes_behind, out);
}

void thin_columns_free(hexcon_context *context, thin_columns *columns) {
  context_free(context, columns->corners);
  context_free(context, columns->line);
  context_free(context, columns->numbers);
  context_free(context, columns->hexes);
  context_free(context, columns->parts);
  memset(columns, 0, sizeof *columns);
}

static bool touches(const growing_mesh *mesh, size_t hex, int32_t a, int32_t b) {
  for (size_t i = 0; i < 8; i++)
    if (mesh->hexes[8 * hex + i] == a || mesh->hexes[8 * hex + i] == b)
      return true;
  return false;
}

hexcon_status thin_columns_go_down(hexcon_context *context, thin_columns *columns,
                                   const surface *coarse, const growing_mesh *mesh,
                                   const size_t *starts, const int32_t *ends) {
  hexcon_status status = HEXCON_OK;
  for (size_t i = 0; !status && i < columns->count; i++) {
    int32_t quad = half_edge_quad(columns->corners[i]);
    int32_t end = ends[half_edge_start(coarse, columns->corners[i])];
    for (size_t hex = starts[quad]; !status && hex < starts[quad + 1]; hex++)
      if (touches(mesh, hex, columns->line[i], end))
        status = add_hex(context, columns, (int32_t)hex, columns->numbers[i]);
    columns->line[i] = end;
  }
  return status;
}

hexcon_status thin_columns_sort_out(hexcon_context *context, thin_columns *columns,
                                    size_t mesh_hex_count) {
  uint8_t *named = context_allocate_zeroed(context, mesh_hex_count, 1);
  if (!named)
    return HEXCON_OUT_OF_MEMORY;
  size_t kept = 0;
  for (size_t i = 0; i < columns->hex_count; i++) {
    int32_t hex = columns->hexes[i];
    if (!named[hex]) {
      columns->hexes[kept] = hex;
      columns->parts[kept++] = columns->parts[i];
    }
    named[hex] = 1;
  }
  columns->hex_count = kept;
  context_free(context, named);
  return HEXCON_OK;
}
