/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "diced_filling.h"

#include <stdio.h>
#include <string.h>

#include "base/vector.h"
#include "construct/dice.h"
#include "shape/offset/inner_surface.h"
#include "shape/place/apex_placement.h"
#include "shape/place/cell_placement.h"
#include "shape/place/nested_placement.h"
#include "solve/common/closure.h"

/* ----------------------------------------------------------------------------------- placement */

/** Rows of points called by letters and 0 .. 3. */
static void find_rows(const hex_template *t, const char *letters, int rows[4]) {
  char label[8];
  for (int i = 0; i < 4; i++) {
    (void)snprintf(label, sizeof label, "%s%d", letters, i);
    rows[i] = template_row(t, label);
  }
}

/** A point of the pyramid, whose base is -1 .. 1 and whose apex is 1 high: on the ray to it. */
static split_place pyramid_place(const hex_template *t, const double at[3]) {
  int corners[4], edges[4];
  find_rows(t, "B", corners);
  find_rows(t, "E", edges);
  double spread = at[2] < 1 ? 0.5 / (1 - at[2]) : 0.5;
  const double local[3] = {0.5 + spread * at[0], 0.5 + spread * at[1], at[2]};
  return split_place_at(local, corners, edges, template_row(t, "Bc"), 1);
}

/** A point of the Geode, which is the unit cube: between its base and its two triangles. */
static split_place geode_place(const hex_template *t, const double at[3]) {
  int corners[4], edges[4], inner[4];
  find_rows(t, "B", corners);
  find_rows(t, "EB", edges);
  find_rows(t, "T", inner);
  split_place place = split_place_at(at, corners, edges, template_row(t, "Bc"), 0);
  memcpy(place.rows + 4, inner, sizeof inner);
  return place;
}

/** All points of blocks but those of the surface and, of Geodes, the inner corners. */
static hexcon_status place_blocks(hexcon_context *context, const coarse_front *front, bool has_apex,
                                  double *points) {
  const hex_template *t = front->block;
  split_place *places = context_allocate(context, t->point_count, sizeof *places);
  if (!places)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t row = 0; row < t->point_count; row++)
    places[row] =
        has_apex ? pyramid_place(t, t->points[row].place) : geode_place(t, t->points[row].place);
  hexcon_status status = HEXCON_OK;
  for (size_t q = 0; !status && q < front->block_count; q++) {
    const int32_t *ids = front->block_points + q * t->point_count;
    double tip[3] = {0};
    if (has_apex)
      memcpy(tip, points + 3 * (size_t)ids[template_row(t, "A")], sizeof tip);
    anchors to = {tip, 0};
    for (size_t row = 0; row < t->point_count; row++)
      if (t->points[row].place[2] > 0 && t->points[row].label[0] != 'T')
        place_over_split_quad(&places[row], ids, ids[row], &to, points);
    status = context_pass(context, q);
  }
  context_free(context, places);
  return status;
}

static hexcon_status place_apices_of(hexcon_context *context, const diced_problem *p, double scale,
                                     double *points) {
  const coarse_surface *c = &p->coarse;
  coarse_faces faces = {c->triangle_count, c->quad_count, c->points,
                        c->faces,          c->middles,    c->centers};
  return place_apices(context, &faces, scale, p->fronts[DICED_PYRAMIDS].points + c->point_count,
                      p->s->point_count, points);
}

/** The inner copies of the coarse corners; those have consecutive ids. */
static hexcon_status place_inner_corners(hexcon_context *context, const diced_problem *p,
                                         double scale, double *points) {
  inner_surface_options options = {.thickness = scale, .depth = 0.6, .no_center = !p->star_shaped};
  memcpy(options.center, p->center, sizeof options.center);
  return inner_surface_place(context, &p->quads, &options,
                             points + 3 * (size_t)p->fronts[DICED_GEODES].points[0]);
}

