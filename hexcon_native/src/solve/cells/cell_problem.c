/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "cell_problem.h"

#include <math.h>

#include "pairing/pair_weights.h"
#include "pairing/pairing.h"
#include "surface/colouring.h"
#include "surface/corner_angles.h"

void cell_problem_free(hexcon_context *context, cell_problem *p) {
  context_free(context, p->colours);
  context_free(context, p->weights);
  context_free(context, p->partner);
  cells_free(context, &p->cells);
}

hexcon_status cell_problem_build_cells(hexcon_context *context, cell_problem *p, size_t layers) {
  cells_free(context, &p->cells);
  hexcon_status status = surface_pair(context, p->s, p->weights, p->partner);
  return status ? status : cells_build(context, p->s, p->colours, p->partner, layers, &p->cells);
}

hexcon_status cell_problem_new(hexcon_context *context, const surface *s,
                               const hexcon_mesh_options *options, cell_problem *out) {
  *out = (cell_problem){.s = s, .options = options, .bound = 1};
  out->colours = context_allocate(context, s->point_count, sizeof *out->colours);
  out->weights = context_allocate(context, 4 * s->quad_count, sizeof *out->weights);
  out->partner = context_allocate(context, s->quad_count, sizeof *out->partner);
  if (!out->colours || !out->weights || !out->partner)
    return HEXCON_OUT_OF_MEMORY;
  hexcon_status status = surface_colour(context, s, out->colours);
  if (status)
    return status;
  surface_pair_weights(s, out->weights);
  for (int32_t h = 0; h < (int32_t)(4 * s->quad_count); h++)
    out->bound = fmin(out->bound, fabs(sin(surface_corner_angle(s, h))));
  return HEXCON_OK;
}
