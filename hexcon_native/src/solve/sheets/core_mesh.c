/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "core_mesh.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core_filling.h"
#include "surface/corner_angles.h"

/** One way to fill a core. */
typedef struct attempt {
  core_way way;
  double thickness; /* of cells, in lengths of the edges above */
} attempt;

static const attempt attempts[] = {{CORE_NONE, 0},
                                   {CORE_TABLE, 0},
                                   {CORE_TETRAHEDRA, 0.6},
                                   {CORE_STAR, 0.6},
                                   {CORE_TETRAHEDRA, 0.4}};
enum { ATTEMPTS = sizeof attempts / sizeof *attempts };
static const char *const way_words[] = {[CORE_NONE] = ", which fill it",
                                        [CORE_TABLE] =
                                            " filled with hexes from the table of small fillings",
                                        [CORE_TETRAHEDRA] = " filled with cells and tetrahedra",
                                        [CORE_STAR] = " filled with cells and a star"};

/** Quads of the largest core in the table, and of the largest that a star is tried on beside
 * tetrahedra. */
enum { TABLE_QUADS = 16, STAR_QUADS = 64 };

/** No further core is begun after so many attempts. */
enum { MOST_ATTEMPTS = 4 };

/** Nothing else is tried once the worst scaled Jacobian is this, or near what the surface allows.
 */
static const double good_worst = 0.1, near_the_bound = 0.8;

/* ---------------------------------------------------------------------------------------- joining
 */

/** The layers' mesh with the filling's hexes, all where they are by then. */
static hexcon_status join(hexcon_context *context, const layered_core *core,
                          const core_filling *filling, filled_mesh *out) {
  size_t shared = core->s.point_count, added = filling->point_count - shared;
  hexcon_status status = filled_mesh_new(context, core->point_count + added,
                                         core->hex_count + filling->hex_count, out);
  if (status)
    return status;
  memcpy(out->points, core->points, 3 * core->point_count * sizeof *out->points);
  if (filling->points)
    memcpy(out->points + 3 * core->point_count, filling->points + 3 * shared,
           3 * added * sizeof *out->points);
  memcpy(out->hexes, core->hexes, 8 * core->hex_count * sizeof *out->hexes);
  for (size_t i = 0; i < 8 * filling->hex_count; i++) {
    size_t id = (size_t)filling->hexes[i];
    out->hexes[8 * core->hex_count + i] =
        id < shared ? core->ids[id] : (int32_t)(core->point_count + id - shared);
  }
  return HEXCON_OK;
}

/* -------------------------------------------------------------------------------------- improving
 */

static bool is_good(const core_mesh *m) {
  return m->mesh.points && m->mesh.inverted == 0 &&
         m->mesh.worst >= fmin(good_worst, near_the_bound * m->bound);
}

/** A worst above 1.5 good_worst counts as that. */
static const mesh_taste preference = {.enough = 0.15, .clearly = 1e-3};

/** Untangle, raise the mean, then the worst. */
static hexcon_status improve(hexcon_context *context, const surface *s, int threads,
                             filled_mesh *mesh) {
  const hexcon_optimize_options untangling = {.threads = threads, .target = 1e-6, .mean_passes = 1};
  const hexcon_optimize_options rough = {
      .threads = threads, .target = 2 * good_worst, .max_rounds = 6};
  hexcon_status status = filled_mesh_improve(context, s->point_count, &untangling, mesh);
  if (!status && mesh->inverted == 0)
    status = filled_mesh_improve(context, s->point_count, &rough, mesh);
  return status;
}

static hexcon_status polish(hexcon_context *context, const surface *s, int threads,
                            filled_mesh *mesh) {
  const hexcon_optimize_options options = {
      .threads = threads, .target = 2.5 * good_worst, .max_rounds = 5, .mean_passes = 2};
  return mesh->inverted == 0 ? filled_mesh_improve(context, s->point_count, &options, mesh)
                             : HEXCON_OK;
}

/** Untangle and smooth the layers alone: the core's points are free then, and come to lie where it
 * has room and does not meet itself.
 * @param inverted  receives how many hexes are not positive whatever will be inside */
static hexcon_status settle(hexcon_context *context, const surface *s, int threads,
                            layered_core *core, size_t *inverted) {
  const hexcon_optimize_options options = {.threads = threads, .target = 1e-6, .mean_passes = 2};
  filled_mesh layers = {.points = core->points,
                        .hexes = core->hexes,
                        .point_count = core->point_count,
                        .hex_count = core->hex_count};
  layers.quality = context_allocate(context, core->hex_count, sizeof *layers.quality);
  if (!layers.quality)
    return HEXCON_OUT_OF_MEMORY;
  hexcon_status status = filled_mesh_improve(context, s->point_count, &options, &layers);
  context_free(context, layers.quality);
  layered_core_follow(core);
  *inverted = layers.inverted;
  return status;
}

