/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "mesh_pillow.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "pillow_bound.h"
#include "pillow_worth.h"
#include "pillowed_mesh.h"
#include "quality_bound.h"
#include "surface/numbering.h"

/** What comes of a pillow, as part of what the surface allows. */
static const double usual_part = 0.8;

/** Larger meshes take too long, unless they are asked to have one. */
enum { MOST_HEXES = 40000 };

/** What the surface allows of hexes that have one of its quads each. */
typedef struct surface_limit {
  double bound;
  int32_t point; /* where that is, the caller's id */
} surface_limit;

static hexcon_status find_limit(hexcon_context *context, const surface *s, surface_limit *out) {
  size_t worst = 0;
  double *bounds = context_allocate(context, s->point_count, sizeof *bounds);
  if (!bounds)
    return HEXCON_OUT_OF_MEMORY;
  hexcon_status status =
      pillow_bounds(context, s->points, s->point_count, s->quads, s->quad_count, bounds);
  if (!status)
    out->bound = pillow_bound_least(bounds, s->point_count, &worst);
  out->point = (int32_t)worst;
  numbering_name_points(s->names, &out->point, 1);
  context_free(context, bounds);
  return status;
}

/** The mesh as what is compared; it keeps its arrays. */
static filled_mesh view(const hexcon_mesh *mesh) {
  return (filled_mesh){.points = mesh->points,
                       .quality = mesh->quality,
                       .hexes = mesh->hexes,
                       .point_count = mesh->point_count,
                       .hex_count = mesh->hex_count};
}

/** Whether one is worth its time, by what is known before; tells why not. */
static bool is_promising(const surface *s, const filled_mesh *plain, const surface_limit *limit,
                         hexcon_mesh *mesh) {
  char line[200];
  bool poor = plain->inverted > 0 || plain->worst < PILLOW_POOR_WORST;
  bool helps = limit->bound > 0 && (plain->inverted > 0 ||
                                    usual_part * limit->bound >= pillow_least_worth(plain->worst));
  bool large = plain->hex_count + s->quad_count > MOST_HEXES;
  if (poor && !helps)
    (void)snprintf(
        line, sizeof line,
        "no pillow: with one the surface's corners at point %d allow a scaled Jacobian of "
        "%.4f at most, and the worst is %.4f",
        (int)limit->point, limit->bound, plain->worst);
  else if (poor && large)
    (void)snprintf(line, sizeof line, "no pillow: it is tried up to %d hexes; ask for one",
                   (int)MOST_HEXES);
  if (poor && (!helps || large))
    mesh_log(mesh, line);
  return poor && helps && !large;
}

