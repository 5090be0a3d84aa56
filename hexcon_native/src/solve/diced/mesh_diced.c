/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "mesh_diced.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "construct/coarse_ways.h"
#include "diced_filling.h"
#include "solve/common/narrow_corners.h"
#include "surface/build.h"
#include "surface/corner_angles.h"
#include "surface/star_center.h"

/** What stands on coarse quads and how high, in this order, until tetrahedra fit between and hexes
 * are good; the last ones only while some are not even positive. Geodes take fewer hexes than
 * pyramids, and better ones, but need coarse quads everywhere. */
static const struct {
  double scale; /* Geodes: mean lengths of the edges there */
  diced_block block;
  bool for_quality;
} blocks[] = {{0.5, DICED_GEODES, true},   {0.35, DICED_GEODES, true},   {1, DICED_PYRAMIDS, true},
              {0.7, DICED_PYRAMIDS, true}, {0.5, DICED_PYRAMIDS, false}, {0.5, DICED_GEODES, false},
              {0.2, DICED_GEODES, false},  {0.3, DICED_PYRAMIDS, false}};
enum { BLOCKS = sizeof blocks / sizeof *blocks };

/** More than this part of the hexes inverted at the start take long to untangle, .. */
static const double strained_part = 0.02;
/** .. minutes where there are more hexes than this. */
enum { STRAINED_HEXES = 6000 };

/** A star's middle is crowded with more triangles than this: it is tried last. */
enum { STAR_TRIANGLES = 64 };

/** Nothing else is tried once the worst scaled Jacobian is this, or near what the surface allows.
 */
static const double good_worst = 0.2, near_the_bound = 0.7;
/** .. on coarse quads: blocks are worse by themselves; .. */
static const double good_worst_block = 0.08;
/** .. up to here their hexes are raised. */
static const double wanted_worst_block = 0.15;

static const mesh_taste preference = {
    .enough = 0.2 /* good_worst */, .clearly = 1e-3, .clear_mean = INFINITY, .fewer = true};

static double good_enough(const diced_problem *p, const diced_filling *f) {
  double good = p->coarse.quad_count > 0 ? good_worst_block : good_worst;
  return fmin(good, near_the_bound * fmin(p->bound, f->bound));
}

static bool is_good(const diced_problem *p, const diced_filling *f) {
  return f->mesh.points && f->mesh.inverted == 0 && f->mesh.worst >= good_enough(p, f);
}

/* ------------------------------------------------------------------------------------- problem */

static void find_bound(diced_problem *p) {
  p->bound = 1;
  for (int32_t h = 0; h < (int32_t)(4 * p->s->quad_count); h++)
    p->bound = fmin(p->bound, fabs(sin(surface_corner_angle(p->s, h))));
}

/** A surface of a higher genus has no centre: its Euler characteristic tells at once. */
static hexcon_status find_center(hexcon_context *context, diced_problem *p) {
  double margin = -1;
  hexcon_status status = HEXCON_OK;
  if (surface_is_sphere(p->s))
    status = surface_star_center(context, p->s, p->center, &margin);
  p->star_shaped = margin > 0;
  return status;
}

static void forget_reading(hexcon_context *context, diced_problem *p) {
  for (size_t k = 0; k < DICED_BLOCKS; k++)
    coarse_front_free(context, &p->fronts[k]);
  coarse_surface_free(context, &p->coarse);
  surface_free(context, &p->quads);
  context_free(context, p->corners);
  p->corners = NULL;
}

/** The coarse surface, and Geodes on it, if it has no triangles. */
static hexcon_status prepare_geodes(hexcon_context *context, diced_problem *p) {
  const coarse_surface *c = &p->coarse;
  if (c->triangle_count > 0)
    return HEXCON_OK;
  p->corners = context_allocate(context, c->point_count, 3 * sizeof *p->corners);
  if (!p->corners)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t i = 0; i < c->point_count; i++)
    memcpy(p->corners + 3 * i, p->s->points + 3 * (size_t)c->points[i], 3 * sizeof *p->corners);
  hexcon_status status =
      surface_build(context, p->corners, c->point_count, c->faces, c->quad_count, &p->quads);
  return status ? status
                : coarse_front_of_geodes(context, c, &p->quads, p->s->point_count,
                                         &p->fronts[DICED_GEODES]);
}

