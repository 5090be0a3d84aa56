/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "odd_cycles.h"

#include <string.h>

#include "edge_labels.h"
#include "linking_numbers.h"
#include "short_cycle.h"
#include "surface/colouring.h"

/** Paths are looked for from so many points of so many odd sums of basis cycles, .. */
enum { SUMS = 16, POINTS_OF_SUM = 8 };
/** .. as long as all searches together are no larger than this many points. */
static const size_t most_searched = 100000000;

typedef struct search {
  const surface *s;
  const handle_cycles *cycles;
  const bit_matrix *linking;
  uint8_t *sum; /* [4 quad_count] edges of a sum of cycles, under their lower half-edge */
  uint64_t
      *labels;    /* [4 quad_count] of half-edges: their sum over a path is 0 if it bounds inside */
  int32_t *place; /* [point_count] of points on the path that is being walked; -1 of others */
  int32_t *half_edge_of_point; /* [point_count] one that starts there */
  int32_t *walk;               /* [2 quad_count] half-edges of that path */
  int32_t *near;               /* [12 quad_count] quads where a sum may still be tightened */
} search;

static void search_free(hexcon_context *context, search *w) {
  context_free(context, w->sum);
  context_free(context, w->labels);
  context_free(context, w->place);
  context_free(context, w->half_edge_of_point);
  context_free(context, w->walk);
  context_free(context, w->near);
}

static hexcon_status search_new(hexcon_context *context, search *w) {
  const surface *s = w->s;
  w->sum = context_allocate_zeroed(context, 4 * s->quad_count, sizeof *w->sum);
  w->labels = context_allocate(context, 4 * s->quad_count, sizeof *w->labels);
  w->place = context_allocate(context, s->point_count, sizeof *w->place);
  w->half_edge_of_point = context_allocate(context, s->point_count, sizeof *w->half_edge_of_point);
  w->walk = context_allocate(context, 2 * s->quad_count, sizeof *w->walk);
  w->near = context_allocate(context, s->quad_count, 12 * sizeof *w->near);
  if (!w->sum || !w->labels || !w->place || !w->half_edge_of_point || !w->walk || !w->near)
    return HEXCON_OUT_OF_MEMORY;
  memset(w->place, -1, s->point_count * sizeof *w->place);
  for (size_t h = 0; h < 4 * s->quad_count; h++)
    w->half_edge_of_point[s->quads[h]] = (int32_t)h;
  return HEXCON_OK;
}

static int32_t edge_of(const surface *s, int32_t half_edge) {
  return half_edge < s->twins[half_edge] ? half_edge : s->twins[half_edge];
}

/* ---------------------------------------------------------------------------------- which bound */

static bool is_odd(const handle_cycles *c, size_t cycle) {
  return (c->first_along[cycle + 1] - c->first_along[cycle]) % 2;
}

/**
 * The linking matrix takes to zero what bounds inside, and is a projection: what it takes away from
 * a cycle bounds inside, and all that does is a sum of such rests. @return whether that of a cycle
 * is odd
 */
static bool rest_is_odd(const search *w, size_t cycle) {
  bool odd = is_odd(w->cycles, cycle);
  for (size_t j = 0; j < w->cycles->count; j++)
    odd ^= bit_matrix_get(w->linking, cycle, j) && is_odd(w->cycles, j);
  return odd;
}

static void add_cycle(search *w, size_t cycle) {
  for (size_t k = w->cycles->first_along[cycle]; k < w->cycles->first_along[cycle + 1]; k++)
    w->sum[edge_of(w->s, w->cycles->along[k])] ^= 1;
}

/** The edges of what bounds inside of a cycle; adding it again takes them away. */
static void add_rest(search *w, size_t cycle) {
  add_cycle(w, cycle);
  for (size_t j = 0; j < w->cycles->count; j++)
    if (bit_matrix_get(w->linking, cycle, j))
      add_cycle(w, j);
}

/* --------------------------------------------------------------------------------------- paths */

