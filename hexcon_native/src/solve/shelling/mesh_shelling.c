/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "mesh_shelling.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "rotation_search.h"
#include "shell_filling.h"
#include "solve/common/quality_bound.h"
#include "surface/corner_angles.h"
#include "surface/star_center.h"

/** So many meshes are made at most, so often loops may turn out not to go, and so many rotations
 * more than the first mesh took are worth a look. */
enum { MESHES_MOST = 4, FAILURES_MOST = 60, ROTATIONS_MORE = 4 };

/** Surfaces kept in the beam: so many at one size, fewer at larger ones. */
enum { WIDTH = 60, WIDE_QUADS = 200, MOST_WIDTH = 200, LEAST_WIDTH = 3 };

/** Of quads that are left when loops are taken away: in this order while no mesh is valid. */
static const double core_weights[] = {1, 0.3, 3};
enum { CORE_WEIGHTS = sizeof core_weights / sizeof *core_weights };

/** Larger surfaces take more rotations than a beam finds. */
enum { MOST_QUADS = 600 };

/** Quads looked at before the search is given up, counting each surface that was considered. */
static const double most_quads_seen = 3e8;

/** Worst scaled Jacobian, and part of what the surface allows, with which no other way is tried. */
static const double good_worst = 0.1, good_part = 0.6;

/** Of two valid meshes, the one whose worst is better by this; else the smaller. */
static const mesh_taste preference = {
    .enough = 1, .clearly = 0.03, .clear_mean = INFINITY, .fewer = true};

/** In mean edge lengths, in this order while hexes are inverted. */
static const double thicknesses[] = {0.8, 0.5};
enum { THICKNESSES = sizeof thicknesses / sizeof *thicknesses };

/** What is being done, for the report. */
typedef struct shelling {
  const surface *s;
  const hexcon_mesh_options *options;
  shell_space space;
  size_t mesh_count, failure_count;
  double quads_seen;
  filled_mesh best;
  double bound; /* of the best */
  size_t rotations, shells;
  size_t first_rotations; /* of a search's first mesh; SIZE_MAX: none yet */
} shelling;

static hexcon_status find_space(hexcon_context *context, shelling *w) {
  double margin;
  hexcon_status status = surface_star_center(context, w->s, w->space.center, &margin);
  if (!status)
    status = surface_check_fillable(context, w->s, margin > 0);
  if (!status && !(margin > 0))
    status = surface_mean_center(context, w->s, w->space.center, &margin);
  w->space.no_center = !(margin > 0);
  return status;
}

static bool is_good(const shelling *w) {
  return w->best.points && w->best.inverted == 0 &&
         w->best.worst >= fmin(good_worst, good_part * w->bound);
}

/** Improve a mesh and keep it if it is the best. */
static hexcon_status judge(hexcon_context *context, shelling *w, const rotation_plan *plan,
                           filled_mesh *made) {
  const hexcon_optimize_options options = {.threads = w->options->threads, .mean_passes = 2};
  hexcon_status status = filled_mesh_improve(context, w->s->point_count, &options, made);
  w->mesh_count++;
  if (!mesh_stop(context, status) || !filled_mesh_is_better(made, &w->best, &preference))
    return status;
  filled_mesh worse = w->best;
  w->best = *made;
  *made = worse;
  hexcon_status bounded =
      quality_bound(context, w->s, w->best.points, w->best.hexes, w->best.hex_count, &w->bound);
  w->rotations = plan->count;
  w->shells = plan->shell_count;
  return status ? status : bounded;
}

/** Fill after one set of rotations. */
static hexcon_status try_plan(hexcon_context *context, shelling *w, const rotation_plan *plan) {
  const size_t limit = 40 * w->s->quad_count;
  hexcon_status status = HEXCON_OK;
  bool filled = true, valid = false;
  for (size_t i = 0; !status && filled && !valid && i < THICKNESSES; i++) {
    filled_mesh made;
    w->space.thickness = thicknesses[i];
    status = shell_filling_build(context, w->s, plan, &w->space, limit, &made);
    filled = made.points != NULL;
    if (!status && filled) {
      status = judge(context, w, plan, &made);
      valid = w->best.inverted == 0;
    }
    filled_mesh_free(context, &made);
  }
  w->failure_count += !filled;
  if (filled && w->first_rotations == SIZE_MAX)
    w->first_rotations = plan->count;
  return status;
}

static bool is_promising(const rotated_surface *r) {
  return r->core == 0;
}

