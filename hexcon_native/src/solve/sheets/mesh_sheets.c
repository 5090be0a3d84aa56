/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "mesh_sheets.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core_mesh.h"
#include "hexmesh/scaled_jacobian.h"
#include "shape/improve/improve.h"
#include "sheet_cores.h"
#include "solve/common/quality_bound.h"

/** In this order until a mesh is good: first what geometry says, then mostly the number of hexes,
 * then with luck, which helps out of dead ends. */
static const sheet_taste tastes[] = {{0.05, 0, 1, -1}, {1, 0, 2, -1}, {0.3, 0.5, 3, -1},
                                     {0.1, 2, 4, -1},  {1, 2, 5, -1}, {1, 8, 6, -1}};
enum { TASTES = sizeof tastes / sizeof *tastes };

/** Of tastes that lead to a mesh, so many are compared; more, if none is valid. */
enum { MESHES_COMPARED = 2, MESHES_MOST = 3 };

/** Quads visited beyond dead ends, for each taste. */
enum { SEARCH_QUADS = 400000 };

/** Worst scaled Jacobian, as part of what the surface allows, with which no other way is tried. */
static const double good_part = 0.6;

/** ... and with which layers alone are good enough. */
static const double good_worst = 0.1;

/** Improvement stops at this part of the bound, and aims at this much where there is none. */
static const double near_the_bound = 0.95, least_target = 1e-3;

/** A mesh made by layers and what it is worth. */
typedef struct filling {
  double *points, *quality;
  int32_t *hexes;
  size_t point_count, hex_count, layer_count, rounds, inverted;
  double worst, mean, bound;
} filling;

/** What has been done, for the report. */
typedef struct effort {
  size_t taste_count, mesh_count, step_count;
  layered_core smallest; /* core met on the way, for the words */
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

static hexcon_status measure(hexcon_context *context, filling *f) {
  hexcon_status status = HEXCON_OK;
  f->inverted = 0;
  f->worst = 1;
  f->mean = 0;
  for (size_t h = 0; !status && h < f->hex_count; h++) {
    f->quality[h] = scaled_jacobian(f->points, f->hexes + 8 * h);
    f->inverted += f->quality[h] <= 0;
    f->worst = fmin(f->worst, f->quality[h]);
    f->mean += f->quality[h] / (double)f->hex_count;
    status = context_pass(context, h);
  }
  return status;
}

/** Improve what falls short of what the surface allows. */
static hexcon_status improve(hexcon_context *context, const surface *s, int threads, filling *f) {
  hexcon_status status = quality_bound(context, s, f->points, f->hexes, f->hex_count, &f->bound);
  hexcon_optimize_options options = {.threads = threads,
                                     .target = fmax(near_the_bound * f->bound, least_target)};
  if (status || f->worst >= options.target || f->bound <= 0)
    return status;
  uint8_t *fixed = context_allocate_zeroed(context, f->point_count, 1);
  if (!fixed)
    return HEXCON_OUT_OF_MEMORY;
  memset(fixed, 1, s->point_count);
  status = improve_mesh(context, f->points, f->point_count, f->hexes, f->hex_count, fixed, &options,
                        &f->rounds);
  context_free(context, fixed);
  hexcon_status measured = mesh_stop(context, status) ? measure(context, f) : HEXCON_OK;
  return measured ? measured : status;
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
  return measure(context, f);
}

/** Remember the smallest core. */
static hexcon_status note_smallest(hexcon_context *context, sheet_search *search, effort *e) {
  if (e->smallest.points && search->front.alive_count >= e->smallest.s.quad_count)
    return HEXCON_OK;
  layered_core_free(context, &e->smallest);
  return layered_core_take(context, search, &e->smallest);
}

static hexcon_status try_taste(hexcon_context *context, const surface *s, const sheet_taste *taste,
                               int threads, effort *e, filling *best) {
  sheet_search search;
  filling f = {0};
  hexcon_status status = sheet_search_run(context, s, taste, SEARCH_QUADS, &search);
  e->taste_count++;
  e->step_count += search.step_count;
  if (!status && !search.complete)
    status = note_smallest(context, &search, e);
  bool taken = false;
  if (!status && search.complete) {
    e->mesh_count++;
    status = take(context, &search, &f);
    taken = !status;
    if (taken)
      status = improve(context, s, threads, &f);
  }
  sheet_search_free(context, &search);
  if (taken && mesh_stop(context, status) && is_better(&f, best)) {
    filling worse = *best;
    *best = f;
    f = worse;
  }
  filling_free(context, &f);
  return status;
}

/** Tell of the most promising core, and list its quads that are the surface's. */
static hexcon_status fail(hexcon_context *context, const surface *s, const layered_core *core,
                          bool tried) {
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
      "itself%s",
      s->quad_count, core->layer_count, core->hex_count, s->quad_count - core->s.quad_count,
      core->s.quad_count,
      tried ? "; nor is there a valid mesh of such layers with a filled core" : "");
}