static int edges_at(const search *w, int32_t point) {
  int32_t start = w->half_edge_of_point[point], h = start;
  int count = 0;
  do {
    count += w->sum[edge_of(w->s, h)];
    h = w->s->twins[half_edge_turn(h, -1)];
  } while (h != start);
  return count;
}

/** Whether a sum passes two sides of a quad between which it touches itself, and not the corner
 * opposite: over the other two it does not. */
static bool touches_itself(const search *w, int32_t quad) {
  for (int32_t h = 4 * quad; h < 4 * quad + 4; h++) {
    const int32_t before = half_edge_turn(h, -1);
    if (w->sum[edge_of(w->s, h)] && w->sum[edge_of(w->s, before)])
      return edges_at(w, half_edge_start(w->s, h)) > 2 &&
             edges_at(w, half_edge_start(w->s, half_edge_turn(h, 2))) == 0;
  }
  return false;
}

/** Add quads to a sum as long as that makes it shorter, or touch itself less. A quad bounds, so the
 * sum stays what it is; no step makes more touching points, so there are at most as many steps as
 * edges. */
static void tighten(search *w) {
  const surface *s = w->s;
  size_t count = 0;
  for (int32_t h = 0; h < (int32_t)(4 * s->quad_count); h++)
    if (w->sum[edge_of(s, h)])
      w->near[count++] = half_edge_quad(h);
  while (count > 0) {
    const int32_t quad = w->near[--count];
    int sides = 0;
    for (int32_t h = 4 * quad; h < 4 * quad + 4; h++)
      sides += w->sum[edge_of(s, h)];
    if (sides < 3 && !(sides == 2 && touches_itself(w, quad)))
      continue;
    for (int32_t h = 4 * quad; h < 4 * quad + 4; h++) {
      w->sum[edge_of(s, h)] ^= 1;
      w->near[count++] = half_edge_quad(s->twins[h]);
    }
  }
}

/** A half-edge that leaves the point along an edge of the sum; -1 if there is none left. */
static int32_t way_on(const search *w, int32_t point) {
  int32_t start = w->half_edge_of_point[point], h = start;
  do {
    if (w->sum[edge_of(w->s, h)])
      return h;
    h = w->s->twins[half_edge_turn(h, -1)];
  } while (h != start);
  return -1;
}

static hexcon_status keep_points(hexcon_context *context, const search *w, const int32_t *path,
                                 size_t length, odd_cycles *out) {
  int32_t *grown =
      context_grow(context, out->points, out->point_count + length, sizeof *out->points);
  if (!grown)
    return HEXCON_OUT_OF_MEMORY;
  out->points = grown;
  for (size_t k = 0; k < length; k++)
    out->points[out->point_count++] = half_edge_start(w->s, path[k]);
  out->path_count++;
  return HEXCON_OK;
}

/** Take the sum apart into simple closed paths, from a point on: whenever the walk comes back to
 * where it was, it has closed one. */
static hexcon_status walk_from(hexcon_context *context, search *w, int32_t point, odd_cycles *out) {
  size_t length = 0;
  hexcon_status status = HEXCON_OK;
  for (int32_t h = way_on(w, point); !status && h >= 0; h = way_on(w, point)) {
    w->sum[edge_of(w->s, h)] = 0;
    w->place[point] = (int32_t)length;
    w->walk[length++] = h;
    point = half_edge_end(w->s, h);
    if (w->place[point] < 0)
      continue;
    const size_t first = (size_t)w->place[point];
    status = keep_points(context, w, w->walk + first, length - first, out);
    for (; length > first; length--)
      w->place[half_edge_start(w->s, w->walk[length - 1])] = -1;
  }
  return status;
}

/** The paths of what bounds inside of a cycle. */
static hexcon_status write_rest(hexcon_context *context, search *w, size_t cycle, odd_cycles *out) {
  hexcon_status status = HEXCON_OK;
  *out = (odd_cycles){.fillable = HEXCON_FILLABLE_NO};
  add_rest(w, cycle);
  tighten(w);
  status = context_after(context, w->s->quad_count);
  for (int32_t h = 0; !status && h < (int32_t)(4 * w->s->quad_count); h++)
    if (w->sum[h])
      status = walk_from(context, w, half_edge_start(w->s, h), out);
  return status;
}

