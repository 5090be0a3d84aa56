/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "diced_filling.h"

#include <string.h>

#include "base/vector.h"
#include "closure.h"
#include "construct/dice.h"
#include "shape/apex_placement.h"
#include "shape/cell_placement.h"
#include "shape/nested_placement.h"

/* ----------------------------------------------------------------------------------- placement */

static void find_base_rows(const hex_template *t, int corners[4], int edges[4]) {
  for (size_t i = 0; i < 4; i++) {
    const char corner[3] = {'B', (char)('0' + i), '\0'}, edge[3] = {'E', (char)('0' + i), '\0'};
    corners[i] = template_row(t, corner);
    edges[i] = template_row(t, edge);
  }
}

/** Where the pyramid's points lie between its base, which is split in four, and its apex. */
static split_place *make_places(hexcon_context *context, const hex_template *t) {
  int corners[4], edges[4], center = template_row(t, "Bc");
  find_base_rows(t, corners, edges);
  split_place *places = context_allocate(context, t->point_count, sizeof *places);
  for (size_t row = 0; places && row < t->point_count; row++) {
    const double *at = t->points[row].place; /* the base is -1 .. 1, the apex 1 high */
    double spread = at[2] < 1 ? 0.5 / (1 - at[2]) : 0.5;
    const double local[3] = {0.5 + spread * at[0], 0.5 + spread * at[1], at[2]};
    places[row] = split_place_at(local, corners, edges, center, 1);
  }
  return places;
}

static hexcon_status place_pyramids(hexcon_context *context, const coarse_front *front,
                                    double *points) {
  const hex_template *t = front->pyramid;
  split_place *places = make_places(context, t);
  if (!places)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t q = 0; q < front->pyramid_count; q++) {
    const int32_t *ids = front->pyramid_points + q * t->point_count;
    size_t apex = (size_t)ids[template_row(t, "A")];
    double tip[3];
    memcpy(tip, points + 3 * apex, sizeof tip);
    for (size_t row = 0; row < t->point_count; row++)
      if (t->points[row].place[2] > 0)
        place_over_split_quad(&places[row], ids, ids[row], tip, points);
  }
  context_free(context, places);
  return HEXCON_OK;
}

/** The surface's points and the pyramids'. */
static hexcon_status place(hexcon_context *context, const diced_problem *p, double scale,
                           double *points) {
  const coarse_surface *c = &p->coarse;
  coarse_faces faces = {c->triangle_count, c->quad_count, c->points,
                        c->faces,          c->middles,    c->centers};
  memcpy(points, p->s->points, 3 * p->s->point_count * sizeof *points);
  if (c->quad_count == 0)
    return HEXCON_OK;
  hexcon_status status = place_apices(context, &faces, scale, p->front.points + c->point_count,
                                      p->s->point_count, points);
  return status ? status : place_pyramids(context, &p->front, points);
}

/* ------------------------------------------------------------------------------------- closing */

bool diced_filling_is_possible(const diced_problem *p, diced_closure kind) {
  switch (kind) {
  case DICED_ONE:
    return p->coarse.quad_count == 0 && p->coarse.triangle_count == 4 && p->coarse.point_count == 4;
  case DICED_STAR:
    return p->star_shaped;
  case DICED_TETRAHEDRA:
    return p->options->tetrahedralise != NULL;
  }
  return false;
}

/** The front's only tetrahedron: its first triangle, seen from inside, and the point left. */
static hexcon_status close_by_one(hexcon_context *context, const coarse_front *front, closure *c) {
  const int32_t *first = front->triangles;
  *c = (closure){.tetrahedron_count = 1};
  c->tetrahedra = context_allocate(context, 4, sizeof *c->tetrahedra);
  c->points = context_allocate(context, 0, sizeof *c->points);
  if (!c->tetrahedra || !c->points)
    return HEXCON_OUT_OF_MEMORY;
  int32_t ids[4] = {first[0], first[2], first[1], 6 - first[0] - first[1] - first[2]};
  memcpy(c->tetrahedra, ids, sizeof ids);
  return HEXCON_OK;
}

static bool sees_from_inside(const double center[3], const double *inner,
                             const coarse_front *front) {
  for (size_t t = 0; t < front->triangle_count; t++) {
    double arms[3][3];
    for (size_t i = 0; i < 3; i++)
      vector_subtract(inner + 3 * (size_t)front->triangles[3 * t + i], center, arms[i]);
    if (!(vector_determinant(arms[0], arms[1], arms[2]) > 0))
      return false;
  }
  return true;
}

