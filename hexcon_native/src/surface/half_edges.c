/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "half_edges.h"

#include <string.h>

size_t surface_used_point_count(const int32_t *quads, size_t quad_count) {
  int32_t largest = -1;
  for (size_t i = 0; i < 4 * quad_count; i++)
    largest = quads[i] > largest ? quads[i] : largest;
  return (size_t)((int64_t)largest + 1);
}

void surface_free(hexcon_context *context, surface *s) {
  context_free(context, s->quads);
  context_free(context, s->twins);
  context_free(context, s->component_of_quad);
  context_free(context, s->is_cavity);
  memset(s, 0, sizeof *s);
}

static int32_t edge_low(const int32_t *quads, int32_t h) {
  int32_t a = quads[h], b = quads[half_edge_turn(h, 1)];
  return a < b ? a : b;
}

static int32_t edge_high(const int32_t *quads, int32_t h) {
  int32_t a = quads[h], b = quads[half_edge_turn(h, 1)];
  return a < b ? b : a;
}

/** One stable counting-sort pass of half-edge ids by one end of their edges. */
static hexcon_status sort_pass(hexcon_context *context, const int32_t *quads, size_t count,
                               int32_t (*end)(const int32_t *, int32_t), const int32_t *in,
                               int32_t *out, size_t *starts, size_t point_count) {
  hexcon_status status = HEXCON_OK;
  memset(starts, 0, (point_count + 1) * sizeof *starts);
  for (size_t i = 0; i < count; i++)
    starts[(size_t)end(quads, in[i]) + 1]++;
  for (size_t v = 0; v < point_count; v++)
    starts[v + 1] += starts[v];
  for (size_t i = 0; !status && i < count; i++) {
    out[starts[end(quads, in[i])]++] = in[i];
    status = context_pass(context, i);
  }
  return status;
}

/** Half-edges ordered by (higher, lower) end, so that those of one edge are neighbours. Linear. */
static hexcon_status sort_half_edges(hexcon_context *context, const surface *s, int32_t *sorted) {
  size_t count = 4 * s->quad_count;
  size_t *starts = context_allocate(context, s->point_count + 1, sizeof *starts);
  int32_t *scratch = context_allocate(context, count, sizeof *scratch);
  hexcon_status status = starts && scratch ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  if (!status) {
    for (size_t h = 0; h < count; h++)
      sorted[h] = (int32_t)h;
    status = sort_pass(context, s->quads, count, edge_low, sorted, scratch, starts, s->point_count);
  }
  if (!status)
    status =
        sort_pass(context, s->quads, count, edge_high, scratch, sorted, starts, s->point_count);
  context_free(context, starts);
  context_free(context, scratch);
  return status;
}

static bool same_edge(const int32_t *quads, int32_t g, int32_t h) {
  return edge_low(quads, g) == edge_low(quads, h) && edge_high(quads, g) == edge_high(quads, h);
}

/** Pair the half-edges of every edge; faults where an edge has not exactly two. */
static hexcon_status match_twins(hexcon_context *context, surface *s, const int32_t *sorted) {
  size_t count = 4 * s->quad_count, open_edges = 0, crowded_edges = 0, first = 0;
  for (size_t pass = 0; pass < 2 && open_edges == 0 && crowded_edges == 0; pass++)
    for (first = 0; first < count;) {
      size_t last = first + 1;
      hexcon_status status = context_pass(context, first / 2);
      if (status)
        return status;
      while (last < count && same_edge(s->quads, sorted[first], sorted[last]))
        last++;
      crowded_edges += pass == 0 && last - first > 2;
      open_edges += pass == 1 && last - first < 2;
      if ((pass == 0 && last - first > 2) || (pass == 1 && last - first < 2))
        for (size_t i = first; i < last; i++)
          context_add_element(context, half_edge_quad(sorted[i]));
      if (last - first == 2) {
        s->twins[sorted[first]] = sorted[first + 1];
        s->twins[sorted[first + 1]] = sorted[first];
      }
      first = last;
    }
  if (crowded_edges)
    return context_fail(context, HEXCON_NON_MANIFOLD_EDGE,
                        "%zu edges have more than two quads (quads listed); remove duplicate quads "
                        "or split the surface there",
                        crowded_edges);
  if (open_edges)
    return context_fail(context, HEXCON_NOT_CLOSED,
                        "the surface is not closed: %zu edges have one quad only (quads listed); "
                        "close the holes or merge coincident points",
                        open_edges);
  return HEXCON_OK;
}

/** True if the two quads at an edge run along it in the same direction: one must be flipped. */
static bool runs_against(const surface *s, int32_t h) {
  return s->quads[h] == s->quads[s->twins[h]];
}

typedef struct orientation {
  uint8_t *flipped; /* [quad_count] relative to the first quad of the component */
  int32_t *queue;   /* [quad_count] quads in breadth-first order */
} orientation;

