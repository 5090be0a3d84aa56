/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "mesh_sheets.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core_mesh.h"
#include "quality_bound.h"
#include "shape/improve.h"
#include "shape/inner_surface.h"
#include "sheet_search.h"
#include "surface/star_center.h"
#include "verify/scaled_jacobian.h"

/** In this order until a mesh is good: first what geometry says, then mostly the number of hexes,
 * then with luck, which helps out of dead ends. */
static const sheet_taste tastes[] = {{0.05, 0, 1, -1}, {1, 0, 2, -1}, {0.3, 0.5, 3, -1},
                                     {0.1, 2, 4, -1},  {1, 2, 5, -1}, {1, 8, 6, -1}};
enum { TASTES = sizeof tastes / sizeof *tastes };

/** Where no order leads to a valid mesh, the layers that have room for good hexes, and a core. */
static const sheet_taste core_tastes[] = {{0.05, 0, 1, 0.2}, {1, 0, 2, 0.2}, {0.3, 0.5, 3, 0.2}};
enum { CORE_TASTES = sizeof core_tastes / sizeof *core_tastes };

/** So many of the other tastes are tried under a layer that covers the whole surface. */
enum { COVERED_TASTES = 3 };

/** Of tastes that lead to a mesh, so many are compared; more, if none is valid. */
enum { MESHES_COMPARED = 2, MESHES_MOST = 3 };

/** Quads visited beyond dead ends, for each taste. */
enum { SEARCH_QUADS = 400000 };

/** Worst scaled Jacobian, as part of what the surface allows, with which no other way is tried. */
static const double good_part = 0.6;

/** Improvement stops at this part of the bound, and aims at this much where there is none. */
static const double near_the_bound = 0.95, least_target = 1e-3;

/** A mesh made by layers and what it is worth. */
typedef struct filling {
  double *points, *quality;
  int32_t *hexes;
  size_t point_count, hex_count, layer_count, rounds, inverted;
  double worst, mean, bound;
} filling;

/** Cores that are kept, to be filled if no order leads to a cube. */
enum { CORES_KEPT = 4 };

/** What has been done, for the report. */
typedef struct effort {
  size_t taste_count, mesh_count, step_count;
  layered_core smallest;
  size_t core_count;
  layered_core cores[CORES_KEPT]; /* the most promising first */
} effort;

static void filling_free(hexcon_context *context, filling *f) {
  context_free(context, f->points);
  context_free(context, f->quality);
  context_free(context, f->hexes);
  memset(f, 0, sizeof *f);
}

static bool is_better(const filling *a, const filling *b) {
  if (!b->points || a->inverted != b->inverted)
    return !b->points || a->inverted < b->inverted;
  return a->worst > b->worst;
}

/** True if no further taste is worth its while. */
static bool is_enough(const effort *e, const filling *best) {
  bool valid = best->points && best->inverted == 0;
  return e->taste_count == TASTES || e->mesh_count >= MESHES_MOST ||
         (valid && e->mesh_count >= MESHES_COMPARED) ||
         (valid && best->worst >= good_part * best->bound);
}

static void measure(filling *f) {
  f->inverted = 0;
  f->worst = 1;
  f->mean = 0;
  for (size_t h = 0; h < f->hex_count; h++) {
    f->quality[h] = scaled_jacobian(f->points, f->hexes + 8 * h);
    f->inverted += f->quality[h] <= 0;
    f->worst = fmin(f->worst, f->quality[h]);
    f->mean += f->quality[h] / (double)f->hex_count;
  }
}

/** Improve what falls short of what the surface allows. */
static hexcon_status improve(hexcon_context *context, const surface *s, filling *f) {
  f->bound = quality_bound(s, f->points, f->hexes, f->hex_count);
  hexcon_optimize_options options = {.target = fmax(near_the_bound * f->bound, least_target)};
  if (f->worst >= options.target || f->bound <= 0)
    return HEXCON_OK;
  uint8_t *fixed = context_allocate_zeroed(context, f->point_count, 1);
  if (!fixed)
    return HEXCON_OUT_OF_MEMORY;
  memset(fixed, 1, s->point_count);
  hexcon_status status = improve_mesh(context, f->points, f->point_count, f->hexes, f->hex_count,
                                      fixed, &options, &f->rounds);
  context_free(context, fixed);
  measure(f);
  return status;
}

/** Take over what a search made. */
static hexcon_status take(hexcon_context *context, sheet_search *search, filling *f) {
  f->points = search->points;
  f->hexes = search->front.mesh.hexes;
  f->point_count = search->front.mesh.point_count;
  f->hex_count = search->front.mesh.hex_count;
  f->layer_count = search->front.layer_count;
  search->points = NULL;
  search->front.mesh.hexes = NULL;
  f->quality = context_allocate(context, f->hex_count, sizeof *f->quality);
  if (!f->quality)
    return HEXCON_OUT_OF_MEMORY;
  measure(f);
  return HEXCON_OK;
}

