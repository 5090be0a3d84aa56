/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "region.h"

#include <string.h>

hexcon_status region_set_new(hexcon_context *context, const int32_t *hexes, size_t hex_count,
                             size_t point_count, const uint8_t *fixed, region_set *out) {
  *out = (region_set){.mesh_point_count = point_count,
                      .mesh_hex_count = hex_count,
                      .mesh_hexes = hexes,
                      .fixed = fixed};
  out->region_of_hex = context_allocate(context, hex_count, sizeof *out->region_of_hex);
  out->point_taken = context_allocate_zeroed(context, point_count, sizeof *out->point_taken);
  out->point_starts = context_allocate_zeroed(context, hex_count + 1, sizeof *out->point_starts);
  out->hex_starts = context_allocate_zeroed(context, hex_count + 1, sizeof *out->hex_starts);
  out->points = context_allocate(context, point_count, sizeof *out->points);
  out->hexes = context_allocate(context, hex_count, sizeof *out->hexes);
  if (!out->region_of_hex || !out->point_taken || !out->point_starts || !out->hex_starts ||
      !out->points || !out->hexes)
    return HEXCON_OUT_OF_MEMORY;
  memset(out->region_of_hex, -1, hex_count * sizeof *out->region_of_hex);
  return corner_table_build(context, hexes, hex_count, point_count, &out->corners);
}

void region_set_free(hexcon_context *context, region_set *set) {
  corner_table_free(context, &set->corners);
  context_free(context, set->region_of_hex);
  context_free(context, set->point_taken);
  context_free(context, set->point_starts);
  context_free(context, set->hex_starts);
  context_free(context, set->points);
  context_free(context, set->hexes);
  memset(set, 0, sizeof *set);
}

/** The region being added; its ends move as it grows. */
typedef struct growth {
  region_set *set;
  size_t point_end, hex_end;
  bool clash;
} growth;

static void take_points_of(growth *g, int32_t hex) {
  region_set *set = g->set;
  for (size_t c = 0; c < 8; c++) {
    int32_t v = set->mesh_hexes[8 * (size_t)hex + c];
    if (set->fixed[v] || set->point_taken[v])
      continue;
    set->point_taken[v] = 1;
    set->points[g->point_end++] = v;
  }
}

/** All hexes at the points from `first` on. */
static void take_hexes_at(growth *g, size_t first) {
  region_set *set = g->set;
  for (size_t i = first; i < g->point_end; i++) {
    size_t v = (size_t)set->points[i];
    for (size_t c = set->corners.starts[v]; c < set->corners.starts[v + 1]; c++) {
      int32_t hex = set->corners.corners[c] / 8, *region = &set->region_of_hex[hex];
      g->clash = g->clash || (*region >= 0 && (size_t)*region != set->count);
      if (*region >= 0)
        continue;
      *region = (int32_t)set->count;
      set->hexes[g->hex_end++] = hex;
    }
  }
}

static void release(region_set *set, size_t first_point, size_t first_hex, const growth *g) {
  for (size_t i = first_point; i < g->point_end; i++)
    set->point_taken[set->points[i]] = 0;
  for (size_t i = first_hex; i < g->hex_end; i++)
    set->region_of_hex[set->hexes[i]] = -1;
}

bool region_set_add(region_set *set, const int32_t *seeds, size_t seed_count, int layers) {
  size_t first_point = set->point_starts[set->count], first_hex = set->hex_starts[set->count];
  growth g = {set, first_point, first_hex, false};
  for (size_t i = 0; i < seed_count; i++) {
    int32_t region = set->region_of_hex[seeds[i]];
    g.clash = g.clash || region >= 0;
    if (!g.clash)
      take_points_of(&g, seeds[i]);
  }
  size_t points_done = first_point, hexes_done = first_hex;
  for (int layer = 0; !g.clash && layer <= layers; layer++) {
    for (size_t i = hexes_done; layer > 0 && i < g.hex_end; i++)
      take_points_of(&g, set->hexes[i]);
    hexes_done = layer > 0 ? g.hex_end : first_hex;
    take_hexes_at(&g, points_done);
    points_done = g.point_end;
  }
  if (g.clash || g.point_end == first_point) {
    release(set, first_point, first_hex, &g);
    return false;
  }
  set->count++;
  set->point_starts[set->count] = g.point_end;
  set->hex_starts[set->count] = g.hex_end;
  return true;
}

void region_set_clear(region_set *set) {
  growth all = {set, set->point_starts[set->count], set->hex_starts[set->count], false};
  release(set, 0, 0, &all);
  set->count = 0;
}
