/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "cut_crossings.h"

#include <string.h>

void cut_crossings_free(hexcon_context *context, cut_crossings *c) {
  context_free(context, c->first);
  context_free(context, c->passages);
  context_free(context, c->thread_of_passage);
  context_free(context, c->ends);
  context_free(context, c->strands);
  context_free(context, c->roots);
  context_free(context, c->order);
  context_free(context, c->joints);
  context_free(context, c->counts);
  context_free(context, c->met);
  memset(c, 0, sizeof *c);
}

static hexcon_status allocate(hexcon_context *context, const surface *s, size_t threads_most,
                              cut_crossings *c) {
  c->first = context_allocate(context, threads_most + 1, sizeof *c->first);
  c->passages = context_allocate(context, s->quad_count, 2 * sizeof *c->passages);
  c->thread_of_passage = context_allocate(context, s->quad_count, 2 * sizeof *c->thread_of_passage);
  c->ends = context_allocate(context, c->length, 2 * sizeof *c->ends);
  c->strands = context_allocate(context, c->length, 2 * sizeof *c->strands);
  c->roots = context_allocate(context, threads_most, sizeof *c->roots);
  c->order = context_allocate(context, c->length, sizeof *c->order);
  c->joints = context_allocate(context, c->length, sizeof *c->joints);
  c->counts = context_allocate_zeroed(context, threads_most, sizeof *c->counts);
  c->met = context_allocate(context, threads_most, sizeof *c->met);
  return c->first && c->passages && c->thread_of_passage && c->ends && c->strands && c->roots &&
                 c->order && c->joints && c->counts && c->met
             ? HEXCON_OK
             : HEXCON_OUT_OF_MEMORY;
}

/* ---------------------------------------------------------------------------------------- threads
 */

/** The half-edge of the ring's quad on its left rail, side 0, or its right one. */
static int32_t rail_side(int32_t entry, int side) {
  return half_edge_turn(entry, side == 0 ? -1 : 1);
}

/** Follow a strand from an end to its other one. @param rungs [quads] of the ring, -1 elsewhere */
static void follow_strand(const surface *s, const int32_t *ring, const int32_t *rungs, int32_t end,
                          cut_crossings *c) {
  const int32_t strand = (int32_t)c->thread_count;
  size_t length = c->first[strand];
  int32_t entry = s->twins[rail_side(ring[end / 2], end % 2)];
  for (; rungs[half_edge_quad(entry)] < 0; entry = s->twins[half_edge_turn(entry, 2)]) {
    c->thread_of_passage[surface_passage(entry)] = strand;
    c->passages[length++] = (int32_t)surface_passage(entry);
  }
  const int32_t rung = rungs[half_edge_quad(entry)];
  const int32_t last = 2 * rung + (entry == rail_side(ring[rung], 1));
  c->ends[2 * strand] = end;
  c->ends[2 * strand + 1] = last;
  c->strands[end] = c->strands[last] = strand;
  c->first[++c->thread_count] = length;
}

/** A loop that the ring does not meet. */
static void take_loop(const surface_loops *loops, size_t loop, cut_crossings *c) {
  const int32_t thread = (int32_t)c->thread_count;
  size_t length = c->first[thread];
  for (size_t i = loops->offsets[loop]; i < loops->offsets[loop + 1]; i++) {
    size_t passage = surface_passage(loops->entries[i]);
    c->thread_of_passage[passage] = thread;
    c->passages[length++] = (int32_t)passage;
  }
  c->first[++c->thread_count] = length;
}

static void find_threads(const surface *s, const surface_loops *loops, size_t loop, int32_t *rungs,
                         cut_crossings *c) {
  const int32_t *ring = loops->entries + loops->offsets[loop];
  memset(rungs, -1, s->quad_count * sizeof *rungs);
  memset(c->thread_of_passage, -1, 2 * s->quad_count * sizeof *c->thread_of_passage);
  memset(c->strands, -1, 2 * c->length * sizeof *c->strands);
  for (size_t i = 0; i < c->length; i++)
    rungs[half_edge_quad(ring[i])] = (int32_t)i;
  c->first[0] = 0;
  for (int32_t end = 0; end < (int32_t)(2 * c->length); end++)
    if (c->strands[end] < 0)
      follow_strand(s, ring, rungs, end, c);
  for (size_t i = 0; i < c->length; i++)
    rungs[i] = loops->loop_of_passage[surface_passage(ring[i]) ^ 1];
  for (size_t i = 0; i < c->length; i++)
    c->met[rungs[i]] = 1;
  c->met[loop] = 1;
  for (size_t i = 0; i < loops->count; i++)
    if (!c->met[i])
      take_loop(loops, i, c);
}

