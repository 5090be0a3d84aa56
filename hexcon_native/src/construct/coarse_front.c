/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "coarse_front.h"

#include <string.h>

/** Rows of the pyramid's points. */
typedef struct pyramid_rows {
  int corners[4], edges[4], uprights[4], sides[4], center, apex;
} pyramid_rows;

static void find_rows(const hex_template *t, char letter, int rows[4]) {
  for (size_t i = 0; i < 4; i++) {
    const char label[3] = {letter, (char)('0' + i), '\0'};
    rows[i] = template_row(t, label);
  }
}

static pyramid_rows find_pyramid_rows(const hex_template *t) {
  pyramid_rows rows = {.center = template_row(t, "Bc"), .apex = template_row(t, "A")};
  find_rows(t, 'B', rows.corners);
  find_rows(t, 'E', rows.edges);
  find_rows(t, 'M', rows.uprights);
  find_rows(t, 'G', rows.sides);
  return rows;
}

void coarse_front_free(hexcon_context *context, coarse_front *front) {
  context_free(context, front->block_points);
  context_free(context, front->points);
  context_free(context, front->triangles);
  context_free(context, front->means);
  context_free(context, front->side_middles);
  memset(front, 0, sizeof *front);
}

/** Points of a pyramid that are not its base's. */
static size_t own_points(const hex_template *pyramid) {
  return pyramid->point_count - 9;
}

hexcon_status coarse_front_allocate(hexcon_context *context, coarse_front *front) {
  size_t block_points = front->block_count * front->block->point_count;
  front->block_points = context_allocate(context, block_points, sizeof *front->block_points);
  front->points = context_allocate(context, front->point_count, sizeof *front->points);
  front->triangles = context_allocate(context, 3 * front->triangle_count, sizeof *front->triangles);
  front->means = context_allocate(context, front->triangle_count, sizeof *front->means);
  front->side_middles =
      context_allocate(context, 3 * front->triangle_count, sizeof *front->side_middles);
  return front->block_points && front->points && front->triangles && front->means &&
                 front->side_middles
             ? HEXCON_OK
             : HEXCON_OUT_OF_MEMORY;
}

static hexcon_status allocate(hexcon_context *context, const coarse_surface *c,
                              size_t surface_point_count, coarse_front *out) {
  size_t own = own_points(out->block), quads = c->quad_count;
  if (quads > (CONTEXT_MAX_COUNT - surface_point_count) / (2 * own))
    return context_fail(context, HEXCON_TOO_LARGE,
                        "pyramids on %zu coarse quads have more points than 32-bit ids hold",
                        quads);
  out->block_count = quads;
  out->mesh_point_count = surface_point_count + own * quads;
  out->point_count = c->point_count + quads;
  out->triangle_count = c->triangle_count + 4 * quads;
  return coarse_front_allocate(context, out);
}

/** Side i of a base runs against the quad's side 3 - i: it is seen from inside. */
static void number_pyramid(const coarse_surface *c, size_t quad, const pyramid_rows *rows,
                           size_t surface_point_count, const coarse_front *out) {
  const hex_template *t = out->block;
  size_t face = c->triangle_count + quad;
  int32_t *ids = out->block_points + quad * t->point_count;
  memset(ids, -1, t->point_count * sizeof *ids);
  for (size_t i = 0; i < 4; i++) {
    ids[rows->corners[i]] = c->points[c->faces[4 * face + ((4 - i) & 3)]];
    ids[rows->edges[i]] = c->middles[4 * face + (3 - i)];
  }
  ids[rows->center] = c->centers[face];
  size_t next = surface_point_count + quad * own_points(t);
  for (size_t row = 0; row < t->point_count; row++)
    if (ids[row] < 0)
      ids[row] = (int32_t)next++;
}

static void write_sides(const coarse_surface *c, size_t quad, const pyramid_rows *rows,
                        const coarse_front *out) {
  const int32_t *ids = out->block_points + quad * out->block->point_count;
  const int32_t *corners = c->faces + 4 * (c->triangle_count + quad);
  size_t apex = c->point_count + quad;
  out->points[apex] = ids[rows->apex];
  for (size_t i = 0; i < 4; i++) {
    size_t after = (i + 1) % 4, triangle = c->triangle_count + 4 * quad + i;
    const int32_t side[3] = {corners[(4 - after) & 3], corners[(4 - i) & 3], (int32_t)apex};
    const int32_t middles[3] = {ids[rows->edges[i]], ids[rows->uprights[i]],
                                ids[rows->uprights[after]]};
    memcpy(out->triangles + 3 * triangle, side, sizeof side);
    memcpy(out->side_middles + 3 * triangle, middles, sizeof middles);
    out->means[triangle] = ids[rows->sides[i]];
  }
}

hexcon_status coarse_front_of_pyramids(hexcon_context *context, const coarse_surface *c,
                                       size_t surface_point_count, coarse_front *out) {
  memset(out, 0, sizeof *out);
  out->block = &template_schneiders_pyramid_36;
  hexcon_status status = template_check(context, out->block);
  if (!status)
    status = allocate(context, c, surface_point_count, out);
  if (status)
    return status;
  memcpy(out->points, c->points, c->point_count * sizeof *out->points);
  for (size_t t = 0; t < c->triangle_count; t++) {
    memcpy(out->triangles + 3 * t, c->faces + 4 * t, 3 * sizeof *out->triangles);
    memcpy(out->side_middles + 3 * t, c->middles + 4 * t, 3 * sizeof *out->side_middles);
    out->means[t] = c->centers[t];
  }
  pyramid_rows rows = find_pyramid_rows(out->block);
  for (size_t q = 0; q < c->quad_count; q++) {
    number_pyramid(c, q, &rows, surface_point_count, out);
    write_sides(c, q, &rows, out);
  }
  return HEXCON_OK;
}
