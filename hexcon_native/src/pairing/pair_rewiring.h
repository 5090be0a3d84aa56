/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * Loops of a surface of which some pairs are transitioned, kept up while pairs come and go.
 *
 * The six new quads of a pair need not be made. Of the passages through its two quads, the one
 * along both stays; the two across are cut and joined anew, each half of the one with the half of
 * the other on its side of the edge between. The loop inside the six crosses nothing but these
 * three, once in each quad: so only quads without a partner can be self-crossed.
 */
#ifndef HEXCON_PAIRING_PAIR_REWIRING_H
#define HEXCON_PAIRING_PAIR_REWIRING_H

#include "pair_state.h"

/** What is known of a half-edge: those of a quad fill one line of the cache. */
typedef struct pair_side {
  int32_t twin;
  int32_t link;  /* what enters by this half-edge leaves by that one */
  int32_t loop;  /* that enters or leaves by it */
  uint32_t walk; /* the last one along the loop */
} pair_side;

typedef struct pair_rewiring {
  hexcon_context *context;
  size_t quad_count;
  int32_t *half_edges;     /* [quad_count] towards the partner, or PAIR_FREE */
  pair_side *sides;        /* [4 * quad_count] */
  int32_t *self_crossings; /* [2 * quad_count] by loop */
  int32_t *unused;         /* [2 * quad_count] numbers that no loop has */
  size_t unused_count;
  uint32_t last_walk;
  int32_t *crossed;   /* [quad_count] the self-crossed quads, and some that were */
  uint8_t *is_listed; /* [quad_count] among these */
  size_t crossed_count;
  size_t pair_count, crossing_count;
  uint64_t work; /* passages walked */
  uint64_t told; /* the work when progress was told */
} pair_rewiring;

/** Two pairs broken and one made change three times four half-edges' links. */
enum { PAIR_CHANGED_LINKS = 12 };

/** A pair made or broken. */
typedef struct pair_change {
  int32_t half_edge;                     /* between the two quads */
  int32_t before[2];                     /* half_edges of the two, as they were */
  int32_t changed[PAIR_CHANGED_LINKS];   /* half-edges whose links are others now */
  int32_t starts[PAIR_CHANGED_LINKS];    /* a half-edge of each new loop */
  int32_t crossings[PAIR_CHANGED_LINKS]; /* self-crossings of each new loop */
  int changed_count, loop_count;
  int more_pairs, more_crossings;
  int more_odd; /* loops of an odd number of self-crossings */
} pair_change;

/** @param r  free with pair_rewiring_free, also after OUT_OF_MEMORY; then set the pairs */
hexcon_status pair_rewiring_create(hexcon_context *context, const surface *s, pair_rewiring *r);
void pair_rewiring_free(pair_rewiring *r);

/** Begin from these pairs, or from none. Linear. @param half_edge_of_quad NULL: no pairs */
void pair_rewiring_set(pair_rewiring *r, const int32_t *half_edge_of_quad);

/**
 * Break the pair at a half-edge, or make it and break those that its quads were in. The loops are
 * brought up to date by pair_rewiring_accept only; pair_rewiring_reject undoes the links. One or
 * the other must follow. Cost: the length of the loops that change.
 */
void pair_rewiring_try(pair_rewiring *r, int32_t half_edge, pair_change *change);
void pair_rewiring_accept(pair_rewiring *r, const pair_change *change);
void pair_rewiring_reject(pair_rewiring *r, const pair_change *change);

/** A self-crossed quad at random; PAIR_FREE if there is none. Cost: constant but for quads that
 * were self-crossed since the last call.
 * @param random  any bits */
int32_t pair_rewiring_crossed_quad(pair_rewiring *r, uint64_t random);

#endif
