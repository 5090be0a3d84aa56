/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "cut_choice.h"

#include <math.h>
#include <string.h>

#include "base/sorting.h"
#include "disc_shapes.h"
#include "hexmesh/scaled_jacobian.h"
#include "homology/edge_labels.h"

/** Of loops of one kind so many are given discs, and so many of those are kept. */
enum { LOOPS_OF_KIND = 12, KEPT_OF_KIND = 2 };

/** Layers that are better than this count alike, and so do those within a step of each other: then
 * fewer quads are better. */
static const double good_layer = 0.55, step = 0.1;

void cut_choice_free(hexcon_context *context, cut_choice *choice) {
  surface_loops_free(context, &choice->loops);
  context_free(context, choice->candidates);
  *choice = (cut_choice){0};
}

/* ----------------------------------------------------------------------------------- which loops
 */

/** A loop that takes a handle away. */
typedef struct cutting_loop {
  size_t loop, length;
  uint64_t kind;
} cutting_loop;

static int by_kind(const void *a, const void *b) {
  const cutting_loop *x = a, *y = b;
  if (x->kind != y->kind)
    return x->kind < y->kind ? -1 : 1;
  if (x->length != y->length)
    return x->length < y->length ? -1 : 1;
  return (x->loop > y->loop) - (x->loop < y->loop);
}

/** True if neither rail meets itself or the other. @param marks  [points] below `mark` */
static bool is_simple(const surface *s, const int32_t *ring, size_t length, size_t *marks,
                      size_t mark) {
  for (size_t i = 0; i < length; i++) {
    size_t *left = &marks[half_edge_start(s, ring[i])], *right = &marks[half_edge_end(s, ring[i])];
    if (*left == mark || *right == mark)
      return false;
    *left = *right = mark;
  }
  return true;
}

static uint64_t sum_of_labels(const uint64_t *labels, const int32_t *ring, size_t length) {
  uint64_t sum = 0;
  for (size_t i = 0; i < length; i++)
    sum ^= labels[half_edge_turn(ring[i], -1)];
  return sum;
}

/** @param cutting  [loops] @param classes  labels of classes on the surface */
static hexcon_status list_cutting(hexcon_context *context, const cut_body *body,
                                  const uint64_t *classes, cutting_loop *cutting, cut_choice *out) {
  const surface_loops *loops = &out->loops;
  size_t *marks = context_allocate_zeroed(context, body->s.point_count, sizeof *marks);
  if (!marks)
    return HEXCON_OUT_OF_MEMORY;
  hexcon_status status = HEXCON_OK;
  for (size_t i = 0; !status && i < loops->count; i++) {
    const int32_t *ring = loops->entries + loops->offsets[i];
    const size_t length = loops->offsets[i + 1] - loops->offsets[i];
    status = context_after(context, length);
    if (loops->self_crossings[i] || length < 4 || length % 2 ||
        !is_simple(&body->s, ring, length, marks, i + 1))
      continue;
    out->simple_count++;
    uint64_t kind = sum_of_labels(classes, ring, length);
    if (kind != 0 && sum_of_labels(body->labels, ring, length) == 0)
      cutting[out->cutting_count++] = (cutting_loop){i, length, kind};
  }
  context_free(context, marks);
  return status ? status
                : context_sort(context, cutting, out->cutting_count, sizeof *cutting, by_kind);
}

/** @param classes  [4 quad_count] receives labels of classes on the surface */
static hexcon_status label_classes(hexcon_context *context, const surface *s, uint64_t *classes) {
  handle_cycles cycles;
  bool known = false;
  hexcon_status status = handle_cycles_find(context, s, &cycles, &known);
  if (!status && known)
    edge_labels_write(s, &cycles, NULL, classes);
  handle_cycles_free(context, &cycles);
  return status;
}

/* ----------------------------------------------------------------------------------- which discs
 */

/** The worst scaled Jacobian of the layer between the discs. */
static hexcon_status measure(hexcon_context *context, const placed_cut *cut, double *worst) {
  const size_t count = cut->disc.point_count;
  double *points = context_allocate(context, count, 6 * sizeof *points);
  if (!points)
    return HEXCON_OUT_OF_MEMORY;
  memcpy(points, cut->sides[CUT_RIGHT], 3 * count * sizeof *points);
  memcpy(points + 3 * count, cut->sides[CUT_LEFT], 3 * count * sizeof *points);
  *worst = 1;
  for (size_t q = 0; q < cut->disc.quad_count; q++) {
    int32_t hex[8];
    for (size_t i = 0; i < 4; i++) {
      hex[i] = cut->disc.quads[4 * q + i];
      hex[i + 4] = hex[i] + (int32_t)count;
    }
    *worst = fmin(*worst, scaled_jacobian(points, hex));
  }
  context_free(context, points);
  return HEXCON_OK;
}

