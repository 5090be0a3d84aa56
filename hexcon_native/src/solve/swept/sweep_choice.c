/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "sweep_choice.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "surface/geometry.h"

static const double right_angle = 1.5707963267948966;

/** A score that leads by this much, some 15 degrees, is not overtaken. */
static const double clear_lead = 0.25;

enum {
  MAX_VISITS_PER_QUAD = 64, /* of failed reflections */
  MAX_REFLECTIONS = 4,      /* that exist and are compared */
  SHARPEST_CYCLES = 32      /* of a cyclic strip, considered as rims */
};

void sweep_choice_free(hexcon_context *context, sweep_choice *choice) {
  reflection_free(context, &choice->reflected);
  strips_free(context, &choice->strips);
  surface_loops_free(context, &choice->loops);
}

/** Mean bends along the edge cycles of all strips, with running sums for means over many rings. */
typedef struct bend_table {
  double *bends; /* strip i, cycle c at first + i + c: cycle c is on the left of ring c */
  double *sums;  /* sum of bends of the strip's cycles before c */
} bend_table;

/** @param measured  goes up by the edges of the ring */
static double mean_bend(const surface *s, int32_t entry, int turn, size_t *measured) {
  double sum = 0;
  size_t count = 0;
  int32_t at = entry;
  do {
    sum += surface_bend(s, half_edge_turn(at, turn));
    count++;
    at = ring_next(s, at);
  } while (at != entry);
  *measured += count;
  return sum / (double)count;
}

static size_t bend_start(const strip_table *strips, int32_t strip_id) {
  return strips->strips[strip_id].first + (size_t)strip_id;
}

static hexcon_status measure_bends(hexcon_context *context, const surface *s,
                                   const strip_table *strips, size_t loop_count, bend_table *out) {
  size_t cycles = loop_count + strips->count;
  out->bends = context_allocate_zeroed(context, cycles, sizeof *out->bends);
  out->sums = context_allocate_zeroed(context, cycles, sizeof *out->sums);
  if (!out->bends || !out->sums)
    return HEXCON_OUT_OF_MEMORY;
  hexcon_status status = HEXCON_OK;
  size_t measured = 0;
  for (size_t i = 0; !status && i < strips->count; i++) {
    const strip *in = &strips->strips[i];
    size_t at = bend_start(strips, (int32_t)i);
    for (size_t ring = 0; !status && ring < in->ring_count; ring++) {
      out->bends[at + ring] = mean_bend(s, strips->entries[in->first + ring], -1, &measured);
      if (measured >= CONTEXT_PATIENCE) {
        status = context_ask(context);
        measured = 0;
      }
    }
    out->bends[at + in->ring_count] =
        mean_bend(s, strips->entries[in->first + in->ring_count - 1], 1, &measured);
    for (size_t c = 1; c <= in->ring_count; c++)
      out->sums[at + c] = out->sums[at + c - 1] + out->bends[at + c - 1];
  }
  return status;
}

/** Sum of the bends of cycles first .. last - 1 of a strip, going round if it is cyclic. */
static double sum_bends(const strip_table *strips, const bend_table *table, int32_t strip_id,
                        size_t first, size_t last) {
  const strip *in = &strips->strips[strip_id];
  const double *sums = table->sums + bend_start(strips, strip_id);
  size_t n = in->ring_count;
  if (!in->cyclic || last <= n)
    return last > first ? sums[last] - sums[first] : 0;
  if (first >= n)
    return sum_bends(strips, table, strip_id, first - n, last - n);
  return sums[n] - sums[first] + sums[last - n];
}

static double bend_at(const strip_table *strips, const bend_table *table, int32_t strip_id,
                      size_t cycle) {
  const strip *in = &strips->strips[strip_id];
  return table->bends[bend_start(strips, strip_id) + (in->cyclic ? cycle % in->ring_count : cycle)];
}

/** How far `rings` rings about a mirror are from flat sides between square rims. */
static double score_mirror(const strip_table *strips, const bend_table *table, mirror at,
                           size_t rings) {
  const strip *in = &strips->strips[at.strip];
  size_t turn = in->cyclic ? 2 * in->ring_count : 0;
  size_t first = (at.middle + turn - rings) / 2, last = first + rings;
  double rims = fabs(bend_at(strips, table, at.strip, first) - right_angle) +
                fabs(bend_at(strips, table, at.strip, last) - right_angle);
  double inside = sum_bends(strips, table, at.strip, first + 1, last);
  return rims / 2 + (rings > 1 ? inside / (double)(rings - 1) : 0);
}

