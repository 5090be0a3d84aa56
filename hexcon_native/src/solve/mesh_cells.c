/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "mesh_cells.h"

#include <math.h>
#include <string.h>

#include "closure.h"
#include "construct/cells.h"
#include "construct/dice.h"
#include "shape/cell_placement.h"
#include "shape/improve.h"
#include "shape/inner_surface.h"
#include "surface/colouring.h"
#include "surface/corner_angles.h"
#include "surface/pair_weights.h"
#include "surface/pairing.h"
#include "surface/star_center.h"
#include "verify/jacobian_sign.h"
#include "verify/scaled_jacobian.h"

/** One way to try. */
typedef struct attempt {
  double thickness;   /* of the cells, in lengths of the edges above */
  size_t more_layers; /* of plain hexes, than the caller wants */
  bool pair_anew;     /* keep pairs apart whose cells came out worst */
} attempt;

/** In this order, until all hexes are good; the last ones only while some are not even positive. A
 * layer of plain hexes over the cells costs a hex a quad and is worth it. */
static const attempt attempts[] = {{0.6, 1, false}, {0.45, 1, false}, {0.7, 0, false},
                                   {0.6, 1, true},  {0.45, 2, true},  {0.45, 0, true},
                                   {0.3, 3, true}};
enum { FOR_QUALITY = 4 };
enum { ATTEMPTS = sizeof attempts / sizeof *attempts };

/** A star's middle is crowded with more quads than this: it is not tried beside tetrahedra. */
enum { STAR_QUADS = 64 };

/** Nothing else is tried once the worst scaled Jacobian is this, or near what the surface allows.
 */
static const double good_worst = 0.1, near_the_bound = 0.8;

/** What all attempts share. */
typedef struct cell_problem {
  const surface *s;
  const hexcon_mesh_options *options;
  double center[3];
  double bound; /* of the worst scaled Jacobian, from the surface's own corners */
  uint8_t *colours;
  double *weights; /* [4 quad_count] of pairs */
  int32_t *partner;
  cell_complex cells;
  size_t pairing; /* how often the pairs' weights were changed */
} cell_problem;

typedef struct cell_filling {
  double *points, *quality;
  int32_t *hexes;
  size_t point_count, hex_count, tetrahedron_count, rounds, layers;
  size_t pairing; /* the problem's number of it */
  closure_kind closure;
  double thickness;
  size_t inverted; /* not proved positive */
  double worst, mean;
} cell_filling;

static void filling_free(hexcon_context *context, cell_filling *f) {
  context_free(context, f->points);
  context_free(context, f->quality);
  context_free(context, f->hexes);
  memset(f, 0, sizeof *f);
}

static void problem_free(hexcon_context *context, cell_problem *p) {
  context_free(context, p->colours);
  context_free(context, p->weights);
  context_free(context, p->partner);
  cells_free(context, &p->cells);
}

/** The centre: sees all corners, or, where some are folded, at least the quads they belong to. */
static hexcon_status find_center(hexcon_context *context, cell_problem *p) {
  double margin;
  hexcon_status status = surface_star_center(context, p->s, p->center, &margin);
  if (!status)
    status = surface_check_fillable(context, p->s, margin > 0);
  if (!status && !(margin > 0))
    status = surface_mean_center(context, p->s, p->center, &margin);
  if (!status && !(margin > 0))
    status = context_fail(context, HEXCON_NOT_STAR_SHAPED,
                          "no point inside sees the whole surface: cells need a convex or "
                          "star-shaped body; cut it into such parts");
  return status;
}

/** Pair the quads and build the cells over the pairs. */
static hexcon_status build_cells(hexcon_context *context, cell_problem *p, size_t layers) {
  cells_free(context, &p->cells);
  hexcon_status status = surface_pair(context, p->s, p->weights, p->partner);
  return status ? status : cells_build(context, p->s, p->colours, p->partner, layers, &p->cells);
}

