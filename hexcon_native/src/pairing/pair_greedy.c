/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "pair_greedy.h"

/** The number by which both sides know their edge. */
static int32_t edge_of(const pair_state *p, int32_t half_edge) {
  int32_t twin = p->s->twins[half_edge];
  return half_edge < twin ? half_edge : twin;
}

static bool comes_before(const pair_state *p, int32_t a, int32_t b) {
  if (p->weights && p->weights[a] != p->weights[b])
    return p->weights[a] > p->weights[b];
  return edge_of(p, a) < edge_of(p, b);
}

/** The first half-edge of a quad to a free one; PAIR_FREE if there is none. */
static int32_t favourite(const pair_state *p, int32_t quad) {
  int32_t best = PAIR_FREE;
  for (int32_t h = 4 * quad; h < 4 * quad + 4; h++) {
    int32_t other = pair_across(p, h);
    if (other != quad && p->half_edges[other] == PAIR_FREE &&
        (best == PAIR_FREE || comes_before(p, h, best)))
      best = h;
  }
  return best;
}

/** Pair a quad with its favourite if that is mutual; pairs are queued by one of their quads. */
static void propose(pair_state *p, int32_t *favourites, int32_t quad, int32_t *queue,
                    size_t *tail) {
  int32_t h = favourites[quad] = favourite(p, quad);
  if (h == PAIR_FREE || favourites[pair_across(p, h)] != p->s->twins[h])
    return;
  pair_join(p, h);
  queue[(*tail)++] = quad;
}

/** The free neighbours of a quad just paired look for other favourites. */
static void disappoint(pair_state *p, int32_t *favourites, int32_t quad, int32_t *queue,
                       size_t *tail) {
  for (int32_t h = 4 * quad; h < 4 * quad + 4; h++) {
    int32_t other = pair_across(p, h);
    if (p->half_edges[other] == PAIR_FREE && favourites[other] == p->s->twins[h])
      propose(p, favourites, other, queue, tail);
  }
}

static hexcon_status run(pair_state *p, int32_t *favourites, int32_t *queue) {
  size_t head = 0, tail = 0;
  for (size_t q = 0; q < p->s->quad_count; q++)
    favourites[q] = PAIR_FREE;
  hexcon_status status = HEXCON_OK;
  for (size_t q = 0; !status && q < p->s->quad_count; q++) {
    if (p->half_edges[q] == PAIR_FREE)
      propose(p, favourites, (int32_t)q, queue, &tail);
    while (head < tail) {
      int32_t quad = queue[head++];
      disappoint(p, favourites, quad, queue, &tail);
      disappoint(p, favourites, pair_partner(p, quad), queue, &tail);
    }
    status = pair_count_work(p, 1, 0);
  }
  return status;
}

hexcon_status pair_greedily(pair_state *p) {
  int32_t *favourites = context_allocate(p->context, p->s->quad_count, sizeof *favourites);
  int32_t *queue = context_allocate(p->context, p->s->quad_count, sizeof *queue);
  hexcon_status status = favourites && queue ? run(p, favourites, queue) : HEXCON_OUT_OF_MEMORY;
  context_free(p->context, favourites);
  context_free(p->context, queue);
  return status;
}
