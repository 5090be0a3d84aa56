/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "short_cycle.h"

#include <string.h>

hexcon_status short_cycle_new(hexcon_context *context, const surface *s, const uint64_t *labels,
                              short_cycle_search *out) {
  *out = (short_cycle_search){
      .s = s,
      .labels = labels,
      .half_edge_of_point =
          context_allocate(context, s->point_count, sizeof *out->half_edge_of_point),
      .depth = context_allocate(context, s->point_count, sizeof *out->depth),
      .reached_by = context_allocate(context, s->point_count, sizeof *out->reached_by),
      .queue = context_allocate(context, s->point_count, sizeof *out->queue),
      .sums = context_allocate(context, s->point_count, sizeof *out->sums)};
  if (!out->half_edge_of_point || !out->depth || !out->reached_by || !out->queue || !out->sums)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t h = 0; h < 4 * s->quad_count; h++)
    out->half_edge_of_point[s->quads[h]] = (int32_t)h;
  return HEXCON_OK;
}

void short_cycle_free(hexcon_context *context, short_cycle_search *search) {
  context_free(context, search->half_edge_of_point);
  context_free(context, search->depth);
  context_free(context, search->reached_by);
  context_free(context, search->queue);
  context_free(context, search->sums);
  *search = (short_cycle_search){0};
}

/** Up both branches of the tree to where they meet. */
static size_t write_cycle(const short_cycle_search *w, int32_t half_edge, int32_t *cycle) {
  int32_t a = half_edge_start(w->s, half_edge), b = half_edge_end(w->s, half_edge);
  size_t front = 0, back = (size_t)(w->depth[a] + w->depth[b]) + 1;
  const size_t room = back;
  while (a != b)
    if (w->depth[a] >= w->depth[b]) {
      cycle[front++] = a;
      a = half_edge_start(w->s, w->reached_by[a]);
    } else {
      cycle[--back] = b;
      b = half_edge_start(w->s, w->reached_by[b]);
    }
  cycle[front++] = a;
  memmove(cycle + front, cycle + back, (room - back) * sizeof *cycle);
  return front + room - back;
}

/** Look at the edges of a point: reach others, or close cycles. */
static void look_around(short_cycle_search *w, int32_t point, size_t *tail, size_t *shortest,
                        int32_t *closing) {
  int32_t start = w->half_edge_of_point[point], h = start;
  do {
    const int32_t other = half_edge_end(w->s, h);
    const uint64_t sum = w->sums[point] ^ w->labels[h];
    if (w->depth[other] < 0) {
      w->depth[other] = w->depth[point] + 1;
      w->reached_by[other] = h;
      w->sums[other] = sum;
      w->queue[(*tail)++] = other;
    } else if (w->depth[other] == w->depth[point] && w->sums[other] == sum &&
               2 * (size_t)w->depth[point] + 1 < *shortest) {
      *shortest = 2 * (size_t)w->depth[point] + 1; /* an odd cycle's two branches are as deep */
      *closing = h;
    }
    h = w->s->twins[half_edge_turn(h, -1)];
  } while (h != start);
}

size_t short_cycle_find(short_cycle_search *search, int32_t root, size_t most, int32_t *cycle) {
  short_cycle_search *w = search;
  size_t head = 0, tail = 0, shortest = most;
  int32_t closing = -1;
  memset(w->depth, -1, w->s->point_count * sizeof *w->depth);
  w->depth[root] = 0;
  w->reached_by[root] = -1;
  w->sums[root] = 0;
  w->queue[tail++] = root;
  while (head < tail && 2 * (size_t)w->depth[w->queue[head]] + 1 < shortest)
    look_around(w, w->queue[head++], &tail, &shortest, &closing);
  return closing < 0 ? 0 : write_cycle(w, closing, cycle);
}
