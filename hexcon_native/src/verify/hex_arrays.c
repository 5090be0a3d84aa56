/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "hex_arrays.h"

#include <math.h>

/** Twelve edges a hex get an id of their own. */
static const size_t max_hexes = CONTEXT_MAX_COUNT / 12;

static hexcon_status check_corner_ids(hexcon_context *context, size_t point_count,
                                      const int32_t *hexes, size_t hex_count) {
  size_t bad = 0;
  for (size_t h = 0; h < hex_count; h++) {
    bool outside = false;
    for (size_t corner = 0; corner < 8; corner++) {
      int32_t v = hexes[8 * h + corner];
      outside |= v < 0 || (size_t)v >= point_count;
    }
    if (outside) {
      context_add_element(context, (int32_t)h);
      bad++;
    }
  }
  if (bad)
    return context_fail(context, HEXCON_INDEX_OUT_OF_RANGE,
                        "%zu hexes (listed) name points outside 0 .. %zd; ids are 0-based", bad,
                        (ptrdiff_t)point_count - 1);
  return HEXCON_OK;
}

hexcon_status check_hex_arrays(hexcon_context *context, const double *points, size_t point_count,
                               const int32_t *hexes, size_t hex_count) {
  if (hex_count == 0)
    return context_fail(context, HEXCON_EMPTY, "the mesh has no hexes");
  if (hex_count > max_hexes || point_count > CONTEXT_MAX_COUNT)
    return context_fail(context, HEXCON_TOO_LARGE,
                        "%zu hexes on %zu points are more than 32-bit ids hold (%zu hexes)",
                        hex_count, point_count, max_hexes);
  hexcon_status status = check_corner_ids(context, point_count, hexes, hex_count);
  if (status)
    return status;
  size_t bad = 0;
  for (size_t v = 0; v < point_count; v++)
    if (!isfinite(points[3 * v]) || !isfinite(points[3 * v + 1]) || !isfinite(points[3 * v + 2])) {
      context_add_element(context, (int32_t)v);
      bad++;
    }
  if (bad)
    return context_fail(context, HEXCON_NOT_FINITE,
                        "%zu points (listed) have a coordinate that is NaN or infinite", bad);
  return HEXCON_OK;
}

hexcon_status check_hex_corners(hexcon_context *context, const int32_t *hexes, size_t hex_count) {
  size_t bad = 0;
  for (size_t h = 0; h < hex_count; h++) {
    const int32_t *v = hexes + 8 * h;
    bool repeated = false;
    for (int i = 0; i < 8; i++)
      for (int j = 0; j < i; j++)
        repeated |= v[i] == v[j];
    if (repeated) {
      context_add_element(context, (int32_t)h);
      bad++;
    }
  }
  if (bad)
    return context_fail(context, HEXCON_REPEATED_VERTEX,
                        "%zu hexes (listed) have a corner twice; they are wedges or worse", bad);
  return HEXCON_OK;
}
