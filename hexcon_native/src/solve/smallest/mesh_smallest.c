/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "mesh_smallest.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "construct/small_fillings.h"
#include "shape/place/model_placement.h"
#include "solve/common/quality_bound.h"
#include "surface/corner_angles.h"

/** Ways to a first placement, in the order in which they are tried while hexes are not positive. */
typedef enum small_way { BY_HOMOTOPY, BY_AFFINE_MAP, BY_MEANS, SMALL_WAYS } small_way;
static const char *const way_names[] = {"homotopy", "affine map", "means"};

/** A copy of the filling's hexes and the surface's points, inner ones not placed. */
static hexcon_status copy_topology(hexcon_context *context, const surface *s,
                                   const small_filling *filling, small_mesh *out) {
  *out = (small_mesh){0};
  filled_mesh *m = &out->mesh;
  hexcon_status status = filled_mesh_new(context, filling->point_count, filling->hex_count, m);
  if (status)
    return status;
  memcpy(m->points, s->points, s->point_count * 3 * sizeof *m->points);
  memcpy(m->hexes, filling->hexes, m->hex_count * 8 * sizeof *m->hexes);
  return HEXCON_OK;
}

static hexcon_status place(hexcon_context *context, const surface *s, const small_filling *filling,
                           small_way way, small_mesh *m) {
  const placed_mesh placed = {s->point_count, m->mesh.point_count, m->mesh.hex_count, m->mesh.hexes,
                              m->mesh.points};
  bool arrived;
  m->way = way_names[way];
  if (way == BY_HOMOTOPY)
    return model_placement_homotopy(context, &placed, filling->places, &arrived);
  if (way == BY_AFFINE_MAP)
    model_placement_affine(&placed, filling->places);
  else
    mean_placement(&placed);
  return HEXCON_OK;
}

static const mesh_taste preference = {.enough = 1, .clear_mean = INFINITY};

static hexcon_status try_way(hexcon_context *context, const surface *s,
                             const small_filling *filling, small_way way, int threads,
                             small_mesh *best) {
  const hexcon_optimize_options improvement = {.threads = threads, .mean_passes = 2};
  small_mesh m = {0};
  hexcon_status status = copy_topology(context, s, filling, &m);
  if (!status)
    status = place(context, s, filling, way, &m);
  bool placed = !status;
  if (placed)
    status = filled_mesh_improve(context, s->point_count, &improvement, &m.mesh);
  if (placed && mesh_stop(context, status) &&
      filled_mesh_is_better(&m.mesh, &best->mesh, &preference)) {
    const small_mesh worse = *best;
    *best = m;
    m = worse;
  }
  filled_mesh_free(context, &m.mesh);
  return status;
}

/** How well a filling suits the surface, turned as it is. */
typedef struct fitness {
  double bound;  /**< no higher worst scaled Jacobian, wherever the inner points are */
  double misfit; /**< of the shape in which it is known to be good */
} fitness;

static hexcon_status find_fitness(hexcon_context *context, const surface *s,
                                  const small_filling *filling, fitness *out) {
  double *points = context_allocate(context, filling->point_count, 3 * sizeof *points);
  if (!points)
    return HEXCON_OUT_OF_MEMORY;
  const placed_mesh placed = {s->point_count, filling->point_count, filling->hex_count,
                              filling->hexes, points};
  memcpy(points, s->points, 3 * s->point_count * sizeof *points);
  model_placement_affine(&placed, filling->places); /* the bound looks at sizes of whole hexes */
  hexcon_status status =
      quality_bound(context, s, points, filling->hexes, filling->hex_count, &out->bound);
  out->misfit = model_placement_misfit(s->points, s->point_count, filling->places);
  context_free(context, points);
  return status;
}

static bool is_fitter(fitness a, fitness b) {
  const double slack = 1e-6; /* symmetric ones differ by rounding */
  if (fabs(a.bound - b.bound) > slack)
    return a.bound > b.bound;
  return a.misfit < (1 - slack) * b.misfit;
}

/** Of the class's symmetries one that puts no two quads of a flat side on one hex, if there is, and
 * no sharp corners; the first of equals. */
static hexcon_status choose_filling(hexcon_context *context, const surface *s, small_filling *out) {
  small_class found;
  fitness best = {0};
  *out = (small_filling){0};
  hexcon_status status = small_class_find(context, s, &small_fillings_smallest, &found);
  if (!status)
    status = small_filling_read(context, s, &found, 0, out);
  if (!status)
    status = find_fitness(context, s, out, &best);
  for (size_t walk = 1; !status && walk < found.walk_count; walk++) {
    small_filling filling;
    fitness here = best;
    status = small_filling_read(context, s, &found, walk, &filling);
    if (!status)
      status = find_fitness(context, s, &filling, &here);
    if (!status && is_fitter(here, best)) {
      const small_filling worse = *out;
      *out = filling;
      filling = worse;
      best = here;
    }
    small_filling_free(context, &filling);
  }
  return status;
}

hexcon_status small_mesh_build(hexcon_context *context, const surface *s, int threads,
                               small_mesh *out) {
  small_filling filling;
  *out = (small_mesh){0};
  hexcon_status status = choose_filling(context, s, &filling);
  for (int way = 0; !status && way < SMALL_WAYS && (!out->mesh.points || out->mesh.inverted > 0);
       way++)
    if (way != BY_HOMOTOPY || filling.certified)
      status = try_way(context, s, &filling, (small_way)way, threads, out);
  small_filling_free(context, &filling);
  return status;
}

/** What the surface's own corners allow: for the words where the mesh cannot be certified. */
static double surface_bound(const surface *s) {
  double bound = 1;
  for (int32_t h = 0; h < (int32_t)(4 * s->quad_count); h++)
    bound = fmin(bound, fabs(sin(surface_corner_angle(s, h))));
  return bound;
}

static void hand_over(const surface *s, small_mesh *made, hexcon_mesh *mesh) {
  const filled_mesh *m = &made->mesh;
  char line[160];
  (void)snprintf(line, sizeof line,
                 "points placed by %s: %zu hexes, %zu not positive, scaled Jacobian min %.4f, mean "
                 "%.4f",
                 made->way, m->hex_count, m->inverted, m->worst, m->mean);
  mesh_log(mesh, line);
  filled_mesh_hand_over(&made->mesh, surface_bound(s), s->quad_count, mesh);
}

hexcon_status mesh_smallest(hexcon_context *context, const surface *s,
                            const hexcon_mesh_options *options, hexcon_mesh *mesh) {
  small_mesh made;
  const double start = mesh_clock();
  hexcon_status status = small_mesh_build(context, s, options->threads, &made);
  status = mesh_settle(context, status, made.mesh.points && made.mesh.inverted == 0, mesh);
  if (!status)
    hand_over(s, &made, mesh);
  filled_mesh_free(context, &made.mesh);
  mesh_note_seconds(mesh, "smallest", start);
  return status;
}
