/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "sheet_candidates.h"

#include <math.h>
#include <string.h>

#include "base/sorting.h"
#include "region_score.h"

/** Pairs of loops looked at on one front. */
enum { MOST_PAIRS = 400 };

/** Rims this many times worse than the best come last, in any order. */
static const double clear_lead = 2;

hexcon_status candidates_new(hexcon_context *context, const sheet_front *front, uint64_t seed,
                             candidate_stack *out) {
  memset(out, 0, sizeof *out);
  out->random = seed;
  out->sides = context_allocate(context, front->loops.count, 2 * sizeof *out->sides);
  return out->sides ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

void candidates_free(hexcon_context *context, candidate_stack *stack) {
  context_free(context, stack->items);
  context_free(context, stack->sides);
  memset(stack, 0, sizeof *stack);
}

/** splitmix64, even in 0 .. 1. */
static double next_random(uint64_t *state) {
  uint64_t bits = *state += 0x9e3779b97f4a7c15U;
  bits = (bits ^ bits >> 30) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ bits >> 27) * 0x94d049bb133111ebU;
  return (double)((bits ^ bits >> 31) >> 11) * 0x1p-53;
}

/** True if the candidate's rings do not meet. */
static bool find_rings(const sheet_front *front, const sheet_candidate *candidate,
                       front_region *region) {
  front_region_begin(front, candidate->entries[0], region);
  return candidate->entries[1] < 0 || front_region_add_ring(front, candidate->entries[1], region);
}

bool candidate_find(sheet_front *front, const sheet_candidate *candidate, front_region *region) {
  return find_rings(front, candidate, region) && front_can_lay(front, region) &&
         front_region_fill(front, front->alive_count, region);
}

/** Add to a rim's score that of the region inside; infinite where there is none, or a bound where
 * it is above the limit. */
static double add_inner_score(const sheet_front *front, const sheet_taste *taste, double rim_score,
                              double limit, front_region *region) {
  size_t most = front->alive_count;
  double quads = (limit - rim_score) / taste->hex_weight;
  if (quads < (double)most)
    most = (size_t)fmax(quads, 0);
  bool filled = front_region_fill(front, most, region);
  double score = rim_score + taste->hex_weight * (double)region->quad_count;
  if (!filled)
    return region->quad_count > most ? score : INFINITY;
  return score + region_inner_score(front, region);
}

static sheet_candidate weigh_side(const sheet_front *front, front_region *region,
                                  const sheet_taste *taste, loop_side *side, double limit) {
  front_region_begin(front, side->entry, region);
  double score = region_rim_score(front, region, limit);
  side->rim_score = score;
  if (score <= limit)
    score = add_inner_score(front, taste, score, limit, region);
  return (sheet_candidate){score, {side->entry, -1}};
}

static hexcon_status reserve(hexcon_context *context, candidate_stack *stack, size_t more) {
  if (stack->count + more <= stack->room)
    return HEXCON_OK;
  size_t room = 2 * (stack->count + more);
  sheet_candidate *grown = context_grow(context, stack->items, room, sizeof *grown);
  if (!grown)
    return HEXCON_OUT_OF_MEMORY;
  stack->items = grown;
  stack->room = room;
  return HEXCON_OK;
}

static int by_rim_score(const void *a, const void *b) {
  const loop_side *left = a, *right = b;
  if (left->rim_score != right->rim_score)
    return left->rim_score < right->rim_score ? -1 : 1;
  return (left->entry > right->entry) - (left->entry < right->entry);
}

hexcon_status candidates_count_work(hexcon_context *context, candidate_stack *stack,
                                    const front_region *region) {
  stack->work += 1 + region->rung_count + region->quad_count;
  if (stack->work < CONTEXT_PATIENCE)
    return HEXCON_OK;
  stack->work = 0;
  return context_ask(context);
}

/** Both sides of every loop that does not cross itself, with what their rims cost as far as that
 * tells which may be best; those first. */
