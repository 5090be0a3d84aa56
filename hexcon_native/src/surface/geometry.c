/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "geometry.h"

#include "base/vector.h"

static const double *corner_point(const surface *s, int32_t half_edge) {
  return s->points + 3 * (size_t)s->quads[half_edge];
}

double surface_quad_volume(const surface *s, int32_t quad, const double origin[3]) {
  /* The mean of the quad's two diagonal splits is its bilinear patch exactly. */
  static const int splits[4][3] = {{0, 1, 2}, {0, 2, 3}, {1, 2, 3}, {1, 3, 0}};
  double corners[4][3], sum = 0;
  for (int corner = 0; corner < 4; corner++)
    vector_subtract(corner_point(s, 4 * quad + corner), origin, corners[corner]);
  for (int i = 0; i < 4; i++)
    sum += vector_determinant(corners[splits[i][0]], corners[splits[i][1]], corners[splits[i][2]]);
  return sum / 12;
}

double surface_volume(const surface *s) {
  /* Relative to one point of the surface: less cancellation far from the origin. */
  const double *origin = corner_point(s, 0);
  double sum = 0;
  for (size_t q = 0; q < s->quad_count; q++)
    sum += surface_quad_volume(s, (int32_t)q, origin);
  return sum;
}

void surface_quad_normal(const surface *s, int32_t quad, double normal[3]) {
  double first[3], second[3];
  vector_subtract(corner_point(s, 4 * quad + 2), corner_point(s, 4 * quad), first);
  vector_subtract(corner_point(s, 4 * quad + 3), corner_point(s, 4 * quad + 1), second);
  vector_cross(first, second, normal);
}

double surface_bend(const surface *s, int32_t half_edge) {
  double a[3], b[3], cross[3];
  surface_quad_normal(s, half_edge_quad(half_edge), a);
  surface_quad_normal(s, half_edge_quad(s->twins[half_edge]), b);
  vector_cross(a, b, cross);
  return atan2(vector_length(cross), vector_dot(a, b));
}

typedef struct plane {
  double normal[3], offset, warp, size;
} plane;

static plane mean_plane(const surface *s, int32_t quad) {
  plane p = {{0}, 0, 0, 0};
  double center[3] = {0};
  surface_quad_normal(s, quad, p.normal);
  double length = vector_length(p.normal);
  p.size = sqrt(length);
  for (int i = 0; i < 3; i++)
    p.normal[i] = length > 0 ? p.normal[i] / length : 0;
  for (int corner = 0; corner < 4; corner++)
    vector_add_scaled(center, 0.25, corner_point(s, 4 * quad + corner));
  p.offset = vector_dot(p.normal, center);
  for (int corner = 0; corner < 4; corner++)
    p.warp =
        fmax(p.warp, fabs(vector_dot(p.normal, corner_point(s, 4 * quad + corner)) - p.offset));
  return p;
}

static bool edge_is_convex(const surface *s, int32_t half_edge, const plane *mine) {
  const double rounding = 1e-9; /* of the quads' size: planar faces of a CAD model are not exact */
  int32_t twin = s->twins[half_edge];
  plane other = mean_plane(s, half_edge_quad(twin));
  double tolerance = mine->warp + other.warp + rounding * (mine->size + other.size);
  for (int far = 2; far < 4; far++) {
    const double *point = corner_point(s, half_edge_turn(twin, far));
    if (vector_dot(mine->normal, point) - mine->offset > tolerance)
      return false;
  }
  return true;
}

bool surface_is_convex(const surface *s) {
  for (size_t q = 0; q < s->quad_count; q++) {
    plane mine = mean_plane(s, (int32_t)q);
    for (int side = 0; side < 4; side++)
      if (!edge_is_convex(s, (int32_t)(4 * q) + side, &mine))
        return false;
  }
  return true;
}
