/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "raise_order.h"

#include <string.h>

#include "construct/second_order.h"
#include "hexmesh/hex_arrays.h"

/** The points, with the edges' midpoints after them. */
static double *append_midpoints(hexcon_context *context, const double *points, size_t point_count,
                                const edge_table *edges) {
  double *all = context_allocate(context, 3 * (point_count + edges->count), sizeof *all);
  if (!all)
    return NULL;
  memcpy(all, points, 3 * point_count * sizeof *all);
  for (size_t e = 0; e < edges->count; e++) {
    const double *a = points + 3 * (size_t)edges->ends[e][0];
    const double *b = points + 3 * (size_t)edges->ends[e][1];
    for (size_t i = 0; i < 3; i++)
      all[3 * (point_count + e) + i] = a[i] + (b[i] - a[i]) / 2;
  }
  return all;
}

/** Corners, then mid-edge points. */
static hexcon_status write_hexes(hexcon_context *context, const int32_t *corners, size_t hex_count,
                                 const edge_table *edges, size_t point_count, int32_t *hexes) {
  hexcon_status status = HEXCON_OK;
  for (size_t h = 0; !status && h < hex_count; h++) {
    memcpy(hexes + 20 * h, corners + 8 * h, 8 * sizeof *hexes);
    for (size_t e = 0; e < 12; e++)
      hexes[20 * h + 8 + e] = (int32_t)point_count + edges->of_hex[12 * h + e];
    status = context_pass(context, h);
  }
  return status;
}

hexcon_status raise_order(hexcon_context *context, const double *points, size_t point_count,
                          const int32_t *hexes, size_t hex_count, hexcon_second_order *out) {
  memset(out, 0, sizeof *out);
  edge_table edges;
  hexcon_status status = edge_table_build(context, hexes, hex_count, &edges);
  if (!status && edges.count > CONTEXT_MAX_COUNT - point_count)
    status = context_fail(context, HEXCON_TOO_LARGE,
                          "%zu mid-edge points are more than 32-bit ids hold", edges.count);
  if (!status) {
    out->point_count = point_count + edges.count;
    out->points = append_midpoints(context, points, point_count, &edges);
    out->hexes = context_allocate(context, 20 * hex_count, sizeof *out->hexes);
    if (out->points && out->hexes)
      status = write_hexes(context, hexes, hex_count, &edges, point_count, out->hexes);
    else
      status = HEXCON_OUT_OF_MEMORY;
  }
  edge_table_free(context, &edges);
  if (status)
    hexcon_second_order_free(context, out);
  return status;
}

hexcon_status hexcon_raise_order(hexcon_context *context, const double *points, size_t point_count,
                                 const int32_t *hexes, size_t hex_count, hexcon_second_order *out) {
  context_clear(context);
  memset(out, 0, sizeof *out);
  hexcon_status status = check_hex_arrays(context, points, point_count, hexes, hex_count);
  return status ? status : raise_order(context, points, point_count, hexes, hex_count, out);
}

void hexcon_second_order_free(hexcon_context *context, hexcon_second_order *raised) {
  context_free(context, raised->points);
  context_free(context, raised->hexes);
  memset(raised, 0, sizeof *raised);
}