/** The last hexes first, as stages lie from outside to inside. */
static hexcon_status bring_forward(hexcon_context *context, size_t last, filled_mesh *mesh) {
  const size_t hex = 8 * sizeof *mesh->hexes, one = sizeof *mesh->quality,
               rest = mesh->hex_count - last;
  int32_t *hexes = context_allocate(context, last, hex);
  double *quality = context_allocate(context, last, one);
  bool made = hexes && quality;
  if (made) {
    memcpy(hexes, mesh->hexes + 8 * rest, last * hex);
    memcpy(quality, mesh->quality + rest, last * one);
    memmove(mesh->hexes + 8 * last, mesh->hexes, rest * hex);
    memmove(mesh->quality + last, mesh->quality, rest * one);
    memcpy(mesh->hexes, hexes, last * hex);
    memcpy(mesh->quality, quality, last * one);
  }
  context_free(context, hexes);
  context_free(context, quality);
  return made ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

/** The result becomes the pillowed mesh. @param bound  of the worst, whatever lies under the
 * surface */
static void take(hexcon_context *context, const surface *s, double bound, size_t sheets,
                 filled_mesh *made, hexcon_mesh *mesh) {
  const size_t added = made->hex_count - mesh->hex_count;
  context_free(context, mesh->points);
  context_free(context, mesh->hexes);
  context_free(context, mesh->quality);
  filled_mesh_hand_over(made, bound, s->quad_count, mesh);
  mesh_note_outer_hexes(mesh, HEXES_OF_PILLOWS, added);
  mesh_note(mesh, "pillows", (double)sheets);
}

static void log_outcome(const filled_mesh *plain, const filled_mesh *made, size_t sheets, bool kept,
                        hexcon_mesh *mesh) {
  char line[256];
  (void)snprintf(
      line, sizeof line,
      "%zu %s: %zu hexes for %zu, %zu not positive for %zu, scaled Jacobian min %.4f for "
      "%.4f, mean %.4f for %.4f: %s",
      sheets, sheets == 1 ? "pillow" : "pillows", made->hex_count, plain->hex_count, made->inverted,
      plain->inverted, made->worst, plain->worst, made->mean, plain->mean,
      kept ? "taken" : "not worth it");
  mesh_log(mesh, line);
}

static hexcon_status make(hexcon_context *context, const surface *s, size_t sheets, int threads,
                          const filled_mesh *plain, filled_mesh *made) {
  uint8_t *fixed = context_allocate_zeroed(context, plain->point_count, sizeof *fixed);
  if (!fixed)
    return HEXCON_OUT_OF_MEMORY;
  memset(fixed, 1, s->point_count);
  context_reserve(context, plain->hex_count + sheets * s->quad_count, true);
  hexcon_status status = pillowed_mesh_make(context, plain, fixed, sheets, threads, made);
  context_free(context, fixed);
  return status;
}

static hexcon_status try_sheets(hexcon_context *context, const surface *s,
                                const hexcon_mesh_options *options, const filled_mesh *plain,
                                hexcon_mesh *mesh) {
  const bool wanted = options->pillow > 0;
  const size_t sheets = wanted ? (size_t)options->pillow : 1;
  filled_mesh made = {0};
  double bound = 0;
  hexcon_status status = make(context, s, sheets, options->threads, plain, &made);
  if (!status)
    status = quality_bound(context, s, made.points, made.hexes, made.hex_count, &bound);
  if (!status) {
    const bool kept = wanted || pillow_is_worth(&made, plain);
    log_outcome(plain, &made, sheets, kept, mesh);
    if (kept)
      status = bring_forward(context, sheets * s->quad_count, &made);
    if (kept && !status)
      take(context, s, bound, sheets, &made, mesh);
  }
  filled_mesh_free(context, &made);
  return status;
}

/** Whether the mesh is good as it is, by the quality that its method found. */
static bool is_good(const hexcon_mesh *mesh) {
  for (size_t h = 0; h < mesh->hex_count; h++)
    if (!(mesh->quality[h] >= PILLOW_POOR_WORST))
      return false;
  return true;
}

static hexcon_status pillow(hexcon_context *context, const surface *s,
                            const hexcon_mesh_options *options, hexcon_mesh *mesh) {
  surface_limit limit = {0};
  filled_mesh plain = view(mesh);
  hexcon_status status = filled_mesh_measure(context, &plain);
  if (!status)
    status = find_limit(context, s, &limit);
  if (!status)
    mesh_note(mesh, "pillow bound", limit.bound);
  if (!status && (options->pillow > 0 || is_promising(s, &plain, &limit, mesh)))
    status = try_sheets(context, s, options, &plain, mesh);
  return status;
}

hexcon_status mesh_pillow(hexcon_context *context, const surface *s,
                          const hexcon_mesh_options *options, hexcon_mesh *mesh) {
  mesh_note(mesh, "pillows", 0);
  if (options->pillow == HEXCON_PILLOW_NEVER || context_is_finishing(context) ||
      (options->pillow == HEXCON_PILLOW_AUTO && is_good(mesh)))
    return HEXCON_OK;
  double start = mesh_clock();
  hexcon_status status = pillow(context, s, options, mesh);
  mesh_note_seconds(mesh, "pillow", start);
  return mesh_settle(context, status, true, mesh);
}
