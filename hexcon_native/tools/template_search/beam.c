/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "beam.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "estimate.h"
#include "hexes.h"
#include "support.h"

uint64_t filling_name(const target *goal, const filling *f) {
  uint64_t colours[256] = {0};
  for (int p = 0; p < goal->point_count; p++)
    colours[p] = (uint64_t)p + 1;
  return hexes_fingerprint((const uint8_t(*)[8])f->hexes, f->hex_count, colours, 4) | 1;
}

typedef struct candidate {
  double promised; /**< hexes still to come */
  uint32_t parent;
  flip last;
} candidate;

typedef struct beam {
  const table *inner;
  const target *goal;
  beam_options options;
  filling_visitor visit;
  void *user;
  estimate guess;
  table outer; /**< of cavities; its marks are of hexes outside */
  dice random;
  double started;
  uint32_t parent; /**< whose children are being looked at */
  size_t count, capacity;
  candidate *candidates;
  key_set seen, found; /**< cavities of this step; fillings */
  int fewest;          /**< hexes that complete the cavity being looked at */
  int best;            /**< hexes of the best filling */
} beam;

/** An edge with one hex outside needs two inside; marked ones have them, or need them not. */
static void find_needed(const ball *cavity, bool needed[MOST_DARTS]) {
  for (int d = 0; d < 4 * cavity->surface.quad_count; d++)
    needed[d] = !cavity->marked[d];
}

static void note_fewest(void *user, uint32_t entry, walk_start start) {
  beam *b = user;
  const int hexes = b->inner->entries[entry].hex_count;
  (void)start;
  b->fewest = hexes < b->fewest ? hexes : b->fewest;
}

/**
 * The guess is learned from small balls with as many marks as they can have. It is far too low for
 * cavities unlike those, and nothing would ever get smaller: hence the rates, found by trial.
 */
static double guessed(const beam *b, const sphere *s, const bool *needed) {
  const double per_quad = 1.5, per_quad_too_many = 1;
  const int too_many = s->quad_count - b->inner->most_quads;
  const double guess = estimate_hexes(&b->guess, s, needed), least = per_quad * s->quad_count;
  return (guess > least ? guess : least) + (too_many > 0 ? per_quad_too_many * too_many : 0);
}

static double promise(beam *b, const ball *cavity, const canonical *c) {
  bool needed[MOST_DARTS];
  find_needed(cavity, needed);
  b->fewest = MOST_HEXES;
  table_match(b->inner, &cavity->surface, c, needed, note_fewest, b);
  const double hexes = b->fewest < MOST_HEXES ? b->fewest : guessed(b, &cavity->surface, needed);
  return hexes + b->options.noise * (dice_unit(&b->random) + dice_unit(&b->random) - 1);
}

static void consider(void *user, flip f, const ball *child) {
  beam *b = user;
  canonical c;
  walk w;
  if (!target_allows(b->goal, child->hexes[child->hex_count - 1]))
    return;
  canonical_find(&child->surface, &c);
  walk_from(&child->surface, c.starts[0], &w);
  const uint64_t marks = walk_marks(&child->surface, &w, child->marked);
  const size_t before = b->seen.count;
  if (key_set_add(&b->seen, mixed(c.key ^ mixed(marks)) | 1) != before)
    return;
  if (b->count == b->capacity) {
    b->capacity = grown(b->capacity, 1024);
    b->candidates = resized(b->candidates, b->capacity, sizeof *b->candidates);
  }
  b->candidates[b->count++] = (candidate){promise(b, child, &c), b->parent, f};
}

static int compare_promises(const void *a, const void *b) {
  const candidate *x = a, *y = b;
  if (x->promised != y->promised)
    return x->promised < y->promised ? -1 : 1;
  return (x->parent > y->parent) - (x->parent < y->parent);
}

/** A cavity and the filling outside it. */
typedef struct join {
  beam *b;
  const ball *cavity;
} join;

