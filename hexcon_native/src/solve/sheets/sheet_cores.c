/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "sheet_cores.h"

#include <string.h>

#include "shape/offset/inner_surface.h"
#include "surface/star_center.h"

/** On the surface itself no corner may be worse than this: a layer needs edges where the surface
 * bends. A covered layer may lie anywhere. First what geometry says, then mostly the number of
 * hexes, then luck. */
static const sheet_taste bare_tastes[] = {{0.05, 0, 1, 0.2}, {1, 0, 2, 0.2}, {0.3, 0.5, 3, 0.2}};
static const sheet_taste covered_tastes[] = {{0.05, 0, 1, -1}, {1, 0, 2, -1}, {0.3, 0.5, 3, -1}};
enum { TASTES = sizeof bare_tastes / sizeof *bare_tastes };

void sheet_cores_free(hexcon_context *context, sheet_cores *cores) {
  while (cores->count)
    layered_core_free(context, &cores->cores[--cores->count]);
}

/** Hexes that a mesh with this core will have, about: cells take many, small fillings few. */
static double expected_hexes(const layered_core *core) {
  const size_t small = 16, quads = core->s.quad_count;
  const double hexes_a_quad = quads <= small ? 5 : 45;
  return (double)core->hex_count + hexes_a_quad * (double)quads;
}

/** True if so little goes that cells alone are as good. */
static bool is_next_to_nothing(const surface *s, const layered_core *core) {
  const double least_part = 0.1;
  return (double)core->s.quad_count > (1 - least_part) * (double)s->quad_count;
}

/** Keep a core, which is then empty, if it is among the most promising and none of them. */
static void keep_core(hexcon_context *context, const surface *s, layered_core *core,
                      sheet_cores *all) {
  size_t at = 0;
  while (at < all->count && expected_hexes(&all->cores[at]) < expected_hexes(core))
    at++;
  bool known = at < all->count && expected_hexes(&all->cores[at]) <= expected_hexes(core);
  if (known || at == CORES_KEPT || is_next_to_nothing(s, core))
    return;
  if (all->count == CORES_KEPT)
    layered_core_free(context, &all->cores[--all->count]);
  memmove(all->cores + at + 1, all->cores + at, (all->count++ - at) * sizeof *all->cores);
  all->cores[at] = *core;
  *core = (layered_core){0};
}

/** Find a core of the surface, or of its copy inside, which is then covered. */
static hexcon_status find_core(hexcon_context *context, const surface *s, const surface *inside,
                               const sheet_taste *taste, size_t limit, sheet_cores *all) {
  sheet_search search;
  layered_core core = {0};
  hexcon_status status = sheet_search_run(context, inside, taste, limit, &search);
  all->step_count += search.step_count;
  if (!status)
    status = layered_core_take(context, &search, &core);
  if (!status && inside != s)
    status = layered_core_cover(context, s, &core);
  if (!status)
    keep_core(context, s, &core, all);
  layered_core_free(context, &core);
  sheet_search_free(context, &search);
  return status;
}

/** A copy of the surface's points inside it, for a layer to lie between.
 * @param points  [s->point_count][3] */
static hexcon_status place_inside(hexcon_context *context, const surface *s, double *points) {
  inner_surface_options options = {.thickness = 0.4, .depth = 0.3};
  double margin;
  hexcon_status status = surface_star_center(context, s, options.center, &margin);
  if (!status && !(margin > 0))
    status = surface_mean_center(context, s, options.center, &margin);
  options.no_center = !(margin > 0);
  return status ? status : inner_surface_place(context, s, &options, points);
}

/** Find cores under a layer that covers the surface. */
static hexcon_status find_covered(hexcon_context *context, const surface *s, size_t limit,
                                  sheet_cores *all) {
  surface inside = *s; /* all but the points is shared */
  double *points = context_allocate(context, s->point_count, 3 * sizeof *points);
  hexcon_status status = points ? place_inside(context, s, points) : HEXCON_OUT_OF_MEMORY;
  inside.points = points;
  for (size_t i = 0; !status && i < TASTES; i++)
    status = find_core(context, s, &inside, &covered_tastes[i], limit, all);
  context_free(context, points);
  return status;
}

static void drop_unfinished(hexcon_context *context, sheet_cores *all) {
  size_t kept = 0;
  for (size_t i = 0; i < all->count; i++)
    if (all->cores[i].s.quad_count == 0)
      all->cores[kept++] = all->cores[i];
    else
      layered_core_free(context, &all->cores[i]);
  all->count = kept;
}

hexcon_status sheet_cores_find(hexcon_context *context, const surface *s, bool whole_only,
                               size_t limit, sheet_cores *out) {
  hexcon_status status = HEXCON_OK;
  *out = (sheet_cores){0};
  for (size_t i = 0; !status && i < TASTES; i++)
    status = find_core(context, s, s, &bare_tastes[i], limit, out);
  if (!status)
    status = find_covered(context, s, limit, out);
  if (whole_only)
    drop_unfinished(context, out);
  return status;
}
