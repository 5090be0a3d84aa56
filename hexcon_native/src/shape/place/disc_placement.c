/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "disc_placement.h"

#include <string.h>

#include "harmonic.h"

static hexcon_status place_axis(hexcon_context *context, harmonic *spread, size_t rim_count,
                                int axis, double *values, double *points) {
  for (size_t v = 0; v < rim_count; v++)
    values[v] = points[3 * v + (size_t)axis];
  hexcon_status status = harmonic_extend(context, spread, 0, values);
  for (size_t v = rim_count; !status && v < spread->point_count; v++)
    points[3 * v + (size_t)axis] = values[v];
  return status;
}

hexcon_status disc_place(hexcon_context *context, const int32_t *quads, size_t quad_count,
                         size_t rim_count, size_t point_count, double *points) {
  if (point_count == rim_count)
    return HEXCON_OK;
  harmonic spread = {0};
  uint8_t *on_rim = context_allocate_zeroed(context, point_count, sizeof *on_rim);
  double *values = context_allocate_zeroed(context, point_count, sizeof *values);
  hexcon_status status = on_rim && values ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  if (!status) {
    memset(on_rim, 1, rim_count);
    status = harmonic_new(context, quads, quad_count, on_rim, point_count, &spread);
  }
  for (int axis = 0; !status && axis < 3; axis++)
    status = place_axis(context, &spread, rim_count, axis, values, points);
  harmonic_free(context, &spread);
  context_free(context, on_rim);
  context_free(context, values);
  return status;
}