static void keep_simpler(odd_cycles *best, odd_cycles *other) {
  bool simpler = other->path_count < best->path_count ||
                 (other->path_count == best->path_count && other->point_count < best->point_count);
  if (best->points && !simpler)
    return;
  odd_cycles worse = *best;
  *best = *other;
  *other = worse;
}

/** Look for one odd path that is shorter, from some points of those that were found. */
static hexcon_status shorten(hexcon_context *context, short_cycle_search *finder,
                             const odd_cycles *paths, odd_cycles *best) {
  hexcon_status status = HEXCON_OK;
  for (size_t k = 0; !status && k < POINTS_OF_SUM && k < paths->point_count; k++) {
    const size_t row = k * paths->point_count / POINTS_OF_SUM;
    odd_cycles found = {.fillable = HEXCON_FILLABLE_NO, .path_count = 1};
    found.points = context_allocate(context, finder->s->point_count, sizeof *found.points);
    if (!found.points)
      return HEXCON_OUT_OF_MEMORY;
    found.point_count =
        short_cycle_find(finder, paths->points[row],
                         best->path_count == 1 ? best->point_count : SIZE_MAX, found.points);
    if (found.point_count > 0)
      keep_simpler(best, &found);
    odd_cycles_free(context, &found);
    status = context_after(context, finder->s->point_count);
  }
  return status;
}

static hexcon_status find_paths(hexcon_context *context, search *w, odd_cycles *out) {
  short_cycle_search finder;
  const size_t step = POINTS_OF_SUM * w->s->point_count;
  hexcon_status status = short_cycle_new(context, w->s, w->labels, &finder);
  size_t looked = 0;
  out->fillable = HEXCON_FILLABLE_YES;
  for (size_t i = 0; !status && i < w->cycles->count && looked < SUMS; i++) {
    if (!rest_is_odd(w, i) || (looked > 0 && looked * step > most_searched))
      continue;
    odd_cycles paths;
    status = write_rest(context, w, i, &paths);
    if (!status)
      status = shorten(context, &finder, &paths, out);
    if (!status)
      keep_simpler(out, &paths);
    odd_cycles_free(context, &paths);
    looked++;
  }
  short_cycle_free(context, &finder);
  return status;
}

static hexcon_status judge(hexcon_context *context, const surface *s, const handle_cycles *cycles,
                           const bit_matrix *linking, odd_cycles *out) {
  search w = {.s = s, .cycles = cycles, .linking = linking};
  hexcon_status status = search_new(context, &w);
  if (!status) {
    edge_labels_write(s, cycles, linking, w.labels);
    status = find_paths(context, &w, out);
  }
  search_free(context, &w);
  return status;
}

static hexcon_status find_by_linking(hexcon_context *context, const surface *s, odd_cycles *out) {
  handle_cycles cycles;
  bit_matrix linking;
  bool known = false;
  hexcon_status status = linked_cycles_find(context, s, &cycles, &linking, &known);
  if (!status && known)
    status = judge(context, s, &cycles, &linking, out);
  bit_matrix_free(context, &linking);
  handle_cycles_free(context, &cycles);
  return status;
}

hexcon_status odd_cycles_find(hexcon_context *context, const surface *s, odd_cycles *out) {
  *out = (odd_cycles){0};
  uint8_t *colours = context_allocate(context, s->point_count, sizeof *colours);
  if (!colours)
    return HEXCON_OUT_OF_MEMORY;
  hexcon_status status = surface_colour(context, s, colours);
  context_free(context, colours);
  if (status == HEXCON_OK)
    out->fillable = HEXCON_FILLABLE_YES;
  if (status != HEXCON_NOT_BIPARTITE)
    return status;
  context_clear(context);
  return find_by_linking(context, s, out);
}

void odd_cycles_free(hexcon_context *context, odd_cycles *found) {
  context_free(context, found->points);
  *found = (odd_cycles){0};
}
