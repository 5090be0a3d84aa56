/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "sheet_search.h"

#include <string.h>

#include "region_score.h"

void sheet_search_free(hexcon_context *context, sheet_search *search) {
  front_free(context, &search->front);
  front_region_free(context, &search->region);
  layer_placement_free(context, &search->placement);
  context_free(context, search->points);
  candidates_free(context, &search->candidates);
  visited_free(context, &search->visited);
  context_free(context, search->levels);
  context_free(context, search->path);
  context_free(context, search->best_path);
  memset(search, 0, sizeof *search);
}

static hexcon_status begin(hexcon_context *context, const surface *s, const sheet_taste *taste,
                           sheet_search *search) {
  memset(search, 0, sizeof *search);
  hexcon_status status = front_begin(context, s, &search->front);
  if (!status)
    status = front_region_new(context, &search->front, &search->region);
  if (status)
    return status;
  status = candidates_new(context, &search->front, taste->seed, &search->candidates);
  if (status)
    return status;
  size_t loops = search->front.loops.count;
  search->best_alive = s->quad_count;
  search->point_room = s->point_count;
  search->points = context_allocate(context, s->point_count, 3 * sizeof *search->points);
  search->levels = context_allocate(context, loops + 1, sizeof *search->levels);
  search->path = context_allocate(context, loops, sizeof *search->path);
  search->best_path = context_allocate(context, loops, sizeof *search->best_path);
  if (!search->points || !search->levels || !search->path || !search->best_path)
    return HEXCON_OUT_OF_MEMORY;
  memcpy(search->points, s->points, 3 * s->point_count * sizeof *s->points);
  search->front.s.points = search->points;
  return HEXCON_OK;
}

static hexcon_status push_level(hexcon_context *context, sheet_search *search,
                                const sheet_taste *taste) {
  size_t first = search->candidates.count;
  search->levels[search->level_count++] = (sheet_level){first, first};
  search->step_count++;
  return candidates_push(context, &search->front, &search->region, taste, &search->candidates);
}

/* ---------------------------------------------------------------------------------------- layers
 */

/** Lay the region, and place its points. */
static hexcon_status lay(hexcon_context *context, sheet_search *search) {
  sheet_front *front = &search->front;
  hexcon_status status = front_lay(context, front, &search->region);
  if (!status && front->mesh.point_count > search->point_room) {
    size_t room = 2 * front->mesh.point_count;
    double *grown = context_grow(context, search->points, room, 3 * sizeof *grown);
    if (!grown)
      return HEXCON_OUT_OF_MEMORY;
    search->points = grown;
    search->point_room = room;
    front->s.points = grown;
  }
  if (status)
    return status;
  const sheet_layer *layer = &front->layers[front->layer_count - 1];
  return layer_place(context, &search->placement, front->mesh.hexes + 8 * layer->first_hex,
                     front->mesh.hex_count - layer->first_hex, layer->first_point,
                     front->mesh.point_count, search->points);
}

/** Key of the set of loops that a layer takes away. */
static uint64_t layer_key(const sheet_search *search, const sheet_candidate *layer) {
  const int32_t *loops = search->front.loops.loop_of_passage;
  uint64_t key = visited_key(loops[surface_passage(layer->entries[0])]);
  if (layer->entries[1] >= 0)
    key ^= visited_key(loops[surface_passage(layer->entries[1])]);
  return key;
}

static hexcon_status lay_candidate(hexcon_context *context, sheet_search *search,
                                   const sheet_candidate *candidate) {
  search->key ^= layer_key(search, candidate);
  search->path[search->front.layer_count] = *candidate;
  return lay(context, search);
}

static void take_back(sheet_search *search) {
  front_take_back(&search->front);
  search->key ^= layer_key(search, &search->path[search->front.layer_count]);
}

static void keep_best(sheet_search *search) {
  search->best_alive = search->front.alive_count;
  search->best_count = search->front.layer_count;
  memcpy(search->best_path, search->path, search->best_count * sizeof *search->path);
}

/** True if the region's layer has no corner that is fixed and worse than the taste allows. */
static bool has_room(sheet_search *search, const sheet_taste *taste) {
  return taste->least_corner <= -1 ||
         region_fixed_bound(&search->front, &search->region) >= taste->least_corner;
}

/** The next candidate of the last level that leads to a new front, whose region is found then; NULL
 * if there is none. */
static const sheet_candidate *next_candidate(hexcon_context *context, sheet_search *search,
                                             const sheet_taste *taste, hexcon_status *status) {
  sheet_level *level = &search->levels[search->level_count - 1];
  while (!*status && level->next < search->candidates.count) {
    const sheet_candidate *candidate = &search->candidates.items[level->next++];
    if (!visited_has(&search->visited, search->key ^ layer_key(search, candidate)) &&
        candidate_find(&search->front, candidate, &search->region) && has_room(search, taste))
      return candidate;
    *status = candidates_count_work(context, &search->candidates, &search->region);
  }
  return NULL;
}

/** Back from a dead end by 1, 2, 1, 4, 1, 2, 1, 8 ... levels, as what is wrong may have begun
 * early, but not beyond the first. */
static void go_back(sheet_search *search) {
  size_t count = ++search->dead_ends;
  for (count &= ~count + 1; count && search->level_count > 1; count--) {
    search->candidates.count = search->levels[--search->level_count].first;
    take_back(search);
  }
}

/** Lay the next candidate. @param found  false: there is none left */
static hexcon_status advance(hexcon_context *context, sheet_search *search,
                             const sheet_taste *taste, bool *found) {
  const sheet_candidate *candidate = NULL;
  hexcon_status status = HEXCON_OK;
  while (!(candidate = next_candidate(context, search, taste, &status)) && !status &&
         search->level_count > 1)
    go_back(search);
  *found = candidate != NULL;
  if (candidate)
    status = lay_candidate(context, search, candidate);
  return status ? status : visited_add(context, &search->visited, search->key);
}

/** Go to the smallest core met. */
static hexcon_status return_to_best(hexcon_context *context, sheet_search *search) {
  while (search->front.layer_count)
    take_back(search);
  hexcon_status status = HEXCON_OK;
  for (size_t i = 0; !status && i < search->best_count; i++)
    if (candidate_find(&search->front, &search->best_path[i], &search->region))
      status = lay_candidate(context, search, &search->best_path[i]);
  return status;
}

hexcon_status sheet_search_run(hexcon_context *context, const surface *s, const sheet_taste *taste,
                               size_t limit, sheet_search *out) {
  hexcon_status status = begin(context, s, taste, out);
  bool found = true;
  size_t spent = 0;
  while (!status && found && !front_is_hex(&out->front) && spent <= limit) {
    status =
        context_progress(context, STAGE_LOOPS, 1 - (double)out->best_alive / (double)s->quad_count);
    if (!status)
      status = push_level(context, out, taste);
    if (!status)
      status = advance(context, out, taste, &found);
    if (out->front.alive_count >= out->best_alive)
      spent += out->front.alive_count;
    else if (!status)
      keep_best(out);
  }
  if (!status && !front_is_hex(&out->front))
    return return_to_best(context, out);
  out->complete = !status;
  return status ? status : front_close(context, &out->front);
}
