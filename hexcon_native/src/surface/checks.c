/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "checks.h"

#include <math.h>

static hexcon_status check_counts(hexcon_context *context, size_t point_count, size_t quad_count) {
  if (quad_count == 0)
    return context_fail(context, HEXCON_EMPTY, "the surface has no quads");
  if (quad_count > CONTEXT_MAX_COUNT / 4 || point_count > CONTEXT_MAX_COUNT)
    return context_fail(context, HEXCON_TOO_LARGE,
                        "%zu quads on %zu points are more than 32-bit ids hold (%zu quads)",
                        quad_count, point_count, CONTEXT_MAX_COUNT / 4);
  return HEXCON_OK;
}

hexcon_status check_ids(hexcon_context *context, size_t point_count, const int32_t *ids,
                        size_t row_count, size_t width, const char *rows) {
  size_t bad = 0;
  for (size_t row = 0; row < row_count; row++) {
    bool outside = false;
    for (size_t i = 0; i < width; i++) {
      int32_t v = ids[width * row + i];
      outside |= v < 0 || (size_t)v >= point_count;
    }
    if (outside) {
      context_add_element(context, (int32_t)row);
      bad++;
    }
  }
  if (bad)
    return context_fail(context, HEXCON_INDEX_OUT_OF_RANGE,
                        "%zu %s (listed) name points outside 0 .. %zd; ids are 0-based", bad, rows,
                        (ptrdiff_t)point_count - 1);
  return HEXCON_OK;
}

static hexcon_status check_repeats(hexcon_context *context, const int32_t *quads,
                                   size_t quad_count) {
  size_t bad = 0;
  for (size_t q = 0; q < quad_count; q++) {
    const int32_t *v = quads + 4 * q;
    if (v[0] == v[1] || v[0] == v[2] || v[0] == v[3] || v[1] == v[2] || v[1] == v[3] ||
        v[2] == v[3]) {
      context_add_element(context, (int32_t)q);
      bad++;
    }
  }
  if (bad)
    return context_fail(context, HEXCON_REPEATED_VERTEX,
                        "%zu quads (listed) have a point twice: triangles or collapsed quads; mesh "
                        "the surface with quads only",
                        bad);
  return HEXCON_OK;
}

hexcon_status check_points(hexcon_context *context, const double *points, size_t point_count,
                           double largest) {
  size_t bad = 0;
  for (size_t v = 0; v < point_count; v++) {
    bool good = true; /* stays false for NaN, which compares false */
    for (size_t i = 0; i < 3; i++)
      good &= fabs(points[3 * v + i]) <= largest;
    if (!good) {
      context_add_element(context, (int32_t)v);
      bad++;
    }
  }
  if (bad)
    return context_fail(context, HEXCON_NOT_FINITE,
                        "%zu points (listed) have a coordinate that is NaN, infinite or beyond %g",
                        bad, largest);
  return HEXCON_OK;
}

static hexcon_status check_use(hexcon_context *context, size_t point_count, const int32_t *quads,
                               size_t quad_count) {
  uint8_t *used = context_allocate_zeroed(context, point_count, 1);
  if (!used)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t i = 0; i < 4 * quad_count; i++)
    used[quads[i]] = 1;
  size_t bad = 0;
  for (size_t v = 0; v < point_count; v++)
    if (!used[v]) {
      context_add_element(context, (int32_t)v);
      bad++;
    }
  context_free(context, used);
  if (bad)
    return context_fail(context, HEXCON_UNUSED_POINT,
                        "%zu points (listed) belong to no quad and would be loose nodes; remove "
                        "them",
                        bad);
  return HEXCON_OK;
}

hexcon_status check_arrays(hexcon_context *context, const double *points, size_t point_count,
                           const int32_t *quads, size_t quad_count) {
  hexcon_status status = check_counts(context, point_count, quad_count);
  if (!status)
    status = check_ids(context, point_count, quads, quad_count, 4, "quads");
  if (!status && points)
    status = check_points(context, points, point_count, largest_coordinate);
  if (!status)
    status = check_repeats(context, quads, quad_count);
  if (!status && points)
    status = check_use(context, point_count, quads, quad_count);
  return status;
}