static bool is_over(const shelling *w) {
  return is_good(w) || w->mesh_count >= MESHES_MOST || w->failure_count >= FAILURES_MOST;
}

static hexcon_status try_promising(hexcon_context *context, shelling *w,
                                   const rotation_search *search) {
  hexcon_status status = HEXCON_OK;
  for (size_t i = 0; !status && i < search->count && !is_over(w); i++) {
    rotation_plan plan;
    if (!is_promising(&search->kept[i]))
      continue;
    status = rotation_search_plan(context, search, i, &plan);
    if (!status)
      status = try_plan(context, w, &plan);
    rotation_plan_free(context, &plan);
  }
  return status;
}

static size_t width_for(size_t quads) {
  double part = (double)WIDE_QUADS / (double)quads;
  return (size_t)fmin(MOST_WIDTH, fmax(LEAST_WIDTH, (double)WIDTH * part * sqrt(part)));
}

static bool is_tired(const hexcon_context *context, const shelling *w) {
  return w->quads_seen > context_patience(context) * most_quads_seen;
}

/** One beam, as its taste has it. */
static hexcon_status search_rotations(hexcon_context *context, shelling *w, double core_weight) {
  rotation_search search;
  size_t quads = w->s->quad_count, most = quads / 3 + 4;
  hexcon_status status = rotation_search_begin(context, w->s, width_for(quads), core_weight,
                                               w->options->threads, &search);
  w->first_rotations = SIZE_MAX;
  w->failure_count = 0;
  while (!status && search.count > 0) {
    status = context_progress(context, STAGE_ROTATIONS, (double)search.step / (double)most);
    if (!status)
      status = try_promising(context, w, &search);
    bool late =
        w->first_rotations != SIZE_MAX && search.step >= w->first_rotations + ROTATIONS_MORE;
    if (status || is_over(w) || late || search.step >= most || is_tired(context, w))
      break;
    status = rotation_search_advance(context, &search);
    w->quads_seen += (double)search.candidate_count * (double)quads;
  }
  rotation_search_free(context, &search);
  return status;
}

static void tell(const shelling *w, hexcon_mesh *mesh) {
  const filled_mesh *f = &w->best;
  char line[200];
  mesh_note(mesh, "rotations", (double)w->rotations);
  mesh_note(mesh, "shells", (double)w->shells);
  mesh_note_hexes(mesh, HEXES_OF_SHELLS, f->outer_hexes);
  mesh_note_hexes(mesh, HEXES_OF_SHEETS_INSIDE, f->hex_count - f->outer_hexes);
  (void)snprintf(line, sizeof line,
                 "shelling: %zu edges rotated in %zu shells, then sheets: %zu hexes, %zu not "
                 "positive, scaled Jacobian min %.4f, mean %.4f; the best of %zu meshes",
                 w->rotations, w->shells, f->hex_count, f->inverted, f->worst, f->mean,
                 w->mesh_count);
  mesh_log(mesh, line);
}

static hexcon_status check(hexcon_context *context, const surface *s) {
  if (s->quad_count > MOST_QUADS)
    return context_fail(context, HEXCON_NO_ROTATIONS,
                        "the surface has %zu quads: rotations are looked for up to %d",
                        s->quad_count, (int)MOST_QUADS);
  if (surface_is_sphere(s))
    return HEXCON_OK;
  return context_fail(context, HEXCON_NOT_A_BALL,
                      "the surface has holes through it: shelling fills balls only; cut it");
}

hexcon_status mesh_shelling(hexcon_context *context, const surface *s,
                            const hexcon_mesh_options *options, hexcon_mesh *mesh) {
  shelling w = {.s = s, .options = options};
  double start = mesh_clock();
  hexcon_status status = check(context, s);
  if (!status)
    status = find_space(context, &w);
  for (size_t i = 0; !status && i < CORE_WEIGHTS && w.best.inverted + !w.best.points > 0; i++)
    if (!is_tired(context, &w))
      status = search_rotations(context, &w, core_weights[i]);
  status = mesh_settle(context, status, w.best.points, mesh);
  if (!status && !w.best.points)
    status = context_fail(context, HEXCON_NO_ROTATIONS,
                          "no set of rotated edges was found after which the dual loops can be "
                          "taken away: %zu were tried",
                          w.failure_count);
  if (!status) {
    tell(&w, mesh);
    filled_mesh_hand_over(&w.best, w.bound, s->quad_count, mesh);
  }
  filled_mesh_free(context, &w.best);
  mesh_note_seconds(mesh, "shelling", start);
  return status;
}