static hexcon_status prepare(hexcon_context *context, const surface *s, cell_problem *p) {
  hexcon_status status = find_center(context, p);
  p->colours = context_allocate(context, s->point_count, sizeof *p->colours);
  p->weights = context_allocate(context, 4 * s->quad_count, sizeof *p->weights);
  p->partner = context_allocate(context, s->quad_count, sizeof *p->partner);
  if (!status && (!p->colours || !p->weights || !p->partner))
    status = HEXCON_OUT_OF_MEMORY;
  if (!status)
    status = surface_colour(context, s, p->colours);
  if (status)
    return status;
  surface_pair_weights(s, p->weights);
  p->bound = 1;
  for (int32_t h = 0; h < (int32_t)(4 * s->quad_count); h++)
    p->bound = fmin(p->bound, fabs(sin(surface_corner_angle(s, h))));
  return HEXCON_OK;
}

/* ---------------------------------------------------------------------------------- placement */

/** Levels of layers lie evenly between the surface and its inner copy; a cell is deeper. */
static const double cell_to_layer = 1.5;

static void place_layers(const cell_problem *p, double *points) {
  const cell_complex *cells = &p->cells;
  size_t width = 3 * p->s->point_count;
  const double *inner = points + 3 * cells->first_inner;
  for (size_t level = 1; level <= cells->layers; level++) {
    double part = (double)level / ((double)cells->layers + cell_to_layer);
    for (size_t i = 0; i < width; i++)
      points[level * width + i] = (1 - part) * points[i] + part * inner[i];
  }
}

static void place_dominoes(const cell_problem *p, double (*local)[3], double *points) {
  static const char *const labels[2][8] = {{"O0", "O1", "O2", "O3", "I0", "I1", "I2", "I3"},
                                           {"O0", "O1", "bO2", "bO3", "I0", "I1", "bI2", "bI3"}};
  const hex_template *t = p->cells.domino;
  double_box box = {.point_count = t->point_count, .local = (const double(*)[3])local};
  for (size_t half = 0; half < 2; half++)
    for (size_t i = 0; i < 8; i++)
      box.rows[half][i] = template_row(t, labels[half][i]);
  for (size_t i = 0; i < t->point_count; i++)
    memcpy(local[i], t->points[i].place, sizeof *local);
  place_cells(&box, p->cells.cell_points, p->cells.cell_count, points);
}

/** All points of layers and cells. */
static hexcon_status place(hexcon_context *context, const cell_problem *p, double thickness,
                           double *points) {
  inner_surface_options options = {.thickness = thickness, .depth = 0.45};
  memcpy(options.center, p->center, sizeof options.center);
  memcpy(points, p->s->points, 3 * p->s->point_count * sizeof *points);
  double layers = (double)p->cells.layers;
  options.thickness *= (layers + cell_to_layer) / cell_to_layer;
  options.depth += (1 - options.depth) * layers / (layers + 4);
  hexcon_status status =
      inner_surface_place(context, p->s, &options, points + 3 * p->cells.first_inner);
  double(*local)[3] = context_allocate(context, p->cells.domino->point_count, sizeof *local);
  if (!local)
    return HEXCON_OUT_OF_MEMORY;
  if (!status) {
    place_layers(p, points);
    place_dominoes(p, local, points);
  }
  context_free(context, local);
  return status;
}

/* ------------------------------------------------------------------------------------- filling */

static int32_t cell_id(const cell_problem *p, int32_t corner) {
  size_t row = (size_t)corner, inner = p->s->point_count;
  return (int32_t)(row < inner ? p->cells.first_inner + row : p->cells.point_count + row - inner);
}

