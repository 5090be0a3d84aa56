/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "mesh_sheets.h"

#include <math.h>
#include <stdio.h>

#include "core_mesh.h"
#include "sheet_cores.h"
#include "solve/common/narrow_corners.h"
#include "solve/common/quality_bound.h"
#include "solve/cuts/mesh_cuts.h"
#include "solve/swept/mesh_swept.h"

/** In this order until a mesh is good: first what geometry says, then mostly the number of hexes,
 * then with luck, which helps out of dead ends. */
static const sheet_taste tastes[] = {{0.05, 0, 1, -1}, {1, 0, 2, -1}, {0.3, 0.5, 3, -1},
                                     {0.1, 2, 4, -1},  {1, 2, 5, -1}, {1, 8, 6, -1}};
enum { TASTES = sizeof tastes / sizeof *tastes };

/** Of tastes that lead to a mesh, so many are compared; more, if none is valid. */
enum { MESHES_COMPARED = 2, MESHES_MOST = 3 };

/** How much is done for a ball. */
typedef struct patience {
  size_t search_quads; /* visited beyond dead ends, for each taste */
  bool rough; /* layers only, not improved: others will do that, and may fill another ball */
} patience;

static const patience full_patience = {.search_quads = 400000};

/** For balls that cuts leave: for each of many, and for one of a few. */
static const patience little_patience = {.search_quads = 20000, .rough = true};
static const patience more_patience = {.search_quads = 400000, .rough = true};

/** Worst scaled Jacobian, as part of what the surface allows, with which no other way is tried. */
static const double good_part = 0.6;

/** ... and with which layers alone are good enough. */
static const double good_worst = 0.1;

/** Improvement stops at this part of the bound, and aims at this much where there is none. */
static const double near_the_bound = 0.95, least_target = 1e-3;

/** A mesh made by layers and what it is worth. */
typedef struct filling {
  filled_mesh mesh;
  size_t layer_count;
  double bound;
} filling;

static const mesh_taste preference = {.enough = 1, .clear_mean = INFINITY};

/** What has been done, for the report. */
typedef struct effort {
  size_t taste_count, mesh_count, step_count;
  layered_core smallest; /* core met on the way, for the words */
} effort;

/** True if no further taste is worth its while. */
static bool is_enough(const patience *p, const effort *e, const filling *best) {
  bool valid = best->mesh.points && best->mesh.inverted == 0;
  return e->taste_count == TASTES || (!p->rough && e->mesh_count >= MESHES_MOST) ||
         (valid && e->mesh_count >= MESHES_COMPARED) ||
         (valid && best->mesh.worst >= good_part * best->bound);
}

/** Improve what falls short of what the surface allows. */
static hexcon_status improve(hexcon_context *context, const surface *s, int threads, filling *f) {
  filled_mesh *m = &f->mesh;
  hexcon_status status = quality_bound(context, s, m->points, m->hexes, m->hex_count, &f->bound);
  hexcon_optimize_options options = {.threads = threads,
                                     .target = fmax(near_the_bound * f->bound, least_target)};
  if (status || m->worst >= options.target || f->bound <= 0)
    return status;
  return filled_mesh_improve(context, s->point_count, &options, m);
}

/** Take over what a search made. */
static hexcon_status take(hexcon_context *context, sheet_search *search, filling *f) {
  filled_mesh *m = &f->mesh;
  m->points = search->points;
  m->hexes = search->front.mesh.hexes;
  m->point_count = search->front.mesh.point_count;
  m->hex_count = search->front.mesh.hex_count;
  f->layer_count = search->front.layer_count;
  search->points = NULL;
  search->front.mesh.hexes = NULL;
  m->quality = context_allocate(context, m->hex_count, sizeof *m->quality);
  return m->quality ? filled_mesh_measure(context, m) : HEXCON_OUT_OF_MEMORY;
}

/** Remember the smallest core. */
static hexcon_status note_smallest(hexcon_context *context, sheet_search *search, effort *e) {
  if (e->smallest.points && search->front.alive_count >= e->smallest.s.quad_count)
    return HEXCON_OK;
  layered_core_free(context, &e->smallest);
  return layered_core_take(context, search, &e->smallest);
}