/** Breadth-first from one quad: component number and parity of flips for all it reaches. */
static hexcon_status orient_component(hexcon_context *context, surface *s, orientation *o,
                                      int32_t seed, size_t *reached, size_t *flip_count) {
  size_t head = 0, tail = 0;
  o->queue[tail++] = seed;
  s->component_of_quad[seed] = (int32_t)s->component_count;
  *flip_count = 0;
  while (head < tail) {
    int32_t quad = o->queue[head++];
    hexcon_status status = context_pass(context, head);
    if (status)
      return status;
    for (int side = 0; side < 4; side++) {
      int32_t h = 4 * quad + side, other = half_edge_quad(s->twins[h]);
      uint8_t flip = o->flipped[quad] ^ (uint8_t)runs_against(s, h);
      if (s->component_of_quad[other] < 0) {
        s->component_of_quad[other] = (int32_t)s->component_count;
        o->flipped[other] = flip;
        *flip_count += flip;
        o->queue[tail++] = other;
      } else if (o->flipped[other] != flip) {
        context_add_element(context, quad);
        context_add_element(context, other);
        return context_fail(context, HEXCON_NOT_ORIENTABLE,
                            "the surface is one-sided: quads %d and %d cannot be oriented alike; a "
                            "solid's surface has an inside and an outside",
                            quad, other);
      }
    }
  }
  *reached = tail;
  return HEXCON_OK;
}

/** Turn the flipped quads, keeping their first corners, and the adjacency with them. */
static void turn_flipped(surface *s, const uint8_t *flipped) {
  for (size_t q = 0; q < s->quad_count; q++)
    if (flipped[q])
      half_edge_reverse(s->quads + 4 * q, s->twins + 4 * q);
  for (size_t h = 0; h < 4 * s->quad_count; h++)
    if (flipped[half_edge_quad(s->twins[h])])
      s->twins[h] = (s->twins[h] & ~3) | (3 - (s->twins[h] & 3));
}

/** Number the components; flipped becomes: oriented against most of the component. These are
 * listed. */
static hexcon_status orient_components(hexcon_context *context, surface *s, orientation *o,
                                       size_t *wrong) {
  for (size_t q = 0; q < s->quad_count; q++)
    s->component_of_quad[q] = -1;
  for (size_t q = 0; q < s->quad_count; q++) {
    if (s->component_of_quad[q] >= 0)
      continue;
    size_t reached = 0, flips = 0;
    hexcon_status status = orient_component(context, s, o, (int32_t)q, &reached, &flips);
    if (status)
      return status;
    uint8_t minority = 2 * flips <= reached;
    for (size_t i = 0; i < reached; i++) {
      uint8_t *flipped = &o->flipped[o->queue[i]];
      *flipped = flips && *flipped == minority;
      if (*flipped) {
        context_add_element(context, o->queue[i]);
        ++*wrong;
      }
    }
    s->component_count++;
  }
  return HEXCON_OK;
}

static hexcon_status check_orientation(hexcon_context *context, surface *s, bool turning) {
  size_t wrong = 0;
  orientation o = {context_allocate_zeroed(context, s->quad_count, sizeof *o.flipped),
                   context_allocate(context, s->quad_count, sizeof *o.queue)};
  hexcon_status status =
      o.flipped && o.queue ? orient_components(context, s, &o, &wrong) : HEXCON_OUT_OF_MEMORY;
  if (!status && wrong && !turning)
    status = context_fail(context, HEXCON_INCONSISTENT_ORIENTATION,
                          "%zu quads are oriented against their neighbours (listed); reverse the "
                          "order of their corners",
                          wrong);
  if (!status && wrong) {
    context_clear(context);
    turn_flipped(s, o.flipped);
  }
  context_free(context, o.flipped);
  context_free(context, o.queue);
  return status;
}

/** Quads of every point must form one fan: walk it and compare with the number of corners. */
static hexcon_status check_vertices(hexcon_context *context, const surface *s) {
  uint8_t *walked = context_allocate_zeroed(context, 4 * s->quad_count, 1);
  uint8_t *has_fan = context_allocate_zeroed(context, s->point_count, 1);
  size_t bad = 0;
  hexcon_status status = HEXCON_OK;
  for (size_t h = 0; !status && walked && has_fan && h < 4 * s->quad_count; h++) {
    status = context_pass(context, h);
    if (walked[h])
      continue;
    int32_t v = s->quads[h], g = (int32_t)h;
    do {
      walked[g] = 1;
      g = s->twins[half_edge_turn(g, -1)];
    } while (g != (int32_t)h);
    if (has_fan[v] == 1) {
      context_add_element(context, v);
      bad++;
    }
    has_fan[v] = has_fan[v] ? 2 : 1;
  }
  bool complete = walked && has_fan;
  context_free(context, walked);
  context_free(context, has_fan);
  if (!complete)
    return HEXCON_OUT_OF_MEMORY;
  if (status)
    return status;
  if (bad)
    return context_fail(context, HEXCON_NON_MANIFOLD_VERTEX,
                        "%zu points join parts of the surface that share no edge there (points "
                        "listed); give each part its own point",
                        bad);
  return HEXCON_OK;
}

void half_edge_reverse(int32_t quad[4], int32_t twins[4]) {
  int32_t kept = quad[1];
  quad[1] = quad[3];
  quad[3] = kept;
  kept = twins[0];
  twins[0] = twins[3];
  twins[3] = kept;
  kept = twins[1];
  twins[1] = twins[2];
  twins[2] = kept;
}

hexcon_status surface_connect(hexcon_context *context, surface *s, bool turning) {
  int32_t *sorted = context_allocate(context, 4 * s->quad_count, sizeof *sorted);
  hexcon_status status = sorted ? sort_half_edges(context, s, sorted) : HEXCON_OUT_OF_MEMORY;
  if (!status)
    status = match_twins(context, s, sorted);
  context_free(context, sorted);
  if (!status)
    status = context_after(context, s->quad_count);
  if (!status)
    status = check_orientation(context, s, turning);
  if (!status)
    status = context_after(context, s->quad_count);
  if (!status)
    status = check_vertices(context, s);
  return status ? status : context_after(context, s->quad_count);
}
