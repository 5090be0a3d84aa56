/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** A pairing in the making, shared by its stages. */
#ifndef HEXCON_PAIRING_PAIR_STATE_H
#define HEXCON_PAIRING_PAIR_STATE_H

#include "surface/half_edges.h"

enum { PAIR_FREE = -1 };

typedef struct pair_state {
  hexcon_context *context;
  const surface *s;
  const double *weights; /* NULL: all equal */
  int32_t *half_edges;   /* [quad_count] towards the partner, or PAIR_FREE */
  size_t work;           /* quads looked at since progress was told */
} pair_state;

/** Quads looked at between two calls of progress: some milliseconds. */
enum { PAIR_PATIENCE = 1 << 16 };

/** The quad on the other side of a half-edge. */
static inline int32_t pair_across(const pair_state *p, int32_t half_edge) {
  return half_edge_quad(p->s->twins[half_edge]);
}

/** The partner of a quad, or PAIR_FREE. */
static inline int32_t pair_partner(const pair_state *p, int32_t quad) {
  return p->half_edges[quad] == PAIR_FREE ? PAIR_FREE : pair_across(p, p->half_edges[quad]);
}

/** Pair the quads at a half-edge; their old partners are left to the caller. */
static inline void pair_join(pair_state *p, int32_t half_edge) {
  int32_t twin = p->s->twins[half_edge];
  p->half_edges[half_edge_quad(half_edge)] = half_edge;
  p->half_edges[half_edge_quad(twin)] = twin;
}

/** Count quads looked at; now and then tell progress and ask whether to go on. */
static inline hexcon_status pair_count_work(pair_state *p, size_t work, double fraction) {
  p->work += work;
  if (p->work < PAIR_PATIENCE)
    return HEXCON_OK;
  p->work = 0;
  return context_progress(p->context, STAGE_PAIRING, fraction);
}

#endif