/** Remember the smallest core. */
static hexcon_status note_smallest(hexcon_context *context, sheet_search *search, effort *e) {
  if (e->smallest.points && search->front.alive_count >= e->smallest.s.quad_count)
    return HEXCON_OK;
  layered_core_free(context, &e->smallest);
  return layered_core_take(context, search, &e->smallest);
}

static hexcon_status try_taste(hexcon_context *context, const surface *s, const sheet_taste *taste,
                               effort *e, filling *best) {
  sheet_search search;
  filling f = {0};
  hexcon_status status = sheet_search_run(context, s, taste, SEARCH_QUADS, &search);
  e->taste_count++;
  e->step_count += search.step_count;
  if (!status && !search.complete)
    status = note_smallest(context, &search, e);
  if (!status && search.complete) {
    e->mesh_count++;
    status = take(context, &search, &f);
    if (!status)
      status = improve(context, s, &f);
  }
  sheet_search_free(context, &search);
  if (!status && f.points && is_better(&f, best)) {
    filling worse = *best;
    *best = f;
    f = worse;
  }
  filling_free(context, &f);
  return status;
}

/** Tell of the most promising core, and list its quads that are the surface's. */
static hexcon_status fail(hexcon_context *context, const surface *s, const layered_core *core) {
  context_clear(context);
  for (size_t q = 0; q < core->s.quad_count; q++) {
    bool given = true;
    for (size_t corner = 0; corner < 4; corner++)
      given &= (size_t)core->ids[core->s.quads[4 * q + corner]] < s->point_count;
    if (given)
      context_add_element(context, core->quad_ids[q]);
  }
  return context_fail(
      context, HEXCON_NO_SHEETS,
      "no order of the dual loops that was tried leads to a cube: of %zu quads, %zu layers of "
      "%zu hexes took %zu away, and left a core of %zu (those of the surface "
      "listed), whose loops cross themselves or keep the surface from touching "
      "itself",
      s->quad_count, core->layer_count, core->hex_count, s->quad_count - core->s.quad_count,
      core->s.quad_count);
}

static void hand_over(const surface *s, const effort *e, const filling *f, hexcon_mesh *mesh) {
  char line[160];
  mesh->points = f->points;
  mesh->hexes = f->hexes;
  mesh->quality = f->quality;
  mesh->point_count = f->point_count;
  mesh->hex_count = f->hex_count;
  mesh->order = 1;
  mesh->method = "sheets";
  mesh->bound = f->bound;
  mesh_note(mesh, "sheets", (double)f->layer_count);
  mesh_note(mesh, "core quads", 0);
  mesh_note(mesh, "hexes per quad", (double)f->hex_count / (double)s->quad_count);
  mesh_note(mesh, "orders tried", (double)e->taste_count);
  mesh_note(mesh, "search steps", (double)e->step_count);
  mesh_note(mesh, "optimisation rounds", (double)f->rounds);
  mesh_note(mesh, "surface bound", f->bound);
  (void)snprintf(line, sizeof line,
                 "sheets: %zu layers and a last hex, %zu hexes; %zu of %zu orders tried lead to a "
                 "mesh",
                 f->layer_count, f->hex_count, e->mesh_count, e->taste_count);
  mesh_log(mesh, line);
}

static hexcon_status check_sphere(hexcon_context *context, const surface *s) {
  if (s->point_count == s->quad_count + 2)
    return HEXCON_OK;
  return context_fail(context, HEXCON_NOT_A_BALL,
                      "the surface has holes through it: sheets fill balls only; cut it");
}

/* ----------------------------------------------------------------------------------------- cores
 */

/** Hexes that a mesh with this core will have, about: cells take most. */
static double expected_hexes(const layered_core *core) {
  const double hexes_a_quad = 45;
  return (double)core->hex_count + hexes_a_quad * (double)core->s.quad_count;
}

/** True if so little goes that cells alone are as good. */
static bool is_next_to_nothing(const surface *s, const layered_core *core) {
  const double least_part = 0.1;
  return (double)core->s.quad_count > (1 - least_part) * (double)s->quad_count;
}

/** Keep a core, which is then empty, if it is among the most promising and none of them. */
static void keep_core(hexcon_context *context, const surface *s, layered_core *core, effort *e) {
  size_t at = 0;
  while (at < e->core_count && expected_hexes(&e->cores[at]) < expected_hexes(core))
    at++;
  bool known = at < e->core_count && expected_hexes(&e->cores[at]) <= expected_hexes(core);
  if (known || at == CORES_KEPT || is_next_to_nothing(s, core))
    return;
  if (e->core_count == CORES_KEPT)
    layered_core_free(context, &e->cores[--e->core_count]);
  memmove(e->cores + at + 1, e->cores + at, (e->core_count++ - at) * sizeof *e->cores);
  e->cores[at] = *core;
  *core = (layered_core){0};
}

