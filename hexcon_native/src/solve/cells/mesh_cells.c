/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "mesh_cells.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cell_filling.h"
#include "surface/corner_angles.h"
#include "surface/star_center.h"

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
/** .. of a star, which is seldom even. */
static const double near_a_star = 0.5;

/** What improvement aims at, as part of what no placement surpasses. */
static const double within_bound = 0.9;

/** The centre: sees all corners, or, where some are folded, at least the quads they belong to. Not
 * every body has one, none with holes or cavities. */
static hexcon_status find_center(hexcon_context *context, const surface *s, double center[3],
                                 bool *found) {
  double margin = -1;
  hexcon_status status =
      surface_is_sphere(s) ? surface_star_center(context, s, center, &margin) : HEXCON_OK;
  if (!status)
    status = surface_check_fillable(context, s, margin > 0);
  if (!status && surface_is_sphere(s) && !(margin > 0))
    status = surface_mean_center(context, s, center, &margin);
  *found = margin > 0;
  return status;
}

static hexcon_status check_closable(hexcon_context *context, const hexcon_mesh_options *options,
                                    bool has_center) {
  if (has_center || options->tetrahedralise)
    return HEXCON_OK;
  return context_fail(context, HEXCON_NOT_STAR_SHAPED,
                      "no point inside sees the whole surface: cells need tetrahedra inside then, "
                      "and no mesher of tetrahedra was given; give one, or cut the body into "
                      "convex or star-shaped parts");
}

static hexcon_status prepare(hexcon_context *context, const surface *s,
                             const hexcon_mesh_options *options, cell_problem *p) {
  double center[3] = {0};
  bool has_center = false;
  hexcon_status status = find_center(context, s, center, &has_center);
  if (!status)
    status = check_closable(context, options, has_center);
  if (!status)
    status = cell_problem_new(context, s, options, p);
  memcpy(p->center, center, sizeof center);
  p->no_center = !has_center;
  return status;
}

static hexcon_status check_found(hexcon_context *context, const cell_filling *best) {
  if (best->mesh.points)
    return HEXCON_OK;
  return context_fail(
      context, HEXCON_NOT_STAR_SHAPED,
      "no point inside sees the whole surface, and no tetrahedra were found between "
      "the cells: thin or narrow parts may need smaller quads");
}

/* ------------------------------------------------------------------------------------ improving */

static const mesh_taste preference = {.enough = 0.15, .clearly = 1e-3}; /* 1.5 good_worst */

/** What no placement surpasses: at a star's middle the hexes, one for each triangle, share all
 * directions. One of them has no larger solid angle than their mean, and three unit vectors with
 * the solid angle a have no larger determinant than 4 tan(a / 2) (Van Oosterom and Strackee, 1983).
 */
static double bound_of(const cell_problem *p, closure_kind kind) {
  const double pi = 3.14159265358979323846;
  double triangles = 2 * (double)p->s->quad_count;
  return kind == CLOSURE_STAR ? fmin(p->bound, 4 * tan(2 * pi / triangles)) : p->bound;
}

/** Where a star is all there can be, it is no worse for being one. */
static double good_enough(const cell_problem *p, closure_kind kind) {
  double bound = near_the_bound * p->bound;
  if (kind == CLOSURE_STAR && !p->options->tetrahedralise)
    bound = fmin(bound, near_a_star * bound_of(p, kind));
  return fmin(good_worst, bound);
}

static bool is_good(const cell_problem *p, const cell_filling *f) {
  return f->mesh.points && f->mesh.inverted == 0 && f->mesh.worst >= good_enough(p, f->closure);
}

/** A scaled Jacobian to raise hexes to, or as far as there is hope. */
static double within_reach(const cell_problem *p, const cell_filling *f, double wanted) {
  return fmin(wanted, within_bound * bound_of(p, f->closure));
}

/** Untangle, raise the mean, which leaves few bad hexes, then the worst of those: enough to see
 * what a filling is worth. */
static hexcon_status improve_roughly(hexcon_context *context, const cell_problem *p,
                                     cell_filling *f) {
  hexcon_optimize_options untangling = {
      .threads = p->options->threads, .target = 1e-6, .mean_passes = 1};
  hexcon_optimize_options rough = {.threads = p->options->threads,
                                   .target = within_reach(p, f, 1.5 * good_worst),
                                   .max_rounds = 3};
  hexcon_optimize_options longer = {.threads = p->options->threads,
                                    .target = within_reach(p, f, 1.2 * good_worst),
                                    .max_rounds = 6};
  hexcon_status status = filled_mesh_improve(context, p->s->point_count, &untangling, &f->mesh);
  if (!status && f->mesh.inverted == 0)
    status = filled_mesh_improve(context, p->s->point_count, &rough, &f->mesh);
  if (!status && f->mesh.inverted == 0 && !is_good(p, f))
    status = filled_mesh_improve(context, p->s->point_count, &longer, &f->mesh);
  return status;
}

/** A mesh of this many hexes is worth the time of more passes for the worst of them. */
enum { SMALL_MESH = 12000 };

/** The best filling's worst hexes, if that does not take long, then its mean. */
static hexcon_status polish(hexcon_context *context, const cell_problem *p, cell_filling *f) {
  bool small = f->mesh.hex_count <= SMALL_MESH;
  hexcon_optimize_options options = {.threads = p->options->threads,
                                     .target = small ? within_reach(p, f, 2.5 * good_worst) : 1e-6,
                                     .max_rounds = 5,
                                     .mean_passes = 2};
  return f->mesh.inverted == 0 ? filled_mesh_improve(context, p->s->point_count, &options, &f->mesh)
                               : HEXCON_OK;
}

