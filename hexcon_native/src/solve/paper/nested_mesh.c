/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "nested_mesh.h"

#include <math.h>
#include <string.h>

#include "construct/pillow.h"
#include "shape/offset/inner_surface.h"
#include "shape/place/pillow_placement.h"
#include "surface/colouring.h"
#include "surface/star_center.h"

/** The ridge of a pair lies this part of the way to the centre, .. */
static const double ridge_share = 0.1;
/** .. all split layers together leave this part of it: alternative ones less uneven a front, as
 * some of its points never move. */
static const double left_by_layers[] = {[SPLIT_ORIGINAL] = 0.6, [SPLIT_ALTERNATIVE] = 0.8};

/** Without a centre, anchors lie so deep, in mean edge lengths. */
static const double anchor_depth = 0.4;

static void find_mean(const surface *s, double center[3]) {
  memset(center, 0, 3 * sizeof *center);
  for (size_t i = 0; i < 3 * s->point_count; i++)
    center[i % 3] += s->points[i] / (double)s->point_count;
}

static hexcon_status find_center(hexcon_context *context, const surface *s, nested_mesh *mesh) {
  double margin = -1; /* a torus has no star centre: no need to look for one */
  hexcon_status status =
      surface_is_sphere(s) ? surface_star_center(context, s, mesh->center, &margin) : HEXCON_OK;
  if (!status && surface_is_sphere(s) && !(margin > 0)) /* flat corners do no harm here */
    status = surface_mean_center(context, s, mesh->center, &margin);
  mesh->star_shaped = margin > 0;
  if (!status && !mesh->star_shaped)
    find_mean(s, mesh->center);
  return status;
}

/** The centre for all, or an inner copy of each point. */
static hexcon_status place_anchors(hexcon_context *context, const surface *s, nested_mesh *mesh) {
  inner_surface_options options = {.thickness = anchor_depth, .no_center = true};
  size_t count = mesh->star_shaped ? 1 : s->point_count;
  mesh->anchor_places = context_allocate(context, count, 3 * sizeof *mesh->anchor_places);
  if (!mesh->anchor_places)
    return HEXCON_OUT_OF_MEMORY;
  if (!mesh->star_shaped)
    return inner_surface_place(context, s, &options, mesh->anchor_places);
  memcpy(mesh->anchor_places, mesh->center, sizeof mesh->center);
  return HEXCON_OK;
}

hexcon_status nested_mesh_new(hexcon_context *context, const surface *s, nested_mesh *out) {
  memset(out, 0, sizeof *out);
  out->grown.point_count = s->point_count;
  out->points = context_allocate(context, s->point_count, 3 * sizeof *out->points);
  if (!out->points)
    return HEXCON_OUT_OF_MEMORY;
  memcpy(out->points, s->points, 3 * s->point_count * sizeof *out->points);
  hexcon_status status = find_center(context, s, out);
  return status ? status : place_anchors(context, s, out);
}

void nested_mesh_free(hexcon_context *context, nested_mesh *mesh) {
  context_free(context, mesh->points);
  context_free(context, mesh->anchor_places);
  context_free(context, mesh->grown.hexes);
  memset(mesh, 0, sizeof *mesh);
}

anchors nested_mesh_anchors(const nested_mesh *mesh) {
  return (anchors){mesh->anchor_places, mesh->star_shaped ? 0 : 3};
}

static hexcon_status grow(hexcon_context *context, size_t count, double **points) {
  double *grown = context_grow(context, *points, count, 3 * sizeof **points);
  if (!grown)
    return HEXCON_OUT_OF_MEMORY;
  *points = grown;
  return HEXCON_OK;
}

hexcon_status nested_mesh_grow_points(hexcon_context *context, nested_mesh *mesh) {
  return grow(context, mesh->grown.point_count, &mesh->points);
}

/** New points have their anchors at the means of the others'. */
static hexcon_status grow_anchors(hexcon_context *context, nested_mesh *mesh,
                                  const mean_points *made) {
  if (mesh->star_shaped)
    return HEXCON_OK;
  hexcon_status status = grow(context, mesh->grown.point_count, &mesh->anchor_places);
  if (!status)
    status = place_plain_means(context, made->means, made->count, made->first, mesh->anchor_places);
  return status;
}

