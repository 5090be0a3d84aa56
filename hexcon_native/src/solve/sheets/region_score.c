/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "region_score.h"

#include "base/vector.h"
#include "hexmesh/hex_tables.h"
#include "hexmesh/scaled_jacobian.h"
#include "surface/geometry.h"

static const double right_angle = 1.57079632679489662;

static double square(double x) {
  return x * x;
}

/** Angle in radians by which the surface turns at an edge: pi / 2 at a box's, < 0 in a notch. */
static double signed_bend(const surface *s, int32_t half_edge) {
  double a[3], b[3], along[3], cross[3];
  surface_quad_normal(s, half_edge_quad(half_edge), a);
  surface_quad_normal(s, half_edge_quad(s->twins[half_edge]), b);
  vector_subtract(s->points + 3 * (size_t)half_edge_end(s, half_edge),
                  s->points + 3 * (size_t)half_edge_start(s, half_edge), along);
  vector_cross(a, b, cross);
  double bend = atan2(vector_length(cross), vector_dot(a, b));
  return vector_dot(cross, along) < 0 ? -bend : bend;
}

/** Quads of the region at the inner end of a rung. */
static int quads_at(const surface *s, int32_t rung) {
  int count = 0;
  int32_t stop = half_edge_turn(s->twins[rung], 1);
  for (int32_t h = s->twins[half_edge_turn(rung, -1)]; h != stop; count++)
    h = s->twins[half_edge_turn(h, -1)];
  return count;
}

double region_rim_score(const sheet_front *front, const front_region *region, double limit) {
  const surface *s = &front->s;
  double score = 0;
  for (size_t i = 0; i < region->rung_count && score <= limit; i++) {
    int32_t rung = region->rungs[i];
    double outer = signed_bend(s, half_edge_turn(rung, 1));
    score += square(signed_bend(s, half_edge_turn(rung, -1)) - right_angle);
    score += square(signed_bend(s, rung) - (2 - quads_at(s, rung)) * right_angle);
    score += outer > 0 ? square(outer) : 0;
  }
  return score;
}

double region_inner_score(const sheet_front *front, const front_region *region) {
  const surface *s = &front->s;
  double score = 0;
  for (size_t i = 0; i < 4 * region->quad_count; i++) {
    int32_t h = 4 * region->quads[i / 4] + (int32_t)(i % 4);
    bool inside = region->marks[half_edge_quad(s->twins[h])] == region->mark + 1;
    if (inside && h < s->twins[h])
      score += square(surface_bend(s, h));
  }
  return score;
}

/** The hex on a quad; a new point below is written as the one above. @param fixed  [8] */
static void find_hex(const sheet_front *front, int32_t quad, int32_t hex[8], bool fixed[8]) {
  for (int corner = 0; corner < 4; corner++) {
    int32_t above = front->s.quads[4 * quad + corner], under = front->image[above];
    hex[corner] = under < 0 ? above : under;
    hex[corner + 4] = above;
    fixed[corner] = under >= 0 && (size_t)under < front->s.point_count;
    fixed[corner + 4] = (size_t)above < front->s.point_count;
  }
}

static double hex_fixed_bound(const sheet_front *front, int32_t quad) {
  int32_t hex[8];
  bool fixed[8];
  double bound = 1;
  find_hex(front, quad, hex, fixed);
  for (int corner = 0; corner < 8; corner++) {
    const uint8_t *next = hex_corner_neighbours[corner];
    if (fixed[corner] && fixed[next[0]] && fixed[next[1]] && fixed[next[2]])
      bound = fmin(bound, corner_scaled_jacobian(front->s.points, hex, corner));
  }
  return bound;
}

double region_fixed_bound(sheet_front *front, const front_region *region) {
  double bound = 1;
  for (size_t i = 0; i < region->rung_count; i++)
    front->image[half_edge_start(&front->s, region->rungs[i])] =
        half_edge_end(&front->s, region->rungs[i]);
  for (size_t i = 0; i < region->quad_count; i++)
    bound = fmin(bound, hex_fixed_bound(front, region->quads[i]));
  for (size_t i = 0; i < region->rung_count; i++)
    front->image[half_edge_start(&front->s, region->rungs[i])] = -1;
  return bound;
}
