/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "handle_cycles.h"

#include <string.h>

/** A breadth-first forest of points, or of quads: how each was reached, and how deep it lies. */
typedef struct forest {
  int32_t *reached_by; /* half-edge that leads there; -1 at roots */
  int32_t *depth;      /* -1: not reached */
} forest;

typedef struct trees {
  const surface *s;
  forest points, quads;
  int32_t *half_edge_of_point; /* [point_count] one that starts there, -1 if unused */
  int32_t *queue;              /* [point_count or quad_count, the larger] */
  uint8_t *taken;              /* [4 quad_count] by the tree or the cotree, alike on twins */
} trees;

static void trees_free(hexcon_context *context, trees *t) {
  context_free(context, t->points.reached_by);
  context_free(context, t->points.depth);
  context_free(context, t->quads.reached_by);
  context_free(context, t->quads.depth);
  context_free(context, t->half_edge_of_point);
  context_free(context, t->queue);
  context_free(context, t->taken);
}

static hexcon_status forest_new(hexcon_context *context, size_t count, forest *out) {
  out->reached_by = context_allocate(context, count, sizeof *out->reached_by);
  out->depth = context_allocate(context, count, sizeof *out->depth);
  if (!out->reached_by || !out->depth)
    return HEXCON_OUT_OF_MEMORY;
  memset(out->depth, -1, count * sizeof *out->depth);
  return HEXCON_OK;
}

static hexcon_status trees_new(hexcon_context *context, const surface *s, trees *out) {
  const size_t most = s->point_count > s->quad_count ? s->point_count : s->quad_count;
  *out = (trees){.s = s};
  hexcon_status status = forest_new(context, s->point_count, &out->points);
  if (!status)
    status = forest_new(context, s->quad_count, &out->quads);
  if (status)
    return status;
  out->half_edge_of_point =
      context_allocate(context, s->point_count, sizeof *out->half_edge_of_point);
  out->queue = context_allocate(context, most, sizeof *out->queue);
  out->taken = context_allocate_zeroed(context, 4 * s->quad_count, sizeof *out->taken);
  if (!out->half_edge_of_point || !out->queue || !out->taken)
    return HEXCON_OUT_OF_MEMORY;
  memset(out->half_edge_of_point, -1, s->point_count * sizeof *out->half_edge_of_point);
  for (size_t h = 0; h < 4 * s->quad_count; h++)
    out->half_edge_of_point[s->quads[h]] = (int32_t)h;
  return HEXCON_OK;
}

static void take(trees *t, int32_t half_edge) {
  t->taken[half_edge] = t->taken[t->s->twins[half_edge]] = 1;
}

/** Note that a node was reached, over an edge that is then taken. */
static bool reach(trees *t, forest *f, int32_t from, int32_t to, int32_t half_edge) {
  if (f->depth[to] >= 0)
    return false;
  f->depth[to] = f->depth[from] + 1;
  f->reached_by[to] = half_edge;
  take(t, half_edge);
  return true;
}

static hexcon_status grow_tree(hexcon_context *context, trees *t, int32_t root) {
  size_t head = 0, tail = 0;
  hexcon_status status = HEXCON_OK;
  t->points.depth[root] = 0;
  t->points.reached_by[root] = -1;
  t->queue[tail++] = root;
  while (!status && head < tail) {
    int32_t v = t->queue[head++], start = t->half_edge_of_point[v], h = start;
    do {
      int32_t other = half_edge_end(t->s, h);
      if (reach(t, &t->points, v, other, h))
        t->queue[tail++] = other;
      h = t->s->twins[half_edge_turn(h, -1)];
    } while (h != start);
    status = context_pass(context, head);
  }
  return status;
}

/** Over the edges that no tree of points has taken. */
static hexcon_status grow_cotree(hexcon_context *context, trees *t, int32_t root) {
  size_t head = 0, tail = 0;
  hexcon_status status = HEXCON_OK;
  t->quads.depth[root] = 0;
  t->quads.reached_by[root] = -1;
  t->queue[tail++] = root;
  while (!status && head < tail) {
    int32_t quad = t->queue[head++];
    for (int32_t h = 4 * quad; h < 4 * quad + 4; h++) {
      int32_t other = half_edge_quad(t->s->twins[h]);
      if (!t->taken[h] && reach(t, &t->quads, quad, other, h))
        t->queue[tail++] = other;
    }
    status = context_pass(context, head);
  }
  return status;
}

static hexcon_status grow(hexcon_context *context, trees *t) {
  hexcon_status status = HEXCON_OK;
  for (size_t v = 0; !status && v < t->s->point_count; v++)
    if (t->points.depth[v] < 0 && t->half_edge_of_point[v] >= 0)
      status = grow_tree(context, t, (int32_t)v);
  for (size_t q = 0; !status && q < t->s->quad_count; q++)
    if (t->quads.depth[q] < 0)
      status = grow_cotree(context, t, (int32_t)q);
  return status;
}