/** Dice the closure, in the mesh's numbering. */
static hexcon_status dice_closure(hexcon_context *context, const cell_problem *p, closure *c,
                                  diced_complex *diced) {
  const cell_complex *cells = &p->cells;
  size_t triangle_count = 2 * p->s->quad_count;
  for (size_t i = 0; i < 4 * c->tetrahedron_count; i++)
    c->tetrahedra[i] = cell_id(p, c->tetrahedra[i]);
  int32_t *corners = context_allocate(context, 3 * triangle_count, sizeof *corners);
  if (!corners)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t i = 0; i < 3 * triangle_count; i++)
    corners[i] = cell_id(p, cells->triangles[i]);
  diced_triangles known = {triangle_count, corners, cells->triangle_means, cells->side_middles};
  hexcon_status status = dice(context, c->tetrahedra, c->tetrahedron_count, &known,
                              cells->point_count + c->point_count, diced);
  context_free(context, corners);
  return status;
}

/** Points and hexes of cells and closure together. */
static hexcon_status assemble(hexcon_context *context, const cell_problem *p, const double *placed,
                              const closure *c, const diced_complex *diced, cell_filling *f) {
  const cell_complex *cells = &p->cells;
  size_t first_mean = cells->point_count + c->point_count;
  f->point_count = first_mean + diced->point_count;
  f->hex_count = cells->hex_count + diced->hex_count;
  f->points = context_allocate(context, f->point_count, 3 * sizeof *f->points);
  f->hexes = context_allocate(context, f->hex_count, 8 * sizeof *f->hexes);
  f->quality = context_allocate(context, f->hex_count, sizeof *f->quality);
  if (!f->points || !f->hexes || !f->quality)
    return HEXCON_OUT_OF_MEMORY;
  memcpy(f->points, placed, 3 * cells->point_count * sizeof *f->points);
  memcpy(f->points + 3 * cells->point_count, c->points, 3 * c->point_count * sizeof *f->points);
  place_means(diced->means, diced->point_count, first_mean, f->points);
  memcpy(f->hexes, cells->hexes, 8 * cells->hex_count * sizeof *f->hexes);
  memcpy(f->hexes + 8 * cells->hex_count, diced->hexes, 8 * diced->hex_count * sizeof *f->hexes);
  return HEXCON_OK;
}

static hexcon_status close_inside(hexcon_context *context, const cell_problem *p, closure_kind kind,
                                  const double *placed, closure *c, bool *found) {
  size_t inner_count = p->s->point_count, triangle_count = 2 * p->s->quad_count;
  *found = true;
  if (kind == CLOSURE_STAR)
    return closure_star(context, inner_count, p->cells.triangles, triangle_count, p->center, c);
  return closure_tetrahedra(context, placed + 3 * p->cells.first_inner, inner_count,
                            p->cells.triangles, triangle_count, p->options, c, found);
}

/** Fill with cells of one thickness and one closure; f stays empty where that was not found. */
static hexcon_status fill(hexcon_context *context, const cell_problem *p, double thickness,
                          closure_kind kind, cell_filling *f) {
  closure c = {0};
  diced_complex diced = {0};
  bool found = false;
  double *placed = context_allocate(context, p->cells.point_count, 3 * sizeof *placed);
  hexcon_status status = placed ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  if (!status)
    status = place(context, p, thickness, placed);
  if (!status)
    status = close_inside(context, p, kind, placed, &c, &found);
  f->tetrahedron_count = c.tetrahedron_count;
  if (!status && found)
    status = dice_closure(context, p, &c, &diced);
  if (!status && found)
    status = assemble(context, p, placed, &c, &diced, f);
  closure_free(context, &c);
  dice_free(context, &diced);
  context_free(context, placed);
  return status;
}

static void measure(cell_filling *f) {
  f->inverted = 0;
  f->worst = 1;
  f->mean = 0;
  for (size_t h = 0; h < f->hex_count; h++) {
    bool positive = prove_jacobian_sign(f->points, f->hexes + 8 * h) == JACOBIAN_POSITIVE;
    f->quality[h] = scaled_jacobian(f->points, f->hexes + 8 * h);
    f->inverted += !positive;
    f->worst = fmin(f->worst, f->quality[h]);
    f->mean += f->quality[h] / (double)f->hex_count;
  }
}