static hexcon_status try_taste(hexcon_context *context, const surface *s, const patience *p,
                               int threads, effort *e, filling *best) {
  sheet_search search;
  filling f = {0};
  hexcon_status status =
      sheet_search_run(context, s, &tastes[e->taste_count++], p->search_quads, &search);
  e->step_count += search.step_count;
  if (!status && !search.complete)
    status = note_smallest(context, &search, e);
  bool taken = false;
  if (!status && search.complete) {
    e->mesh_count++;
    status = take(context, &search, &f);
    taken = !status;
    if (taken && !p->rough)
      status = improve(context, s, threads, &f);
  }
  sheet_search_free(context, &search);
  if (taken && mesh_stop(context, status) &&
      filled_mesh_is_better(&f.mesh, &best->mesh, &preference)) {
    filling worse = *best;
    *best = f;
    f = worse;
  }
  filled_mesh_free(context, &f.mesh);
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

static void tell_layers(const surface *s, const effort *e, filling *f, hexcon_mesh *mesh) {
  char line[160];
  mesh_note(mesh, "sheets", (double)f->layer_count);
  mesh_note(mesh, "cuts", 0);
  mesh_note(mesh, "quads removed", (double)s->quad_count);
  mesh_note(mesh, "core quads", 0);
  mesh_note(mesh, "core hexes", 0);
  mesh_note(mesh, "orders tried", (double)e->taste_count);
  mesh_note(mesh, "search steps", (double)e->step_count);
  (void)snprintf(line, sizeof line,
                 "sheets: %zu layers and a last hex, %zu hexes; %zu of %zu orders tried lead to a "
                 "mesh",
                 f->layer_count, f->mesh.hex_count, e->mesh_count, e->taste_count);
  mesh_log(mesh, line);
}

/* ------------------------------------------------------------------------------------ the core */

static void tell_core(const surface *s, const core_mesh *m, hexcon_mesh *mesh) {
  mesh_note(mesh, "sheets", (double)m->layer_count);
  mesh_note(mesh, "cuts", 0);
  mesh_note(mesh, "quads removed", (double)(s->quad_count - m->core_quads));
  mesh_note(mesh, "core quads", (double)m->core_quads);
  mesh_note(mesh, "core hexes", (double)m->core_hexes);
  mesh_note_hexes(mesh, HEXES_OF_LAYERS, m->mesh.hex_count - m->core_hexes);
  mesh_note_hexes(mesh, HEXES_OF_CORE, m->core_hexes);
  mesh_note(mesh, "fillings tried", (double)m->attempt_count);
}

/** Whether a filled core, or layers under a cover, are better than what layers alone gave. */
static bool is_core_better(const core_mesh *m, const filled_mesh *best) {
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
  const bool whole_only = options->no_core || (best->mesh.points && best->mesh.inverted == 0);
  double start = mesh_clock();
  hexcon_status status = sheet_cores_find(context, s, whole_only, full_patience.search_quads, &all);
  mesh_note_seconds(mesh, "core search", start);
  start = mesh_clock();
  if (!status)
    status = core_mesh_make(context, s, options, all.cores, all.count, mesh, out);
  status = mesh_settle(context, status, out->mesh.points || best->mesh.points, mesh);
  mesh_note_seconds(mesh, "core filling", start);
  sheet_cores_free(context, &all);
  return status;
}

static bool is_good(const filling *best) {
  return best->mesh.points && best->mesh.inverted == 0 &&
         best->mesh.worst >= fmin(good_worst, near_the_bound * best->bound);
}

static hexcon_status fill_ball(hexcon_context *context, const surface *s, const patience *p,
                               const hexcon_mesh_options *options, hexcon_mesh *mesh) {
  effort e = {0};
  filling best = {0};
  core_mesh with_core = {0};
  double start = mesh_clock();
  hexcon_status status = HEXCON_OK;
  while (!status && !is_enough(p, &e, &best))
    status = try_taste(context, s, p, options->threads, &e, &best);
  mesh_note_seconds(mesh, "sheets", start);
  bool late = status == HEXCON_OUT_OF_TIME;
  status = mesh_settle(context, status, best.mesh.points != NULL, mesh);
  if (!status && best.mesh.points)
    status = narrow_corner_bound(context, best.mesh.points, best.mesh.hexes, best.mesh.hex_count,
                                 s->point_count, &best.bound);
  if (!status && !late && !p->rough && !is_good(&best))
    status = try_cores(context, s, options, &best, &with_core, mesh);
  if (!status && !best.mesh.points && !with_core.mesh.points)
    status = fail(context, s, &e.smallest, with_core.core_count > 0);
  if (!status && is_core_better(&with_core, &best.mesh)) {
    tell_core(s, &with_core, mesh);
    filled_mesh_hand_over(&with_core.mesh, with_core.bound, s->quad_count, mesh);
  } else if (!status) {
    tell_layers(s, &e, &best, mesh);
    filled_mesh_hand_over(&best.mesh, best.bound, s->quad_count, mesh);
  }
  filled_mesh_free(context, &best.mesh);
  filled_mesh_free(context, &with_core.mesh);
  layered_core_free(context, &e.smallest);
  return status;
}

/* ----------------------------------------------------------------------------------------- handles
 */

static hexcon_status fill_roughly(hexcon_context *context, const surface *s,
                                  const hexcon_mesh_options *options, hexcon_mesh *mesh) {
  return fill_ball(context, s, &little_patience, options, mesh);
}

static hexcon_status fill_roughly_with_patience(hexcon_context *context, const surface *s,
                                                const hexcon_mesh_options *options,
                                                hexcon_mesh *mesh) {
  return fill_ball(context, s, &more_patience, options, mesh);
}

/** Cut them; the ball that is left may be a sweep, which has its places at once. */
static hexcon_status fill_with_handles(hexcon_context *context, const surface *s,
                                       const hexcon_mesh_options *options, hexcon_mesh *mesh) {
  static const ball_method methods[] = {
      {mesh_swept, "is swept", BALL_ALWAYS},
      {fill_roughly, "is filled by sheets", BALL_ALWAYS},
      {fill_roughly_with_patience, "is filled by sheets", BALL_IF_NONE},
      {mesh_sheets, "is filled by sheets", BALL_IF_INVALID}};
  return mesh_cuts(context, s, options, methods, sizeof methods / sizeof *methods, mesh);
}

hexcon_status mesh_sheets(hexcon_context *context, const surface *s,
                          const hexcon_mesh_options *options, hexcon_mesh *mesh) {
  return surface_is_sphere(s) ? fill_ball(context, s, &full_patience, options, mesh)
                              : fill_with_handles(context, s, options, mesh);
}
