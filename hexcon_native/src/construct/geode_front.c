/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include <string.h>

#include "coarse_front.h"
#include "split_closure.h"

/** The coarse surface as a front that is split in four everywhere, at the surface's own points. */
static hexcon_status split_surface(hexcon_context *context, const coarse_surface *c,
                                   const surface *s, split_front *out) {
  hexcon_status status = split_front_new(context, s, out);
  if (status)
    return status;
  memcpy(out->points, c->points, c->point_count * sizeof *out->points);
  for (size_t q = 0; q < s->quad_count; q++) {
    out->points[split_center_node(out, q)] = c->centers[q];
    for (size_t i = 0; i < 4; i++)
      out->points[split_edge_node(out, (int32_t)(4 * q + i))] = c->middles[4 * q + i];
  }
  return HEXCON_OK;
}

/** The two triangles of a Geode's inner end; the template's corners are seen from inside. */
static void write_triangles(const split_closure *closure, size_t quad, const coarse_front *out) {
  static const char *const corners[2][3] = {{"T0", "T2", "T1"}, {"T0", "T3", "T2"}};
  static const char *const middles[2][3] = {{"N", "ET1", "ET0"}, {"ET3", "ET2", "N"}};
  static const char *const means[2] = {"Ga", "Gb"};
  const hex_template *t = out->block;
  const int32_t *ids = out->block_points + quad * t->point_count;
  for (size_t k = 0; k < 2; k++) {
    size_t triangle = 2 * quad + k;
    out->means[triangle] = ids[template_row(t, means[k])];
    for (size_t i = 0; i < 3; i++) {
      out->triangles[3 * triangle + i] =
          ids[template_row(t, corners[k][i])] - (int32_t)closure->first_corner;
      out->side_middles[3 * triangle + i] = ids[template_row(t, middles[k][i])];
    }
  }
}

static hexcon_status number(hexcon_context *context, const split_closure *closure,
                            coarse_front *out) {
  const surface *s = closure->front->s;
  out->block_count = s->quad_count;
  out->mesh_point_count = closure->point_count;
  out->point_count = s->point_count;
  out->triangle_count = 2 * s->quad_count;
  hexcon_status status = coarse_front_allocate(context, out);
  if (status)
    return status;
  for (size_t v = 0; v < s->point_count; v++)
    out->points[v] = (int32_t)(closure->first_corner + v);
  for (size_t q = 0; q < s->quad_count; q++) {
    split_closure_points(closure, q, out->block_points + q * out->block->point_count);
    write_triangles(closure, q, out);
  }
  return HEXCON_OK;
}

hexcon_status coarse_front_of_geodes(hexcon_context *context, const coarse_surface *c,
                                     const surface *s, size_t surface_point_count,
                                     coarse_front *out) {
  split_front front = {0};
  split_closure closure = {0};
  memset(out, 0, sizeof *out);
  out->block = &template_geode_26;
  uint8_t *turns = context_allocate(context, s->quad_count, sizeof *turns);
  hexcon_status status = turns ? split_surface(context, c, s, &front) : HEXCON_OUT_OF_MEMORY;
  if (!status)
    status = split_closure_choose_diagonals(context, s, turns);
  if (!status)
    status = split_closure_new(context, &front, out->block, turns, surface_point_count, &closure);
  if (!status)
    status = number(context, &closure, out);
  split_closure_free(context, &closure);
  split_front_free(context, &front);
  context_free(context, turns);
  return status;
}
