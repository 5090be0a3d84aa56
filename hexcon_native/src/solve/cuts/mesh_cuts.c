/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "mesh_cuts.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cut_choice.h"
#include "solve/common/filled_mesh.h"
#include "solve/common/quality_bound.h"

/** So many ways to cut are tried at most, and so many meshes compared; fewer, where one of those is
 * valid. */
enum { WAYS_MOST = 12, MESHES_MOST = 6, VALID_MOST = 2 };

/** Later turns take so many ways, and what takes long balls of so many quads at most. */
enum { FEW_WAYS = 2, SMALL_BALL = 1000 };

/** Worst scaled Jacobian, as part of what the surface allows, with which no other way is tried. */
static const double good_part = 0.6;

/** Improvement stops at this part of the bound, and aims at this much where there is none. */
static const double near_the_bound = 0.95, least_target = 1e-3;

/** Rounds of improvement where no mesh can be valid. */
enum { HOPELESS_ROUNDS = 2 };

static const mesh_taste preference = {
    .enough = 1, .clearly = 0.01, .clear_mean = 0.01, .fewer = true};

/** A mesh and how it was made. */
typedef struct cut_filling {
  filled_mesh mesh;
  size_t cut_count, layer_count, core_quads, core_hexes;
  const char *done; /* with the ball */
  double bound;
} cut_filling;

typedef struct cut_search {
  const surface *s;
  const hexcon_mesh_options *options;
  const ball_method *methods;
  size_t method_count;
  cut_body whole; /* nothing is cut */
  size_t way_count, ball_count, mesh_count, valid_count;
  size_t simple_count, cutting_count; /* loops of the surface */
  size_t stuck;                       /* most handles cut where there was no way on */
  cut_filling best;
} cut_search;

/** Where a way leaves the one of the best cuts: the handle, and which candidate it takes there. */
typedef struct cut_way {
  size_t handle, rank;
} cut_way;

/* ----------------------------------------------------------------------------------------- cutting
 */

static hexcon_status cut_by(hexcon_context *context, const cut_body *body, const cut_choice *choice,
                            const cut_candidate *candidate, cut_body *out) {
  placed_cut cut;
  const int32_t *ring = cut_choice_ring(choice, candidate);
  hexcon_status status = placed_cut_new(context, &body->s, ring, &candidate->shape, &cut);
  if (!status)
    status = cut_body_cut(context, body, ring, &cut, out);
  placed_cut_free(context, &cut);
  return status;
}

/** Cut one handle by the candidate of that rank, or the next one that goes; `out` stays without
 * points where there is none. */
static hexcon_status cut_one(hexcon_context *context, cut_search *w, const cut_body *body,
                             size_t rank, cut_body *out) {
  cut_choice choice;
  *out = (cut_body){0};
  hexcon_status status = cut_choice_find(context, body, &choice);
  if (!status && body->cut_count == 0) {
    w->simple_count = choice.simple_count;
    w->cutting_count = choice.cutting_count;
  }
  for (size_t i = rank; !status && !out->points && i < choice.count; i++)
    status = cut_by(context, body, &choice, &choice.candidates[i], out);
  cut_choice_free(context, &choice);
  return status;
}

/** Cut all handles; `ball` stays without points where there is no such way. */
static hexcon_status cut_all(hexcon_context *context, cut_search *w, const cut_way *way,
                             cut_body *ball) {
  const size_t handles = body_handle_count(w->s);
  cut_body body = {0};
  hexcon_status status = HEXCON_OK;
  *ball = (cut_body){0};
  for (size_t i = 0; !status && i < handles; i++) {
    const cut_body *from = i == 0 ? &w->whole : &body;
    cut_body next = {0};
    status = context_progress(context, STAGE_CUTS, (double)i / (double)handles);
    if (!status)
      status = cut_one(context, w, from, i == way->handle ? way->rank : 0, &next);
    cut_body_free(context, &body);
    body = next;
    if (status || !body.points)
      break;
    w->stuck = body.cut_count > w->stuck ? body.cut_count : w->stuck;
  }
  if (!status)
    *ball = body;
  else
    cut_body_free(context, &body);
  return status;
}