static double score_reflection(const strip_table *strips, const bend_table *table,
                               const reflection *r, size_t rings) {
  double sum = 0;
  for (size_t m = 0; m < r->mirror_count; m++)
    sum += score_mirror(strips, table, r->mirrors[m], rings);
  return sum / (double)r->mirror_count;
}

static int by_score(const void *a, const void *b) {
  const sweep_candidate *x = a, *y = b;
  if (x->score != y->score)
    return x->score < y->score ? -1 : 1;
  return x->seed.strip < y->seed.strip ? -1 : x->seed.strip > y->seed.strip;
}

/** Best ring count of a strip about its middle. */
static sweep_candidate best_of_strip(const strip_table *strips, const bend_table *table,
                                     int32_t strip_id) {
  size_t n = strips->strips[strip_id].ring_count;
  sweep_candidate best = {{strip_id, n}, n, INFINITY};
  for (size_t rings = n; rings >= 1 && rings <= n; rings -= 2) {
    double score = score_mirror(strips, table, best.seed, rings);
    if (score < best.score) {
      best.score = score;
      best.rings = rings;
    }
  }
  return best;
}

/** The sharpest cycles of a cyclic strip: between two of them the sides may lie. */
static size_t sharpest_cycles(const strip_table *strips, const bend_table *table, int32_t strip_id,
                              size_t *cycles) {
  const strip *in = &strips->strips[strip_id];
  size_t count = 0;
  for (size_t c = 0; c < in->ring_count; c++) {
    double bend = bend_at(strips, table, strip_id, c);
    if (count == SHARPEST_CYCLES && bend <= bend_at(strips, table, strip_id, cycles[count - 1]))
      continue;
    size_t place = count < SHARPEST_CYCLES ? count++ : SHARPEST_CYCLES - 1;
    for (; place > 0 && bend_at(strips, table, strip_id, cycles[place - 1]) < bend; place--)
      cycles[place] = cycles[place - 1];
    cycles[place] = c;
  }
  return count;
}

/** Best mirror and ring count of a strip that goes all the way round: rims at its sharpest
 * cycles, and at their images about the opposite mirror. */
static sweep_candidate best_of_cyclic(const strip_table *strips, const bend_table *table,
                                      int32_t strip_id) {
  size_t n = strips->strips[strip_id].ring_count, cycles[SHARPEST_CYCLES];
  size_t count = sharpest_cycles(strips, table, strip_id, cycles);
  sweep_candidate best = {{strip_id, 0}, 0, INFINITY};
  for (size_t i = 0; n % 2 == 0 && i < count; i++)
    for (size_t j = 0; j < count; j++) {
      size_t rings = (cycles[j] + n - cycles[i]) % n;
      if (rings == 0 || 2 * rings + 2 > n)
        continue;
      mirror near = {strip_id, (2 * cycles[i] + rings) % (2 * n)};
      mirror far = {strip_id, (near.middle + n) % (2 * n)};
      double score =
          (score_mirror(strips, table, near, rings) + score_mirror(strips, table, far, rings)) / 2;
      /* A tube's wall may count as caps or as sides: rounding must not decide between equals. */
      bool equal = fabs(score - best.score) < 1e-9;
      if (equal ? rings > best.rings : score < best.score)
        best = (sweep_candidate){near, rings, score};
    }
  return best;
}

/** Keep a candidate if it is among the best. */
static void keep(sweep_choice *choice, sweep_candidate candidate) {
  size_t last = choice->count;
  if (choice->count < MAX_SWEEP_CANDIDATES)
    choice->count++;
  else if (candidate.score >= choice->candidates[--last].score)
    return;
  choice->candidates[last] = candidate;
  qsort(choice->candidates, choice->count, sizeof candidate, by_score);
}

