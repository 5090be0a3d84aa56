/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "closure.h"

#include <string.h>

#include "base/vector.h"
#include "construct/tuple_table.h"

void closure_free(hexcon_context *context, closure *c) {
  context_free(context, c->tetrahedra);
  context_free(context, c->points);
  memset(c, 0, sizeof *c);
}

static hexcon_status allocate(hexcon_context *context, size_t tetrahedra, size_t points,
                              closure *out) {
  memset(out, 0, sizeof *out);
  out->tetrahedron_count = tetrahedra;
  out->point_count = points;
  out->tetrahedra = context_allocate(context, 4 * tetrahedra, sizeof *out->tetrahedra);
  out->points = context_allocate(context, points, 3 * sizeof *out->points);
  return out->tetrahedra && out->points ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

hexcon_status closure_star(hexcon_context *context, size_t inner_count, const int32_t *triangles,
                           size_t triangle_count, const double center[3], closure *out) {
  hexcon_status status = allocate(context, triangle_count, 1, out);
  if (status)
    return status;
  memcpy(out->points, center, 3 * sizeof *center);
  for (size_t t = 0; t < triangle_count; t++) {
    const int32_t *from = triangles + 3 * t;
    int32_t to[4] = {from[0], from[2], from[1], (int32_t)inner_count};
    memcpy(out->tetrahedra + 4 * t, to, sizeof to);
  }
  return HEXCON_OK;
}

static const double *corner(const double *inner, size_t inner_count, const closure *c, int32_t id) {
  size_t row = (size_t)id;
  return row < inner_count ? inner + 3 * row : c->points + 3 * (row - inner_count);
}

/** Whether ids are in range and every tetrahedron has a positive volume. */
static bool are_positive(const double *inner, size_t inner_count, const closure *c) {
  for (size_t t = 0; t < c->tetrahedron_count; t++) {
    const int32_t *ids = c->tetrahedra + 4 * t;
    double edges[3][3];
    for (size_t i = 0; i < 4; i++)
      if (ids[i] < 0 || (size_t)ids[i] >= inner_count + c->point_count)
        return false;
    for (size_t i = 0; i < 3; i++)
      vector_subtract(corner(inner, inner_count, c, ids[i + 1]),
                      corner(inner, inner_count, c, ids[0]), edges[i]);
    if (!(vector_determinant(edges[0], edges[1], edges[2]) > 0))
      return false;
  }
  return true;
}

/** Whether every point, given or new, is a corner. */
static hexcon_status check_points_used(hexcon_context *context, const closure *c,
                                       size_t inner_count, bool *used) {
  size_t count = inner_count + c->point_count, met = 0;
  uint8_t *seen = context_allocate_zeroed(context, count, sizeof *seen);
  if (!seen)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t i = 0; i < 4 * c->tetrahedron_count; i++) {
    met += seen[c->tetrahedra[i]] == 0;
    seen[c->tetrahedra[i]] = 1;
  }
  context_free(context, seen);
  *used = met == count;
  return HEXCON_OK;
}

/** Whether every face is met twice: by two tetrahedra, or by one and a given triangle. */
static hexcon_status check_faces(hexcon_context *context, const closure *c,
                                 const int32_t *triangles, size_t triangle_count, bool *match) {
  static const unsigned char faces[4][3] = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
  size_t most = 4 * c->tetrahedron_count + triangle_count;
  tuple_table table;
  hexcon_status status = tuple_table_new(context, most, &table);
  uint8_t *met = context_allocate_zeroed(context, most, sizeof *met);
  if (!met)
    status = HEXCON_OUT_OF_MEMORY;
  for (size_t i = 0; !status && i < most; i++) {
    size_t face = i - triangle_count; /* of the tetrahedra, after the triangles */
    const int32_t *ids = i < triangle_count ? triangles + 3 * i : c->tetrahedra + 4 * (face / 4);
    const unsigned char *corners = faces[i < triangle_count ? 0 : face % 4];
    int32_t number = tuple_table_number(&table, ids[corners[0]], ids[corners[1]], ids[corners[2]],
                                        (int32_t)table.count);
    met[number] = (uint8_t)(met[number] < 3 ? met[number] + 1 : 3);
  }
  *match = !status;
  for (size_t i = 0; *match && i < table.count; i++)
    *match = met[i] == 2;
  context_free(context, met);
  tuple_table_free(context, &table);
  return status;
}

hexcon_status closure_tetrahedra(hexcon_context *context, const double *inner, size_t inner_count,
                                 const int32_t *triangles, size_t triangle_count,
                                 const hexcon_mesh_options *options, closure *out, bool *found) {
  hexcon_tetrahedra made = {0};
  memset(out, 0, sizeof *out);
  *found = false;
  hexcon_status status = context_progress(context, "tetrahedra inside", 0);
  if (status || !options->tetrahedralise)
    return status;
  if (!options->tetrahedralise(options->tetrahedralise_user, inner, inner_count, triangles,
                               triangle_count, &made))
    return context_progress(context, "tetrahedra inside", 1); /* cancelled, or nothing found */
  if (made.tetrahedron_count > CONTEXT_MAX_COUNT / 32 || made.point_count > CONTEXT_MAX_COUNT / 2)
    return HEXCON_OK;
  status = allocate(context, made.tetrahedron_count, made.point_count, out);
  if (status)
    return status;
  memcpy(out->tetrahedra, made.tetrahedra, 4 * made.tetrahedron_count * sizeof *out->tetrahedra);
  memcpy(out->points, made.points, 3 * made.point_count * sizeof *out->points);
  if (!are_positive(inner, inner_count, out))
    return HEXCON_OK;
  status = check_points_used(context, out, inner_count, found);
  return status || !*found ? status : check_faces(context, out, triangles, triangle_count, found);
}
