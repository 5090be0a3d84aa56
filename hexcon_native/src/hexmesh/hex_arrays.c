/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "hex_arrays.h"

#include <float.h>

#include "surface/checks.h"

/** Twelve edges a hex get an id of their own. */
static const size_t max_hexes = CONTEXT_MAX_COUNT / 12;

static hexcon_status check_hexes_of(hexcon_context *context, const double *points,
                                    size_t point_count, const int32_t *hexes, size_t hex_count,
                                    size_t nodes) {
  if (hex_count == 0)
    return context_fail(context, HEXCON_EMPTY, "the mesh has no hexes");
  if (hex_count > max_hexes || point_count > CONTEXT_MAX_COUNT)
    return context_fail(context, HEXCON_TOO_LARGE,
                        "%zu hexes on %zu points are more than 32-bit ids hold (%zu hexes)",
                        hex_count, point_count, max_hexes);
  hexcon_status status = check_ids(context, point_count, hexes, hex_count, nodes, "hexes");
  return status ? status : check_points(context, points, point_count, DBL_MAX);
}

hexcon_status check_hex_arrays(hexcon_context *context, const double *points, size_t point_count,
                               const int32_t *hexes, size_t hex_count) {
  return check_hexes_of(context, points, point_count, hexes, hex_count, 8);
}

hexcon_status check_second_order_arrays(hexcon_context *context, const double *points,
                                        size_t point_count, const int32_t *hexes,
                                        size_t hex_count) {
  return check_hexes_of(context, points, point_count, hexes, hex_count, 20);
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
