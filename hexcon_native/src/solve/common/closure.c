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

/** Whether every new point is the corner of a tetrahedron: others would be points of no hex. */
static hexcon_status check_points(hexcon_context *context, size_t inner_count, const closure *c,
                                  bool *used) {
  uint8_t *met = context_allocate_zeroed(context, c->point_count, sizeof *met);
  if (!met)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t i = 0; i < 4 * c->tetrahedron_count; i++)
    if ((size_t)c->tetrahedra[i] >= inner_count)
      met[(size_t)c->tetrahedra[i] - inner_count] = 1;
  *used = !memchr(met, 0, c->point_count);
  context_free(context, met);
  return HEXCON_OK;
}

/** Bit of the way round in which a face names its corners. */
static uint8_t face_sense(int32_t a, int32_t b, int32_t c) {
  return (a < b) + (b < c) + (c < a) == 2 ? 1 : 2;
}

/** Whether every face is met once from each side: by two tetrahedra, or by one and a given
 * triangle, which counts as seen from outside. */
static hexcon_status check_faces(hexcon_context *context, const closure *c,
                                 const int32_t *triangles, size_t triangle_count, bool *match) {
  static const unsigned char faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  static const unsigned char inward[3] = {0, 2, 1};
  size_t most = 4 * c->tetrahedron_count + triangle_count;
  tuple_table table;
  hexcon_status status = tuple_table_new(context, most, &table);
  uint8_t *met = context_allocate_zeroed(context, most, sizeof *met);
  if (!met)
    status = HEXCON_OUT_OF_MEMORY;
  *match = !status;
  for (size_t i = 0; !status && *match && i < most; i++) {
    status = context_pass(context, i);
    size_t face = i - triangle_count; /* of the tetrahedra, after the triangles */
    const int32_t *ids = i < triangle_count ? triangles + 3 * i : c->tetrahedra + 4 * (face / 4);
    const unsigned char *way = i < triangle_count ? inward : faces[face % 4];
    int32_t corners[3] = {ids[way[0]], ids[way[1]], ids[way[2]]};
    int32_t number =
        tuple_table_number(&table, corners[0], corners[1], corners[2], (int32_t)table.count);
    uint8_t sense = face_sense(corners[0], corners[1], corners[2]);
    *match = !(met[number] & sense);
    met[number] |= sense;
  }
  for (size_t i = 0; *match && i < table.count; i++)
    *match = met[i] == 3;
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
  hexcon_status status = context_progress(context, STAGE_TETRAHEDRA_INSIDE, 0);
  if (status || !options->tetrahedralise)
    return status;
  if (!options->tetrahedralise(options->tetrahedralise_user, inner, inner_count, triangles,
                               triangle_count, &made))
    return context_progress(context, STAGE_TETRAHEDRA_INSIDE, 1); /* cancelled, or nothing found */
  if (made.tetrahedron_count > CONTEXT_MAX_COUNT / 32 || made.point_count > CONTEXT_MAX_COUNT / 2 ||
      (made.tetrahedron_count && !made.tetrahedra) || (made.point_count && !made.points))
    return HEXCON_OK;
  status = allocate(context, made.tetrahedron_count, made.point_count, out);
  if (status)
    return status;
  if (made.tetrahedron_count)
    memcpy(out->tetrahedra, made.tetrahedra, 4 * made.tetrahedron_count * sizeof *out->tetrahedra);
  if (made.point_count)
    memcpy(out->points, made.points, 3 * made.point_count * sizeof *out->points);
  bool used = false;
  if (!are_positive(inner, inner_count, out))
    return HEXCON_OK;
  status = check_points(context, inner_count, out, &used);
  if (status || !used)
    return status;
  return check_faces(context, out, triangles, triangle_count, found);
}
