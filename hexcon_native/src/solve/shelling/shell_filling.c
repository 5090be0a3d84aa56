/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "shell_filling.h"

#include <string.h>

#include "base/vector.h"
#include "shape/offset/inner_surface.h"
#include "shape/place/prism_placement.h"
#include "solve/sheets/sheet_search.h"

enum { PRISM = 12 };

/** The inner surface goes at most this part of the way to the centre. */
static const double deepest = 0.6;

/** In this order, until one fills the inside. */
static const sheet_taste tastes[] = {
    {.hex_weight = 0.05, .seed = 1, .least_corner = -1},
    {.hex_weight = 1, .seed = 2, .least_corner = -1},
    {.hex_weight = 0.1, .noise = 2, .seed = 3, .least_corner = -1}};
enum { TASTES = sizeof tastes / sizeof *tastes };

/* ------------------------------------------------------------------------------------ placement */

/** Levels lie evenly between the surface and its inner copy. */
static hexcon_status place_levels(hexcon_context *context, const surface *s, size_t shells,
                                  const shell_space *space, double *points) {
  size_t width = 3 * s->point_count;
  inner_surface_options options = {.thickness = space->thickness * (double)shells,
                                   .depth = deepest,
                                   .no_center = space->no_center};
  memcpy(options.center, space->center, sizeof options.center);
  memcpy(points, s->points, width * sizeof *points);
  if (shells == 0)
    return HEXCON_OK;
  double *inner = points + shells * width;
  hexcon_status status = inner_surface_place(context, s, &options, inner);
  for (size_t level = 1; !status && level < shells; level++) {
    double part = (double)level / (double)shells;
    for (size_t i = 0; i < width; i++)
      points[level * width + i] = (1 - part) * points[i] + part * inner[i];
  }
  return status;
}

/** Points inside the cells, where mean value coordinates of the prism take those of the template.
 */
static void place_cells_inside(const rotated_shell *shell, double *points) {
  const hex_template *cell = shell->cell;
  double corners[PRISM][3];
  int rows[PRISM];
  for (int i = 0; i < PRISM; i++) {
    const char label[] = {i < PRISM / 2 ? 'T' : 'B', (char)('0' + i % (PRISM / 2)), '\0'};
    rows[i] = template_row(cell, label);
    memcpy(corners[i], cell->points[rows[i]].place, sizeof corners[i]);
  }
  for (size_t row = 0; row < cell->point_count; row++) {
    double weights[PRISM];
    if (strcmp(cell->points[row].label, "int") != 0)
      continue;
    prism_weights(corners, cell->points[row].place, weights);
    for (size_t c = 0; c < shell->cell_count; c++) {
      const int32_t *ids = shell->cell_points + c * cell->point_count;
      double *place = points + 3 * (size_t)ids[row];
      memset(place, 0, 3 * sizeof *place);
      for (int i = 0; i < PRISM; i++)
        vector_add_scaled(place, weights[i], points + 3 * (size_t)ids[rows[i]]);
    }
  }
}

/* ---------------------------------------------------------------------------------------- joining
 */

/** Shells and sheets in one numbering: the inner surface's points are those of the last level. */
static hexcon_status join(hexcon_context *context, const rotated_shell *shell, size_t shells,
                          const double *placed, const sheet_search *sheets, filled_mesh *out) {
  const growing_mesh *inside = &sheets->front.mesh;
  size_t width = shell->inner.point_count, base = shells * width;
  hexcon_status status =
      filled_mesh_new(context, shell->mesh.point_count + inside->point_count - width,
                      shell->mesh.hex_count + inside->hex_count, out);
  if (status)
    return status;
  memcpy(out->points, placed, 3 * shell->mesh.point_count * sizeof *placed);
  memcpy(out->points + 3 * shell->mesh.point_count, sheets->points + 3 * width,
         3 * (inside->point_count - width) * sizeof *placed);
  out->outer_hexes = shell->mesh.hex_count;
  memcpy(out->hexes, shell->mesh.hexes, 8 * shell->mesh.hex_count * sizeof *out->hexes);
  int32_t *hexes = out->hexes + 8 * shell->mesh.hex_count;
  for (size_t i = 0; i < 8 * inside->hex_count; i++) {
    size_t point = (size_t)inside->hexes[i];
    hexes[i] = (int32_t)(point < width ? base + point : shell->mesh.point_count + point - width);
  }
  return HEXCON_OK;
}

/** Fill the inner surface. */
static hexcon_status fill_inside(hexcon_context *context, const rotated_shell *shell, size_t shells,
                                 const double *placed, size_t limit, filled_mesh *out) {
  surface inner = shell->inner;
  hexcon_status status = HEXCON_OK;
  inner.points = placed + 3 * shells * inner.point_count;
  for (size_t i = 0; !status && !out->points && i < TASTES; i++) {
    sheet_search sheets;
    status = sheet_search_run(context, &inner, &tastes[i], limit, &sheets);
    if (!status && sheets.complete)
      status = join(context, shell, shells, placed, &sheets, out);
    sheet_search_free(context, &sheets);
  }
  return status;
}

hexcon_status shell_filling_build(hexcon_context *context, const surface *s,
                                  const rotation_plan *plan, const shell_space *space, size_t limit,
                                  filled_mesh *out) {
  rotated_shell shell;
  double *placed = NULL;
  bool fits;
  *out = (filled_mesh){0};
  hexcon_status status = rotated_shell_build(context, s, plan, &shell, &fits);
  if (!status && fits) {
    placed = context_allocate(context, shell.mesh.point_count, 3 * sizeof *placed);
    status =
        placed ? place_levels(context, s, plan->shell_count, space, placed) : HEXCON_OUT_OF_MEMORY;
  }
  if (!status && fits) {
    place_cells_inside(&shell, placed);
    status = fill_inside(context, &shell, plan->shell_count, placed, limit, out);
  }
  context_free(context, placed);
  rotated_shell_free(context, &shell);
  return status;
}
