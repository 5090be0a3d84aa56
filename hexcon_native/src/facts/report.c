/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The public calls that tell facts of a surface. */
#include <string.h>

#include "homology/odd_cycles.h"
#include "pairing/pair_crossings.h"
#include "pairing/pair_weights.h"
#include "pairing/pairing.h"
#include "surface/build.h"
#include "surface/colouring.h"
#include "surface/geometry.h"
#include "surface/loops.h"
#include "surface/shells.h"
#include "surface/star_center.h"

/** Every component on its own needs an even number: each is the boundary of its own filling. */
static hexcon_status components_are_even(hexcon_context *context, const surface *s, bool *even) {
  uint8_t *odd = context_allocate_zeroed(context, s->component_count, 1);
  if (!odd)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t q = 0; q < s->quad_count; q++)
    odd[s->component_of_quad[q]] ^= 1;
  *even = memchr(odd, 1, s->component_count) == NULL;
  context_free(context, odd);
  return HEXCON_OK;
}

static hexcon_status report_bipartite(hexcon_context *context, const surface *s, bool *bipartite) {
  uint8_t *colours = context_allocate(context, s->point_count, 1);
  if (!colours)
    return HEXCON_OUT_OF_MEMORY;
  hexcon_status status = surface_colour(context, s, colours);
  context_free(context, colours);
  *bipartite = status == HEXCON_OK;
  if (status != HEXCON_NOT_BIPARTITE)
    return status;
  context_clear(context);
  return HEXCON_OK;
}

/** Of one body only the number of all quads counts; that of several bodies is told where every
 * shell has an even number. */
static hexcon_status report_fillable(hexcon_context *context, const surface *s,
                                     hexcon_surface_report *report) {
  const bool one_body = surface_body_count(s) == 1;
  odd_cycles found;
  if (s->quad_count % 2)
    report->fillable = HEXCON_FILLABLE_NO;
  if (s->quad_count % 2 || !(one_body || report->even))
    return HEXCON_OK;
  hexcon_status status = odd_cycles_find(context, s, &found);
  report->fillable = found.fillable;
  odd_cycles_free(context, &found);
  return status;
}

static hexcon_status report_loops(hexcon_context *context, const surface *s,
                                  hexcon_surface_report *report) {
  surface_loops loops;
  hexcon_status status = surface_find_loops(context, s, &loops);
  if (!status) {
    report->loop_count = loops.count;
    for (size_t i = 0; i < loops.count; i++)
      report->self_crossing_count += loops.self_crossings[i];
  }
  surface_loops_free(context, &loops);
  return status;
}

static hexcon_status report_geometry(hexcon_context *context, const surface *s,
                                     hexcon_surface_report *report) {
  report->oriented = !s->turned;
  report->volume = surface_volume(s);
  report->star_margin = -1;
  if (report->genus || report->component_count > 1)
    return HEXCON_OK;
  hexcon_status status = surface_star_center(context, s, report->star_center, &report->star_margin);
  report->star_shaped = report->star_margin > 0;
  report->convex = surface_is_convex(s);
  return status;
}

hexcon_status hexcon_check_surface(hexcon_context *context, const double *points,
                                   size_t point_count, const int32_t *quads, size_t quad_count,
                                   hexcon_surface_report *report) {
  context_clear(context);
  memset(report, 0, sizeof *report);
  surface s;
  hexcon_status status = surface_build(context, points, point_count, quads, quad_count, &s);
  if (!status) {
    report->quad_count = quad_count;
    report->point_count = point_count;
    report->edge_count = 2 * quad_count;
    report->component_count = s.component_count;
    report->cavity_count = s.cavity_count;
    report->euler = (int64_t)point_count - (int64_t)quad_count;
    report->genus = (int64_t)s.component_count - report->euler / 2;
    status = components_are_even(context, &s, &report->even);
  }
  if (!status)
    status = report_bipartite(context, &s, &report->bipartite);
  if (!status)
    status = report_fillable(context, &s, report);
  if (!status)
    status = report_loops(context, &s, report);
  if (!status)
    status = report_geometry(context, &s, report);
  surface_free(context, &s);
  return status;
}

hexcon_status hexcon_orient_surface(hexcon_context *context, const double *points,
                                    size_t point_count, int32_t *quads, size_t quad_count,
                                    size_t *body_count, size_t *cavity_count) {
  context_clear(context);
  surface s;
  hexcon_status status = surface_build_turning(context, points, point_count, quads, quad_count, &s);
  for (size_t q = 0; !status && q < quad_count; q++) {
    int32_t *quad = quads + 4 * q;
    if (quad[1] == s.quads[4 * q + 1])
      continue;
    for (int i = 0; i < 2; i++) {
      int32_t kept = quad[i];
      quad[i] = quad[3 - i];
      quad[3 - i] = kept;
    }
  }
  *body_count = surface_body_count(&s);
  *cavity_count = s.cavity_count;
  surface_free(context, &s);
  return status;
}

