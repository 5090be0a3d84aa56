/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * A cycle is searched for from one of its pairs: taken apart, one quad is left alone, joins a
 * neighbour, whose partner is now alone and joins a neighbour, and so on until a quad is left alone
 * for the second time: a cycle. Of the gains in a cycle of positive gain, added up from the right
 * pair on, all partial sums are positive: a path whose sum is not is dropped (Lin and Kernighan, An
 * effective heuristic algorithm for the traveling-salesman problem, 1973, section 1.1). Of the
 * paths that leave the same quad alone, only one of greater gain than all before is followed.
 *
 * Every quad has a potential, and a step from one lone quad to the next gains the difference of
 * theirs besides: in a cycle these add up to nothing. A search in vain raises the potentials by
 * what it gained, so that its steps gain nothing any more, and later searches stop at once where
 * this one went: they are not paid for twice (Johnson's reweighting, Efficient algorithms for
 * shortest paths in sparse networks, 1977). Where potentials leave no step of positive gain there
 * is no cycle.
 */
#include "pair_improve.h"

#include <math.h>
#include <string.h>

/** A search may make this many steps, on paths a tenth as long: more find little more. Large
 * surfaces get less, lest they take too long. */
static size_t most_steps(size_t quad_count) {
  const size_t for_all = 100000000, least = 1000, most = 10000;
  size_t share = for_all / (quad_count + 1);
  return share < least ? least : share < most ? share : most;
}

typedef struct step {
  int32_t alone;     /* the quad whose partner was taken */
  int32_t half_edge; /* of the lone quad before: the new pair */
  int32_t before;    /* number of the step before; -1 at the first */
  int32_t length;    /* steps before */
  double gain;
} step;

/** A cycle: lone quads from step `first` to step `last`, closed across a half-edge of the last. */
typedef struct cycle {
  int32_t first, last, closing;
} cycle;

typedef struct search {
  pair_state *p;
  double least_gain;
  double *potentials; /* [quad_count] */
  size_t most, count; /* steps allowed and made */
  int32_t longest;    /* steps of a path */
  step *steps;        /* [most] */
  int32_t *heap;      /* [most] steps to go on from, of greatest gain first */
  size_t heap_count;
  int32_t *step_of_quad; /* [quad_count] the last step that left it alone, -1 for none */
  int32_t *queue;        /* [quad_count] ring: quads to search from */
  uint8_t *queued;       /* [quad_count] */
  size_t head, waiting;
} search;

/* -------------------------------------------------------------------------------------- steps */

static bool goes_first(const search *f, int32_t a, int32_t b) {
  if (f->steps[a].gain != f->steps[b].gain)
    return f->steps[a].gain > f->steps[b].gain;
  return a < b;
}

static void push(search *f, int32_t number) {
  size_t place = f->heap_count++;
  while (place && goes_first(f, number, f->heap[(place - 1) / 2])) {
    f->heap[place] = f->heap[(place - 1) / 2];
    place = (place - 1) / 2;
  }
  f->heap[place] = number;
}

static int32_t pop(search *f) {
  int32_t first = f->heap[0], moved = f->heap[--f->heap_count];
  size_t place = 0;
  for (size_t child = 1; child < f->heap_count; child = 2 * place + 1) {
    if (child + 1 < f->heap_count && goes_first(f, f->heap[child + 1], f->heap[child]))
      child++;
    if (goes_first(f, moved, f->heap[child]))
      break;
    f->heap[place] = f->heap[child];
    place = child;
  }
  f->heap[place] = moved;
  return first;
}

static void add_step(search *f, step made) {
  int32_t number = (int32_t)f->count++;
  f->steps[number] = made;
  f->step_of_quad[made.alone] = number;
  push(f, number);
}

/** The last step on the path that took a pair apart, -1 if none did. */
static int32_t taken_apart(const search *f, int32_t number, int32_t quad, int32_t partner) {
  while (number >= 0 && f->steps[number].alone != quad && f->steps[number].alone != partner)
    number = f->steps[number].before;
  return number;
}

/** Let the lone quad of a step join the one across a half-edge; true if that closes a cycle. */
static bool join(search *f, int32_t before, int32_t half_edge, cycle *found) {
  const pair_state *p = f->p;
  int32_t from = f->steps[before].alone, quad = pair_across(p, half_edge);
  int32_t alone = pair_partner(p, quad);
  if (half_edge == p->half_edges[from] || quad == from)
    return false;
  int32_t known = f->step_of_quad[alone];
  double gain = f->steps[before].gain + p->weights[half_edge] - p->weights[p->half_edges[quad]] +
                f->potentials[from] - f->potentials[alone];
  if (gain <= (known >= 0 ? f->steps[known].gain : 0) + f->least_gain ||
      f->steps[before].length == f->longest)
    return false;
  int32_t apart = taken_apart(f, before, quad, alone);
  if (apart >= 0) { /* the other way round it is no cycle, and the path leads nowhere */
    *found = (cycle){apart, before, half_edge};
    return f->steps[apart].alone == alone;
  }
  add_step(f, (step){alone, half_edge, before, f->steps[before].length + 1, gain});
  return false;
}

