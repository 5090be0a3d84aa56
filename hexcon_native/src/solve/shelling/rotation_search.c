/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "rotation_search.h"

#include <math.h>
#include <stdlib.h>

#include "base/workers.h"
#include "solve/sheets/sheet_search.h"
#include "surface/corner_angles.h"

#define NO_ROTATION UINT32_MAX

/** Of a degree that is one off, and of a further shell for a surface of as many quads as a cell has
 * hexes, in crossings that are one too many. */
static const double irregularity_weight = 0.1, shell_weight = 1;

/** Rotations that make more points irregular than this are not looked at. */
static const double most_change = 4.5;

/** Points with fewer quads leave no room for hexes. */
static const double least_ideal = 3;

/** So many surfaces are looked at more closely for each that is kept. */
enum { BRANCHES = 3 };

enum { MOST_SHELLS = 8, CELL_HEXES = 38 };

/* ------------------------------------------------------------------------------------- surfaces */

static void rotated_surface_free(hexcon_context *context, rotated_surface *r) {
  context_free(context, r->s.quads);
  context_free(context, r->s.twins);
  context_free(context, r->depth);
}

static hexcon_status rotated_surface_new(hexcon_context *context, const surface *s,
                                         rotated_surface *out) {
  out->s = (surface){.point_count = s->point_count,
                     .quad_count = s->quad_count,
                     .component_count = s->component_count};
  out->s.quads = context_allocate(context, 4 * s->quad_count, sizeof *out->s.quads);
  out->s.twins = context_allocate(context, 4 * s->quad_count, sizeof *out->s.twins);
  out->depth = context_allocate_zeroed(context, s->quad_count, sizeof *out->depth);
  out->node = NO_ROTATION;
  return out->s.quads && out->s.twins && out->depth ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

static void rotated_surface_copy(const rotated_surface *from, rotated_surface *to) {
  size_t sides = 4 * from->s.quad_count;
  surface s = to->s;
  uint8_t *depth = to->depth;
  *to = *from;
  to->s = s;
  to->depth = depth;
  memcpy(s.quads, from->s.quads, sides * sizeof *s.quads);
  memcpy(s.twins, from->s.twins, sides * sizeof *s.twins);
  memcpy(depth, from->depth, from->s.quad_count * sizeof *depth);
}

static uint64_t edge_key(int32_t a, int32_t b) {
  uint64_t x = (uint64_t)(a < b ? a : b) << 32 | (uint64_t)(a < b ? b : a);
  x = (x ^ x >> 31) * 0x7fb5d329728ea185u; /* thorough mixing: keys are joined by exclusive or */
  x = (x ^ x >> 27) * 0x81dadef4bc2dd44du;
  return x ^ x >> 33;
}

static double off(const rotation_search *search, const surface *s, int32_t half_edge, double more) {
  double by =
      (double)surface_degree(s, half_edge) + more - search->ideal[half_edge_start(s, half_edge)];
  return by * by;
}

/** What a rotation does to the irregularity: the edge's ends lose a quad, its new ends gain one. */
static double change_of_irregularity(const rotation_search *search, const surface *s,
                                     edge_rotation r) {
  int32_t twin = s->twins[r.half_edge];
  int32_t gain[2] = {half_edge_turn(r.half_edge, r.step + 1), half_edge_turn(twin, r.step + 1)};
  double change = off(search, s, r.half_edge, -1) - off(search, s, r.half_edge, 0) +
                  off(search, s, twin, -1) - off(search, s, twin, 0);
  for (int i = 0; i < 2; i++)
    change += off(search, s, gain[i], 1) - off(search, s, gain[i], 0);
  return change;
}

/** The shell in which an edge can be rotated: below those in which its quads were. */
static uint8_t shell_of(const rotated_surface *from, int32_t half_edge) {
  uint8_t a = from->depth[half_edge_quad(half_edge)];
  uint8_t b = from->depth[half_edge_quad(from->s.twins[half_edge])];
  return a > b ? a : b;
}

static size_t shells_of(const rotated_surface *r) {
  uint8_t most = 0;
  for (size_t q = 0; q < r->s.quad_count; q++)
    most = r->depth[q] > most ? r->depth[q] : most;
  return most;
}

/* ----------------------------------------------------------------------------------- candidates */

/** What a rotation would be worth. @return false: it cannot be, or need not be looked at */
static bool weigh(const rotation_search *search, rotated_surface *from, edge_rotation r,
                  size_t shells, crossing_counter *counter, rotation_candidate *out) {
  surface *s = &from->s;
  int32_t corners[6];
  rotation_undo undo;
  uint8_t shell = shell_of(from, r.half_edge);
  double change = change_of_irregularity(search, s, r);
  rotation_hexagon(s, r.half_edge, corners);
  if (shell >= MOST_SHELLS || change > most_change || !surface_rotate(s, r, &undo))
    return false;
  loop_crossings c = count_crossings(s, counter);
  surface_rotate_back(s, &undo);
  size_t more = shell >= shells ? shell + 1u : shells;
  out->score = (double)(c.of_themselves + c.in_excess) +
               irregularity_weight * (from->irregularity + change) +
               shell_weight * (double)more * (double)s->quad_count / (double)CELL_HEXES;
  out->key =
      from->key ^ edge_key(corners[0], corners[3]) ^ edge_key(corners[r.step], corners[r.step + 3]);
  out->rotation = r;
  return true;
}

/** All rotations of one surface: a piece of work. */
static hexcon_status weigh_surface(void *user, hexcon_context *context, int worker, size_t item) {
  rotation_search *search = user;
  rotated_surface *from = &search->kept[item];
  size_t sides = 4 * from->s.quad_count, shells = shells_of(from), count = 0;
  rotation_candidate *out = search->candidates + item * sides;
  (void)context;
  for (int32_t h = 0; h < (int32_t)sides; h++)
    for (uint8_t step = 1; h < from->s.twins[h] && step <= 2; step++) {
      out[count].parent = (uint32_t)item;
      count += weigh(search, from, (edge_rotation){h, step}, shells, &search->counters[worker],
                     &out[count]);
    }
  search->counts[item] = count;
  return HEXCON_OK;
}

static hexcon_status find_candidates(hexcon_context *context, rotation_search *search) {
  size_t sides = 4 * search->kept->s.quad_count, most = search->count * sides;
  if (most > search->candidate_room) {
    rotation_candidate *grown = context_grow(context, search->candidates, most, sizeof *grown);
    if (!grown)
      return HEXCON_OUT_OF_MEMORY;
    search->candidates = grown;
    search->candidate_room = most;
  }
  hexcon_status status =
      workers_run(context, search->threads, search->count, STAGE_ROTATIONS, weigh_surface, search);
  search->candidate_count = 0;
  for (size_t i = 0; !status && i < search->count; i++) {
    memmove(search->candidates + search->candidate_count, search->candidates + i * sides,
            search->counts[i] * sizeof *search->candidates);
    search->candidate_count += search->counts[i];
  }
  return status;
}

static int compare(const void *a, const void *b) {
  const rotation_candidate *x = a, *y = b;
  if (x->score != y->score)
    return x->score < y->score ? -1 : 1;
  if (x->parent != y->parent)
    return x->parent < y->parent ? -1 : 1;
  if (x->rotation.half_edge != y->rotation.half_edge)
    return x->rotation.half_edge < y->rotation.half_edge ? -1 : 1;
  return (x->rotation.step > y->rotation.step) - (x->rotation.step < y->rotation.step);
}

/** Make the surface of a candidate. */
static hexcon_status keep(hexcon_context *context, rotation_search *search,
                          const rotation_candidate *c, rotated_surface *to) {
  if (search->node_count == search->node_room) {
    size_t room = 2 * search->node_room + 64;
    rotation_node *grown = context_grow(context, search->nodes, room, sizeof *grown);
    if (!grown)
      return HEXCON_OUT_OF_MEMORY;
    search->nodes = grown;
    search->node_room = room;
  }
  const rotated_surface *from = &search->kept[c->parent];
  rotation_undo undo;
  uint8_t shell = shell_of(from, c->rotation.half_edge);
  rotated_surface_copy(from, to);
  to->irregularity += change_of_irregularity(search, &to->s, c->rotation);
  (void)surface_rotate(&to->s, c->rotation, &undo); /* it could be rotated when it was considered */
  to->depth[undo.quads[0]] = to->depth[undo.quads[1]] = (uint8_t)(shell + 1);
  to->crossings = count_crossings(&to->s, search->counters);
  to->key = c->key;
  to->score = c->score;
  to->node = (uint32_t)search->node_count;
  search->nodes[search->node_count++] = (rotation_node){c->rotation, shell, from->node};
  return HEXCON_OK;
}

/** Take loops away without looking back: a piece of work. */
static hexcon_status find_core(void *user, hexcon_context *context, int worker, size_t item) {
  const rotation_search *search = user;
  rotated_surface *r = &search->next[item];
  const sheet_taste taste = {.hex_weight = 1, .seed = 1, .least_corner = -1};
  surface s = r->s;
  sheet_search sheets;
  (void)worker;
  s.points = search->points;
  hexcon_status status = sheet_search_run(context, &s, &taste, 0, &sheets);
  r->core = sheets.complete ? 0 : sheets.front.alive_count;
  r->score += search->core_weight * (double)r->core;
  sheet_search_free(context, &sheets);
  return status;
}

static int compare_surfaces(const void *a, const void *b) {
  const rotated_surface *x = a, *y = b;
  if (x->score != y->score)
    return x->score < y->score ? -1 : 1;
  return (x->key > y->key) - (x->key < y->key);
}

/** The best candidates that have not been met. @param count  receives their number */
static hexcon_status make_next(hexcon_context *context, rotation_search *search, size_t *count) {
  hexcon_status status = HEXCON_OK;
  *count = 0;
  for (size_t i = 0; !status && i < search->candidate_count && *count < BRANCHES * search->width;
       i++) {
    const rotation_candidate *c = &search->candidates[i];
    if (visited_has(&search->visited, c->key))
      continue;
    status = visited_add(context, &search->visited, c->key);
    if (!status)
      status = keep(context, search, c, &search->next[(*count)++]);
  }
  return status;
}

hexcon_status rotation_search_advance(hexcon_context *context, rotation_search *search) {
  size_t count = 0;
  hexcon_status status = find_candidates(context, search);
  if (status)
    return status;
  qsort(search->candidates, search->candidate_count, sizeof *search->candidates, compare);
  status = make_next(context, search, &count);
  if (!status)
    status = workers_run(context, search->threads, count, STAGE_LOOPS, find_core, search);
  if (status)
    return status;
  qsort(search->next, count, sizeof *search->next, compare_surfaces);
  search->count = count < search->width ? count : search->width;
  for (size_t i = 0; i < search->count; i++) {
    rotated_surface before = search->kept[i];
    search->kept[i] = search->next[i];
    search->next[i] = before;
  }
  search->step++;
  return HEXCON_OK;
}

/* ---------------------------------------------------------------------------- beginning and end */

void rotation_search_free(hexcon_context *context, rotation_search *search) {
  for (size_t i = 0; search->kept && i < search->width; i++)
    rotated_surface_free(context, &search->kept[i]);
  for (size_t i = 0; search->next && i < BRANCHES * search->width; i++)
    rotated_surface_free(context, &search->next[i]);
  context_free(context, search->kept);
  context_free(context, search->next);
  context_free(context, search->ideal);
  for (int i = 0; search->counters && i < search->threads; i++)
    crossing_counter_free(context, &search->counters[i]);
  context_free(context, search->counters);
  context_free(context, search->counts);
  visited_free(context, &search->visited);
  context_free(context, search->nodes);
  context_free(context, search->candidates);
  *search = (rotation_search){0};
}

/** As many quads as fit the angle around a point: 4 in the plane, 3 at a cube's corner. */
static void find_ideals(const surface *s, double *ideal) {
  const double right = acos(0);
  memset(ideal, 0, s->point_count * sizeof *ideal);
  for (int32_t h = 0; h < (int32_t)(4 * s->quad_count); h++)
    ideal[half_edge_start(s, h)] += surface_corner_angle(s, h) / right;
  for (size_t p = 0; p < s->point_count; p++)
    ideal[p] = fmax(ideal[p], least_ideal);
}

static void first_surface(const surface *s, rotation_search *search, rotated_surface *first) {
  memcpy(first->s.quads, s->quads, 4 * s->quad_count * sizeof *s->quads);
  memcpy(first->s.twins, s->twins, 4 * s->quad_count * sizeof *s->twins);
  for (int32_t h = 0; h < (int32_t)(4 * s->quad_count); h++) /* each degree, once for each quad */
    first->irregularity += off(search, s, h, 0) / (double)surface_degree(s, h);
  first->crossings = count_crossings(s, search->counters);
  search->count = 1;
}

static hexcon_status allocate(hexcon_context *context, const surface *s, rotation_search *out) {
  out->kept = context_allocate_zeroed(context, out->width, sizeof *out->kept);
  out->next = context_allocate_zeroed(context, BRANCHES * out->width, sizeof *out->next);
  out->ideal = context_allocate(context, s->point_count, sizeof *out->ideal);
  out->counts = context_allocate(context, out->width, sizeof *out->counts);
  out->counters = context_allocate_zeroed(context, (size_t)out->threads, sizeof *out->counters);
  if (!out->kept || !out->next || !out->ideal || !out->counts || !out->counters)
    return HEXCON_OUT_OF_MEMORY;
  hexcon_status status = HEXCON_OK;
  for (int i = 0; !status && i < out->threads; i++)
    status = crossing_counter_new(context, s->quad_count, &out->counters[i]);
  for (size_t i = 0; !status && i < out->width; i++)
    status = rotated_surface_new(context, s, &out->kept[i]);
  for (size_t i = 0; !status && i < BRANCHES * out->width; i++)
    status = rotated_surface_new(context, s, &out->next[i]);
  return status;
}

hexcon_status rotation_search_begin(hexcon_context *context, const surface *s, size_t width,
                                    double core_weight, int threads, rotation_search *out) {
  *out = (rotation_search){.width = width,
                           .core_weight = core_weight,
                           .threads = workers_count(threads),
                           .points = s->points};
  hexcon_status status = allocate(context, s, out);
  if (status)
    return status;
  find_ideals(s, out->ideal);
  first_surface(s, out, &out->kept[0]);
  rotated_surface_copy(&out->kept[0], &out->next[0]);
  status = find_core(out, context, 0, 0);
  out->kept[0].core = out->next[0].core;
  return status;
}

void rotation_plan_free(hexcon_context *context, rotation_plan *plan) {
  context_free(context, plan->rotations);
  context_free(context, plan->shells);
  *plan = (rotation_plan){0};
}

hexcon_status rotation_search_plan(hexcon_context *context, const rotation_search *search,
                                   size_t index, rotation_plan *out) {
  *out = (rotation_plan){.count = search->step};
  out->rotations = context_allocate(context, out->count, sizeof *out->rotations);
  out->shells = context_allocate(context, out->count, sizeof *out->shells);
  if (!out->rotations || !out->shells)
    return HEXCON_OUT_OF_MEMORY;
  uint32_t node = search->kept[index].node;
  for (size_t i = out->count; i-- > 0; node = search->nodes[node].before) {
    out->rotations[i] = search->nodes[node].rotation;
    out->shells[i] = search->nodes[node].shell;
    if (out->shells[i] >= out->shell_count)
      out->shell_count = out->shells[i] + 1u;
  }
  return HEXCON_OK;
}
