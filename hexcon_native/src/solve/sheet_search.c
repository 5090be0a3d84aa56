/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "sheet_search.h"

#include <string.h>

void sheet_search_free(hexcon_context *context, sheet_search *search) {
  front_free(context, &search->front);
  front_region_free(context, &search->region);
  layer_placement_free(context, &search->placement);
  context_free(context, search->points);
  candidates_free(context, &search->candidates);
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
  search->best_alive = s->quad_count + 1;
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

/** @param laid  false: the front would not be proper */
static hexcon_status lay_candidate(hexcon_context *context, sheet_search *search,
                                   const sheet_candidate *candidate, bool *laid) {
  *laid = candidate_find(&search->front, candidate, &search->region);
  if (!*laid)
    return HEXCON_OK;
  search->path[search->front.layer_count] = *candidate;
  return lay(context, search);
}

static void keep_best(sheet_search *search) {
  if (search->front.alive_count >= search->best_alive)
    return;
  search->best_alive = search->front.alive_count;
  search->best_count = search->front.layer_count;
  memcpy(search->best_path, search->path, search->best_count * sizeof *search->path);
}

/** Lay the next candidate that can be; where a level has none, go back to the one before.
 * @param found  false: there is no level left */
static hexcon_status advance(hexcon_context *context, sheet_search *search, bool *found) {
  hexcon_status status = HEXCON_OK;
  *found = false;
  while (!status && !*found && search->level_count) {
    sheet_level *level = &search->levels[search->level_count - 1];
    if (level->next < search->candidates.count) {
      status = lay_candidate(context, search, &search->candidates.items[level->next++], found);
      continue;
    }
    search->candidates.count = level->first;
    if (--search->level_count)
      front_take_back(&search->front);
  }
  return status;
}

/** Go to the smallest core met. */
static hexcon_status return_to_best(hexcon_context *context, sheet_search *search) {
  while (search->front.layer_count)
    front_take_back(&search->front);
  hexcon_status status = HEXCON_OK;
  bool laid = true;
  for (size_t i = 0; !status && laid && i < search->best_count; i++)
    status = lay_candidate(context, search, &search->best_path[i], &laid);
  return status;
}

hexcon_status sheet_search_run(hexcon_context *context, const surface *s, const sheet_taste *taste,
                               size_t limit, sheet_search *out) {
  hexcon_status status = begin(context, s, taste, out);
  bool found = true;
  size_t spent = 0;
  keep_best(out);
  while (!status && found && !front_is_hex(&out->front) && spent <= limit) {
    status = context_progress(context, "taking loops away",
                              1 - (double)out->best_alive / (double)s->quad_count);
    if (!status)
      status = push_level(context, out, taste);
    if (!status)
      status = advance(context, out, &found);
    if (out->front.alive_count >= out->best_alive)
      spent += out->front.alive_count;
    keep_best(out);
  }
  if (!status && !front_is_hex(&out->front))
    return return_to_best(context, out);
  out->complete = !status;
  return status ? status : front_close(context, &out->front);
}
