/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "cut_body.h"

#include <string.h>

#include "homology/edge_labels.h"
#include "homology/linking_numbers.h"
#include "shape/place/disc_placement.h"

void cut_body_free(hexcon_context *context, cut_body *body) {
  surface_free(context, &body->s);
  context_free(context, body->points);
  context_free(context, body->labels);
  context_free(context, body->hexes);
  memset(body, 0, sizeof *body);
}

/** @param s  with its counts */
static hexcon_status allocate(hexcon_context *context, size_t point_count, size_t quad_count,
                              size_t hex_count, cut_body *out) {
  surface *s = &out->s;
  *out = (cut_body){.hex_count = hex_count};
  s->point_count = point_count;
  s->quad_count = quad_count;
  s->quads = context_allocate(context, quad_count, 4 * sizeof *s->quads);
  s->twins = context_allocate(context, quad_count, 4 * sizeof *s->twins);
  s->component_of_quad = context_allocate(context, quad_count, sizeof *s->component_of_quad);
  out->points = context_allocate(context, point_count, 3 * sizeof *out->points);
  out->labels = context_allocate_zeroed(context, quad_count, 4 * sizeof *out->labels);
  out->hexes = context_allocate(context, hex_count, 8 * sizeof *out->hexes);
  s->points = out->points;
  return s->quads && s->twins && s->component_of_quad && out->points && out->labels && out->hexes
             ? HEXCON_OK
             : HEXCON_OUT_OF_MEMORY;
}

static hexcon_status label(hexcon_context *context, const surface *s, uint64_t *labels) {
  handle_cycles cycles;
  bit_matrix linking;
  bool known = false;
  hexcon_status status = linked_cycles_find(context, s, &cycles, &linking, &known);
  if (!status && known)
    edge_labels_write(s, &cycles, &linking, labels);
  bit_matrix_free(context, &linking);
  handle_cycles_free(context, &cycles);
  return status;
}

hexcon_status cut_body_begin(hexcon_context *context, const surface *s, cut_body *out) {
  hexcon_status status = allocate(context, s->point_count, s->quad_count, 0, out);
  if (status)
    return status;
  memcpy(out->points, s->points, 3 * s->point_count * sizeof *out->points);
  memcpy(out->s.quads, s->quads, 4 * s->quad_count * sizeof *s->quads);
  memcpy(out->s.twins, s->twins, 4 * s->quad_count * sizeof *s->twins);
  memcpy(out->s.component_of_quad, s->component_of_quad,
         s->quad_count * sizeof *s->component_of_quad);
  out->s.component_count = s->component_count;
  return label(context, s, out->labels);
}

/* ----------------------------------------------------------------------------------------- labels
 */

/** A rail bounds inside, so labels inside its disc are differences of a function on its corners. */
static void label_rim(const cut_body *body, const int32_t *ring, size_t rim_count,
                      uint64_t *potentials) {
  uint64_t sum = 0;
  for (size_t i = 0; i < rim_count; i++) {
    potentials[i] = sum;
    sum ^= body->labels[half_edge_turn(ring[i], -1)]; /* of the left rail */
  }
}

/** In the order of handle_cut_write_quads. */
static void write_labels(const cut_body *body, const placed_cut *cut, const uint8_t *in_ring,
                         const uint64_t *potentials, uint64_t *labels) {
  for (size_t q = 0; q < body->s.quad_count; q++)
    if (!in_ring[q]) {
      memcpy(labels, body->labels + 4 * q, 4 * sizeof *labels);
      labels += 4;
    }
  const size_t corners = 4 * cut->disc.quad_count;
  for (size_t i = 0; i < corners; i++) {
    const size_t next = (i & ~(size_t)3) | ((i + 1) & 3), quad = i & ~(size_t)3;
    uint64_t here = potentials[cut->disc.quads[i]] ^ potentials[cut->disc.quads[next]];
    labels[quad | (3 - (i & 3))] = here; /* reversed: the side after corner -i is that before i */
    labels[corners + i] = here;
  }
}

/* ---------------------------------------------------------------------------------------- cutting
 */

static void write_points(const cut_body *body, const placed_cut *cut, double *points) {
  const size_t rim = cut->disc.rim_count, inner = cut->disc.point_count - rim;
  memcpy(points, body->points, 3 * body->s.point_count * sizeof *points);
  points += 3 * body->s.point_count;
  for (int side = 0; side < 2; side++, points += 3 * inner)
    memcpy(points, cut->sides[side] + 3 * rim, 3 * inner * sizeof *points);
}

