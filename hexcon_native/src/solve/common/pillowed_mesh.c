/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "pillowed_mesh.h"

#include <string.h>

#include "construct/pillow.h"
#include "shape/improve/improve.h"
#include "shape/place/pillow_placement.h"

/** Rounds of untangling and of raising the worst, and passes that raise the mean. More of them take
 * ten times as long and raise the worst by a tenth. */
enum { UNTANGLINGS = 4, RAISINGS = 5, MEAN_PASSES = 2 };

/** The mesh while sheets are laid. */
typedef struct growth {
  growing_mesh mesh;
  double *points;
} growth;

static hexcon_status begin(hexcon_context *context, const filled_mesh *from, growth *g) {
  g->points = context_allocate(context, from->point_count, 3 * sizeof *g->points);
  hexcon_status status =
      g->points ? growing_mesh_reserve(context, &g->mesh, from->hex_count, from->point_count)
                : HEXCON_OUT_OF_MEMORY;
  if (status)
    return status;
  memcpy(g->points, from->points, 3 * from->point_count * sizeof *g->points);
  memcpy(g->mesh.hexes, from->hexes, 8 * from->hex_count * sizeof *g->mesh.hexes);
  g->mesh.point_count = from->point_count;
  g->mesh.hex_count = from->hex_count;
  return HEXCON_OK;
}

/** Put the copies that a sheet made between the boundary and the hexes under it. */
static hexcon_status place_copies(hexcon_context *context, growth *g, const int32_t *set,
                                  size_t set_count, const pillow_points *copies) {
  double *grown = context_grow(context, g->points, g->mesh.point_count, 3 * sizeof *grown);
  if (!grown)
    return HEXCON_OUT_OF_MEMORY;
  g->points = grown;
  return place_pillow(context, g->mesh.hexes, set, set_count, copies->originals, copies->first,
                      copies->count, g->points);
}

/** One sheet over all that there is. */
static hexcon_status lay_sheet(hexcon_context *context, growth *g) {
  size_t count = g->mesh.hex_count;
  int32_t *set = context_allocate(context, count, sizeof *set);
  int32_t *parts = context_allocate_zeroed(context, count, sizeof *parts);
  pillow_points copies = {0};
  hexcon_status status = set && parts ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  for (size_t h = 0; !status && h < count; h++)
    set[h] = (int32_t)h;
  if (!status)
    status = pillow_hexes(context, set, parts, count, &g->mesh, &copies);
  if (!status)
    status = place_copies(context, g, set, count, &copies);
  context_free(context, copies.originals);
  context_free(context, set);
  context_free(context, parts);
  return status;
}

static hexcon_status take(hexcon_context *context, growth *g, filled_mesh *out) {
  out->points = g->points;
  out->hexes = g->mesh.hexes;
  out->point_count = g->mesh.point_count;
  out->hex_count = g->mesh.hex_count;
  *g = (growth){0};
  out->quality = context_allocate(context, out->hex_count, sizeof *out->quality);
  return out->quality ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

/** Untangle; and go on with what could be made positive, which most are at once. */
static hexcon_status improve(hexcon_context *context, const uint8_t *fixed, size_t fixed_count,
                             int threads, filled_mesh *mesh) {
  const hexcon_optimize_options untangling = {
      .threads = threads, .target = 1e-6, .max_rounds = UNTANGLINGS};
  const hexcon_optimize_options raising = {
      .threads = threads, .max_rounds = RAISINGS, .mean_passes = MEAN_PASSES};
  uint8_t *all = context_allocate_zeroed(context, mesh->point_count, sizeof *all);
  if (!all)
    return HEXCON_OUT_OF_MEMORY;
  memcpy(all, fixed, fixed_count);
  hexcon_status status = filled_mesh_improve_free(context, all, &untangling, mesh);
  if (!status && mesh->inverted == 0)
    status = filled_mesh_improve_free(context, all, &raising, mesh);
  context_free(context, all);
  return status;
}

hexcon_status pillowed_mesh_make(hexcon_context *context, const filled_mesh *from,
                                 const uint8_t *fixed, size_t sheets, int threads,
                                 filled_mesh *out) {
  growth g = {0};
  *out = (filled_mesh){0};
  hexcon_status status = begin(context, from, &g);
  for (size_t i = 0; !status && i < sheets; i++)
    status = lay_sheet(context, &g);
  if (!status)
    status = take(context, &g, out);
  context_free(context, g.points);
  context_free(context, g.mesh.hexes);
  return status ? status : improve(context, fixed, from->point_count, threads, out);
}
