/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "affine_fit.h"

#include "base/vector.h"

rim_pose rim_measure(const double *points, const int32_t *ids, const int32_t *rim, size_t count,
                     const int32_t *edges, size_t edge_count) {
  rim_pose pose = {{0}, {0}};
  for (size_t i = 0; i < count; i++)
    vector_add_scaled(pose.center, 1 / (double)count, points + 3 * (size_t)ids[rim[i]]);
  for (size_t e = 0; e < edge_count; e++) {
    double a[3], b[3], cross[3];
    vector_subtract(points + 3 * (size_t)ids[edges[2 * e]], pose.center, a);
    vector_subtract(points + 3 * (size_t)ids[edges[2 * e + 1]], pose.center, b);
    vector_cross(a, b, cross);
    vector_add_scaled(pose.normal, 0.5, cross);
  }
  double length = vector_length(pose.normal);
  for (int i = 0; i < 3; i++)
    pose.normal[i] = length > 0 ? pose.normal[i] / sqrt(length) : 0;
  return pose;
}

static void add_outer(double matrix[3][3], double weight, const double a[3], const double b[3]) {
  for (int i = 0; i < 3; i++)
    vector_add_scaled(matrix[i], weight * a[i], b);
}

/** Inverse of a symmetric positive matrix by its adjugate; zero if it is singular. */
static void invert(double m[3][3], double out[3][3]) {
  double rows[3][3];
  for (int i = 0; i < 3; i++)
    vector_cross(m[(i + 1) % 3], m[(i + 2) % 3], rows[i]);
  double determinant = vector_dot(m[0], rows[0]);
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      out[i][j] = determinant > 0 ? rows[j][i] / determinant : 0;
}

affine_map affine_fit(const double *points, const int32_t *from, const rim_pose *from_pose,
                      const int32_t *to, const rim_pose *to_pose, const int32_t *rim,
                      size_t count) {
  double source[3][3] = {{0}}, mixed[3][3] = {{0}}, inverse[3][3];
  for (size_t i = 0; i < count; i++) {
    double a[3], b[3];
    vector_subtract(points + 3 * (size_t)from[rim[i]], from_pose->center, a);
    vector_subtract(points + 3 * (size_t)to[rim[i]], to_pose->center, b);
    add_outer(source, 1, a, a);
    add_outer(mixed, 1, b, a);
  }
  double weight = (double)count / 4; /* so that the normal counts like an extent of the rim */
  add_outer(source, weight, from_pose->normal, from_pose->normal);
  add_outer(mixed, weight, to_pose->normal, from_pose->normal);
  invert(source, inverse);
  affine_map map;
  for (int i = 0; i < 3; i++) {
    map.source[i] = from_pose->center[i];
    map.target[i] = to_pose->center[i];
    for (int j = 0; j < 3; j++)
      map.matrix[i][j] =
          mixed[i][0] * inverse[0][j] + mixed[i][1] * inverse[1][j] + mixed[i][2] * inverse[2][j];
  }
  return map;
}

void affine_apply(const affine_map *map, const double in[3], double out[3]) {
  double relative[3];
  vector_subtract(in, map->source, relative);
  for (int i = 0; i < 3; i++)
    out[i] = map->target[i] + vector_dot(map->matrix[i], relative);
}
