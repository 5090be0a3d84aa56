/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "disc_pattern.h"

size_t disc_shape_quads(const disc_shape *shape) {
  return shape->a * shape->b + shape->rings * 2 * (shape->a + shape->b);
}

size_t disc_shape_across(const disc_shape *shape, size_t edge) {
  const size_t half = shape->a + shape->b, rim = 2 * half,
               along = (edge + rim - shape->first % rim) % rim;
  const size_t sum = along % half < shape->a ? half : rim; /* of a pair, and 1 - a */
  return (shape->first + sum + shape->a - 1 - along) % rim;
}

void disc_pattern_free(hexcon_context *context, disc_pattern *pattern) {
  context_free(context, pattern->quads);
  *pattern = (disc_pattern){0};
}

/** Point of the grid, i along a and j along b: its rim is the innermost ring. */
static int32_t grid_point(const disc_shape *shape, size_t i, size_t j) {
  const size_t a = shape->a, b = shape->b, rim = 2 * (a + b);
  size_t along;
  if (j == 0)
    along = i;
  else if (i == a)
    along = a + j;
  else if (j == b)
    along = 2 * a + b - i;
  else if (i == 0)
    along = rim - j;
  else
    return (int32_t)((shape->rings + 1) * rim + (i - 1) * (b - 1) + j - 1);
  return (int32_t)(shape->rings * rim + (shape->first + along) % rim);
}

static void write_ring(size_t rim, size_t ring, int32_t *quads) {
  for (size_t k = 0; k < rim; k++) {
    const size_t outer = ring * rim, inner = outer + rim, next = (k + 1) % rim;
    quads[4 * k] = (int32_t)(outer + k);
    quads[4 * k + 1] = (int32_t)(outer + next);
    quads[4 * k + 2] = (int32_t)(inner + next);
    quads[4 * k + 3] = (int32_t)(inner + k);
  }
}

static void write_grid(const disc_shape *shape, int32_t *quads) {
  for (size_t i = 0; i < shape->a; i++)
    for (size_t j = 0; j < shape->b; j++) {
      int32_t *quad = quads + 4 * (i * shape->b + j);
      quad[0] = grid_point(shape, i, j);
      quad[1] = grid_point(shape, i + 1, j);
      quad[2] = grid_point(shape, i + 1, j + 1);
      quad[3] = grid_point(shape, i, j + 1);
    }
}

hexcon_status disc_pattern_build(hexcon_context *context, const disc_shape *shape,
                                 disc_pattern *out) {
  const size_t rim = 2 * (shape->a + shape->b), quads = disc_shape_quads(shape);
  *out = (disc_pattern){.rim_count = rim, .quad_count = quads};
  if (quads >= CONTEXT_MAX_COUNT / 2)
    return context_fail(context, HEXCON_TOO_LARGE,
                        "a cut of %zu quads has more points than 32-bit ids hold", quads);
  out->point_count = rim * (shape->rings + 1) + (shape->a - 1) * (shape->b - 1);
  out->quads = context_allocate(context, quads, 4 * sizeof *out->quads);
  if (!out->quads)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t ring = 0; ring < shape->rings; ring++)
    write_ring(rim, ring, out->quads + 4 * ring * rim);
  write_grid(shape, out->quads + 4 * shape->rings * rim);
  return HEXCON_OK;
}
