/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "pair_rewiring.h"

hexcon_status pair_rewiring_create(hexcon_context *context, const surface *s, pair_rewiring *r) {
  size_t count = s->quad_count;
  *r = (pair_rewiring){.context = context,
                       .quad_count = count,
                       .half_edges = context_allocate(context, count, sizeof *r->half_edges),
                       .sides = context_allocate_zeroed(context, 4 * count, sizeof *r->sides),
                       .self_crossings =
                           context_allocate(context, 2 * count, sizeof *r->self_crossings),
                       .unused = context_allocate(context, 2 * count, sizeof *r->unused),
                       .crossed = context_allocate(context, count, sizeof *r->crossed),
                       .is_listed = context_allocate_zeroed(context, count, 1)};
  bool complete =
      r->half_edges && r->sides && r->self_crossings && r->unused && r->crossed && r->is_listed;
  for (size_t h = 0; complete && h < 4 * count; h++)
    r->sides[h].twin = s->twins[h];
  return complete ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

void pair_rewiring_free(pair_rewiring *r) {
  context_free(r->context, r->half_edges);
  context_free(r->context, r->sides);
  context_free(r->context, r->self_crossings);
  context_free(r->context, r->unused);
  context_free(r->context, r->crossed);
  context_free(r->context, r->is_listed);
}

/* ------------------------------------------------------------------------------------- links */

static void link_half_edges(pair_rewiring *r, int32_t a, int32_t b) {
  r->sides[a].link = b;
  r->sides[b].link = a;
}

static void make_pair(pair_rewiring *r, int32_t half_edge) {
  int32_t twin = r->sides[half_edge].twin;
  link_half_edges(r, half_edge_turn(half_edge, -1), half_edge_turn(twin, 1));
  link_half_edges(r, half_edge_turn(half_edge, 1), half_edge_turn(twin, -1));
  r->half_edges[half_edge_quad(half_edge)] = half_edge;
  r->half_edges[half_edge_quad(twin)] = twin;
  r->pair_count++;
}

static void break_pair(pair_rewiring *r, int32_t half_edge) {
  int32_t twin = r->sides[half_edge].twin;
  link_half_edges(r, half_edge_turn(half_edge, -1), half_edge_turn(half_edge, 1));
  link_half_edges(r, half_edge_turn(twin, -1), half_edge_turn(twin, 1));
  r->half_edges[half_edge_quad(half_edge)] = PAIR_FREE;
  r->half_edges[half_edge_quad(twin)] = PAIR_FREE;
  r->pair_count--;
}

/* ------------------------------------------------------------------------------------- loops */

/** Mark a loop by a new walk; returns its number of self-crossings. */
static int32_t walk(pair_rewiring *r, int32_t start) {
  int32_t crossings = 0, entry = start;
  uint32_t number = ++r->last_walk;
  do {
    int32_t leave = r->sides[entry].link;
    r->sides[entry].walk = r->sides[leave].walk = number;
    crossings += r->half_edges[half_edge_quad(entry)] == PAIR_FREE &&
                 r->sides[half_edge_turn(entry, 1)].walk == number;
    entry = r->sides[leave].twin;
    r->work++;
  } while (entry != start);
  return crossings;
}

static bool is_crossed(const pair_rewiring *r, int32_t quad) {
  return r->half_edges[quad] == PAIR_FREE && r->sides[4 * quad].loop == r->sides[4 * quad + 1].loop;
}

static void list_crossed(pair_rewiring *r, int32_t quad) {
  if (r->is_listed[quad] || !is_crossed(r, quad))
    return;
  r->is_listed[quad] = 1;
  r->crossed[r->crossed_count++] = quad;
}

/** Give a loop a number. */
static void enter_loop(pair_rewiring *r, int32_t start, int32_t crossings) {
  int32_t loop = r->unused[--r->unused_count], entry = start;
  r->self_crossings[loop] = crossings;
  r->crossing_count += (size_t)crossings;
  do {
    int32_t leave = r->sides[entry].link;
    r->sides[entry].loop = r->sides[leave].loop = loop;
    list_crossed(r, half_edge_quad(entry));
    entry = r->sides[leave].twin;
    r->work++;
  } while (entry != start);
}

/** Start numbering walks afresh before the numbers run out. */
static void spare_walks(pair_rewiring *r) {
  if (r->last_walk < UINT32_MAX - PAIR_CHANGED_LINKS)
    return;
  for (size_t h = 0; h < 4 * r->quad_count; h++)
    r->sides[h].walk = 0;
  r->last_walk = 0;
}

void pair_rewiring_set(pair_rewiring *r, const int32_t *half_edge_of_quad) {
  size_t sides = 4 * r->quad_count;
  r->pair_count = r->crossing_count = r->unused_count = 0;
  for (size_t h = 0; h < sides; h++) {
    r->sides[h].link = half_edge_turn((int32_t)h, 2);
    r->sides[h].loop = -1;
  }
  r->crossed_count = 0;
  for (size_t q = 0; q < r->quad_count; q++) {
    r->half_edges[q] = PAIR_FREE;
    r->is_listed[q] = 0;
  }
  for (size_t q = 0; half_edge_of_quad && q < r->quad_count; q++)
    if (half_edge_of_quad[q] != PAIR_FREE && r->half_edges[q] == PAIR_FREE)
      make_pair(r, half_edge_of_quad[q]);
  for (size_t i = sides / 2; i-- > 0;)
    r->unused[r->unused_count++] = (int32_t)i;
  for (size_t h = 0; h < sides; h++)
    if (r->sides[h].loop < 0) {
      spare_walks(r);
      enter_loop(r, (int32_t)h, walk(r, (int32_t)h));
    }
}

/* ----------------------------------------------------------------------------------- changes */

static void note_changed(const pair_rewiring *r, int32_t half_edge, pair_change *change) {
  int32_t twin = r->sides[half_edge].twin;
  int32_t *out = change->changed + change->changed_count;
  out[0] = half_edge_turn(half_edge, 1);
  out[1] = half_edge_turn(half_edge, -1);
  out[2] = half_edge_turn(twin, 1);
  out[3] = half_edge_turn(twin, -1);
  change->changed_count += 4;
}

/** The pairs that a change breaks, by a half-edge of each; returns how many. */
static int broken_pairs(const pair_rewiring *r, const pair_change *change, int32_t broken[2]) {
  int count = 0;
  if (change->before[0] != PAIR_FREE)
    broken[count++] = change->before[0];
  if (change->before[1] != PAIR_FREE &&
      (count == 0 || change->before[1] != r->sides[change->before[0]].twin))
    broken[count++] = change->before[1];
  return count;
}

/** The loops that the changed half-edges had; returns how many. */
static int old_loops(const pair_rewiring *r, const pair_change *change,
                     int32_t found[PAIR_CHANGED_LINKS]) {
  int count = 0;
  for (int i = 0; i < change->changed_count; i++) {
    int32_t loop = r->sides[change->changed[i]].loop;
    int k = 0;
    while (k < count && found[k] != loop)
      k++;
    found[k] = loop;
    count += k == count;
  }
  return count;
}

static void count_loop(pair_change *change, int32_t crossings, int sign) {
  change->more_crossings += sign * crossings;
  change->more_odd += sign * (crossings & 1);
}

static void walk_new_loops(pair_rewiring *r, pair_change *change) {
  spare_walks(r);
  uint32_t before = r->last_walk;
  for (int i = 0; i < change->changed_count; i++) {
    int32_t h = change->changed[i];
    if (r->sides[h].walk > before)
      continue;
    change->starts[change->loop_count] = h;
    change->crossings[change->loop_count] = walk(r, h);
    count_loop(change, change->crossings[change->loop_count++], 1);
  }
}

void pair_rewiring_try(pair_rewiring *r, int32_t half_edge, pair_change *change) {
  int32_t broken[2], loops[PAIR_CHANGED_LINKS];
  *change = (pair_change){.half_edge = half_edge};
  change->before[0] = r->half_edges[half_edge_quad(half_edge)];
  change->before[1] = r->half_edges[half_edge_quad(r->sides[half_edge].twin)];
  bool breaks_only = change->before[0] == half_edge;
  int broken_count = broken_pairs(r, change, broken);
  for (int i = 0; i < broken_count; i++)
    note_changed(r, broken[i], change);
  if (!breaks_only)
    note_changed(r, half_edge, change);
  for (int i = old_loops(r, change, loops); i-- > 0;)
    count_loop(change, r->self_crossings[loops[i]], -1);
  for (int i = 0; i < broken_count; i++)
    break_pair(r, broken[i]);
  if (!breaks_only)
    make_pair(r, half_edge);
  change->more_pairs = !breaks_only - broken_count;
  walk_new_loops(r, change);
}

void pair_rewiring_accept(pair_rewiring *r, const pair_change *change) {
  int32_t loops[PAIR_CHANGED_LINKS];
  for (int i = old_loops(r, change, loops); i-- > 0;) {
    r->crossing_count -= (size_t)r->self_crossings[loops[i]];
    r->unused[r->unused_count++] = loops[i];
  }
  for (int i = 0; i < change->loop_count; i++)
    enter_loop(r, change->starts[i], change->crossings[i]);
}

void pair_rewiring_reject(pair_rewiring *r, const pair_change *change) {
  int32_t broken[2];
  if (change->before[0] != change->half_edge)
    break_pair(r, change->half_edge);
  for (int i = broken_pairs(r, change, broken); i-- > 0;)
    make_pair(r, broken[i]);
}

int32_t pair_rewiring_crossed_quad(pair_rewiring *r, uint64_t random) {
  while (r->crossed_count > 0) {
    size_t place = (size_t)(random % r->crossed_count);
    int32_t quad = r->crossed[place];
    if (is_crossed(r, quad))
      return quad;
    r->is_listed[quad] = 0;
    r->crossed[place] = r->crossed[--r->crossed_count];
  }
  return PAIR_FREE;
}