static hexcon_status list_sides(hexcon_context *context, sheet_front *front, front_region *region,
                                candidate_stack *stack) {
  hexcon_status status = HEXCON_OK;
  double best = INFINITY;
  stack->side_count = 0;
  for (size_t i = 0; !status && i < front->loops.count; i++) {
    status = candidates_count_work(context, stack, region);
    if (front->gone[i] || front->loops.self_crossings[i])
      continue;
    int32_t entry = front_loop_start(front, i);
    for (int turn = 0; turn < 4; turn += 2) {
      loop_side *side = &stack->sides[stack->side_count++];
      side->entry = half_edge_turn(entry, turn);
      front_region_begin(front, side->entry, region);
      side->rim_score = region_rim_score(front, region, clear_lead * best);
      best = fmin(best, side->rim_score);
    }
  }
  return status ? status
                : context_sort(context, stack->sides, stack->side_count, sizeof *stack->sides,
                               by_rim_score);
}

/** Push the sides of loops that may go. @param least  receives the best score */
static hexcon_status push_sides(hexcon_context *context, sheet_front *front, front_region *region,
                                const sheet_taste *taste, candidate_stack *stack, double *least) {
  double best = INFINITY;
  hexcon_status status = HEXCON_OK;
  for (size_t i = 0; !status && i < stack->side_count; i++) {
    status = candidates_count_work(context, stack, region);
    sheet_candidate candidate = weigh_side(front, region, taste, &stack->sides[i], best);
    candidate.score *= 1 + taste->noise * next_random(&stack->random);
    if (candidate.score < best && !front_can_lay(front, region))
      continue;
    stack->items[stack->count++] = candidate;
    best = fmin(best, candidate.score);
  }
  *least = best;
  return status;
}

/** A pair of sides, with a region between them that can be laid; infinitely bad if there is none.
 */
static sheet_candidate weigh_pair(sheet_front *front, front_region *region,
                                  const sheet_taste *taste, const loop_side *a, const loop_side *b,
                                  double limit) {
  sheet_candidate pair = {INFINITY, {a->entry, b->entry}};
  if (find_rings(front, &pair, region) && front_can_lay(front, region))
    pair.score = add_inner_score(front, taste, a->rim_score + b->rim_score, limit, region);
  return pair;
}

/** Push pairs of loops that are better than `best`, each better than those before. */
static hexcon_status push_pairs(hexcon_context *context, sheet_front *front, front_region *region,
                                const sheet_taste *taste, double best, candidate_stack *stack) {
  size_t tried = 0;
  hexcon_status status =
      context_sort(context, stack->sides, stack->side_count, sizeof *stack->sides, by_rim_score);
  for (size_t j = 1; !status && j < stack->side_count && tried < MOST_PAIRS; j++) {
    const loop_side *b = &stack->sides[j];
    if (stack->sides[0].rim_score + b->rim_score >= best)
      break;
    for (size_t i = 0; !status && i < j && tried < MOST_PAIRS; i++, tried++) {
      status = candidates_count_work(context, stack, region);
      const loop_side *a = &stack->sides[i];
      if (a->rim_score + b->rim_score >= best)
        break;
      sheet_candidate pair = weigh_pair(front, region, taste, a, b, best);
      pair.score *= 1 + taste->noise * next_random(&stack->random);
      if (pair.score < best) {
        stack->items[stack->count++] = pair;
        best = pair.score;
      }
    }
  }
  return status;
}

static int by_score(const void *a, const void *b) {
  const sheet_candidate *left = a, *right = b;
  if (left->score != right->score)
    return left->score < right->score ? -1 : 1;
  return (left->entries[0] > right->entries[0]) - (left->entries[0] < right->entries[0]);
}

hexcon_status candidates_push(hexcon_context *context, sheet_front *front, front_region *region,
                              const sheet_taste *taste, candidate_stack *stack) {
  size_t first = stack->count;
  hexcon_status status = reserve(context, stack, 2 * front->loops.count + MOST_PAIRS);
  if (status)
    return status;
  double best = INFINITY;
  status = list_sides(context, front, region, stack);
  if (!status)
    status = push_sides(context, front, region, taste, stack, &best);
  if (!status)
    status = push_pairs(context, front, region, taste, best, stack);
  return status ? status
                : context_sort(context, stack->items + first, stack->count - first,
                               sizeof *stack->items, by_score);
}
