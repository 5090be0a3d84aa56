/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "narrow_corners.h"

#include <math.h>

#include "base/vector.h"
#include "hexmesh/hex_tables.h"

/** Above this solid angle a corner bounds nothing: 4 tan(w / 2) would exceed 1. */
static const double wide = 0.48;

typedef struct shared_angle {
  double sum; /* of the signed solid angles of the hex corners at a point */
  size_t corners;
} shared_angle;

/** Signed, between -2 pi and 2 pi. Van Oosterom and Strackee (1983), equation 8. */
static double solid_angle(const double *points, const int32_t *hex, int corner) {
  double edges[3][3], lengths[3];
  for (int i = 0; i < 3; i++) {
    vector_subtract(points + 3 * (size_t)hex[hex_corner_neighbours[corner][i]],
                    points + 3 * (size_t)hex[corner], edges[i]);
    lengths[i] = vector_length(edges[i]);
  }
  double below = lengths[0] * lengths[1] * lengths[2];
  for (int i = 0; i < 3; i++)
    below += vector_dot(edges[i], edges[(i + 1) % 3]) * lengths[(i + 2) % 3];
  return 2 * atan2(vector_determinant(edges[0], edges[1], edges[2]), below);
}

static hexcon_status add_corners(hexcon_context *context, const double *points,
                                 const int32_t *hexes, size_t hex_count, size_t surface_points,
                                 shared_angle *angles) {
  hexcon_status status = HEXCON_OK;
  for (size_t h = 0; !status && h < hex_count; h++) {
    const int32_t *hex = hexes + 8 * h;
    for (int corner = 0; corner < 8; corner++)
      if ((size_t)hex[corner] < surface_points) {
        angles[hex[corner]].sum += solid_angle(points, hex, corner);
        angles[hex[corner]].corners++;
      }
    status = context_pass(context, h);
  }
  return status;
}

hexcon_status narrow_corner_bound(hexcon_context *context, const double *points,
                                  const int32_t *hexes, size_t hex_count, size_t surface_points,
                                  double *bound) {
  shared_angle *angles = context_allocate_zeroed(context, surface_points, sizeof *angles);
  if (!angles)
    return HEXCON_OUT_OF_MEMORY;
  hexcon_status status = add_corners(context, points, hexes, hex_count, surface_points, angles);
  for (size_t i = 0; !status && i < surface_points; i++) {
    double each = angles[i].corners ? angles[i].sum / (double)angles[i].corners : 0;
    if (each > 0 && each < wide)
      *bound = fmin(*bound, 4 * tan(each / 2));
  }
  context_free(context, angles);
  return status;
}
