/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "region.h"

#include <string.h>

hexcon_status region_mesh_build(hexcon_context *context, const int32_t *hexes, size_t hex_count,
                                size_t point_count, const uint8_t *fixed, region_mesh *mesh) {
  *mesh = (region_mesh){
      .point_count = point_count, .hex_count = hex_count, .hexes = hexes, .fixed = fixed};
  mesh->slot_of_point = context_allocate(context, point_count, sizeof *mesh->slot_of_point);
  mesh->hex_seen = context_allocate_zeroed(context, hex_count, sizeof *mesh->hex_seen);
  if (!mesh->slot_of_point || !mesh->hex_seen)
    return HEXCON_OUT_OF_MEMORY;
  memset(mesh->slot_of_point, -1, point_count * sizeof *mesh->slot_of_point);
  return corner_table_build(context, hexes, hex_count, point_count, &mesh->corners);
}

void region_mesh_free(hexcon_context *context, region_mesh *mesh) {
  context_free(context, mesh->slot_of_point);
  context_free(context, mesh->hex_seen);
  corner_table_free(context, &mesh->corners);
  memset(mesh, 0, sizeof *mesh);
}

hexcon_status region_new(hexcon_context *context, const region_mesh *mesh, region *out) {
  memset(out, 0, sizeof *out);
  out->points = context_allocate(context, mesh->point_count, sizeof *out->points);
  out->hexes = context_allocate(context, mesh->hex_count, sizeof *out->hexes);
  return out->points && out->hexes ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

void region_free(hexcon_context *context, region *r) {
  context_free(context, r->points);
  context_free(context, r->hexes);
  memset(r, 0, sizeof *r);
}

static void add_points_of(region_mesh *mesh, int32_t hex, region *r) {
  for (size_t c = 0; c < 8; c++) {
    int32_t v = mesh->hexes[8 * (size_t)hex + c];
    if (mesh->fixed[v] || mesh->slot_of_point[v] >= 0)
      continue;
    mesh->slot_of_point[v] = (int32_t)r->point_count;
    r->points[r->point_count++] = v;
  }
}

/** All hexes at the points from `first` on. */
static void add_hexes_at(region_mesh *mesh, size_t first, region *r) {
  for (size_t i = first; i < r->point_count; i++) {
    int32_t v = r->points[i];
    for (size_t c = mesh->corners.starts[v]; c < mesh->corners.starts[v + 1]; c++) {
      int32_t hex = mesh->corners.corners[c] / 8;
      if (mesh->hex_seen[hex])
        continue;
      mesh->hex_seen[hex] = 1;
      r->hexes[r->hex_count++] = hex;
    }
  }
}

void region_open(region_mesh *mesh, const int32_t *seeds, size_t seed_count, int layers,
                 region *r) {
  r->point_count = r->hex_count = 0;
  for (size_t i = 0; i < seed_count; i++)
    add_points_of(mesh, seeds[i], r);
  add_hexes_at(mesh, 0, r);
  size_t points_done = r->point_count, hexes_done = 0;
  for (int layer = 0; layer < layers; layer++) {
    size_t hexes_now = r->hex_count;
    for (size_t i = hexes_done; i < hexes_now; i++)
      add_points_of(mesh, r->hexes[i], r);
    hexes_done = hexes_now;
    add_hexes_at(mesh, points_done, r);
    points_done = r->point_count;
  }
}

void region_close(region_mesh *mesh, region *r) {
  for (size_t i = 0; i < r->point_count; i++)
    mesh->slot_of_point[r->points[i]] = -1;
  for (size_t i = 0; i < r->hex_count; i++)
    mesh->hex_seen[r->hexes[i]] = 0;
  r->point_count = r->hex_count = 0;
}
