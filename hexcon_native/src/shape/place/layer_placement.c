/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "layer_placement.h"

#include <string.h>

#include "base/vector.h"
#include "harmonic.h"

/** Steps of the rim that differ by less than this part of the longest need no solve. */
static const double negligible = 1e-6;

/** A layer seen as a quad mesh with numbers of its own. */
typedef struct layer {
  size_t point_count, quad_count;
  int32_t *quads;   /* [quad_count][4] */
  int32_t *ids;     /* [point_count][2] the point above, and the one under it */
  uint8_t *on_rim;  /* [point_count] */
  double *steps[3]; /* [point_count] from the point above to the one under it */
} layer;

void layer_placement_free(hexcon_context *context, layer_placement *p) {
  context_free(context, p->slots);
  memset(p, 0, sizeof *p);
}

static void layer_free(hexcon_context *context, layer *l) {
  context_free(context, l->quads);
  context_free(context, l->ids);
  context_free(context, l->on_rim);
  for (int axis = 0; axis < 3; axis++)
    context_free(context, l->steps[axis]);
}

static hexcon_status reserve(hexcon_context *context, layer_placement *p, size_t point_count) {
  if (point_count <= p->point_room)
    return HEXCON_OK;
  size_t room = point_count + point_count / 2;
  int32_t *slots = context_grow(context, p->slots, room, sizeof *slots);
  if (!slots)
    return HEXCON_OUT_OF_MEMORY;
  memset(slots + p->point_room, -1, (room - p->point_room) * sizeof *slots);
  p->slots = slots;
  p->point_room = room;
  return HEXCON_OK;
}

static hexcon_status number_points(hexcon_context *context, layer_placement *p,
                                   const int32_t *hexes, size_t hex_count, size_t first_new,
                                   layer *l) {
  l->quad_count = hex_count;
  l->quads = context_allocate(context, hex_count, 4 * sizeof *l->quads);
  l->ids = context_allocate(context, 4 * hex_count, 2 * sizeof *l->ids);
  l->on_rim = context_allocate(context, 4 * hex_count, sizeof *l->on_rim);
  if (!l->quads || !l->ids || !l->on_rim)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t i = 0; i < 4 * hex_count; i++) {
    int32_t above = hexes[8 * (i / 4) + i % 4 + 4], under = hexes[8 * (i / 4) + i % 4];
    if (p->slots[above] < 0) {
      p->slots[above] = (int32_t)l->point_count;
      l->on_rim[l->point_count] = (size_t)under < first_new;
      l->ids[2 * l->point_count] = above;
      l->ids[2 * l->point_count++ + 1] = under;
    }
    l->quads[i] = p->slots[above];
  }
  for (size_t v = 0; v < l->point_count; v++)
    p->slots[l->ids[2 * v]] = -1;
  return HEXCON_OK;
}

/** The rim's mean step; steps less that. @return the longest difference, relative */
static double measure_steps(layer *l, const double *points, double mean[3]) {
  size_t rim = 0;
  double most = 0, longest = 0;
  for (size_t v = 0; v < l->point_count; v++) {
    double step[3] = {0, 0, 0};
    if (l->on_rim[v])
      vector_subtract(points + 3 * (size_t)l->ids[2 * v + 1], points + 3 * (size_t)l->ids[2 * v],
                      step);
    rim += l->on_rim[v];
    longest = fmax(longest, vector_length(step));
    vector_add_scaled(mean, 1, step);
    for (int axis = 0; axis < 3; axis++)
      l->steps[axis][v] = step[axis];
  }
  for (int axis = 0; axis < 3; axis++) {
    mean[axis] /= rim ? (double)rim : 1;
    for (size_t v = 0; v < l->point_count; v++) {
      l->steps[axis][v] = l->on_rim[v] ? l->steps[axis][v] - mean[axis] : 0;
      most = fmax(most, fabs(l->steps[axis][v]));
    }
  }
  return longest > 0 ? most / longest : 0;
}

static hexcon_status spread_steps(hexcon_context *context, layer *l) {
  harmonic spread;
  hexcon_status status =
      harmonic_new(context, l->quads, l->quad_count, l->on_rim, l->point_count, &spread);
  for (int axis = 0; !status && axis < 3; axis++)
    status = harmonic_extend(context, &spread, 0, l->steps[axis]);
  harmonic_free(context, &spread);
  return status;
}

hexcon_status layer_place(hexcon_context *context, layer_placement *p, const int32_t *hexes,
                          size_t hex_count, size_t first_new, size_t point_count, double *points) {
  layer l = {0};
  double mean[3] = {0, 0, 0};
  hexcon_status status = reserve(context, p, point_count);
  if (!status)
    status = number_points(context, p, hexes, hex_count, first_new, &l);
  for (int axis = 0; !status && axis < 3; axis++) {
    l.steps[axis] = context_allocate(context, l.point_count, sizeof *l.steps[axis]);
    status = l.steps[axis] ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  }
  if (!status && measure_steps(&l, points, mean) > negligible)
    status = spread_steps(context, &l);
  for (size_t v = 0; !status && v < l.point_count; v++)
    for (size_t axis = 0; !l.on_rim[v] && axis < 3; axis++)
      points[3 * (size_t)l.ids[2 * v + 1] + axis] =
          points[3 * (size_t)l.ids[2 * v] + axis] + mean[axis] + l.steps[axis][v];
  layer_free(context, &l);
  return status;
}