static hexcon_status close_front(hexcon_context *context, const diced_problem *p,
                                 diced_closure kind, const double *inner, closure *c, bool *found) {
  const coarse_front *front = &p->front;
  *found = true;
  switch (kind) {
  case DICED_ONE:
    return close_by_one(context, front, c);
  case DICED_STAR:
    *found = sees_from_inside(p->center, inner, front);
    return *found ? closure_star(context, front->point_count, front->triangles,
                                 front->triangle_count, p->center, c)
                  : HEXCON_OK;
  case DICED_TETRAHEDRA:
    break;
  }
  return closure_tetrahedra(context, inner, front->point_count, front->triangles,
                            front->triangle_count, p->options, c, found);
}

/* ------------------------------------------------------------------------------------- filling */

/** Ids of the mesh for those of the front and of the closure's new points. */
static int32_t mesh_id(const coarse_front *front, int32_t id) {
  size_t row = (size_t)id;
  return row < front->point_count ? front->points[row]
                                  : (int32_t)(front->mesh_point_count + row - front->point_count);
}

static hexcon_status dice_closure(hexcon_context *context, const coarse_front *front, closure *c,
                                  diced_complex *diced) {
  size_t count = 3 * front->triangle_count;
  int32_t *corners = context_allocate(context, count, sizeof *corners);
  if (!corners)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t i = 0; i < count; i++)
    corners[i] = mesh_id(front, front->triangles[i]);
  for (size_t i = 0; i < 4 * c->tetrahedron_count; i++)
    c->tetrahedra[i] = mesh_id(front, c->tetrahedra[i]);
  diced_triangles known = {front->triangle_count, corners, front->means, front->side_middles};
  hexcon_status status = dice(context, c->tetrahedra, c->tetrahedron_count, &known,
                              front->mesh_point_count + c->point_count, diced);
  context_free(context, corners);
  return status;
}

static void write_pyramids(const coarse_front *front, int32_t *hexes) {
  const hex_template *t = front->pyramid;
  for (size_t q = 0; q < front->pyramid_count; q++)
    for (size_t h = 0; h < t->hex_count; h++)
      for (size_t i = 0; i < 8; i++)
        *hexes++ = front->pyramid_points[q * t->point_count + (size_t)t->hexes[h][i]];
}

static hexcon_status assemble(hexcon_context *context, const coarse_front *front,
                              const double *placed, const closure *c, const diced_complex *diced,
                              filled_mesh *out) {
  size_t first_mean = front->mesh_point_count + c->point_count;
  size_t pyramid_hexes = front->pyramid_count * front->pyramid->hex_count;
  hexcon_status status = filled_mesh_new(context, first_mean + diced->point_count,
                                         pyramid_hexes + diced->hex_count, out);
  if (status)
    return status;
  memcpy(out->points, placed, 3 * front->mesh_point_count * sizeof *placed);
  memcpy(out->points + 3 * front->mesh_point_count, c->points, 3 * c->point_count * sizeof *placed);
  place_means(diced->means, diced->point_count, first_mean, out->points);
  write_pyramids(front, out->hexes);
  memcpy(out->hexes + 8 * pyramid_hexes, diced->hexes, 8 * diced->hex_count * sizeof *out->hexes);
  return HEXCON_OK;
}

/** Close what is left inside, dice it, and put all together. */
static hexcon_status fill_front(hexcon_context *context, const diced_problem *p,
                                const double *placed, const double *inner, diced_filling *f) {
  closure c = {0};
  diced_complex diced = {0};
  bool found = false;
  hexcon_status status = close_front(context, p, f->closure, inner, &c, &found);
  f->tetrahedron_count = c.tetrahedron_count;
  if (!status && found)
    status = dice_closure(context, &p->front, &c, &diced);
  if (!status && found)
    status = assemble(context, &p->front, placed, &c, &diced, &f->mesh);
  closure_free(context, &c);
  dice_free(context, &diced);
  return status;
}

hexcon_status diced_filling_build(hexcon_context *context, const diced_problem *p,
                                  diced_closure kind, double scale, diced_filling *f) {
  const coarse_front *front = &p->front;
  *f = (diced_filling){.closure = kind,
                       .scale = scale,
                       .triangle_count = p->coarse.triangle_count,
                       .quad_count = p->coarse.quad_count};
  double *placed = context_allocate(context, front->mesh_point_count, 3 * sizeof *placed);
  double *inner = context_allocate(context, front->point_count, 3 * sizeof *inner);
  hexcon_status status = placed && inner ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  if (!status)
    status = place(context, p, scale, placed);
  for (size_t i = 0; !status && i < front->point_count; i++)
    memcpy(inner + 3 * i, placed + 3 * (size_t)front->points[i], 3 * sizeof *inner);
  if (!status)
    status = fill_front(context, p, placed, inner, f);
  context_free(context, placed);
  context_free(context, inner);
  return status;
}