/* ----------------------------------------------------------------------------------------- filling
 */

/** The layers and the ball's hexes: the ball has all points of the surface and of the layers. */
static hexcon_status join(hexcon_context *context, const cut_body *ball, const hexcon_mesh *inside,
                          filled_mesh *out) {
  hexcon_status status =
      filled_mesh_new(context, inside->point_count, ball->hex_count + inside->hex_count, out);
  if (status)
    return status;
  out->outer_hexes = ball->hex_count;
  memcpy(out->points, inside->points, 3 * inside->point_count * sizeof *out->points);
  memcpy(out->hexes, ball->hexes, 8 * ball->hex_count * sizeof *out->hexes);
  memcpy(out->hexes + 8 * ball->hex_count, inside->hexes,
         8 * inside->hex_count * sizeof *out->hexes);
  return HEXCON_OK;
}

/** Improve what falls short of what the surface allows; also where it allows no valid mesh, as a
 * pillow may help then, which begins with these places. */
static hexcon_status improve(hexcon_context *context, const cut_search *w, cut_filling *f) {
  filled_mesh *m = &f->mesh;
  hexcon_status status = filled_mesh_measure(context, m);
  if (!status)
    status = quality_bound(context, w->s, m->points, m->hexes, m->hex_count, &f->bound);
  const hexcon_optimize_options options = {.threads = w->options->threads,
                                           .target = fmax(near_the_bound * f->bound, least_target),
                                           .max_rounds = f->bound > 0 ? 0 : HOPELESS_ROUNDS,
                                           .mean_passes = f->bound > 0 ? 2 : 0};
  if (status || m->worst >= options.target)
    return status;
  return filled_mesh_improve(context, w->s->point_count, &options, m);
}

static bool is_good(const cut_filling *f) {
  return f->mesh.points && f->mesh.inverted == 0 && f->mesh.worst >= good_part * f->bound;
}

/** Glue, improve, and keep the mesh if it is the best. */
static hexcon_status judge(hexcon_context *context, cut_search *w, const cut_body *ball,
                           const hexcon_mesh *inside, const char *done) {
  cut_filling f = {.cut_count = ball->cut_count,
                   .done = done,
                   .layer_count = (size_t)mesh_figure(inside, "sheets") +
                                  (size_t)mesh_figure(inside, "rings") + ball->cut_count,
                   .core_quads = (size_t)mesh_figure(inside, "core quads"),
                   .core_hexes = (size_t)mesh_figure(inside, "core hexes")};
  hexcon_status status = join(context, ball, inside, &f.mesh);
  bool joined = !status;
  if (joined)
    status = improve(context, w, &f);
  if (joined && mesh_stop(context, status)) {
    w->mesh_count++;
    w->valid_count += f.mesh.inverted == 0;
    if (filled_mesh_is_better(&f.mesh, &w->best.mesh, &preference)) {
      cut_filling worse = w->best;
      w->best = f;
      f = worse;
    }
  }
  filled_mesh_free(context, &f.mesh);
  return status;
}

/** Fill what is left by one method; its mesh need not be valid, as its boundary will move. */
static hexcon_status fill_ball(hexcon_context *context, cut_search *w, const cut_body *ball,
                               const ball_method *method) {
  hexcon_mesh *inside = context_allocate_zeroed(context, 1, sizeof *inside);
  if (!inside)
    return HEXCON_OUT_OF_MEMORY;
  hexcon_status status = method->fill(context, &ball->s, w->options, inside);
  if (!status) {
    status = judge(context, w, ball, inside, method->done);
  } else if (fault_is_about_method(status)) {
    context_clear(context);
    status = HEXCON_OK;
  }
  hexcon_mesh_free(context, inside);
  return status;
}

/** Way 0 takes the best candidate at every handle, the others the next best one at one handle. */
static cut_way way_of(size_t number, size_t handles) {
  if (number == 0)
    return (cut_way){0, 0};
  return (cut_way){(number - 1) % handles, 1 + (number - 1) / handles};
}

