/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "build.h"

#include <string.h>

#include "checks.h"
#include "shells.h"

static hexcon_status build(hexcon_context *context, const double *points, size_t point_count,
                           const int32_t *quads, size_t quad_count, bool turning, surface *out) {
  memset(out, 0, sizeof *out);
  hexcon_status status = check_arrays(context, points, point_count, quads, quad_count);
  if (!status)
    status = context_after(context, quad_count);
  if (status)
    return status;
  out->points = points;
  out->point_count = point_count;
  out->quad_count = quad_count;
  out->quads = context_allocate(context, 4 * quad_count, sizeof *out->quads);
  out->twins = context_allocate(context, 4 * quad_count, sizeof *out->twins);
  out->component_of_quad = context_allocate(context, quad_count, sizeof *out->component_of_quad);
  if (!out->quads || !out->twins || !out->component_of_quad)
    return HEXCON_OUT_OF_MEMORY;
  memcpy(out->quads, quads, 4 * quad_count * sizeof *quads);
  status = surface_connect(context, out, turning);
  return !status && points ? surface_orient_shells(context, out) : status;
}

hexcon_status surface_build(hexcon_context *context, const double *points, size_t point_count,
                            const int32_t *quads, size_t quad_count, surface *out) {
  return build(context, points, point_count, quads, quad_count, false, out);
}

hexcon_status surface_build_turning(hexcon_context *context, const double *points,
                                    size_t point_count, const int32_t *quads, size_t quad_count,
                                    surface *out) {
  return build(context, points, point_count, quads, quad_count, true, out);
}