static hexcon_status read_way(hexcon_context *context, const uint8_t *ways, diced_problem *p) {
  forget_reading(context, p);
  hexcon_status status = coarse_surface_read(context, p->s, ways, &p->coarse, NULL);
  if (!status)
    status = coarse_front_of_pyramids(context, &p->coarse, p->s->point_count,
                                      &p->fronts[DICED_PYRAMIDS]);
  return status ? status : prepare_geodes(context, p);
}

/* ------------------------------------------------------------------------------------ improving */

/** Raise the worst hexes to where this surface's are worth no more time. */
static double wanted_worst(const diced_problem *p) {
  return p->coarse.quad_count > 0 ? wanted_worst_block : 1.5 * good_worst;
}

/** Untangle and raise the mean, then the worst hexes: enough to see what a filling is worth. */
static hexcon_status improve(hexcon_context *context, const diced_problem *p, filled_mesh *f) {
  hexcon_optimize_options untangling = {
      .threads = p->options->threads, .target = 1e-6, .mean_passes = 1};
  hexcon_optimize_options raising = {
      .threads = p->options->threads, .target = wanted_worst(p), .max_rounds = 3};
  hexcon_status status = filled_mesh_improve(context, p->s->point_count, &untangling, f);
  if (!status && f->inverted == 0)
    status = filled_mesh_improve(context, p->s->point_count, &raising, f);
  return status;
}

static hexcon_status polish(hexcon_context *context, const diced_problem *p, filled_mesh *f) {
  hexcon_optimize_options options = {
      .threads = p->options->threads, .target = wanted_worst(p), .max_rounds = 4, .mean_passes = 2};
  return f->inverted == 0 ? filled_mesh_improve(context, p->s->point_count, &options, f)
                          : HEXCON_OK;
}

/* ------------------------------------------------------------------------------------- attempts */

static const char *const block_names[] = {"pyramids", "Geodes"};
static const char *const closure_names[] = {"one tetrahedron", "star", "tetrahedra"};

static void log_attempt(hexcon_mesh *mesh, const diced_filling *f) {
  char line[256], found[128] = "no tetrahedra found", heights[48] = "";
  if (f->mesh.points)
    (void)snprintf(found, sizeof found,
                   "%zu hexes, %zu not positive, scaled Jacobian min %.4f, mean %.4f",
                   f->mesh.hex_count, f->mesh.inverted, f->mesh.worst, f->mesh.mean);
  if (f->quad_count > 0)
    (void)snprintf(heights, sizeof heights, ", %s, height %.2f", block_names[f->block], f->scale);
  (void)snprintf(line, sizeof line, "%zu coarse triangles and %zu quads, %s%s: %s",
                 f->triangle_count, f->quad_count, closure_names[f->closure], heights, found);
  mesh_log(mesh, line);
}

static bool is_strained(const filled_mesh *f) {
  return f->hex_count > STRAINED_HEXES &&
         (double)f->inverted > strained_part * (double)f->hex_count;
}

/** Improve, but leave strained Geodes as they are while pyramids are left to try. */
static hexcon_status improve_or_put_off(hexcon_context *context, const diced_problem *p, size_t way,
                                        filled_mesh *f) {
  hexcon_status status = filled_mesh_measure(context, f);
  bool waits = blocks[way].block == DICED_GEODES && blocks[way].for_quality && is_strained(f);
  return status || waits ? status : improve(context, p, f);
}

/** Fill so, if that is possible; keep the better of that and `best`. */
static hexcon_status try_closure(hexcon_context *context, const diced_problem *p, size_t way,
                                 diced_closure closure, hexcon_mesh *mesh, diced_filling *best) {
  if (is_good(p, best) || !diced_filling_is_possible(p, blocks[way].block, closure))
    return HEXCON_OK;
  diced_filling f;
  hexcon_status status =
      diced_filling_build(context, p, blocks[way].block, closure, blocks[way].scale, &f);
  bool built = !status && f.mesh.points;
  f.bound = 1;
  if (built)
    status = improve_or_put_off(context, p, way, &f.mesh);
  if (built && !status)
    status = narrow_corner_bound(context, f.mesh.points, f.mesh.hexes, f.mesh.hex_count,
                                 p->s->point_count, &f.bound);
  if (!status)
    log_attempt(mesh, &f);
  if (built && mesh_stop(context, status) &&
      filled_mesh_is_better(&f.mesh, &best->mesh, &preference)) {
    diced_filling worse = *best;
    *best = f;
    f = worse;
  }
  filled_mesh_free(context, &f.mesh);
  return status;
}

