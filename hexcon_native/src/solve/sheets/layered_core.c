/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "layered_core.h"

#include <string.h>

void layered_core_free(hexcon_context *context, layered_core *core) {
  context_free(context, core->points);
  context_free(context, core->hexes);
  surface_free(context, &core->s);
  context_free(context, core->core_points);
  context_free(context, core->ids);
  context_free(context, core->quad_ids);
  memset(core, 0, sizeof *core);
}

/** Quads alive get numbers of their own, in their order. */
static void number_quads(const sheet_front *front, int32_t *numbers, int32_t *ids) {
  int32_t count = 0;
  for (size_t q = 0; q < front->s.quad_count; q++)
    if (front->alive[q]) {
      ids[count] = (int32_t)q;
      numbers[q] = count++;
    }
}

static void copy_quads(const sheet_front *front, const int32_t *numbers, surface *s) {
  for (int32_t h = 0; h < (int32_t)(4 * front->s.quad_count); h++) {
    if (!front->alive[half_edge_quad(h)])
      continue;
    size_t to = 4 * (size_t)numbers[half_edge_quad(h)] + ((size_t)h & 3);
    int32_t twin = front->s.twins[h];
    s->quads[to] = front->s.quads[h];
    s->twins[to] = 4 * numbers[half_edge_quad(twin)] + (twin & 3);
  }
}

/** Points get numbers in the order of the mesh's: so those of the outer surface come first. */
static void number_points(size_t point_count, int32_t *numbers, layered_core *core) {
  surface *s = &core->s;
  memset(numbers, 0, point_count * sizeof *numbers);
  for (size_t i = 0; i < 4 * s->quad_count; i++)
    numbers[s->quads[i]] = 1;
  s->point_count = 0;
  for (size_t v = 0; v < point_count; v++)
    if (numbers[v]) {
      core->ids[s->point_count] = (int32_t)v;
      numbers[v] = (int32_t)s->point_count++;
    }
  for (size_t i = 0; i < 4 * s->quad_count; i++)
    s->quads[i] = numbers[s->quads[i]];
}

void layered_core_follow(layered_core *core) {
  for (size_t v = 0; v < core->s.point_count; v++)
    memcpy(core->core_points + 3 * v, core->points + 3 * (size_t)core->ids[v],
           3 * sizeof *core->points);
}

static hexcon_status copy_front(hexcon_context *context, const sheet_front *front,
                                layered_core *out) {
  size_t count = front->alive_count, points = front->mesh.point_count;
  size_t numbered = points > front->s.quad_count ? points : front->s.quad_count;
  surface *s = &out->s;
  s->quad_count = count;
  s->component_count = 1;
  s->quads = context_allocate(context, count, 4 * sizeof *s->quads);
  s->twins = context_allocate(context, count, 4 * sizeof *s->twins);
  s->component_of_quad = context_allocate_zeroed(context, count, sizeof *s->component_of_quad);
  out->ids = context_allocate(context, count + 2, sizeof *out->ids); /* a sphere's: Euler */
  out->core_points = context_allocate(context, count + 2, 3 * sizeof *out->core_points);
  out->quad_ids = context_allocate(context, count, sizeof *out->quad_ids);
  int32_t *numbers = context_allocate(context, numbered, sizeof *numbers);
  bool ready = s->quads && s->twins && s->component_of_quad && out->ids && out->quad_ids &&
               out->core_points && numbers;
  if (ready) {
    number_quads(front, numbers, out->quad_ids);
    copy_quads(front, numbers, s);
    number_points(points, numbers, out);
    s->points = out->core_points;
  }
  context_free(context, numbers);
  return ready ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

hexcon_status layered_core_take(hexcon_context *context, sheet_search *search, layered_core *out) {
  memset(out, 0, sizeof *out);
  hexcon_status status = search->complete ? HEXCON_OK : copy_front(context, &search->front, out);
  if (status)
    return status;
  out->point_count = search->front.mesh.point_count;
  out->hex_count = search->front.mesh.hex_count;
  out->layer_count = search->front.layer_count;
  out->points = search->points;
  out->hexes = search->front.mesh.hexes;
  search->points = NULL;
  search->front.mesh.hexes = NULL;
  layered_core_follow(out);
  return HEXCON_OK;
}

static void write_cover(const surface *s, int32_t *hexes) {
  for (size_t i = 0; i < 4 * s->quad_count; i++) {
    int32_t *hex = hexes + 8 * (i / 4), outer = s->quads[i];
    hex[i % 4 + 4] = outer;
    hex[i % 4] = outer + (int32_t)s->point_count;
  }
}

hexcon_status layered_core_cover(hexcon_context *context, const surface *s, layered_core *core) {
  size_t shift = s->point_count, point_count = core->point_count + shift;
  size_t hex_count = core->hex_count + s->quad_count;
  if (point_count >= CONTEXT_MAX_COUNT)
    return context_fail(context, HEXCON_TOO_LARGE, "the mesh has too many points");
  double *points = context_allocate(context, point_count, 3 * sizeof *points);
  int32_t *hexes = context_allocate(context, hex_count, 8 * sizeof *hexes);
  if (!points || !hexes) {
    context_free(context, points);
    context_free(context, hexes);
    return HEXCON_OUT_OF_MEMORY;
  }
  memcpy(points, s->points, 3 * shift * sizeof *points);
  memcpy(points + 3 * shift, core->points, 3 * core->point_count * sizeof *points);
  write_cover(s, hexes);
  for (size_t i = 0; i < 8 * core->hex_count; i++)
    hexes[8 * s->quad_count + i] = core->hexes[i] + (int32_t)shift;
  for (size_t v = 0; v < core->s.point_count; v++)
    core->ids[v] += (int32_t)shift;
  context_free(context, core->points);
  context_free(context, core->hexes);
  core->points = points;
  core->hexes = hexes;
  core->point_count = point_count;
  core->hex_count = hex_count;
  core->layer_count++;
  core->covered = true;
  return HEXCON_OK;
}
