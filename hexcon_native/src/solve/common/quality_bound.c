/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "quality_bound.h"

#include <math.h>

#include "base/vector.h"
#include "hexmesh/hex_tables.h"
#include "hexmesh/scaled_jacobian.h"

/** Sines of the surface quads' corners: no hex corner there can have a higher scaled Jacobian. */
static double surface_bound(const surface *s) {
  double bound = 1;
  for (int32_t corner = 0; corner < (int32_t)(4 * s->quad_count); corner++) {
    const double *here = s->points + 3 * (size_t)s->quads[corner];
    double next[3], previous[3], cross[3];
    vector_subtract(s->points + 3 * (size_t)s->quads[half_edge_turn(corner, 1)], here, next);
    vector_subtract(s->points + 3 * (size_t)s->quads[half_edge_turn(corner, -1)], here, previous);
    vector_cross(next, previous, cross);
    double lengths = vector_length(next) * vector_length(previous);
    bound = fmin(bound, lengths > 0 ? vector_length(cross) / lengths : 0);
  }
  return bound;
}

/** Scaled Jacobians of the hex corners whose four points are all on the surface. */
static hexcon_status fixed_bound(hexcon_context *context, const double *points,
                                 const int32_t *hexes, size_t hex_count, size_t surface_points,
                                 double *bound) {
  hexcon_status status = HEXCON_OK;
  for (size_t h = 0; !status && h < hex_count; h++) {
    for (int corner = 0; corner < 8; corner++) {
      const int32_t *hex = hexes + 8 * h;
      bool fixed = (size_t)hex[corner] < surface_points;
      for (int i = 0; i < 3; i++)
        fixed &= (size_t)hex[hex_corner_neighbours[corner][i]] < surface_points;
      if (fixed)
        *bound = fmin(*bound, corner_scaled_jacobian(points, hex, corner));
    }
    status = context_pass(context, h);
  }
  return status;
}

hexcon_status quality_bound(hexcon_context *context, const surface *s, const double *points,
                            const int32_t *hexes, size_t hex_count, double *bound) {
  *bound = surface_bound(s);
  return fixed_bound(context, points, hexes, hex_count, s->point_count, bound);
}