static hexcon_status improve(hexcon_context *context, const cell_problem *p,
                             const hexcon_optimize_options *options, cell_filling *f) {
  uint8_t *fixed = context_allocate_zeroed(context, f->point_count, sizeof *fixed);
  if (!fixed)
    return HEXCON_OUT_OF_MEMORY;
  memset(fixed, 1, p->s->point_count);
  size_t rounds = 0;
  hexcon_status status = improve_mesh(context, f->points, f->point_count, f->hexes, f->hex_count,
                                      fixed, options, &rounds);
  f->rounds += rounds;
  context_free(context, fixed);
  measure(f);
  return status;
}

static bool is_good(const cell_problem *p, const cell_filling *f) {
  return f->points && f->inverted == 0 && f->worst >= fmin(good_worst, near_the_bound * p->bound);
}

/** Untangle, raise the mean, which leaves few bad hexes, then the worst of those: enough to see
 * what a filling is worth. */
static hexcon_status improve_roughly(hexcon_context *context, const cell_problem *p,
                                     cell_filling *f) {
  hexcon_optimize_options untangling = {
      .threads = p->options->threads, .target = 1e-6, .mean_passes = 1};
  hexcon_optimize_options rough = {
      .threads = p->options->threads, .target = 1.5 * good_worst, .max_rounds = 3};
  hexcon_optimize_options longer = {
      .threads = p->options->threads, .target = 1.2 * good_worst, .max_rounds = 6};
  hexcon_status status = improve(context, p, &untangling, f);
  if (!status && f->inverted == 0)
    status = improve(context, p, &rough, f);
  if (!status && f->inverted == 0 && !is_good(p, f))
    status = improve(context, p, &longer, f);
  return status;
}

/** A mesh of this many hexes is worth the time of more passes for the worst of them. */
enum { SMALL_MESH = 12000 };

/** The best filling's worst hexes, if that does not take long, then its mean. */
static hexcon_status polish(hexcon_context *context, const cell_problem *p, cell_filling *f) {
  bool small = f->hex_count <= SMALL_MESH;
  hexcon_optimize_options options = {.threads = p->options->threads,
                                     .target = small ? 2.5 * good_worst : 1e-6,
                                     .max_rounds = 5,
                                     .mean_passes = 2};
  return f->inverted == 0 ? improve(context, p, &options, f) : HEXCON_OK;
}

static bool is_better(const cell_filling *a, const cell_filling *b) {
  if (!b->points || a->inverted != b->inverted)
    return !b->points || a->inverted < b->inverted;
  double part = fmin(a->worst, good_worst) - fmin(b->worst, good_worst);
  return fabs(part) > 1e-3 ? part > 0 : a->mean > b->mean;
}

static const char *const closure_names[] = {"star", "tetrahedra"};

/** Fill by one closure; keep the better of that and `best`. */
static hexcon_status try_closure(hexcon_context *context, const cell_problem *p, const attempt *way,
                                 closure_kind kind, hexcon_mesh *mesh, cell_filling *best) {
  cell_filling f = {.closure = kind,
                    .thickness = way->thickness,
                    .layers = p->cells.layers,
                    .pairing = p->pairing};
  hexcon_status status = fill(context, p, way->thickness, kind, &f);
  if (!status && f.points)
    status = improve_roughly(context, p, &f);
  if (!status && f.points)
    mesh_log(mesh,
             "%s, thickness %.2f, %zu layers%s: %zu hexes, %zu not positive, scaled Jacobian min "
             "%.4f, mean %.4f",
             closure_names[kind], way->thickness, p->cells.layers,
             way->pair_anew ? ", paired anew" : "", f.hex_count, f.inverted, f.worst, f.mean);
  else if (!status)
    mesh_log(mesh, "%s, thickness %.2f, %zu layers: no tetrahedra found", closure_names[kind],
             way->thickness, p->cells.layers);
  if (!status && f.points && is_better(&f, best)) {
    cell_filling worse = *best;
    *best = f;
    f = worse;
  }
  filling_free(context, &f);
  return status;
}

