/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "core_filling.h"

#include <string.h>

#include "solve/cells/cell_filling.h"
#include "solve/smallest/mesh_smallest.h"
#include "surface/star_center.h"

void core_filling_free(hexcon_context *context, core_filling *f) {
  context_free(context, f->points);
  context_free(context, f->hexes);
  memset(f, 0, sizeof *f);
}

static void take(filled_mesh *from, core_filling *out) {
  *out = (core_filling){from->point_count, from->hex_count, from->points, from->hexes};
  from->points = NULL;
  from->hexes = NULL;
}

static hexcon_status fill_from_table(hexcon_context *context, const surface *core, int threads,
                                     core_filling *out) {
  small_mesh made;
  hexcon_status status = small_mesh_build(context, core, threads, &made);
  if (!status)
    take(&made.mesh, out);
  filled_mesh_free(context, &made.mesh);
  return status;
}

/** A point that sees the core, or most of it, or lies in its middle. */
static hexcon_status find_center(hexcon_context *context, const surface *core, double center[3]) {
  double margin;
  hexcon_status status = surface_star_center(context, core, center, &margin);
  if (!status && !(margin > 0))
    status = surface_mean_center(context, core, center, &margin);
  if (status || margin > 0)
    return status;
  memset(center, 0, 3 * sizeof *center);
  for (size_t i = 0; i < 3 * core->point_count; i++)
    center[i % 3] += core->points[i] / (double)core->point_count;
  return HEXCON_OK;
}

static hexcon_status fill_with_cells(hexcon_context *context, const surface *core,
                                     closure_kind kind, double thickness,
                                     const hexcon_mesh_options *options, core_filling *out) {
  cell_problem p;
  cell_filling f = {0};
  hexcon_status status = cell_problem_new(context, core, options, &p);
  if (!status)
    status = find_center(context, core, p.center);
  if (!status)
    status = cell_problem_build_cells(context, &p, 1);
  if (!status)
    status = cell_filling_build(context, &p, thickness, kind, &f);
  if (!status)
    take(&f.mesh, out);
  filled_mesh_free(context, &f.mesh);
  cell_problem_free(context, &p);
  return status;
}

/** Whether a fault only says that this way does not suit the core. */
static bool is_about_way(hexcon_status status) {
  return status == HEXCON_NO_SMALL_FILLING || status == HEXCON_NO_PAIRING;
}

hexcon_status core_filling_build(hexcon_context *context, const surface *core, core_way way,
                                 double thickness, const hexcon_mesh_options *options,
                                 core_filling *out) {
  *out = (core_filling){0};
  if (way == CORE_NONE)
    return HEXCON_OK;
  hexcon_status status =
      way == CORE_TABLE
          ? fill_from_table(context, core, options->threads, out)
          : fill_with_cells(context, core, way == CORE_STAR ? CLOSURE_STAR : CLOSURE_TETRAHEDRA,
                            thickness, options, out);
  return is_about_way(status) ? HEXCON_OK : status;
}