/* -------------------------------------------------------------------------------------- cycles */

static int32_t start_of(const trees *t, bool of_quads, int32_t h) {
  return of_quads ? half_edge_quad(h) : half_edge_start(t->s, h);
}

static int32_t end_of(const trees *t, bool of_quads, int32_t h) {
  return of_quads ? half_edge_quad(t->s->twins[h]) : half_edge_end(t->s, h);
}

/**
 * The cycle that an edge closes in a forest: over it, from its end up to where the branches meet,
 * and down to its start.
 * @param cycle  receives the half-edges, if not NULL
 * @return their number
 */
static size_t close_cycle(const trees *t, bool of_quads, int32_t half_edge, int32_t *cycle) {
  const forest *f = of_quads ? &t->quads : &t->points;
  int32_t up = end_of(t, of_quads, half_edge), down = start_of(t, of_quads, half_edge);
  int32_t a = up, b = down;
  while (a != b) {
    bool climb = f->depth[a] >= f->depth[b];
    int32_t *node = climb ? &a : &b;
    *node = start_of(t, of_quads, f->reached_by[*node]);
  }
  const size_t ups = (size_t)(f->depth[up] - f->depth[a]);
  const size_t length = 1 + ups + (size_t)(f->depth[down] - f->depth[a]);
  if (!cycle)
    return length;
  cycle[0] = half_edge;
  for (size_t i = 1; i <= ups; i++) {
    cycle[i] = t->s->twins[f->reached_by[up]];
    up = start_of(t, of_quads, f->reached_by[up]);
  }
  for (size_t i = length - 1; i > ups; i--) {
    cycle[i] = f->reached_by[down];
    down = start_of(t, of_quads, f->reached_by[down]);
  }
  return length;
}

/** One basis, along edges or across them: a cycle for each edge that is in no tree. */
static hexcon_status write_basis(hexcon_context *context, const trees *t, bool of_quads,
                                 const int32_t *left, size_t count, size_t **first,
                                 int32_t **cycles, bool *complete) {
  *first = context_allocate(context, count + 1, sizeof **first);
  if (!*first)
    return HEXCON_OUT_OF_MEMORY;
  size_t total = 0;
  size_t asked = 0;
  hexcon_status status = HEXCON_OK;
  for (size_t i = 0; !status && i < count && *complete; i++) {
    (*first)[i] = total;
    total += close_cycle(t, of_quads, left[i], NULL);
    *complete = total <= HANDLE_CYCLES_MOST;
    if (total - asked >= CONTEXT_PATIENCE) {
      status = context_ask(context);
      asked = total;
    }
  }
  (*first)[count] = total;
  if (status || !*complete)
    return status;
  *cycles = context_allocate(context, total, sizeof **cycles);
  if (!*cycles)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t i = 0; i < count; i++)
    (void)close_cycle(t, of_quads, left[i], *cycles + (*first)[i]);
  return HEXCON_OK;
}

static hexcon_status write_cycles(hexcon_context *context, const trees *t, handle_cycles *out,
                                  bool *complete) {
  const int32_t sides = (int32_t)(4 * t->s->quad_count);
  for (int32_t h = 0; h < sides; h++)
    out->count += !t->taken[h] && h < t->s->twins[h];
  int32_t *left = context_allocate(context, out->count, sizeof *left);
  if (!left)
    return HEXCON_OUT_OF_MEMORY;
  size_t next = 0;
  for (int32_t h = 0; h < sides; h++)
    if (!t->taken[h] && h < t->s->twins[h])
      left[next++] = h;
  hexcon_status status =
      write_basis(context, t, false, left, out->count, &out->first_along, &out->along, complete);
  if (!status && *complete)
    status =
        write_basis(context, t, true, left, out->count, &out->first_across, &out->across, complete);
  context_free(context, left);
  return status;
}

hexcon_status handle_cycles_find(hexcon_context *context, const surface *s, handle_cycles *out,
                                 bool *complete) {
  trees t;
  *out = (handle_cycles){0};
  *complete = true;
  hexcon_status status = trees_new(context, s, &t);
  if (!status)
    status = grow(context, &t);
  if (!status)
    status = write_cycles(context, &t, out, complete);
  trees_free(context, &t);
  return status;
}

void handle_cycles_free(hexcon_context *context, handle_cycles *cycles) {
  context_free(context, cycles->first_along);
  context_free(context, cycles->along);
  context_free(context, cycles->first_across);
  context_free(context, cycles->across);
  *cycles = (handle_cycles){0};
}
