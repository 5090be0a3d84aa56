/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "edge_lengths.h"

#include <math.h>
#include <string.h>

#include "base/vector.h"
#include "shape/place/conjugate_gradients.h"

/** Pull of a hex's mean on each of its edges, against 1 between opposite edges of a face. */
static const double weak = 1e-5;

typedef struct spreading {
  const patch *p;
  size_t edge_count;
  int32_t *edges;   /* [hex_count][PATCH_EDGES] ids of the patch's edges */
  uint8_t *trusted; /* [edge_count] */
  double *degree;   /* [edge_count] */
  double *lengths;  /* [edge_count] logarithms, as far as trusted */
} spreading;

/** Number the edges: those with the same lower end are in one bucket, and few. */
static hexcon_status number_edges(hexcon_context *context, spreading *s) {
  const patch *p = s->p;
  size_t uses = PATCH_EDGES * p->hex_count;
  size_t *starts = context_allocate_zeroed(context, p->point_count + 2, sizeof *starts);
  size_t *filled = context_allocate_zeroed(context, p->point_count, sizeof *filled);
  int32_t(*bucket)[2] = context_allocate(context, uses, sizeof *bucket); /* upper end, id */
  s->edges = context_allocate(context, uses, sizeof *s->edges);
  hexcon_status status = starts && filled && bucket && s->edges ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  for (int pass = 0; !status && pass < 2; pass++) {
    for (size_t i = 0; i < uses; i++) {
      const int32_t *corners = p->corners + 8 * (i / PATCH_EDGES);
      int edge = (int)(i % PATCH_EDGES), start = patch_edge_start(edge);
      int32_t a = corners[start], b = corners[start | 1 << edge / 4];
      size_t low = (size_t)(a < b ? a : b);
      int32_t high = a < b ? b : a;
      if (pass == 0) {
        starts[low + 1]++;
        continue;
      }
      size_t k = starts[low], end = k + filled[low];
      while (k < end && bucket[k][0] != high)
        k++;
      if (k == end) {
        bucket[k][0] = high;
        bucket[k][1] = (int32_t)s->edge_count++;
        filled[low]++;
      }
      s->edges[i] = bucket[k][1];
    }
    for (size_t v = 0; pass == 0 && v < p->point_count; v++)
      starts[v + 1] += starts[v];
  }
  context_free(context, starts);
  context_free(context, filled);
  context_free(context, bucket);
  return status;
}

/** Lengths and trust, edge by edge: an edge is as good as the worst hex at it. */
static void measure_edges(spreading *s, const uint8_t *healthy) {
  const patch *p = s->p;
  memset(s->trusted, healthy != NULL, s->edge_count);
  for (size_t i = 0; healthy && i < PATCH_EDGES * p->hex_count; i++)
    s->trusted[s->edges[i]] &= healthy[i / PATCH_EDGES];
  for (size_t i = 0; i < PATCH_EDGES * p->hex_count; i++) {
    const int32_t *corners = p->corners + 8 * (i / PATCH_EDGES);
    int edge = (int)(i % PATCH_EDGES), start = patch_edge_start(edge);
    size_t a = (size_t)corners[start], b = (size_t)corners[start | 1 << edge / 4];
    double along[3];
    vector_subtract(p->x + 3 * b, p->x + 3 * a, along);
    double length = vector_length(along);
    s->degree[s->edges[i]] += 2 + weak;
    if (a >= p->free_count && b >= p->free_count)
      s->trusted[s->edges[i]] = 1;
    if (length > 0)
      s->lengths[s->edges[i]] = log(length);
    else
      s->trusted[s->edges[i]] = 0;
  }
}

static void multiply(void *user, const double *in, double *out) {
  const spreading *s = user;
  memset(out, 0, s->edge_count * sizeof *out);
  for (size_t h = 0; h < s->p->hex_count; h++) {
    const int32_t *edges = s->edges + PATCH_EDGES * h;
    double mean = 0;
    for (int e = 0; e < PATCH_EDGES; e++)
      mean += in[edges[e]] / (double)PATCH_EDGES;
    for (int e = 0; e < PATCH_EDGES; e++) {
      int first = e & ~3; /* two of the four edges along the axis are opposite in a face */
      double own = in[edges[e]];
      out[edges[e]] += 2 * own - in[edges[first | ((e & 3) ^ 1)]] -
                       in[edges[first | ((e & 3) ^ 2)]] + weak * (own - mean);
    }
  }
  for (size_t e = 0; e < s->edge_count; e++)
    if (s->trusted[e])
      out[e] = 0;
}

static void precondition(void *user, const double *in, double *out) {
  const spreading *s = user;
  for (size_t e = 0; e < s->edge_count; e++)
    out[e] = s->trusted[e] ? 0 : in[e] / s->degree[e];
}

/** Unknown lengths start at the mean of the trusted ones; then the rest is solved for. */
static hexcon_status solve(hexcon_context *context, spreading *s, double *const work[5]) {
  double sum = 0, *b = work[4];
  size_t count = 0;
  for (size_t e = 0; e < s->edge_count; e++)
    if (s->trusted[e]) {
      sum += s->lengths[e];
      count++;
    }
  for (size_t e = 0; e < s->edge_count; e++)
    if (!s->trusted[e])
      s->lengths[e] = count > 0 ? sum / (double)count : 0;
  linear_system system = {
      s->edge_count, multiply, precondition, s, {work[0], work[1], work[2], work[3]}};
  multiply(s, s->lengths, b);
  double *change = s->degree + s->edge_count;
  memset(change, 0, s->edge_count * sizeof *change);
  for (size_t e = 0; e < s->edge_count; e++)
    b[e] = -b[e];
  hexcon_status status = conjugate_gradients(context, &system, b, 1e-4, 2000, change);
  for (size_t e = 0; e < s->edge_count; e++)
    s->lengths[e] += change[e];
  return status;
}

hexcon_status edge_lengths_spread(hexcon_context *context, patch *p, const uint8_t *healthy) {
  spreading s = {.p = p};
  double *work[5] = {NULL};
  hexcon_status status = number_edges(context, &s);
  if (!status) {
    s.trusted = context_allocate_zeroed(context, s.edge_count, sizeof *s.trusted);
    s.degree = context_allocate_zeroed(context, s.edge_count, 2 * sizeof *s.degree);
    s.lengths = context_allocate_zeroed(context, s.edge_count, sizeof *s.lengths);
    status = s.trusted && s.degree && s.lengths ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  }
  for (int i = 0; !status && i < 5; i++) {
    work[i] = context_allocate(context, s.edge_count, sizeof *work[i]);
    status = work[i] ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  }
  if (!status) {
    measure_edges(&s, healthy);
    status = solve(context, &s, work);
    for (size_t i = 0; i < PATCH_EDGES * p->hex_count; i++)
      p->stretch[i] = exp(-s.lengths[s.edges[i]]);
  }
  for (int i = 0; i < 5; i++)
    context_free(context, work[i]);
  context_free(context, s.edges);
  context_free(context, s.trusted);
  context_free(context, s.degree);
  context_free(context, s.lengths);
  return status;
}
