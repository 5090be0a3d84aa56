/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "mesh_sheets.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "quality_bound.h"
#include "shape/improve.h"
#include "sheet_search.h"
#include "verify/scaled_jacobian.h"

/** In this order until a mesh is good: first what geometry says, then mostly the number of hexes,
 * then with luck, which helps out of dead ends. */
static const sheet_taste tastes[] = {{0.05, 0, 1}, {1, 0, 2}, {0.3, 0.5, 3},
                                     {0.1, 2, 4},  {1, 2, 5}, {1, 8, 6}};
enum { TASTES = sizeof tastes / sizeof *tastes };

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

/** What has been done, for the report. */
typedef struct effort {
  size_t taste_count, mesh_count, step_count;
  size_t core_quads, core_layers, core_hexes; /* of the smallest core */
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

/** Remember the smallest core, and list its quads that are the surface's. */
static void note_core(hexcon_context *context, const sheet_search *search, effort *e) {
  const sheet_front *front = &search->front;
  if (e->core_quads && front->alive_count >= e->core_quads)
    return;
  e->core_quads = front->alive_count;
  e->core_layers = front->layer_count;
  e->core_hexes = front->mesh.hex_count;
  context_clear(context);
  for (size_t q = 0; q < front->s.quad_count; q++) {
    bool given = front->alive[q];
    for (size_t corner = 0; corner < 4; corner++)
      given &= (size_t)front->s.quads[4 * q + corner] < front->s.point_count;
    if (given)
      context_add_element(context, (int32_t)q);
  }
}

static hexcon_status try_taste(hexcon_context *context, const surface *s, const sheet_taste *taste,
                               effort *e, filling *best) {
  sheet_search search;
  filling f = {0};
  hexcon_status status = sheet_search_run(context, s, taste, SEARCH_QUADS, &search);
  e->taste_count++;
  e->step_count += search.step_count;
  if (!status && !search.complete)
    note_core(context, &search, e);
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

static hexcon_status fail(hexcon_context *context, const surface *s, const effort *e) {
  return context_fail(
      context, HEXCON_NO_SHEETS,
      "no order of the dual loops that was tried leads to a cube: of %zu quads, %zu layers of "
      "%zu hexes took %zu away, and left a core of %zu (those of the surface "
      "listed), whose loops cross themselves or keep the surface from touching "
      "itself",
      s->quad_count, e->core_layers, e->core_hexes, s->quad_count - e->core_quads, e->core_quads);
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

hexcon_status mesh_sheets(hexcon_context *context, const surface *s, hexcon_mesh *mesh) {
  effort e = {0};
  filling best = {0};
  double start = mesh_clock();
  hexcon_status status = check_sphere(context, s);
  while (!status && !is_enough(&e, &best))
    status = try_taste(context, s, &tastes[e.taste_count], &e, &best);
  if (!status && !best.points)
    status = fail(context, s, &e);
  if (!status)
    hand_over(s, &e, &best, mesh);
  else
    filling_free(context, &best);
  mesh_note_seconds(mesh, "sheets", start);
  return status;
}
