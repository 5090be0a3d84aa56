/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "patch.h"

#include <string.h>

#include "base/vector.h"
#include "hexmesh/hex_tables.h"

static void number_corners(const int32_t *hexes, const double *positions, int32_t *slots,
                           patch *p) {
  for (size_t h = 0; h < p->hex_count; h++)
    for (size_t c = 0; c < 8; c++) {
      int32_t v = hexes[8 * (size_t)p->hexes[h] + c];
      if (slots[v] < 0) {
        slots[v] = (int32_t)p->point_count;
        p->points[p->point_count++] = v;
      }
      p->corners[8 * h + hex_corner_bits[c]] = slots[v];
    }
  for (size_t i = 0; i < p->point_count; i++) {
    memcpy(p->x + 3 * i, positions + 3 * (size_t)p->points[i], 3 * sizeof *p->x);
    slots[p->points[i]] = -1;
  }
}

/** Corners of the hexes beside the free points, which have slots already; those are left as they
 * are. */
static size_t count_others(const int32_t *hexes, const int32_t *hex_ids, size_t hex_count,
                           int32_t *slots) {
  const int32_t counted = INT32_MAX;
  size_t count = 0;
  for (int pass = 0; pass < 2; pass++)
    for (size_t h = 0; h < hex_count; h++)
      for (size_t c = 0; c < 8; c++) {
        int32_t *slot = &slots[hexes[8 * (size_t)hex_ids[h] + c]];
        count += pass == 0 && *slot < 0;
        if (*slot == (pass == 0 ? -1 : counted))
          *slot = pass == 0 ? counted : -1;
      }
  return count;
}

hexcon_status patch_copy(hexcon_context *context, const int32_t *hexes, const double *positions,
                         const int32_t *free_points, size_t free_count, const int32_t *hex_ids,
                         size_t hex_count, int32_t *slots, patch *out) {
  for (size_t i = 0; i < free_count; i++)
    slots[free_points[i]] = (int32_t)i;
  size_t most = free_count + count_others(hexes, hex_ids, hex_count, slots);
  *out = (patch){.free_count = free_count,
                 .point_count = free_count,
                 .hex_count = hex_count,
                 .smallest_edge = PATCH_SMALLEST_EDGE};
  out->points = context_allocate(context, most, sizeof *out->points);
  out->hexes = context_allocate(context, hex_count, sizeof *out->hexes);
  out->corners = context_allocate(context, hex_count, 8 * sizeof *out->corners);
  out->x = context_allocate(context, most, 3 * sizeof *out->x);
  out->stretch = context_allocate(context, hex_count, PATCH_EDGES * sizeof *out->stretch);
  out->watched = context_allocate_zeroed(context, hex_count, sizeof *out->watched);
  if (!out->points || !out->hexes || !out->corners || !out->x || !out->stretch || !out->watched) {
    for (size_t i = 0; i < free_count; i++)
      slots[free_points[i]] = -1;
    return HEXCON_OUT_OF_MEMORY;
  }
  memcpy(out->points, free_points, free_count * sizeof *free_points);
  memcpy(out->hexes, hex_ids, hex_count * sizeof *hex_ids);
  number_corners(hexes, positions, slots, out);
  return HEXCON_OK;
}

void patch_free(hexcon_context *context, patch *p) {
  context_free(context, p->points);
  context_free(context, p->hexes);
  context_free(context, p->corners);
  context_free(context, p->x);
  context_free(context, p->stretch);
  context_free(context, p->watched);
  memset(p, 0, sizeof *p);
}

void patch_edge_lengths(const patch *p, size_t hex, double *lengths) {
  const int32_t *corners = p->corners + 8 * hex;
  for (int e = 0; e < PATCH_EDGES; e++) {
    int start = patch_edge_start(e);
    double edge[3];
    vector_subtract(p->x + 3 * (size_t)corners[start | 1 << e / 4],
                    p->x + 3 * (size_t)corners[start], edge);
    lengths[e] = vector_length(edge);
  }
}

void patch_target_own_lengths(patch *p, double smallest) {
  for (size_t h = 0; h < p->hex_count; h++) {
    double *stretch = p->stretch + PATCH_EDGES * h, longest = 0;
    patch_edge_lengths(p, h, stretch);
    for (int e = 0; e < PATCH_EDGES; e++)
      longest = fmax(longest, stretch[e]);
    for (int e = 0; e < PATCH_EDGES; e++)
      stretch[e] = longest > 0 ? 1 / fmax(stretch[e], smallest * longest) : 1;
  }
}