/** Connect what is left. @return whether that is a proper surface of one handle less */
static hexcon_status connect(hexcon_context *context, const cut_body *before, cut_body *out,
                             bool *proper) {
  hexcon_status status = surface_connect(context, &out->s, false);
  bool faulty = status == HEXCON_NON_MANIFOLD_EDGE || status == HEXCON_NON_MANIFOLD_VERTEX ||
                status == HEXCON_NOT_CLOSED || status == HEXCON_NOT_ORIENTABLE ||
                status == HEXCON_INCONSISTENT_ORIENTATION;
  if (faulty)
    context_clear(context);
  *proper = !status && out->s.component_count == 1 &&
            body_handle_count(&out->s) + 1 == body_handle_count(&before->s);
  return faulty ? HEXCON_OK : status;
}

static hexcon_status write(hexcon_context *context, const cut_body *body, const int32_t *ring,
                           const placed_cut *cut, cut_body *out) {
  const handle_cut topology = {ring, &cut->disc, body->s.point_count};
  uint8_t *in_ring = context_allocate_zeroed(context, body->s.quad_count, sizeof *in_ring);
  uint64_t *potentials =
      context_allocate_zeroed(context, cut->disc.point_count, sizeof *potentials);
  hexcon_status status = in_ring && potentials ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  if (!status)
    status = allocate(context, body->s.point_count + handle_cut_points(&topology),
                      handle_cut_quads(&body->s, &topology), body->hex_count + cut->disc.quad_count,
                      out);
  if (!status) {
    for (size_t i = 0; i < cut->disc.rim_count; i++)
      in_ring[half_edge_quad(ring[i])] = 1;
    label_rim(body, ring, cut->disc.rim_count, potentials);
    handle_cut_write_quads(&body->s, &topology, in_ring, out->s.quads);
    write_labels(body, cut, in_ring, potentials, out->labels);
    memcpy(out->hexes, body->hexes, 8 * body->hex_count * sizeof *out->hexes);
    handle_cut_write_hexes(&body->s, &topology, out->hexes + 8 * body->hex_count);
    write_points(body, cut, out->points);
    out->cut_count = body->cut_count + 1;
  }
  context_free(context, in_ring);
  context_free(context, potentials);
  return status;
}

hexcon_status cut_body_cut(hexcon_context *context, const cut_body *body, const int32_t *ring,
                           const placed_cut *cut, cut_body *out) {
  *out = (cut_body){0};
  const size_t most = CONTEXT_MAX_COUNT / 8; /* as for any surface: half-edges have ids */
  if (body->s.quad_count + 2 * cut->disc.quad_count >= most ||
      body->s.point_count + 2 * cut->disc.point_count >= most)
    return context_fail(context, HEXCON_TOO_LARGE, "the cut body has too many quads");
  bool proper = false;
  hexcon_status status = write(context, body, ring, cut, out);
  if (!status)
    status = connect(context, body, out, &proper);
  if (!status && !proper)
    cut_body_free(context, out);
  return status;
}

/* -------------------------------------------------------------------------------------- placement
 */

hexcon_status placed_cut_new(hexcon_context *context, const surface *s, const int32_t *ring,
                             const disc_shape *shape, placed_cut *out) {
  *out = (placed_cut){0};
  hexcon_status status = disc_pattern_build(context, shape, &out->disc);
  const disc_pattern *disc = &out->disc;
  for (int side = 0; !status && side < 2; side++) {
    double *points = context_allocate(context, disc->point_count, 3 * sizeof *points);
    out->sides[side] = points;
    if (!points)
      return HEXCON_OUT_OF_MEMORY;
    for (size_t i = 0; i < disc->rim_count; i++) {
      int32_t v = side == CUT_LEFT ? half_edge_start(s, ring[i]) : half_edge_end(s, ring[i]);
      memcpy(points + 3 * i, s->points + 3 * (size_t)v, 3 * sizeof *points);
    }
    status = disc_place(context, disc->quads, disc->quad_count, disc->rim_count, disc->point_count,
                        points);
  }
  return status;
}

void placed_cut_free(hexcon_context *context, placed_cut *cut) {
  disc_pattern_free(context, &cut->disc);
  context_free(context, cut->sides[0]);
  context_free(context, cut->sides[1]);
  *cut = (placed_cut){0};
}