/** Find a core of the surface, or of its copy inside, which is then covered. */
static hexcon_status find_core(hexcon_context *context, const surface *s, const surface *inside,
                               const sheet_taste *taste, effort *e) {
  sheet_search search;
  layered_core core = {0};
  hexcon_status status = sheet_search_run(context, inside, taste, SEARCH_QUADS, &search);
  e->step_count += search.step_count;
  if (!status)
    status = layered_core_take(context, &search, &core);
  if (!status && inside != s)
    status = layered_core_cover(context, s, &core);
  if (!status)
    keep_core(context, s, &core, e);
  layered_core_free(context, &core);
  sheet_search_free(context, &search);
  return status;
}

/** A copy of the surface for a layer to lie between; shares all but the points. */
static hexcon_status copy_inside(hexcon_context *context, const surface *s, surface *out) {
  inner_surface_options options = {.thickness = 0.4, .depth = 0.3};
  double margin, *points = context_allocate(context, s->point_count, 3 * sizeof *points);
  *out = *s;
  out->points = points;
  if (!points)
    return HEXCON_OUT_OF_MEMORY;
  hexcon_status status = surface_star_center(context, s, options.center, &margin);
  if (!status && !(margin > 0))
    status = surface_mean_center(context, s, options.center, &margin);
  options.no_center = !(margin > 0);
  return status ? status : inner_surface_place(context, s, &options, points);
}

static hexcon_status find_cores(hexcon_context *context, const surface *s, effort *e) {
  surface inside = {0};
  hexcon_status status = HEXCON_OK;
  for (size_t i = 0; !status && i < CORE_TASTES; i++)
    status = find_core(context, s, s, &core_tastes[i], e);
  if (!status)
    status = copy_inside(context, s, &inside);
  for (size_t i = 0; !status && i < COVERED_TASTES; i++)
    status = find_core(context, s, &inside, &tastes[i], e);
  context_free(context, (double *)(uintptr_t)inside.points);
  return status;
}

static void hand_over_core(const surface *s, const effort *e, core_mesh *m, hexcon_mesh *mesh) {
  mesh->points = m->mesh.points;
  mesh->hexes = m->mesh.hexes;
  mesh->quality = m->mesh.quality;
  mesh->point_count = m->mesh.point_count;
  mesh->hex_count = m->mesh.hex_count;
  mesh->order = 1;
  mesh->method = "sheets";
  mesh->bound = m->bound;
  mesh_note(mesh, "sheets", (double)m->layer_count);
  mesh_note(mesh, "quads removed", (double)(s->quad_count - m->core_quads));
  mesh_note(mesh, "core quads", (double)m->core_quads);
  mesh_note(mesh, "core hexes", (double)m->core_hexes);
  mesh_note(mesh, "hexes per quad", (double)m->mesh.hex_count / (double)s->quad_count);
  mesh_note(mesh, "orders tried", (double)e->taste_count);
  mesh_note(mesh, "search steps", (double)e->step_count);
  mesh_note(mesh, "cores tried", (double)m->attempt_count);
  mesh_note(mesh, "optimisation rounds", (double)m->mesh.rounds);
  mesh_note(mesh, "surface bound", m->bound);
}

static hexcon_status fill_core(hexcon_context *context, const surface *s,
                               const hexcon_mesh_options *options, effort *e, hexcon_mesh *mesh) {
  core_mesh best;
  hexcon_status status = core_mesh_make(context, s, options, e->cores, e->core_count, mesh, &best);
  if (!status && best.mesh.points)
    hand_over_core(s, e, &best, mesh);
  else
    filled_mesh_free(context, &best.mesh);
  return status ? status : mesh->hexes ? HEXCON_OK : fail(context, s, &e->smallest);
}

hexcon_status mesh_sheets(hexcon_context *context, const surface *s,
                          const hexcon_mesh_options *options, hexcon_mesh *mesh) {
  effort e = {0};
  filling best = {0};
  double start = mesh_clock();
  hexcon_status status = check_sphere(context, s);
  while (!status && !is_enough(&e, &best))
    status = try_taste(context, s, &tastes[e.taste_count], &e, &best);
  mesh_note_seconds(mesh, "sheets", start);
  start = mesh_clock();
  bool valid = best.points && best.inverted == 0;
  if (!status && !valid)
    status = find_cores(context, s, &e);
  mesh_note_seconds(mesh, "core search", start);
  if (!status && (valid || !e.core_count) && best.points)
    hand_over(s, &e, &best, mesh);
  else if (!status && !e.core_count)
    status = fail(context, s, &e.smallest);
  else if (!status)
    status = fill_core(context, s, options, &e, mesh);
  if (status)
    filling_free(context, &best);
  layered_core_free(context, &e.smallest);
  while (e.core_count)
    layered_core_free(context, &e.cores[--e.core_count]);
  return status;
}