/* --------------------------------------------------------------------------------------- counting
 */

static void count_one(cut_crossings *c, int32_t root, size_t *met) {
  if (c->counts[root]++ == 0)
    c->met[(*met)++] = root;
}

static void count_thread(cut_crossings *c, int32_t thread, size_t *met) {
  for (size_t i = c->first[thread]; i < c->first[thread + 1]; i++)
    count_one(c, c->roots[c->thread_of_passage[c->passages[i] ^ 1]], met);
}

/** Add what was counted of one loop, against those of larger numbers, and forget it. */
static void add_counts(cut_crossings *c, int32_t root, size_t met, crossing_counts *out) {
  for (size_t i = 0; i < met; i++) {
    const int32_t other = c->met[i];
    if (other == root)
      out->of_themselves += c->counts[other] / 2;
    else if (other > root && c->counts[other] > 2)
      out->in_excess += (c->counts[other] - 2) / 2;
    c->counts[other] = 0;
  }
}

/** Crossings of whole loops with each other: strands do not count here, as they have no root. */
static void count_whole_loops(cut_crossings *c) {
  crossing_counts found = {0};
  for (size_t thread = 0; thread < c->thread_count; thread++)
    c->roots[thread] = thread < c->length ? 0 : (int32_t)thread;
  for (size_t thread = c->length; thread < c->thread_count; thread++) {
    size_t met = 0;
    count_thread(c, (int32_t)thread, &met);
    add_counts(c, (int32_t)thread, met, &found);
  }
  c->of_themselves = found.of_themselves;
  c->in_excess = found.in_excess;
}

hexcon_status cut_crossings_new(hexcon_context *context, const surface *s,
                                const surface_loops *loops, size_t loop, cut_crossings *out) {
  *out = (cut_crossings){.length = loops->offsets[loop + 1] - loops->offsets[loop]};
  hexcon_status status = allocate(context, s, out->length + loops->count, out);
  int32_t *rungs = context_allocate(context, s->quad_count, sizeof *rungs);
  if (!rungs)
    status = HEXCON_OUT_OF_MEMORY;
  if (!status) {
    memset(out->met, 0, (out->length + loops->count) * sizeof *out->met);
    find_threads(s, loops, loop, rungs, out);
    count_whole_loops(out);
  }
  context_free(context, rungs);
  return status;
}

/** Name all strands by the first one of their loop, and put them in order. */
static void join_strands(cut_crossings *c, const disc_shape *shape) {
  size_t placed = 0;
  for (size_t i = 0; i < c->length; i++)
    c->roots[i] = -1;
  for (int32_t root = 0; root < (int32_t)c->length; root++) {
    int32_t strand = root, enter = c->ends[2 * root];
    while (c->roots[strand] < 0) {
      const int32_t leave =
          c->ends[2 * strand] == enter ? c->ends[2 * strand + 1] : c->ends[2 * strand];
      c->roots[strand] = root;
      c->order[placed] = strand;
      c->joints[placed++] = leave;
      enter = 2 * (int32_t)disc_shape_across(shape, (size_t)leave / 2) + leave % 2;
      strand = c->strands[enter];
    }
  }
}

/** The rows of the grid that cross the one which begins at an end. */
static void count_rows(cut_crossings *c, const disc_shape *shape, int32_t end, size_t *met) {
  const size_t a = shape->a, b = shape->b, n = c->length;
  const size_t along = ((size_t)end / 2 + n - shape->first) % n % (a + b);
  const size_t begin = along < a ? a : 0, count = along < a ? b : a;
  for (size_t i = 0; i < count; i++) {
    size_t rung = (shape->first + begin + i) % n;
    count_one(c, c->roots[c->strands[2 * rung + (size_t)end % 2]], met);
  }
}

crossing_counts cut_crossings_count(cut_crossings *c, const disc_shape *shape) {
  crossing_counts found = {c->of_themselves, c->in_excess};
  join_strands(c, shape);
  for (size_t i = 0; i < c->length;) {
    const int32_t root = c->roots[c->order[i]];
    size_t met = 0;
    for (; i < c->length && c->roots[c->order[i]] == root; i++) {
      count_thread(c, c->order[i], &met);
      count_rows(c, shape, c->joints[i], &met);
    }
    add_counts(c, root, met, &found);
  }
  return found;
}