/* ------------------------------------------------------------------------------------ searches */

/** True if there is a cycle.
 * @param reach  receives, if not, the greatest gain of a step that was not gone on from */
static bool find(search *f, int32_t root, cycle *found, double *reach) {
  f->count = f->heap_count = 0;
  *reach = 0;
  add_step(f, (step){root, PAIR_FREE, -1, 0, 0});
  while (f->heap_count) {
    int32_t number = pop(f), quad = f->steps[number].alone;
    if (f->step_of_quad[quad] != number)
      continue;
    if (f->count + 4 > f->most) {
      *reach = f->steps[number].gain;
      return false;
    }
    for (int32_t h = 4 * quad; h < 4 * quad + 4; h++)
      if (join(f, number, h, found))
        return true;
  }
  return false;
}

static void enqueue(search *f, int32_t quad) {
  if (f->queued[quad])
    return;
  size_t place = f->head + f->waiting++, count = f->p->s->quad_count;
  f->queued[quad] = 1;
  f->queue[place < count ? place : place - count] = quad;
}

static void exchange(search *f, const cycle *found) {
  int32_t h = found->closing;
  for (int32_t i = found->last;; i = f->steps[i].before) {
    pair_join(f->p, h);
    enqueue(f, half_edge_quad(h));
    enqueue(f, pair_across(f->p, h));
    if (i == found->first)
      return;
    h = f->steps[i].half_edge;
  }
}

/** Gains above what the search did not go on from are final: see Dijkstra. */
static void raise_potentials(search *f, double reach) {
  for (size_t i = 0; i < f->count; i++)
    if (f->step_of_quad[f->steps[i].alone] == (int32_t)i && f->steps[i].gain > reach)
      f->potentials[f->steps[i].alone] += f->steps[i].gain - reach;
}

static void search_from(search *f, int32_t root) {
  cycle found;
  double reach;
  if (find(f, root, &found, &reach)) {
    exchange(f, &found);
    enqueue(f, root);
  } else {
    raise_potentials(f, reach);
  }
  for (size_t i = 0; i < f->count; i++)
    f->step_of_quad[f->steps[i].alone] = -1;
}

static hexcon_status run(search *f) {
  size_t count = f->p->s->quad_count, done = 0;
  hexcon_status status = HEXCON_OK;
  memset(f->step_of_quad, -1, count * sizeof *f->step_of_quad);
  for (size_t q = 0; q < count; q++)
    enqueue(f, (int32_t)q);
  while (f->waiting && !status) {
    int32_t root = f->queue[f->head];
    f->head = f->head + 1 < count ? f->head + 1 : 0;
    f->waiting--;
    f->queued[root] = 0;
    search_from(f, root);
    done++;
    status =
        pair_count_work(f->p, f->count, 0.2 + 0.8 * (double)done / (double)(done + f->waiting));
  }
  return status;
}

/** Gains that rounding may fake would be won for ever. */
static double least_gain(const pair_state *p) {
  double most = 0;
  for (size_t h = 0; h < 4 * p->s->quad_count; h++)
    most = fmax(most, fabs(p->weights[h]));
  return 1e-9 * most;
}

hexcon_status pair_improve(pair_state *p) {
  size_t count = p->s->quad_count, most = most_steps(count);
  search f = {.p = p,
              .most = most,
              .longest = (int32_t)(most / 10),
              .least_gain = least_gain(p),
              .potentials = context_allocate_zeroed(p->context, count, sizeof *f.potentials),
              .steps = context_allocate(p->context, most, sizeof *f.steps),
              .heap = context_allocate(p->context, most, sizeof *f.heap),
              .step_of_quad = context_allocate(p->context, count, sizeof *f.step_of_quad),
              .queue = context_allocate(p->context, count, sizeof *f.queue),
              .queued = context_allocate_zeroed(p->context, count, 1)};
  bool complete = f.potentials && f.steps && f.heap && f.step_of_quad && f.queue && f.queued;
  hexcon_status status = complete ? run(&f) : HEXCON_OUT_OF_MEMORY;
  context_free(p->context, f.potentials);
  context_free(p->context, f.steps);
  context_free(p->context, f.heap);
  context_free(p->context, f.step_of_quad);
  context_free(p->context, f.queue);
  context_free(p->context, f.queued);
  return status;
}
