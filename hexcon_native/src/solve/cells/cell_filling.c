/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "cell_filling.h"

#include <string.h>

#include "construct/dice.h"
#include "shape/offset/inner_surface.h"
#include "shape/place/cell_placement.h"

/* ---------------------------------------------------------------------------------- placement */

/** Levels of layers lie evenly between the surface and its inner copy; a cell is deeper. */
static const double cell_to_layer = 1.5;

static hexcon_status place_layers(hexcon_context *context, const cell_problem *p, double *points) {
  hexcon_status status = HEXCON_OK;
  const cell_complex *cells = &p->cells;
  size_t width = 3 * p->s->point_count;
  const double *inner = points + 3 * cells->first_inner;
  for (size_t level = 1; !status && level <= cells->layers; level++) {
    double part = (double)level / ((double)cells->layers + cell_to_layer);
    for (size_t i = 0; i < width; i++)
      points[level * width + i] = (1 - part) * points[i] + part * inner[i];
    status = context_after(context, p->s->point_count);
  }
  return status;
}

static hexcon_status place_dominoes(hexcon_context *context, const cell_problem *p,
                                    double (*local)[3], double *points) {
  static const char *const labels[2][8] = {{"O0", "O1", "O2", "O3", "I0", "I1", "I2", "I3"},
                                           {"O0", "O1", "bO2", "bO3", "I0", "I1", "bI2", "bI3"}};
  const hex_template *t = p->cells.domino;
  double_box box = {.point_count = t->point_count, .local = (const double(*)[3])local};
  for (size_t half = 0; half < 2; half++)
    for (size_t i = 0; i < 8; i++)
      box.rows[half][i] = template_row(t, labels[half][i]);
  for (size_t i = 0; i < t->point_count; i++)
    memcpy(local[i], t->points[i].place, sizeof *local);
  return place_cells(context, &box, p->cells.cell_points, p->cells.cell_count, points);
}

/** All points of layers and cells. */
static hexcon_status place(hexcon_context *context, const cell_problem *p, double thickness,
                           double *points) {
  inner_surface_options options = {
      .thickness = thickness, .depth = 0.45, .no_center = p->no_center};
  memcpy(options.center, p->center, sizeof options.center);
  memcpy(points, p->s->points, 3 * p->s->point_count * sizeof *points);
  double layers = (double)p->cells.layers;
  options.thickness *= (layers + cell_to_layer) / cell_to_layer;
  options.depth += (1 - options.depth) * layers / (layers + 4);
  hexcon_status status =
      inner_surface_place(context, p->s, &options, points + 3 * p->cells.first_inner);
  double(*local)[3] = context_allocate(context, p->cells.domino->point_count, sizeof *local);
  if (!local)
    return HEXCON_OUT_OF_MEMORY;
  if (!status)
    status = place_layers(context, p, points);
  if (!status)
    status = place_dominoes(context, p, local, points);
  context_free(context, local);
  return status;
}

/* ------------------------------------------------------------------------------------- filling */

static int32_t cell_id(const cell_problem *p, int32_t corner) {
  size_t row = (size_t)corner, inner = p->s->point_count;
  return (int32_t)(row < inner ? p->cells.first_inner + row : p->cells.point_count + row - inner);
}

/** Dice the closure, in the mesh's numbering. */
static hexcon_status dice_closure(hexcon_context *context, const cell_problem *p, closure *c,
                                  diced_complex *diced) {
  const cell_complex *cells = &p->cells;
  size_t triangle_count = 2 * p->s->quad_count;
  for (size_t i = 0; i < 4 * c->tetrahedron_count; i++)
    c->tetrahedra[i] = cell_id(p, c->tetrahedra[i]);
  int32_t *corners = context_allocate(context, 3 * triangle_count, sizeof *corners);
  if (!corners)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t i = 0; i < 3 * triangle_count; i++)
    corners[i] = cell_id(p, cells->triangles[i]);
  diced_triangles known = {triangle_count, corners, cells->triangle_means, cells->side_middles};
  hexcon_status status = dice(context, c->tetrahedra, c->tetrahedron_count, &known,
                              cells->point_count + c->point_count, diced);
  context_free(context, corners);
  return status;
}

/** Points and hexes of cells and closure together. */
static hexcon_status assemble(hexcon_context *context, const cell_problem *p, const double *placed,
                              const closure *c, const diced_complex *diced, cell_filling *f) {
  const cell_complex *cells = &p->cells;
  size_t first_mean = cells->point_count + c->point_count;
  filled_mesh *m = &f->mesh;
  hexcon_status status = filled_mesh_new(context, first_mean + diced->point_count,
                                         cells->hex_count + diced->hex_count, m);
  if (status)
    return status;
  memcpy(m->points, placed, 3 * cells->point_count * sizeof *m->points);
  memcpy(m->points + 3 * cells->point_count, c->points, 3 * c->point_count * sizeof *m->points);
  status = place_means(context, diced->means, diced->point_count, first_mean, m->points);
  memcpy(m->hexes, cells->hexes, 8 * cells->hex_count * sizeof *m->hexes);
  memcpy(m->hexes + 8 * cells->hex_count, diced->hexes, 8 * diced->hex_count * sizeof *m->hexes);
  return status ? status : context_after(context, m->hex_count);
}

static hexcon_status close_inside(hexcon_context *context, const cell_problem *p, closure_kind kind,
                                  const double *placed, closure *c, bool *found) {
  size_t inner_count = p->s->point_count, triangle_count = 2 * p->s->quad_count;
  *found = true;
  if (kind == CLOSURE_STAR)
    return closure_star(context, inner_count, p->cells.triangles, triangle_count, p->center, c);
  return closure_tetrahedra(context, placed + 3 * p->cells.first_inner, inner_count,
                            p->cells.triangles, triangle_count, p->options, c, found);
}

hexcon_status cell_filling_build(hexcon_context *context, const cell_problem *p, double thickness,
                                 closure_kind kind, cell_filling *f) {
  closure c = {0};
  diced_complex diced = {0};
  bool found = false;
  double *placed = context_allocate(context, p->cells.point_count, 3 * sizeof *placed);
  hexcon_status status = placed ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  if (!status)
    status = place(context, p, thickness, placed);
  if (!status)
    status = close_inside(context, p, kind, placed, &c, &found);
  f->tetrahedron_count = c.tetrahedron_count;
  if (!status && found)
    status = dice_closure(context, p, &c, &diced);
  if (!status && found)
    status = assemble(context, p, placed, &c, &diced, f);
  closure_free(context, &c);
  dice_free(context, &diced);
  context_free(context, placed);
  return status;
}