/** Place a stage's points: those near the older ones, then the others, by their shares. */
static hexcon_status place(hexcon_context *context, nested_mesh *mesh, const mean_points *made,
                           double near_share, double far_share) {
  hexcon_status status = nested_mesh_grow_points(context, mesh);
  if (!status)
    status = grow_anchors(context, mesh, made);
  if (status)
    return status;
  anchors to = nested_mesh_anchors(mesh);
  status = place_drawn_means(context, made->means, made->near_count, made->first, &to, near_share,
                             mesh->points);
  if (!status)
    status = place_drawn_means(context, made->means + 4 * made->near_count,
                               made->count - made->near_count, made->first + made->near_count, &to,
                               far_share, mesh->points);
  return status;
}

hexcon_status nested_mesh_pair(hexcon_context *context, const surface *s, const int32_t *partner,
                               nested_mesh *mesh, paired_quads *out) {
  hexcon_status status = paired_transition_build(context, s, partner, &mesh->grown, out);
  return status ? status : place(context, mesh, &out->points, ridge_share, 0);
}

/* ------------------------------------------------------------------------------------ split layers
 */

static void mark_crossed(const surface *s, const surface_loops *loops, const int32_t *families,
                         int32_t family, uint8_t *crossed) {
  for (int32_t h = 0; h < (int32_t)(4 * s->quad_count); h++)
    crossed[h] = families[loops->loop_of_passage[surface_passage(h)]] == family;
}

static hexcon_status add_layer(hexcon_context *context, split_front *front, split_kind kind,
                               const uint8_t *crossed, uint8_t *sides, double share,
                               nested_mesh *mesh) {
  mean_points made = {0};
  size_t *starts =
      mesh->thin ? context_allocate(context, front->s->quad_count + 1, sizeof *starts) : NULL;
  hexcon_status status = surface_sides(context, front->s, crossed, sides);
  if (mesh->thin && !starts)
    status = HEXCON_OUT_OF_MEMORY;
  if (!status)
    status =
        split_front_add_layer(context, front, kind, crossed, sides, &mesh->grown, starts, &made);
  if (!status)
    status = place(context, mesh, &made, share / 2, share);
  if (!status && mesh->thin)
    status =
        thin_columns_go_down(context, mesh->thin, front->s, &mesh->grown, starts, front->points);
  context_free(context, made.means);
  context_free(context, starts);
  return status;
}

hexcon_status nested_mesh_split(hexcon_context *context, split_front *front, split_kind kind,
                                const surface_loops *loops, const int32_t *family_of_loop,
                                size_t family_count, nested_mesh *mesh, size_t *added) {
  uint8_t *crossed = context_allocate(context, front->s->quad_count, 4);
  uint8_t *sides = context_allocate(context, front->s->point_count, 1);
  hexcon_status status = crossed && sides ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  double share = 1 - pow(left_by_layers[kind], 1 / (double)family_count);
  for (size_t family = 0; !status && family < family_count; family++) {
    size_t before = mesh->grown.hex_count;
    status = context_progress(context, STAGE_SPLIT_LAYERS, (double)family / (double)family_count);
    mark_crossed(front->s, loops, family_of_loop, (int32_t)family, crossed);
    if (!status)
      status = add_layer(context, front, kind, crossed, sides, share, mesh);
    added[family] = mesh->grown.hex_count - before;
  }
  context_free(context, crossed);
  context_free(context, sides);
  return status;
}

/* --------------------------------------------------------------------------------------- pillowing
 */

hexcon_status nested_mesh_pillow(hexcon_context *context, nested_mesh *mesh) {
  thin_columns *thin = mesh->thin;
  pillow_points copies = {0};
  hexcon_status status = thin_columns_sort_out(context, thin, mesh->grown.hex_count);
  if (!status)
    status =
        pillow_hexes(context, thin->hexes, thin->parts, thin->hex_count, &mesh->grown, &copies);
  if (!status)
    status = nested_mesh_grow_points(context, mesh);
  if (!status)
    status = place_pillow(context, mesh->grown.hexes, thin->hexes, thin->hex_count,
                          copies.originals, copies.first, copies.count, mesh->points);
  context_free(context, copies.originals);
  return status;
}