static void try_join(void *user, uint32_t entry, walk_start start) {
  const join *j = user;
  beam *b = j->b;
  const int outside = j->cavity->hex_count, more = b->inner->entries[entry].hex_count;
  const int most = b->best + 4 < b->options.most_hexes ? b->best + 4 : b->options.most_hexes;
  if (outside + more > most || b->found.count >= (size_t)b->options.most_fillings)
    return;
  filling f = {.hex_count = outside + more};
  seat where = {&j->cavity->surface, j->cavity->point, start, true, j->cavity->point_count};
  memcpy(f.hexes, j->cavity->hexes, 8 * (size_t)outside);
  if (table_transplant(b->inner, entry, &where, f.hexes + outside, MOST_HEXES - outside) == 0 ||
      !target_filled(b->goal, (const uint8_t(*)[8])f.hexes, f.hex_count))
    return;
  for (int h = outside; h < f.hex_count; h++)
    if (!target_allows(b->goal, f.hexes[h]))
      return;
  const size_t before = b->found.count;
  const uint64_t name = filling_name(b->goal, &f);
  if (key_set_add(&b->found, name) != before)
    return;
  b->best = f.hex_count < b->best ? f.hex_count : b->best;
  b->visit(b->user, &f);
}

static void join_cavity(beam *b, const ball *cavity, const canonical *c) {
  bool needed[MOST_DARTS];
  join j = {b, cavity};
  find_needed(cavity, needed);
  table_match(b->inner, &cavity->surface, c, needed, try_join, &j);
}

/** Add the best candidates to the outer table and join them. */
static void keep_best(beam *b) {
  ball parent, child;
  flip_disc disc;
  canonical c;
  int kept = 0;
  qsort(b->candidates, b->count, sizeof *b->candidates, compare_promises);
  for (size_t i = 0; i < b->count && kept < b->options.width; i++) {
    const candidate *k = &b->candidates[i];
    table_replay(&b->outer, k->parent, &parent);
    if (!flip_find(&parent.surface, k->last, &disc) || !ball_glue(&parent, k->last, &disc, &child))
      continue;
    canonical_find(&child.surface, &c);
    if (table_add(&b->outer, k->parent, k->last, &child, &c) == NO_ENTRY)
      continue;
    kept++;
    join_cavity(b, &child, &c);
  }
}

static bool beam_over(const beam *b, int step, size_t begin) {
  return begin == b->outer.count || step + 1 >= b->options.most_hexes || step > b->best + 4 ||
         b->found.count >= (size_t)b->options.most_fillings ||
         now() - b->started > b->options.seconds;
}

/** One hex more in every cavity kept. */
static void advance(beam *b, size_t begin, size_t end) {
  ball cavity;
  b->count = 0;
  key_set_free(&b->seen);
  for (size_t i = begin; i < end; i++) {
    b->parent = (uint32_t)i;
    table_replay(&b->outer, b->parent, &cavity);
    table_children(&b->outer, &cavity, consider, b);
  }
  keep_best(b);
}

int beam_search(const table *inner, const target *t, const beam_options *options,
                filling_visitor visit, void *user) {
  beam b = {.inner = inner,
            .goal = t,
            .options = *options,
            .visit = visit,
            .user = user,
            .random = {options->seed},
            .started = now(),
            .best = MOST_HEXES};
  ball cavity;
  target_cavity(t, &cavity);
  estimate_learn(inner, &b.guess);
  const int quads = cavity.surface.quad_count;
  table_begin(&b.outer, quads > options->most_quads ? quads : options->most_quads, 1);
  table_add_root(&b.outer, &cavity);
  canonical code;
  canonical_find(&cavity.surface, &code);
  join_cavity(&b, &cavity, &code);
  size_t begin = 0;
  for (int step = 1; !beam_over(&b, step, begin); step++) {
    const size_t end = b.outer.count;
    advance(&b, begin, end);
    begin = end;
    (void)fprintf(stderr, "beam %d: %zu cavities of %zu, promised %.1f, fillings %zu, best %d\n",
                  step, b.outer.count - end, b.count, b.count ? b.candidates[0].promised : 0.0,
                  b.found.count, b.found.count ? b.best : 0);
  }
  const int found = (int)b.found.count;
  table_free(&b.outer);
  key_set_free(&b.seen);
  key_set_free(&b.found);
  free(b.candidates);
  return found;
}
