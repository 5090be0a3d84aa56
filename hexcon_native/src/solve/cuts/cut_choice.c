/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "cut_choice.h"

#include <math.h>
#include <string.h>

#include "base/sorting.h"
#include "cut_crossings.h"
#include "disc_shapes.h"
#include "hexmesh/scaled_jacobian.h"
#include "homology/edge_labels.h"

/** Of loops of one kind so many are given discs, so many for each, and so many of all are kept; ..
 */
enum { LOOPS_OF_KIND = 12, DISCS_OF_LOOP = 3, KEPT_OF_KIND = 6 };
/** .. fewer loops, but one at least, where those of all kinds would take more passages to be
 * followed than this. */
static const double most_passages = 2e7;

/**
 * What a cut costs. A loop that crosses itself can hardly be taken away; two that cross more than
 * twice take more layers than they seem to need. A layer that is worse than good must be improved,
 * one that is not positive needs a layer more around it.
 */
static const double self_crossing = 8, excess_crossing = 1, square_radian = 3, quad_of_disc = 0.1;
static const double good_layer = 0.3, poor_layer = 5, bad_layer = 20;

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

/** Best first; where candidates are equal in all that counts, the loop's number decides. */
static int by_cost(const void *a, const void *b) {
  const cut_candidate *x = a, *y = b;
  if (x->cost != y->cost)
    return x->cost < y->cost ? -1 : 1;
  if (x->loop != y->loop)
    return x->loop < y->loop ? -1 : 1;
  if (x->shape.a != y->shape.a)
    return x->shape.a > y->shape.a ? -1 : 1;
  return (x->shape.first > y->shape.first) - (x->shape.first < y->shape.first);
}

/** Keep a candidate if it is among the best. @param count  of those kept, `most` at most */
static void keep(cut_candidate *best, size_t most, size_t *count, const cut_candidate *candidate) {
  size_t at = *count < most ? (*count)++ : most;
  if (at == most && by_cost(candidate, &best[--at]) >= 0)
    return;
  for (; at > 0 && by_cost(candidate, &best[at - 1]) < 0; at--)
    best[at] = best[at - 1];
  best[at] = *candidate;
}

/** Find the discs of a loop that promise most by the rim's angles and by how loops cross then, each
 * as a grid alone and with a ring of quads around.
 * @param best  [DISCS_OF_LOOP] */
static hexcon_status find_discs(hexcon_context *context, const surface *s,
                                const surface_loops *loops, const cutting_loop *cutting,
                                cut_candidate *best, size_t *kept) {
  rated_shape shapes[DISC_SHAPES_MOST];
  cut_crossings crossings = {0};
  size_t count = 0;
  double flat;
  const int32_t *ring = loops->entries + loops->offsets[cutting->loop];
  hexcon_status status = disc_shapes_find(context, s, ring, cutting->length, shapes, &count, &flat);
  *kept = 0;
  if (!status)
    status = cut_crossings_new(context, s, loops, cutting->loop, &crossings);
  for (size_t i = 0; !status && i < count; i++) {
    const crossing_counts c = cut_crossings_count(&crossings, &shapes[i].shape);
    for (size_t rings = 0; rings < 2; rings++) {
      cut_candidate one = {.loop = cutting->loop, .kind = cutting->kind, .shape = shapes[i].shape};
      one.shape.rings = rings;
      one.cost = self_crossing * (double)c.of_themselves + excess_crossing * (double)c.in_excess +
                 square_radian * (rings ? flat : shapes[i].misfit) +
                 quad_of_disc * (double)disc_shape_quads(&one.shape);
      keep(best, DISCS_OF_LOOP, kept, &one);
    }
    status = context_after(context, s->quad_count);
  }
  cut_crossings_free(context, &crossings);
  return status;
}

/** Place a disc, and add what its layer's shape costs. */
static hexcon_status weigh(hexcon_context *context, const surface *s, const int32_t *ring,
                           cut_candidate *candidate) {
  hexcon_status status = rate(context, s, ring, candidate);
  candidate->cost += candidate->worst < 0            ? bad_layer
                     : candidate->worst < good_layer ? poor_layer
                                                     : 0;
  candidate->cost -= candidate->worst;
  return status;
}

static hexcon_status choose_of_loop(hexcon_context *context, const surface *s,
                                    const cutting_loop *cutting, cut_candidate *best, size_t *count,
                                    cut_choice *out) {
  cut_candidate discs[DISCS_OF_LOOP];
  size_t kept = 0;
  const int32_t *ring = out->loops.entries + out->loops.offsets[cutting->loop];
  hexcon_status status = find_discs(context, s, &out->loops, cutting, discs, &kept);
  for (size_t i = 0; !status && i < kept; i++) {
    status = weigh(context, s, ring, &discs[i]);
    keep(best, KEPT_OF_KIND, count, &discs[i]);
  }
  return status;
}

/** The best of the loops of one kind. */
static hexcon_status choose_of_kind(hexcon_context *context, const surface *s,
                                    const cutting_loop *cutting, size_t loop_count,
                                    cut_choice *out) {
  size_t kept = 0;
  hexcon_status status = HEXCON_OK;
  for (size_t i = 0; !status && i < loop_count; i++)
    status = choose_of_loop(context, s, &cutting[i], out->candidates + out->count, &kept, out);
  out->count += kept;
  return status;
}

/** Where the loops of the kind at `first` end. */
static size_t end_of_kind(const cutting_loop *cutting, size_t first, size_t count) {
  size_t end = first;
  while (end < count && cutting[end].kind == cutting[first].kind)
    end++;
  return end;
}

static size_t loops_of_kind(const surface *s, const cutting_loop *cutting, size_t count) {
  size_t kinds = 0;
  for (size_t first = 0; first < count; first = end_of_kind(cutting, first, count))
    kinds++;
  double loops = most_passages / ((double)kinds * (double)DISC_SHAPES_MOST * (double)s->quad_count);
  return (size_t)fmin(fmax(loops, 1), LOOPS_OF_KIND);
}

static hexcon_status choose(hexcon_context *context, const surface *s, const cutting_loop *cutting,
                            cut_choice *out) {
  hexcon_status status = HEXCON_OK;
  const size_t count = out->cutting_count, most = loops_of_kind(s, cutting, count);
  for (size_t first = 0, end; !status && first < count; first = end) {
    end = end_of_kind(cutting, first, count);
    status =
        choose_of_kind(context, s, cutting + first, end - first < most ? end - first : most, out);
  }
  return status
             ? status
             : context_sort(context, out->candidates, out->count, sizeof *out->candidates, by_cost);
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
