/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "mesh_swept.h"

#include <math.h>
#include <string.h>

#include "construct/sweep.h"
#include "hexmesh/scaled_jacobian.h"
#include "shape/improve/improve.h"
#include "shape/place/sweep_placement.h"
#include "solve/common/quality_bound.h"
#include "surface/numbering.h"
#include "sweep_choice.h"

/** A worst scaled Jacobian as high as this leaves nothing that another sweep could better. */
static const double as_good_as_any = 0.95;

/** Improvement stops at this part of what the surface's own angles allow. */
static const double near_the_bound = 0.95;

/** ... and aims at this much where they allow next to nothing. */
static const double least_target = 1e-3;

/** A filled sweep and what it is worth. */
typedef struct filling {
  double *points, *quality;
  int32_t *hexes;
  size_t point_count, hex_count, rings, cap_quad_count, rounds;
  size_t inverted;
  double worst, mean;
  double bound; /* of the worst scaled Jacobian, whatever the placement */
} filling;

static void filling_free(hexcon_context *context, filling *f) {
  context_free(context, f->points);
  context_free(context, f->quality);
  context_free(context, f->hexes);
  memset(f, 0, sizeof *f);
}

static bool is_better(const filling *a, const filling *b) {
  if (!b->points)
    return true;
  if (a->inverted != b->inverted)
    return a->inverted < b->inverted;
  if (fabs(a->worst - b->worst) > 1e-9)
    return a->worst > b->worst;
  return a->mean > b->mean + 1e-9;
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

/** Improve what falls short of what the surface allows; nothing at all in most sweeps. */
static hexcon_status improve_filling(hexcon_context *context, const surface *s, filling *f) {
  hexcon_status status = quality_bound(context, s, f->points, f->hexes, f->hex_count, &f->bound);
  hexcon_optimize_options options = {.target = fmax(near_the_bound * f->bound, least_target)};
  if (status || f->worst >= options.target || f->bound <= 0) /* below 0 no placement is valid */
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

static hexcon_status place(hexcon_context *context, const surface *s, const sweep *w, filling *f) {
  f->point_count = w->point_count;
  f->rings = w->rings;
  f->cap_quad_count = w->cap_quad_count;
  f->hex_count = w->cap_quad_count * w->rings;
  f->points = context_allocate(context, 3 * f->point_count, sizeof *f->points);
  f->hexes = context_allocate(context, 8 * f->hex_count, sizeof *f->hexes);
  f->quality = context_allocate(context, f->hex_count, sizeof *f->quality);
  if (!f->points || !f->hexes || !f->quality)
    return HEXCON_OUT_OF_MEMORY;
  memcpy(f->points, s->points, 3 * s->point_count * sizeof *f->points);
  context_reserve(context, f->hex_count);
  hexcon_status status = sweep_write_hexes(context, w, f->hexes);
  sweep_levels levels = {w->rings,     w->cap_quad_count, w->cap_point_count,
                         w->cap_quads, w->on_rim,         w->ids};
  context_tell_mesh(context, f->hex_count, 0, NAN);
  if (!status)
    status = sweep_place(context, &levels, f->points);
  context_tell_mesh(context, 0, 0, NAN);
  return status;
}

/** Build and place one candidate; f stays empty where the sweep does not exist. */
static hexcon_status fill(hexcon_context *context, const surface *s, sweep_choice *choice,
                          const sweep_candidate *candidate, filling *f) {
  sweep w = {0};
  hexcon_status status = reflection_try(context, s, &choice->loops, &choice->strips,
                                        candidate->seed, &choice->reflected);
  if (!status)
    status = sweep_build(context, s, &choice->loops, &choice->strips, &choice->reflected,
                         candidate->rings, &w);
  if (!status && w.failure && !choice->failure)
    choice->failure = w.failure;
  if (!status && !w.failure)
    status = place(context, s, &w, f);
  sweep_free(context, &w);
  if (!status && f->points)
    status = measure(context, f);
  return status;
}

static hexcon_status fill_best(hexcon_context *context, const surface *s, sweep_choice *choice,
                               filling *best, size_t *tried) {
  hexcon_status status = HEXCON_OK;
  for (*tried = 0; !status && *tried < choice->count; ++*tried) {
    if (best->points && best->inverted == 0 && best->worst >= as_good_as_any)
      break;
    filling f = {0};
    status = fill(context, s, choice, &choice->candidates[*tried], &f);
    if (!status && f.points && is_better(&f, best)) {
      filling worse = *best;
      *best = f;
      f = worse;
    }
    filling_free(context, &f);
  }
  if (!status && best->points)
    status = improve_filling(context, s, best);
  return status;
}

static hexcon_status fail(hexcon_context *context, const surface *s, const sweep_choice *choice) {
  for (int i = 0; i < 2; i++)
    if (choice->clash[i] >= 0)
      context_add_element(context, choice->clash[i]);
  const char *why = choice->failure ? choice->failure : "no dual loop can be a ring of sides";
  if (choice->clash[1] >= 0)
    return context_fail(context, HEXCON_NOT_SWEPT,
                        "not swept: of %zu dual loops %zu do not cross themselves, and none of "
                        "%zu ways to sweep fits; in the most promising one %s (quad %d against "
                        "quad %d)",
                        choice->loops.count, choice->simple_loop_count, choice->strip_tried_count,
                        why, numbering_quad_name(s, choice->clash[0]),
                        numbering_quad_name(s, choice->clash[1]));
  return context_fail(context, HEXCON_NOT_SWEPT,
                      "not swept: of %zu dual loops %zu do not cross themselves, and none of %zu "
                      "ways to sweep fits: %s",
                      choice->loops.count, choice->simple_loop_count, choice->strip_tried_count,
                      why);
}

static void hand_over(const filling *f, hexcon_mesh *mesh) {
  mesh->points = f->points;
  mesh->hexes = f->hexes;
  mesh->quality = f->quality;
  mesh->point_count = f->point_count;
  mesh->hex_count = f->hex_count;
  mesh->order = 1;
  mesh_note(mesh, "cap quads", (double)f->cap_quad_count);
  mesh_note(mesh, "rings", (double)f->rings);
  mesh_note(mesh, "optimisation rounds", (double)f->rounds);
  mesh_note(mesh, "surface bound", f->bound);
  mesh->bound = f->bound;
}

hexcon_status mesh_swept(hexcon_context *context, const surface *s,
                         const hexcon_mesh_options *options, hexcon_mesh *mesh) {
  (void)options;
  sweep_choice choice;
  filling best = {0};
  size_t tried = 0;
  double start = mesh_clock();
  hexcon_status status = sweep_choose(context, s, &choice);
  mesh_note_seconds(mesh, "recognition", start);
  start = mesh_clock();
  if (!status)
    status = fill_best(context, s, &choice, &best, &tried);
  status = mesh_settle(context, status, best.points != NULL, mesh);
  if (!status && best.points) {
    hand_over(&best, mesh);
    mesh_note(mesh, "sweeps tried", (double)tried);
    mesh_note_seconds(mesh, "construction and placement", start);
  } else {
    filling_free(context, &best);
    status = status ? status : fail(context, s, &choice);
  }
  sweep_choice_free(context, &choice);
  return status;
}