static hexcon_status copy_loops(hexcon_context *context, const surface_loops *from,
                                hexcon_loops *to) {
  size_t passages = from->offsets[from->count];
  to->count = from->count;
  to->offsets = context_allocate(context, from->count + 1, sizeof *to->offsets);
  to->quads = context_allocate(context, passages, sizeof *to->quads);
  to->self_crossings = context_allocate(context, from->count, sizeof *to->self_crossings);
  if (!to->offsets || !to->quads || !to->self_crossings)
    return HEXCON_OUT_OF_MEMORY;
  memcpy(to->offsets, from->offsets, (from->count + 1) * sizeof *to->offsets);
  memcpy(to->self_crossings, from->self_crossings, from->count * sizeof *to->self_crossings);
  for (size_t i = 0; i < passages; i++)
    to->quads[i] = half_edge_quad(from->entries[i]);
  return HEXCON_OK;
}

hexcon_status hexcon_surface_loops(hexcon_context *context, const int32_t *quads, size_t quad_count,
                                   hexcon_loops *loops) {
  context_clear(context);
  memset(loops, 0, sizeof *loops);
  surface s;
  surface_loops found = {0};
  size_t point_count = quad_count <= CONTEXT_MAX_COUNT / 4
                           ? surface_used_point_count(quads, quad_count)
                           : 0; /* too large, as surface_build finds */
  hexcon_status status = surface_build(context, NULL, point_count, quads, quad_count, &s);
  if (!status)
    status = surface_find_loops(context, &s, &found);
  if (!status)
    status = copy_loops(context, &found, loops);
  surface_loops_free(context, &found);
  surface_free(context, &s);
  if (status)
    hexcon_loops_free(context, loops);
  return status;
}

void hexcon_loops_free(hexcon_context *context, hexcon_loops *loops) {
  context_free(context, loops->offsets);
  context_free(context, loops->quads);
  context_free(context, loops->self_crossings);
  memset(loops, 0, sizeof *loops);
}

hexcon_status hexcon_surface_colouring(hexcon_context *context, const int32_t *quads,
                                       size_t quad_count, size_t point_count, uint8_t *colours) {
  context_clear(context);
  surface s;
  hexcon_status status = surface_build(context, NULL, point_count, quads, quad_count, &s);
  if (!status)
    status = surface_colour(context, &s, colours);
  surface_free(context, &s);
  return status;
}

static hexcon_status pair_by_shape(hexcon_context *context, const surface *s,
                                   int32_t *half_edge_of_quad) {
  double *weights = context_allocate(context, 4 * s->quad_count, sizeof *weights);
  if (!weights)
    return HEXCON_OUT_OF_MEMORY;
  surface_pair_weights(s, weights);
  hexcon_status status = surface_pair(context, s, weights, half_edge_of_quad);
  context_free(context, weights);
  return status;
}

static void list_pairs(const surface *s, const int32_t *half_edge_of_quad, int32_t *pairs) {
  for (size_t q = 0; q < s->quad_count; q++) {
    if (half_edge_of_quad[q] < 0)
      continue;
    int32_t partner = half_edge_quad(s->twins[half_edge_of_quad[q]]);
    if ((int32_t)q < partner) {
      *pairs++ = (int32_t)q;
      *pairs++ = partner;
    }
  }
}

hexcon_status hexcon_surface_pairing(hexcon_context *context, const double *points,
                                     size_t point_count, const int32_t *quads, size_t quad_count,
                                     int32_t *pairs) {
  context_clear(context);
  surface s;
  int32_t *half_edge_of_quad = NULL;
  hexcon_status status = surface_build(context, points, point_count, quads, quad_count, &s);
  if (!status) {
    half_edge_of_quad = context_allocate(context, quad_count, sizeof *half_edge_of_quad);
    status = half_edge_of_quad ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  }
  if (!status)
    status = points ? pair_by_shape(context, &s, half_edge_of_quad)
                    : surface_pair(context, &s, NULL, half_edge_of_quad);
  if (!status)
    list_pairs(&s, half_edge_of_quad, pairs);
  context_free(context, half_edge_of_quad);
  surface_free(context, &s);
  return status;
}

hexcon_status hexcon_surface_pairing_of_crossings(hexcon_context *context, size_t point_count,
                                                  const int32_t *quads, size_t quad_count,
                                                  int32_t *pairs, size_t *pair_count) {
  context_clear(context);
  *pair_count = 0;
  surface s;
  int32_t *half_edge_of_quad = NULL;
  hexcon_status status = surface_build(context, NULL, point_count, quads, quad_count, &s);
  if (!status) {
    half_edge_of_quad = context_allocate(context, quad_count, sizeof *half_edge_of_quad);
    status = half_edge_of_quad ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  }
  if (!status)
    status = surface_pair_crossings(context, &s, half_edge_of_quad, pair_count);
  if (!status)
    list_pairs(&s, half_edge_of_quad, pairs);
  else
    *pair_count = 0;
  context_free(context, half_edge_of_quad);
  surface_free(context, &s);
  return status;
}