static hexcon_status try_way(hexcon_context *context, cut_search *w, size_t number,
                             ball_turn turn) {
  const cut_way way = way_of(number, body_handle_count(w->s));
  cut_body ball;
  hexcon_status status = cut_all(context, w, &way, &ball);
  bool suits =
      !status && ball.points && (turn != BALL_IF_INVALID || ball.s.quad_count <= SMALL_BALL);
  w->ball_count += suits;
  for (size_t i = 0; suits && !status && i < w->method_count && !is_good(&w->best); i++)
    if (w->methods[i].turn == turn)
      status = fill_ball(context, w, &ball, &w->methods[i]);
  cut_body_free(context, &ball);
  return status;
}

static bool is_over(const cut_search *w) {
  return is_good(&w->best) || w->way_count >= WAYS_MOST || w->mesh_count >= MESHES_MOST ||
         w->valid_count >= VALID_MOST;
}

static bool is_wanted(const cut_search *w, ball_turn turn) {
  return turn == BALL_IF_NONE ? w->mesh_count == 0 : w->valid_count == 0;
}

static hexcon_status try_ways(hexcon_context *context, cut_search *w) {
  hexcon_status status = HEXCON_OK;
  while (!status && !is_over(w))
    status = try_way(context, w, w->way_count++, BALL_ALWAYS);
  for (ball_turn turn = BALL_IF_NONE; turn < BALL_TURNS; turn++)
    for (size_t i = 0; !status && i < FEW_WAYS && i < w->way_count && is_wanted(w, turn); i++)
      status = try_way(context, w, i, turn);
  return status;
}

/* ------------------------------------------------------------------------------------------ report
 */

static void tell(const cut_search *w, hexcon_mesh *mesh) {
  const cut_filling *f = &w->best;
  char line[240];
  mesh_note(mesh, "sheets", (double)f->layer_count);
  mesh_note(mesh, "cuts", (double)f->cut_count);
  mesh_note(mesh, "hexes in cuts", (double)f->mesh.outer_hexes);
  mesh_note(mesh, "core quads", (double)f->core_quads);
  mesh_note(mesh, "core hexes", (double)f->core_hexes);
  mesh_note(mesh, "ways to cut", (double)w->way_count);
  (void)snprintf(line, sizeof line,
                 "cuts: %zu handles cut by layers of %zu hexes, the ball that is left %s: %zu "
                 "hexes, %zu not positive, scaled Jacobian min %.4f, mean %.4f; the best of %zu "
                 "meshes",
                 f->cut_count, f->mesh.outer_hexes, f->done, f->mesh.hex_count, f->mesh.inverted,
                 f->mesh.worst, f->mesh.mean, w->mesh_count);
  mesh_log(mesh, line);
}

static hexcon_status fail(hexcon_context *context, const cut_search *w) {
  const size_t handles = body_handle_count(w->s);
  if (w->ball_count == 0)
    return context_fail(
        context, HEXCON_NO_SHEETS,
        "the body has %zu holes, and cuts take %zu of them away at most: of its dual loops %zu do "
        "not touch themselves, and %zu go round a handle so that a disc inside closes them; "
        "quads in rows round the handles would help",
        handles, w->stuck, w->simple_count, w->cutting_count);
  return context_fail(context, HEXCON_NO_SHEETS,
                      "the body's %zu holes were cut in %zu ways, but none of the balls that are "
                      "left is filled by sweeps or sheets",
                      handles, w->ball_count);
}

hexcon_status mesh_cuts(hexcon_context *context, const surface *s,
                        const hexcon_mesh_options *options, const ball_method *methods,
                        size_t method_count, hexcon_mesh *mesh) {
  cut_search w = {.s = s, .options = options, .methods = methods, .method_count = method_count};
  double start = mesh_clock();
  hexcon_status status = cut_body_begin(context, s, &w.whole);
  if (!status)
    status = try_ways(context, &w);
  mesh_note_seconds(mesh, "cuts", start);
  status = mesh_settle(context, status, w.best.mesh.points != NULL, mesh);
  if (!status && !w.best.mesh.points)
    status = fail(context, &w);
  if (!status) {
    tell(&w, mesh);
    filled_mesh_hand_over(&w.best.mesh, w.best.bound, s->quad_count, mesh);
  }
  filled_mesh_free(context, &w.best.mesh);
  cut_body_free(context, &w.whole);
  return status;
}
