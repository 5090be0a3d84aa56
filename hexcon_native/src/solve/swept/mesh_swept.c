/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "mesh_swept.h"

#include <math.h>
#include <string.h>

#include "construct/sweep.h"
#include "shape/place/sweep_placement.h"
#include "solve/common/filled_mesh.h"
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
  filled_mesh mesh;
  size_t rings, cap_quad_count;
  double bound; /* of the worst scaled Jacobian, whatever the placement */
} filling;

static const mesh_taste preference = {.enough = 1, .clearly = 1e-9, .clear_mean = 1e-9};

/** Improve what falls short of what the surface allows; nothing at all in most sweeps. */
static hexcon_status improve_filling(hexcon_context *context, const surface *s, filling *f) {
  filled_mesh *m = &f->mesh;
  hexcon_status status = quality_bound(context, s, m->points, m->hexes, m->hex_count, &f->bound);
  hexcon_optimize_options options = {.target = fmax(near_the_bound * f->bound, least_target)};
  if (status || m->worst >= options.target || f->bound <= 0) /* below 0 no placement is valid */
    return status;
  return filled_mesh_improve(context, s->point_count, &options, m);
}

static hexcon_status place(hexcon_context *context, const surface *s, const sweep *w, filling *f) {
  f->rings = w->rings;
  f->cap_quad_count = w->cap_quad_count;
  const size_t hex_count = w->cap_quad_count * w->rings;
  hexcon_status status = filled_mesh_new(context, w->point_count, hex_count, &f->mesh);
  if (status)
    return status;
  memcpy(f->mesh.points, s->points, 3 * s->point_count * sizeof *f->mesh.points);
  context_reserve(context, hex_count, false);
  status = sweep_write_hexes(context, w, f->mesh.hexes);
  sweep_levels levels = {w->rings,     w->cap_quad_count, w->cap_point_count,
                         w->cap_quads, w->on_rim,         w->ids};
  context_tell_mesh(context, hex_count, 0, NAN);
  if (!status)
    status = sweep_place(context, &levels, f->mesh.points);
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
  if (!status && f->mesh.points)
    status = filled_mesh_measure(context, &f->mesh);
  return status;
}

static hexcon_status fill_best(hexcon_context *context, const surface *s, sweep_choice *choice,
                               filling *best, size_t *tried) {
  hexcon_status status = HEXCON_OK;
  for (*tried = 0; !status && *tried < choice->count; ++*tried) {
    if (best->mesh.points && best->mesh.inverted == 0 && best->mesh.worst >= as_good_as_any)
      break;
    filling f = {0};
    status = fill(context, s, choice, &choice->candidates[*tried], &f);
    if (!status && f.mesh.points && filled_mesh_is_better(&f.mesh, &best->mesh, &preference)) {
      filling worse = *best;
      *best = f;
      f = worse;
    }
    filled_mesh_free(context, &f.mesh);
  }
  if (!status && best->mesh.points)
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
  status = mesh_settle(context, status, best.mesh.points != NULL, mesh);
  if (!status && best.mesh.points) {
    mesh_note(mesh, "cap quads", (double)best.cap_quad_count);
    mesh_note(mesh, "rings", (double)best.rings);
    filled_mesh_hand_over(&best.mesh, best.bound, s->quad_count, mesh);
    mesh_note(mesh, "sweeps tried", (double)tried);
    mesh_note_seconds(mesh, "construction and placement", start);
  } else {
    filled_mesh_free(context, &best.mesh);
    status = status ? status : fail(context, s, &choice);
  }
  sweep_choice_free(context, &choice);
  return status;
}
