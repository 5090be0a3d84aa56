/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "pair_augment.h"

#include <string.h>

/** EVEN: an alternating path of even length leads from the root to the quad; ODD: none is known but
 * one of odd length. DEAD: in a tree that found no free quad; no augmenting path ever enters it
 * again, whatever is paired elsewhere. */
enum { UNSEEN, EVEN, ODD, DEAD };

typedef struct forest {
  pair_state *p;
  uint8_t *labels;
  int32_t *back;    /* [quad_count] of quads that do not lead back across their pair: the half-edge
                       towards the root */
  int32_t *bases;   /* [quad_count] union-find: the quad of a blossom that is nearest to the root */
  int32_t *marks;   /* [quad_count] the last walk to the root that passed a base */
  int32_t walks;    /* of this search */
  int32_t *queue;   /* [quad_count] even quads to look around from */
  int32_t *visited; /* [quad_count] */
  size_t tail, visited_count;
} forest;

/** Halving paths keeps it near-constant without a rank. */
static int32_t base_of(forest *f, int32_t quad) {
  int32_t *bases = f->bases;
  while (bases[quad] != quad) {
    bases[quad] = bases[bases[quad]];
    quad = bases[quad];
  }
  return quad;
}

static void visit(forest *f, int32_t quad, uint8_t label) {
  f->labels[quad] = label;
  f->visited[f->visited_count++] = quad;
  if (label == EVEN)
    f->queue[f->tail++] = quad;
}

/** Two steps from an even quad towards the root; PAIR_FREE at the root. */
static int32_t grandparent(const forest *f, int32_t quad) {
  int32_t partner = pair_partner(f->p, quad);
  return partner == PAIR_FREE ? PAIR_FREE : pair_across(f->p, f->back[partner]);
}

/** The base where the ways of two even quads to the root meet: walk both in turn. */
static int32_t meeting(forest *f, int32_t a, int32_t b) {
  f->walks++;
  for (;;) {
    if (a != PAIR_FREE) {
      a = base_of(f, a);
      if (f->marks[a] == f->walks)
        return a;
      f->marks[a] = f->walks;
      a = grandparent(f, a);
    }
    int32_t swapped = a;
    a = b;
    b = swapped;
  }
}

/** Put one side of a new blossom into it, from the quad of a half-edge up to the base: what was odd
 * there is even now, round the other way. */
static void shrink(forest *f, int32_t half_edge, int32_t base) {
  int32_t quad = half_edge_quad(half_edge);
  while (base_of(f, quad) != base) {
    int32_t partner = pair_partner(f->p, quad);
    f->back[quad] = half_edge;
    if (f->labels[partner] == ODD) {
      f->labels[partner] = EVEN;
      f->queue[f->tail++] = partner;
    }
    if (f->bases[quad] == quad)
      f->bases[quad] = base;
    if (f->bases[partner] == partner)
      f->bases[partner] = base;
    half_edge = f->p->s->twins[f->back[partner]];
    quad = half_edge_quad(half_edge);
  }
}

/** Pair along the path from a free quad back to the root. */
static void turn_path(forest *f, int32_t quad) {
  while (quad != PAIR_FREE) {
    int32_t h = f->back[quad], next = pair_partner(f->p, pair_across(f->p, h));
    pair_join(f->p, h);
    quad = next;
  }
}

/** Look across one half-edge of an even quad; true if that paired the root. */
static bool look_across(forest *f, int32_t half_edge) {
  int32_t quad = half_edge_quad(half_edge), other = pair_across(f->p, half_edge);
  int32_t twin = f->p->s->twins[half_edge];
  switch (f->labels[other]) {
  case UNSEEN:
    visit(f, other, ODD);
    f->back[other] = twin;
    if (f->p->half_edges[other] == PAIR_FREE) {
      turn_path(f, other);
      return true;
    }
    visit(f, pair_partner(f->p, other), EVEN);
    return false;
  case EVEN:
    if (base_of(f, quad) != base_of(f, other)) {
      int32_t base = meeting(f, quad, other);
      shrink(f, half_edge, base);
      shrink(f, twin, base);
    }
    return false;
  default:
    return false;
  }
}

/** Grow a tree of alternating paths from a free quad, until one ends at another free quad. */
static bool search(forest *f, int32_t root) {
  f->tail = f->visited_count = 0;
  f->walks = 0;
  visit(f, root, EVEN);
  for (size_t head = 0; head < f->tail; head++) {
    int32_t h = 4 * f->queue[head];
    for (int side = 0; side < 4; side++)
      if (look_across(f, h + side))
        return true;
  }
  return false;
}

/** Make the arrays as they were before a search. */
static void forget(forest *f, bool found) {
  for (size_t i = 0; i < f->visited_count; i++) {
    int32_t quad = f->visited[i];
    f->labels[quad] = found ? UNSEEN : DEAD;
    f->bases[quad] = quad;
    f->marks[quad] = 0;
  }
}

static hexcon_status search_all(forest *f) {
  size_t count = f->p->s->quad_count;
  hexcon_status status = HEXCON_OK;
  for (size_t q = 0; q < count; q++)
    f->bases[q] = (int32_t)q;
  for (size_t q = 0; !status && q < count; q++) {
    if (f->p->half_edges[q] != PAIR_FREE || f->labels[q] == DEAD)
      continue;
    forget(f, search(f, (int32_t)q));
    status = pair_count_work(f->p, f->visited_count, 0.2 * (double)q / (double)count);
  }
  return status;
}

hexcon_status pair_augment(pair_state *p) {
  size_t count = p->s->quad_count;
  forest f = {.p = p,
              .labels = context_allocate_zeroed(p->context, count, 1),
              .back = context_allocate(p->context, count, sizeof *f.back),
              .bases = context_allocate(p->context, count, sizeof *f.bases),
              .marks = context_allocate_zeroed(p->context, count, sizeof *f.marks),
              .queue = context_allocate(p->context, count, sizeof *f.queue),
              .visited = context_allocate(p->context, count, sizeof *f.visited)};
  bool complete = f.labels && f.back && f.bases && f.marks && f.queue && f.visited;
  hexcon_status status = complete ? search_all(&f) : HEXCON_OUT_OF_MEMORY;
  context_free(p->context, f.labels);
  context_free(p->context, f.back);
  context_free(p->context, f.bases);
  context_free(p->context, f.marks);
  context_free(p->context, f.queue);
  context_free(p->context, f.visited);
  return status;
}