static void hand_over(const surface *s, const effort *e, const filling *f, hexcon_mesh *mesh) {
  char line[160];
  mesh->points = f->points;
  mesh->hexes = f->hexes;
  mesh->quality = f->quality;
  mesh->point_count = f->point_count;
  mesh->hex_count = f->hex_count;
  mesh->order = 1;
  mesh->bound = f->bound;
  mesh_note(mesh, "sheets", (double)f->layer_count);
  mesh_note(mesh, "quads removed", (double)s->quad_count);
  mesh_note(mesh, "core quads", 0);
  mesh_note(mesh, "core hexes", 0);
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
  if (surface_is_sphere(s))
    return HEXCON_OK;
  return context_fail(context, HEXCON_NOT_A_BALL,
                      "the surface has holes through it: sheets fill balls only; cut it");
}

/* ------------------------------------------------------------------------------------ the core */

static void hand_over_core(const surface *s, core_mesh *m, hexcon_mesh *mesh) {
  mesh->points = m->mesh.points;
  mesh->hexes = m->mesh.hexes;
  mesh->quality = m->mesh.quality;
  mesh->point_count = m->mesh.point_count;
  mesh->hex_count = m->mesh.hex_count;
  mesh->order = 1;
  mesh->bound = m->bound;
  mesh_note(mesh, "sheets", (double)m->layer_count);
  mesh_note(mesh, "quads removed", (double)(s->quad_count - m->core_quads));
  mesh_note(mesh, "core quads", (double)m->core_quads);
  mesh_note(mesh, "core hexes", (double)m->core_hexes);
  mesh_note_hexes(mesh, HEXES_OF_LAYERS, m->mesh.hex_count - m->core_hexes);
  mesh_note_hexes(mesh, HEXES_OF_CORE, m->core_hexes);
  mesh_note(mesh, "hexes per quad", (double)m->mesh.hex_count / (double)s->quad_count);
  mesh_note(mesh, "fillings tried", (double)m->attempt_count);
  mesh_note(mesh, "optimisation rounds", (double)m->mesh.rounds);
  mesh_note(mesh, "surface bound", m->bound);
}

/** Whether a filled core, or layers under a cover, are better than what layers alone gave. */
static bool is_core_better(const core_mesh *m, const filling *best) {
  if (!m->mesh.points || !best->points)
    return m->mesh.points != NULL;
  if ((m->mesh.inverted == 0) != (best->inverted == 0))
    return m->mesh.inverted == 0;
  return m->mesh.worst > best->worst;
}

/** Fill a core, or lay the same layers under one that covers the surface; a mesh of layers alone
 * that is bad but valid is only compared with others of layers alone. */
static hexcon_status try_cores(hexcon_context *context, const surface *s,
                               const hexcon_mesh_options *options, const filling *best,
                               core_mesh *out, hexcon_mesh *mesh) {
  sheet_cores all;
  const bool whole_only = options->no_core || (best->points && best->inverted == 0);
  double start = mesh_clock();
  hexcon_status status = sheet_cores_find(context, s, whole_only, SEARCH_QUADS, &all);
  mesh_note_seconds(mesh, "core search", start);
  start = mesh_clock();
  if (!status)
    status = core_mesh_make(context, s, options, all.cores, all.count, mesh, out);
  status = mesh_settle(context, status, out->mesh.points || best->points, mesh);
  mesh_note_seconds(mesh, "core filling", start);
  sheet_cores_free(context, &all);
  return status;
}

static bool is_good(const filling *best) {
  return best->points && best->inverted == 0 &&
         best->worst >= fmin(good_worst, near_the_bound * best->bound);
}

hexcon_status mesh_sheets(hexcon_context *context, const surface *s,
                          const hexcon_mesh_options *options, hexcon_mesh *mesh) {
  effort e = {0};
  filling best = {0};
  core_mesh with_core = {0};
  double start = mesh_clock();
  hexcon_status status = check_sphere(context, s);
  while (!status && !is_enough(&e, &best))
    status = try_taste(context, s, &tastes[e.taste_count], options->threads, &e, &best);
  mesh_note_seconds(mesh, "sheets", start);
  bool late = status == HEXCON_OUT_OF_TIME;
  status = mesh_settle(context, status, best.points != NULL, mesh);
  if (!status && !late && !is_good(&best))
    status = try_cores(context, s, options, &best, &with_core, mesh);
  if (!status && !best.points && !with_core.mesh.points)
    status = fail(context, s, &e.smallest, with_core.core_count > 0);
  if (!status && is_core_better(&with_core, &best)) {
    hand_over_core(s, &with_core, mesh);
    memset(&with_core, 0, sizeof with_core);
  } else if (!status) {
    hand_over(s, &e, &best, mesh);
    memset(&best, 0, sizeof best);
  }
  filling_free(context, &best);
  filled_mesh_free(context, &with_core.mesh);
  layered_core_free(context, &e.smallest);
  return status;
}