static hexcon_status rate(hexcon_context *context, const surface *s, const int32_t *ring,
                          cut_candidate *candidate) {
  placed_cut cut;
  hexcon_status status = placed_cut_new(context, s, ring, &candidate->shape, &cut);
  if (!status)
    status = measure(context, &cut, &candidate->worst);
  placed_cut_free(context, &cut);
  return status;
}

static double rank_of(const cut_candidate *candidate) {
  return floor(fmin(candidate->worst, good_layer) / step);
}

/** Best first; where shapes are equal in all that counts, the loop's number decides. */
static int by_worth(const void *a, const void *b) {
  const cut_candidate *x = a, *y = b;
  if (rank_of(x) != rank_of(y))
    return rank_of(x) > rank_of(y) ? -1 : 1;
  size_t quads = disc_shape_quads(&x->shape), others = disc_shape_quads(&y->shape);
  if (quads != others)
    return quads < others ? -1 : 1;
  if (x->worst != y->worst)
    return x->worst > y->worst ? -1 : 1;
  if (x->loop != y->loop)
    return x->loop < y->loop ? -1 : 1;
  return (x->shape.first > y->shape.first) - (x->shape.first < y->shape.first);
}

/** Keep a candidate if it is among the best of its kind. @param count  of those kept */
static void keep(cut_candidate *best, size_t *count, const cut_candidate *candidate) {
  size_t at = *count < KEPT_OF_KIND ? (*count)++ : KEPT_OF_KIND;
  if (at == KEPT_OF_KIND && by_worth(candidate, &best[--at]) >= 0)
    return;
  for (; at > 0 && by_worth(candidate, &best[at - 1]) < 0; at--)
    best[at] = best[at - 1];
  best[at] = *candidate;
}

/** The best of the loops of one kind. */
static hexcon_status choose_of_kind(hexcon_context *context, const surface *s,
                                    const cutting_loop *cutting, size_t loop_count,
                                    cut_choice *out) {
  const size_t most_work = 2 * s->quad_count + 10000; /* quads of discs */
  size_t kept = 0, work = 0;
  hexcon_status status = HEXCON_OK;
  for (size_t i = 0; !status && i < loop_count && work < most_work; i++) {
    cut_candidate candidate = {.loop = cutting[i].loop, .kind = cutting[i].kind};
    const int32_t *ring = cut_choice_ring(out, &candidate);
    disc_shape shapes[DISC_SHAPES_MOST];
    size_t count = 0;
    status = disc_shapes_find(context, s, ring, cutting[i].length, shapes, &count);
    for (size_t k = 0; !status && k < count; k++) {
      candidate.shape = shapes[k];
      status = rate(context, s, ring, &candidate);
      work += disc_shape_quads(&candidate.shape);
      keep(out->candidates + out->count, &kept, &candidate);
    }
  }
  out->count += kept;
  return status;
}

static hexcon_status choose(hexcon_context *context, const surface *s, const cutting_loop *cutting,
                            cut_choice *out) {
  hexcon_status status = HEXCON_OK;
  for (size_t first = 0, end; !status && first < out->cutting_count; first = end) {
    for (end = first; end < out->cutting_count && cutting[end].kind == cutting[first].kind;)
      end++;
    size_t loops = end - first < LOOPS_OF_KIND ? end - first : LOOPS_OF_KIND;
    status = choose_of_kind(context, s, cutting + first, loops, out);
  }
  return status ? status
                : context_sort(context, out->candidates, out->count, sizeof *out->candidates,
                               by_worth);
}

hexcon_status cut_choice_find(hexcon_context *context, const cut_body *body, cut_choice *out) {
  const surface *s = &body->s;
  *out = (cut_choice){0};
  hexcon_status status = surface_find_loops(context, s, &out->loops);
  if (status)
    return status;
  cutting_loop *cutting = context_allocate(context, out->loops.count, sizeof *cutting);
  uint64_t *classes = context_allocate_zeroed(context, 4 * s->quad_count, sizeof *classes);
  status = cutting && classes ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  if (!status)
    status = label_classes(context, s, classes);
  if (!status)
    status = list_cutting(context, body, classes, cutting, out);
  if (!status) {
    out->candidates =
        context_allocate(context, out->cutting_count, KEPT_OF_KIND * sizeof *out->candidates);
    status = out->candidates ? choose(context, s, cutting, out) : HEXCON_OUT_OF_MEMORY;
  }
  context_free(context, cutting);
  context_free(context, classes);
  return status;
}