/** Ring counts of a reflection that exists: the two best. */
static void keep_best_ring_counts(const bend_table *table, sweep_choice *choice,
                                  sweep_candidate candidate) {
  const reflection *r = &choice->reflected;
  sweep_candidate best[2] = {candidate, candidate};
  best[0].score = best[1].score = INFINITY;
  for (size_t rings = r->max_rings; rings >= 1 && rings <= r->max_rings; rings -= 2) {
    double score = score_reflection(&choice->strips, table, r, rings);
    if (score < best[0].score) {
      best[1] = best[0];
      best[0].rings = rings;
      best[0].score = score;
    } else if (score < best[1].score) {
      best[1].rings = rings;
      best[1].score = score;
    }
  }
  for (int i = 0; i < 2; i++)
    if (isfinite(best[i].score))
      keep(choice, best[i]);
}

/** Drop what is so much worse than the best that no placement would make up for it. */
static void drop_hopeless(sweep_choice *choice) {
  while (choice->count > 1 &&
         choice->candidates[choice->count - 1].score > choice->candidates[0].score + clear_lead)
    choice->count--;
}

/** Reflect about each strip in turn; strips that a reflection already maps are not tried again. */
static hexcon_status try_strips(hexcon_context *context, const surface *s, const bend_table *table,
                                const sweep_candidate *order, uint8_t *covered,
                                sweep_choice *choice) {
  size_t visits = 0, existing = 0;
  const size_t budget = MAX_VISITS_PER_QUAD * s->quad_count;
  for (size_t i = 0; i < choice->strips.count; i++) {
    if (visits > budget || existing == MAX_REFLECTIONS)
      break;
    if (covered[order[i].seed.strip] || !isfinite(order[i].score))
      continue;
    hexcon_status status =
        context_progress(context, STAGE_SWEEP_RECOGNITION, (double)visits / (double)budget);
    if (!status)
      status = reflection_try(context, s, &choice->loops, &choice->strips, order[i].seed,
                              &choice->reflected);
    if (status)
      return status;
    const reflection *r = &choice->reflected;
    choice->strip_tried_count++;
    visits += r->reached;
    if (r->failure && !choice->failure) {
      choice->failure = r->failure;
      memcpy(choice->clash, r->clash, sizeof choice->clash);
    }
    for (size_t m = 0; m < r->mirror_count; m++)
      covered[r->mirrors[m].strip] = 1;
    if (r->failure)
      continue;
    existing++;
    keep_best_ring_counts(table, choice, order[i]);
  }
  return HEXCON_OK;
}

static hexcon_status rank_and_try(hexcon_context *context, const surface *s,
                                  const bend_table *table, sweep_choice *choice) {
  size_t count = choice->strips.count;
  sweep_candidate *order = context_allocate(context, count, sizeof *order);
  uint8_t *covered = context_allocate_zeroed(context, count, sizeof *covered);
  hexcon_status status = order && covered ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  if (!status) {
    for (size_t i = 0; i < count; i++)
      order[i] = choice->strips.strips[i].cyclic
                     ? best_of_cyclic(&choice->strips, table, (int32_t)i)
                     : best_of_strip(&choice->strips, table, (int32_t)i);
    qsort(order, count, sizeof *order, by_score);
    status = try_strips(context, s, table, order, covered, choice);
  }
  context_free(context, order);
  context_free(context, covered);
  return status;
}

hexcon_status sweep_choose(hexcon_context *context, const surface *s, sweep_choice *out) {
  memset(out, 0, sizeof *out);
  out->clash[0] = out->clash[1] = -1;
  bend_table table = {NULL, NULL};
  hexcon_status status = context_progress(context, STAGE_SWEEP_RECOGNITION, 0);
  if (!status)
    status = surface_find_loops(context, s, &out->loops);
  if (!status)
    status = strips_build(context, s, &out->loops, &out->strips);
  if (!status)
    status = context_after(context, s->quad_count);
  if (!status)
    status = reflection_new(context, s, &out->strips, &out->reflected);
  if (!status)
    status = measure_bends(context, s, &out->strips, out->loops.count, &table);
  for (size_t i = 0; !status && i < out->loops.count; i++)
    out->simple_loop_count += out->loops.self_crossings[i] == 0;
  if (!status)
    status = rank_and_try(context, s, &table, out);
  drop_hopeless(out);
  if (out->count)
    out->failure = NULL;
  else if (!out->simple_loop_count)
    out->failure = "every dual loop crosses itself, so no ring of sides exists";
  context_free(context, table.bends);
  context_free(context, table.sums);
  return status;
}