/** The surface's points and the blocks'. */
static hexcon_status place(hexcon_context *context, const diced_problem *p, diced_block block,
                           double scale, double *points) {
  memcpy(points, p->s->points, 3 * p->s->point_count * sizeof *points);
  if (p->coarse.quad_count == 0)
    return HEXCON_OK;
  hexcon_status status = block == DICED_PYRAMIDS ? place_apices_of(context, p, scale, points)
                                                 : place_inner_corners(context, p, scale, points);
  return status ? status
                : place_blocks(context, &p->fronts[block], block == DICED_PYRAMIDS, points);
}

/* ------------------------------------------------------------------------------------- closing */

bool diced_filling_is_possible(const diced_problem *p, diced_block block, diced_closure kind) {
  if (!p->fronts[block].points)
    return false;
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
                                 const coarse_front *front, diced_closure kind, const double *inner,
                                 closure *c, bool *found) {
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

static void write_blocks(const coarse_front *front, int32_t *hexes) {
  const hex_template *t = front->block;
  for (size_t q = 0; q < front->block_count; q++)
    for (size_t h = 0; h < t->hex_count; h++)
      for (size_t i = 0; i < 8; i++)
        *hexes++ = front->block_points[q * t->point_count + (size_t)t->hexes[h][i]];
}

static hexcon_status assemble(hexcon_context *context, const coarse_front *front,
                              const double *placed, const closure *c, const diced_complex *diced,
                              filled_mesh *out) {
  size_t first_mean = front->mesh_point_count + c->point_count;
  size_t block_hexes = front->block_count * front->block->hex_count;
  hexcon_status status = filled_mesh_new(context, first_mean + diced->point_count,
                                         block_hexes + diced->hex_count, out);
  if (status)
    return status;
  memcpy(out->points, placed, 3 * front->mesh_point_count * sizeof *placed);
  memcpy(out->points + 3 * front->mesh_point_count, c->points, 3 * c->point_count * sizeof *placed);
  status = place_means(context, diced->means, diced->point_count, first_mean, out->points);
  write_blocks(front, out->hexes);
  memcpy(out->hexes + 8 * block_hexes, diced->hexes, 8 * diced->hex_count * sizeof *out->hexes);
  return status ? status : context_after(context, out->hex_count);
}

/** Close what is left inside, dice it, and put all together. */
static hexcon_status fill_front(hexcon_context *context, const diced_problem *p,
                                const double *placed, const double *inner, diced_filling *f) {
  const coarse_front *front = &p->fronts[f->block];
  closure c = {0};
  diced_complex diced = {0};
  bool found = false;
  hexcon_status status = close_front(context, p, front, f->closure, inner, &c, &found);
  f->tetrahedron_count = c.tetrahedron_count;
  if (!status && found)
    status = dice_closure(context, front, &c, &diced);
  if (!status && found)
    status = assemble(context, front, placed, &c, &diced, &f->mesh);
  closure_free(context, &c);
  dice_free(context, &diced);
  return status;
}

hexcon_status diced_filling_build(hexcon_context *context, const diced_problem *p,
                                  diced_block block, diced_closure kind, double scale,
                                  diced_filling *f) {
  const coarse_front *front = &p->fronts[block];
  *f = (diced_filling){.block = block,
                       .closure = kind,
                       .scale = scale,
                       .triangle_count = p->coarse.triangle_count,
                       .quad_count = p->coarse.quad_count};
  double *placed = context_allocate(context, front->mesh_point_count, 3 * sizeof *placed);
  double *inner = context_allocate(context, front->point_count, 3 * sizeof *inner);
  hexcon_status status = placed && inner ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  if (!status)
    status = place(context, p, block, scale, placed);
  for (size_t i = 0; !status && i < front->point_count; i++)
    memcpy(inner + 3 * i, placed + 3 * (size_t)front->points[i], 3 * sizeof *inner);
  if (!status)
    status = fill_front(context, p, placed, inner, f);
  context_free(context, placed);
  context_free(context, inner);
  return status;
}