/** Make pairs less wanted whose cells hold bad hexes. */
static void keep_apart(cell_problem *p, const cell_filling *f) {
  size_t first = f->layers * p->s->quad_count, width = p->cells.domino->hex_count, cell = 0;
  if (f->pairing != p->pairing)
    return; /* of an earlier one: its cells are not these */
  p->pairing++;
  for (size_t q = 0; q < p->s->quad_count; q++) {
    int32_t h = p->partner[q];
    if (p->colours[half_edge_start(p->s, h)] == 0)
      continue; /* as cells_build numbers them */
    double worst = 1;
    for (size_t i = 0; i < width; i++)
      worst = fmin(worst, f->quality[first + width * cell + i]);
    cell++;
    if (worst < good_worst)
      p->weights[h] = p->weights[p->s->twins[h]] = p->weights[h] - 1;
  }
}

/** One way, by all closures that suit the surface. */
static hexcon_status try_way(hexcon_context *context, cell_problem *p, const attempt *way,
                             hexcon_mesh *mesh, cell_filling *best) {
  size_t layers = (size_t)p->options->layers + way->more_layers;
  bool meshes_inside = p->options->tetrahedralise != NULL;
  if (way->pair_anew && best->points)
    keep_apart(p, best);
  hexcon_status status = HEXCON_OK;
  if (!p->cells.hexes || way->pair_anew || layers != p->cells.layers)
    status = build_cells(context, p, layers);
  if (!status && meshes_inside)
    status = try_closure(context, p, way, CLOSURE_TETRAHEDRA, mesh, best);
  bool star =
      !meshes_inside || !best->points || best->inverted > 0 || p->s->quad_count <= STAR_QUADS;
  if (!status && star)
    status = try_closure(context, p, way, CLOSURE_STAR, mesh, best);
  return status;
}

static void hand_over(const cell_problem *p, const cell_filling *f, hexcon_mesh *mesh) {
  mesh->points = f->points;
  mesh->hexes = f->hexes;
  mesh->quality = f->quality;
  mesh->point_count = f->point_count;
  mesh->hex_count = f->hex_count;
  mesh->order = 1;
  mesh->method = "cells";
  mesh->bound = p->bound;
  mesh_note(mesh, "pairs", (double)p->s->quad_count / 2);
  mesh_note(mesh, "layers", (double)f->layers);
  mesh_note(mesh, "cell thickness", f->thickness);
  mesh_note(mesh, "tetrahedra", (double)f->tetrahedron_count);
  mesh_note(mesh, "hexes per quad", (double)f->hex_count / (double)p->s->quad_count);
  mesh_note(mesh, "optimisation rounds", (double)f->rounds);
  mesh_note(mesh, "surface bound", p->bound);
}

hexcon_status mesh_cells(hexcon_context *context, const surface *s,
                         const hexcon_mesh_options *options, hexcon_mesh *mesh) {
  cell_problem p = {.s = s, .options = options};
  cell_filling best = {0};
  double start = mesh_clock();
  hexcon_status status = prepare(context, s, &p);
  size_t tried = 0;
  for (; !status && tried < ATTEMPTS && !is_good(&p, &best); tried++) {
    if (tried >= FOR_QUALITY && best.points && best.inverted == 0)
      break;
    status = try_way(context, &p, &attempts[tried], mesh, &best);
  }
  mesh_note_seconds(mesh, "cells", start);
  start = mesh_clock();
  if (!status)
    status = polish(context, &p, &best);
  mesh_note_seconds(mesh, "optimisation", start);
  if (!status) {
    mesh_note(mesh, "attempts", (double)tried);
    hand_over(&p, &best, mesh);
  } else {
    filling_free(context, &best);
  }
  problem_free(context, &p);
  return status;
}
