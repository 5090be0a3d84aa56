/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "groups.h"

#include <string.h>

hexcon_status hex_groups_new(hexcon_context *context, size_t hex_count, hex_groups *out) {
  *out = (hex_groups){0};
  out->starts = context_allocate_zeroed(context, hex_count + 1, sizeof *out->starts);
  out->hexes = context_allocate(context, hex_count, sizeof *out->hexes);
  out->wanted = context_allocate_zeroed(context, hex_count, sizeof *out->wanted);
  return out->starts && out->hexes && out->wanted ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

void hex_groups_free(hexcon_context *context, hex_groups *groups) {
  context_free(context, groups->starts);
  context_free(context, groups->hexes);
  context_free(context, groups->wanted);
  memset(groups, 0, sizeof *groups);
}

/** Append the wanted hexes around one to the list, up to `limit` entries. */
static size_t append_neighbours(const region_set *set, int32_t hex, size_t end, size_t limit,
                                hex_groups *groups) {
  for (size_t c = 0; c < 8; c++) {
    size_t v = (size_t)set->mesh_hexes[8 * (size_t)hex + c];
    for (size_t k = set->corners.starts[v]; !set->fixed[v] && k < set->corners.starts[v + 1]; k++) {
      int32_t other = set->corners.corners[k] / 8;
      if (!groups->wanted[other] || end == limit)
        continue;
      groups->wanted[other] = 0;
      groups->hexes[end++] = other;
    }
  }
  return end;
}

hexcon_status hex_groups_fill(hexcon_context *context, const region_set *set, const int32_t *seeds,
                              size_t seed_count, size_t limit, hex_groups *groups) {
  hexcon_status status = HEXCON_OK;
  for (size_t i = 0; i < seed_count; i++)
    groups->wanted[seeds[i]] = 1;
  groups->count = 0;
  size_t end = 0;
  for (size_t i = 0; !status && i < seed_count; i++) {
    if (!groups->wanted[seeds[i]])
      continue;
    size_t next = end, most = limit < seed_count - end ? end + limit : seed_count;
    groups->wanted[seeds[i]] = 0;
    groups->hexes[end++] = seeds[i];
    for (; !status && next < end; next++) {
      end = append_neighbours(set, groups->hexes[next], end, most, groups);
      status = context_pass(context, next);
    }
    groups->starts[++groups->count] = end;
  }
  return status;
}