/** More than this part of the hexes inverted after all: walls are closer than cells are thick. */
static const double hopeless = 0.1;

static bool is_hopeless(const cell_filling *f) {
  return f->mesh.points && (double)f->mesh.inverted > hopeless * (double)f->mesh.hex_count;
}

static const char *const closure_names[] = {"star", "tetrahedra"};

static void log_attempt(hexcon_mesh *mesh, const attempt *way, const cell_filling *f) {
  char line[256], found[128] = "no tetrahedra found";
  if (f->mesh.points)
    (void)snprintf(found, sizeof found,
                   "%zu hexes, %zu not positive, scaled Jacobian min %.4f, mean %.4f",
                   f->mesh.hex_count, f->mesh.inverted, f->mesh.worst, f->mesh.mean);
  (void)snprintf(line, sizeof line, "%s, thickness %.2f, %zu layers%s: %s",
                 closure_names[f->closure], way->thickness, f->layers,
                 way->pair_anew ? ", paired anew" : "", found);
  mesh_log(mesh, line);
}

/** Fill by one closure; keep the better of that and `best`. */
static hexcon_status try_closure(hexcon_context *context, const cell_problem *p, const attempt *way,
                                 closure_kind kind, hexcon_mesh *mesh, cell_filling *best) {
  cell_filling f = {.closure = kind,
                    .thickness = way->thickness,
                    .layers = p->cells.layers,
                    .pairing = p->pairing};
  hexcon_status status = cell_filling_build(context, p, way->thickness, kind, &f);
  bool built = !status && f.mesh.points;
  if (built)
    status = improve_roughly(context, p, &f);
  if (!status)
    log_attempt(mesh, way, &f);
  if (built && mesh_stop(context, status) &&
      filled_mesh_is_better(&f.mesh, &best->mesh, &preference)) {
    cell_filling worse = *best;
    *best = f;
    f = worse;
  }
  filled_mesh_free(context, &f.mesh);
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
      worst = fmin(worst, f->mesh.quality[first + width * cell + i]);
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
  if (way->pair_anew && best->mesh.points)
    keep_apart(p, best);
  hexcon_status status = HEXCON_OK;
  if (!p->cells.hexes || way->pair_anew || layers != p->cells.layers)
    status = cell_problem_build_cells(context, p, layers);
  if (!status && meshes_inside)
    status = try_closure(context, p, way, CLOSURE_TETRAHEDRA, mesh, best);
  bool star = !meshes_inside || !best->mesh.points || best->mesh.inverted > 0 ||
              p->s->quad_count <= STAR_QUADS;
  if (!status && star && !p->no_center)
    status = try_closure(context, p, way, CLOSURE_STAR, mesh, best);
  return status;
}

/** As they lie in the mesh, from outside to inside. */
static void note_stages(const cell_problem *p, const cell_filling *f, hexcon_mesh *mesh) {
  size_t layers = f->layers * p->s->quad_count,
         cells = p->s->quad_count / 2 * p->cells.domino->hex_count;
  mesh_note_hexes(mesh, HEXES_OF_LAYERS, layers);
  mesh_note_hexes(mesh, HEXES_OF_CELLS, cells);
  mesh_note_hexes(mesh, f->closure == CLOSURE_STAR ? HEXES_OF_STAR : HEXES_OF_TETRAHEDRA,
                  f->mesh.hex_count - layers - cells);
}

static void tell(const cell_problem *p, const cell_filling *f, hexcon_mesh *mesh) {
  mesh_note(mesh, "pairs", (double)p->s->quad_count / 2);
  mesh_note(mesh, "layers", (double)f->layers);
  mesh_note(mesh, "cell thickness", f->thickness);
  mesh_note(mesh, "tetrahedra", (double)f->tetrahedron_count);
  note_stages(p, f, mesh);
}

hexcon_status mesh_cells(hexcon_context *context, const surface *s,
                         const hexcon_mesh_options *options, hexcon_mesh *mesh) {
  cell_problem p = {0};
  cell_filling best = {0};
  double start = mesh_clock();
  hexcon_status status = prepare(context, s, options, &p);
  size_t tried = 0;
  for (; !status && tried < ATTEMPTS && !is_good(&p, &best); tried++) {
    if ((double)tried >= context_patience(context) * (double)FOR_QUALITY && best.mesh.points &&
        best.mesh.inverted == 0)
      break;
    if (tried > 1 && is_hopeless(&best))
      break;
    status = try_way(context, &p, &attempts[tried], mesh, &best);
  }
  mesh_note_seconds(mesh, "cells", start);
  start = mesh_clock();
  if (!status)
    status = check_found(context, &best);
  if (!status)
    status = polish(context, &p, &best);
  status = mesh_settle(context, status, best.mesh.points, mesh);
  mesh_note_seconds(mesh, "optimisation", start);
  if (!status && best.mesh.points) {
    mesh_note(mesh, "attempts", (double)tried);
    tell(&p, &best, mesh);
    filled_mesh_hand_over(&best.mesh, p.bound, s->quad_count, mesh);
  } else {
    filled_mesh_free(context, &best.mesh);
  }
  cell_problem_free(context, &p);
  return status;
}