/** All closures, with one kind of blocks, that are worth a try. */
static hexcon_status try_blocks(hexcon_context *context, const diced_problem *p, size_t way,
                                hexcon_mesh *mesh, diced_filling *best) {
  bool small = p->fronts[blocks[way].block].triangle_count <= STAR_TRIANGLES;
  hexcon_status status = try_closure(context, p, way, DICED_ONE, mesh, best);
  if (!status && small)
    status = try_closure(context, p, way, DICED_STAR, mesh, best);
  if (!status)
    status = try_closure(context, p, way, DICED_TETRAHEDRA, mesh, best);
  bool wanting = !best->mesh.points || best->mesh.inverted > 0;
  if (!status && !small && wanting)
    status = try_closure(context, p, way, DICED_STAR, mesh, best);
  return status;
}

static bool is_worth_a_try(const diced_problem *p, size_t way, const diced_filling *best) {
  if (p->coarse.quad_count == 0) /* no block makes a difference */
    return blocks[way].block == DICED_PYRAMIDS && blocks[way].scale >= 1;
  return blocks[way].for_quality || !best->mesh.points || best->mesh.inverted > 0;
}

static hexcon_status try_reading(hexcon_context *context, const diced_problem *p, hexcon_mesh *mesh,
                                 diced_filling *best) {
  hexcon_status status = HEXCON_OK;
  for (size_t way = 0; !status && way < BLOCKS; way++)
    if (is_worth_a_try(p, way, best))
      status = try_blocks(context, p, way, mesh, best);
  return status;
}

static void tell(const diced_filling *f, hexcon_mesh *mesh) {
  mesh_note(mesh, "coarse triangles", (double)f->triangle_count);
  mesh_note(mesh, "coarse quads", (double)f->quad_count);
  mesh_note(mesh, "tetrahedra", (double)f->tetrahedron_count);
  mesh_note(mesh, "pyramids", f->block == DICED_PYRAMIDS ? (double)f->quad_count : 0);
  mesh_note(mesh, "geodes", f->block == DICED_GEODES ? (double)f->quad_count : 0);
  size_t inside = 4 * f->tetrahedron_count;
  mesh_note_hexes(mesh, f->block == DICED_GEODES ? HEXES_OF_GEODES : HEXES_OF_PYRAMIDS,
                  f->mesh.hex_count - inside);
  mesh_note_hexes(mesh, HEXES_OF_TETRAHEDRA, inside);
}

static hexcon_status check_found(hexcon_context *context, const diced_problem *p,
                                 const diced_filling *best) {
  if (best->mesh.points)
    return HEXCON_OK;
  return context_fail(context, HEXCON_NOT_STAR_SHAPED,
                      "the surface is a subdivision, but its inside could not be closed: %s, and "
                      "no point inside sees the whole surface; %s",
                      p->options->tetrahedralise ? "no tetrahedra were found for it"
                                                 : "no mesher of tetrahedra was given",
                      p->options->tetrahedralise ? "a finer surface may help" : "give one");
}

/** The best of all readings. */
static hexcon_status fill(hexcon_context *context, diced_problem *p, const coarse_ways *ways,
                          hexcon_mesh *mesh, diced_filling *best) {
  hexcon_status status = HEXCON_OK;
  for (size_t w = 0; !status && w < ways->count && (w == 0 || !is_good(p, best)); w++) {
    status = read_way(context, ways->of_shells + w * p->s->component_count, p);
    if (!status)
      status = try_reading(context, p, mesh, best);
  }
  if (!status)
    status = check_found(context, p, best);
  return status ? status : polish(context, p, &best->mesh);
}

hexcon_status mesh_diced(hexcon_context *context, const surface *s,
                         const hexcon_mesh_options *options, hexcon_mesh *mesh) {
  diced_problem p = {.s = s, .options = options};
  diced_filling best = {.closure = DICED_ONE};
  coarse_ways ways;
  double start = mesh_clock();
  hexcon_status status = coarse_ways_find(context, s, &ways);
  if (!status)
    status = surface_check_fillable(context, s, false);
  if (!status)
    status = find_center(context, &p);
  find_bound(&p);
  if (!status)
    status = fill(context, &p, &ways, mesh, &best);
  status = mesh_settle(context, status, best.mesh.points && best.mesh.inverted == 0, mesh);
  mesh_note_seconds(mesh, "diced", start);
  if (!status) {
    tell(&best, mesh);
    filled_mesh_hand_over(&best.mesh, fmin(p.bound, best.bound), s->quad_count, mesh);
  }
  filled_mesh_free(context, &best.mesh);
  forget_reading(context, &p);
  coarse_ways_free(context, &ways);
  return status;
}