/* --------------------------------------------------------------------------------------- attempts
 */

/** A star's middle is crowded, but it is better than nothing. */
static bool suits(const layered_core *core, core_way way, bool has_mesher, const core_mesh *best) {
  const size_t quads = core->s.quad_count;
  const bool suited[] = {[CORE_NONE] = quads == 0,
                         [CORE_TABLE] = quads > 0 && quads <= TABLE_QUADS,
                         [CORE_TETRAHEDRA] = quads > 0 && has_mesher,
                         [CORE_STAR] = quads > 0 && (quads <= STAR_QUADS || !best->mesh.points)};
  return suited[way];
}

/** Layers and core in words. */
static void describe(const layered_core *core, char words[128]) {
  int length = snprintf(words, 128, "%zu layers of %zu hexes%s", core->layer_count, core->hex_count,
                        core->covered ? ", the first over the whole surface" : "");
  if (core->s.quad_count > 0 && length > 0 && length < 128)
    (void)snprintf(words + length, 128 - (size_t)length, ", a core of %zu quads",
                   core->s.quad_count);
}

static void log_attempt(hexcon_mesh *told, const layered_core *core, const attempt *way,
                        const filled_mesh *m) {
  char line[320], words[128], found[128] = "none found";
  describe(core, words);
  if (m->points)
    (void)snprintf(found, sizeof found,
                   "%zu hexes, %zu not positive, scaled Jacobian min %.4f, mean %.4f", m->hex_count,
                   m->inverted, m->worst, m->mean);
  (void)snprintf(line, sizeof line, "%s%s: %s", words, way_words[way->way], found);
  mesh_log(told, line);
}

static void keep(const layered_core *core, size_t core_hexes, filled_mesh *made, core_mesh *best) {
  filled_mesh worse = best->mesh;
  best->mesh = *made;
  *made = worse;
  best->core_quads = core->s.quad_count;
  best->layer_count = core->layer_count;
  best->core_hexes = core_hexes;
}

static hexcon_status try_way(hexcon_context *context, const surface *s,
                             const hexcon_mesh_options *options, const layered_core *core,
                             const attempt *way, hexcon_mesh *told, core_mesh *best) {
  core_filling filling = {0};
  filled_mesh made = {0};
  hexcon_status status =
      core_filling_build(context, &core->s, way->way, way->thickness, options, &filling);
  if (!status && (filling.points || way->way == CORE_NONE))
    status = join(context, core, &filling, &made);
  bool joined = !status && made.points;
  if (joined)
    status = improve(context, s, options->threads, &made);
  if (!status) {
    log_attempt(told, core, way, &made);
    best->attempt_count++;
  }
  if (joined && mesh_stop(context, status) &&
      filled_mesh_is_better(&made, &best->mesh, &preference))
    keep(core, filling.hex_count, &made, best);
  core_filling_free(context, &filling);
  filled_mesh_free(context, &made);
  return status;
}

static void log_tangled(hexcon_mesh *told, const layered_core *core, size_t inverted) {
  char line[256], words[128];
  describe(core, words);
  (void)snprintf(line, sizeof line, "%s: %zu hexes of the layers cannot be positive", words,
                 inverted);
  mesh_log(told, line);
}

static hexcon_status try_core(hexcon_context *context, const surface *s,
                              const hexcon_mesh_options *options, layered_core *core,
                              hexcon_mesh *told, core_mesh *best) {
  size_t inverted = 0;
  hexcon_status status = settle(context, s, options->threads, core, &inverted);
  if (!status && inverted > 0) {
    log_tangled(told, core, inverted);
    return HEXCON_OK;
  }
  for (size_t i = 0; !status && i < ATTEMPTS && !is_good(best); i++)
    if (suits(core, attempts[i].way, options->tetrahedralise != NULL, best))
      status = try_way(context, s, options, core, &attempts[i], told, best);
  return status;
}

hexcon_status core_mesh_make(hexcon_context *context, const surface *s,
                             const hexcon_mesh_options *options, layered_core *cores,
                             size_t core_count, hexcon_mesh *told, core_mesh *best) {
  *best = (core_mesh){.bound = 1};
  for (int32_t h = 0; h < (int32_t)(4 * s->quad_count); h++)
    best->bound = fmin(best->bound, fabs(sin(surface_corner_angle(s, h))));
  hexcon_status status = HEXCON_OK;
  for (size_t i = 0; !status && i < core_count && best->attempt_count < MOST_ATTEMPTS; i++) {
    best->core_count++;
    status = try_core(context, s, options, &cores[i], told, best);
    if (best->mesh.points && best->mesh.inverted == 0)
      break; /* only quality is left to win */
  }
  if (!status && best->mesh.points)
    status = polish(context, s, options->threads, &best->mesh);
  return status;
}
