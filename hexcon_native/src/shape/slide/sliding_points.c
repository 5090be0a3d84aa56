/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "sliding_points.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "base/vector.h"
#include "closed_forms.h"
#include "surface/checks.h"

/** What is wrong with a carrier; NULL: nothing. */
static const char *fault_of(const hexcon_sliding *given, size_t carrier) {
  const int32_t first = given->starts[carrier], end = given->starts[carrier + 1];
  if (first < 0 || end <= first || (carrier == 0 && first != 0))
    return "it has no pieces, or its first is not where the one before ends";
  for (int32_t i = first; i < end; i++) {
    const hexcon_carrier *piece = &given->pieces[i];
    const char *fault = carrier_fault(piece);
    if (fault)
      return fault;
    if (!carrier_is_closed(piece->kind) && !given->project)
      return "it has no closed form, and there is no project";
    if (hexcon_carrier_info(piece->kind)->freedom !=
        hexcon_carrier_info(given->pieces[first].kind)->freedom)
      return "its pieces are points, curves and surfaces mixed";
  }
  return NULL;
}

static hexcon_status check_carriers(hexcon_context *context, const hexcon_sliding *given) {
  const char *first = NULL;
  size_t bad = 0;
  for (size_t c = 0; c < given->carrier_count; c++) {
    const char *fault = fault_of(given, c);
    if (!fault)
      continue;
    first = first ? first : fault;
    bad++;
    context_add_element(context, (int32_t)c);
  }
  if (bad == 0)
    return HEXCON_OK;
  (void)context_fail(context, HEXCON_BAD_ARGUMENT,
                     "%zu of %zu carriers (listed) cannot be used; of the first, %s", bad,
                     given->carrier_count, first);
  return HEXCON_BAD_ARGUMENT;
}

static hexcon_status check_points_of(hexcon_context *context, const hexcon_sliding *given,
                                     size_t point_count) {
  size_t bad = 0;
  hexcon_status status = HEXCON_OK;
  for (size_t v = 0; !status && v < point_count; v++) {
    int32_t carrier = given->carrier_of_point[v];
    if (carrier < HEXCON_STAYS || (carrier >= 0 && (size_t)carrier >= given->carrier_count)) {
      bad++;
      context_add_element(context, (int32_t)v);
    }
    status = context_pass(context, v);
  }
  if (status || bad == 0)
    return status;
  (void)context_fail(context, HEXCON_INDEX_OUT_OF_RANGE,
                     "%zu points (listed) name carriers outside -2 .. %zu - 1", bad,
                     given->carrier_count);
  return HEXCON_INDEX_OUT_OF_RANGE;
}

hexcon_status sliding_points_new(hexcon_context *context, const hexcon_sliding *given,
                                 size_t point_count, sliding_points *out) {
  *out = (sliding_points){.point_count = point_count,
                          .carrier_of_point = given->carrier_of_point,
                          .starts = given->starts,
                          .project = given->project,
                          .project_user = given->project_user};
  if (given->carrier_count >= CONTEXT_MAX_COUNT) {
    (void)context_fail(context, HEXCON_TOO_LARGE, "%zu carriers are more than 32-bit ids count",
                       given->carrier_count);
    return HEXCON_TOO_LARGE;
  }
  hexcon_status status = check_carriers(context, given);
  if (!status)
    status = check_points_of(context, given, point_count);
  if (status)
    return status;
  size_t pieces = given->carrier_count > 0 ? (size_t)given->starts[given->carrier_count] : 0;
  out->pieces = context_allocate(context, pieces, sizeof *out->pieces);
  if (!out->pieces)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t i = 0; i < pieces; i++)
    out->pieces[i] = carrier_normalised(&given->pieces[i]);
  return facet_carriers_new(context, given, out->pieces, &out->facets);
}

void sliding_points_free(hexcon_context *context, sliding_points *points) {
  context_free(context, points->pieces);
  facet_carriers_free(context, &points->facets);
  memset(points, 0, sizeof *points);
}

uint8_t sliding_freedom(const sliding_points *points, int32_t point) {
  int32_t carrier = points->carrier_of_point[point];
  if (carrier < 0)
    return carrier == HEXCON_FREE ? 3 : 0;
  return (uint8_t)hexcon_carrier_info(points->pieces[points->starts[carrier]].kind)->freedom;
}

/** Of how many of a carrier's pieces hexcon_project is asked. */
static size_t asked_of(const sliding_points *points, int32_t carrier) {
  size_t asked = 0;
  for (int32_t i = carrier < 0 ? 0 : points->starts[carrier];
       carrier >= 0 && i < points->starts[carrier + 1]; i++)
    asked += !carrier_is_closed(points->pieces[i].kind);
  return asked;
}

bool sliding_is_asked(const sliding_points *points, int32_t point) {
  return asked_of(points, points->carrier_of_point[point]) > 0;
}

/** A place on a carrier; where nothing was found yet the distance is infinite. */
typedef struct landing {
  double nearest[3], direction[3], distance;
} landing;

static void take_nearer(landing *best, const double point[3], const double nearest[3],
                        const double direction[3]) {
  double gap[3];
  vector_subtract(point, nearest, gap);
  double distance = vector_length(gap);
  if (!(distance < best->distance))
    return;
  best->distance = distance;
  memcpy(best->nearest, nearest, 3 * sizeof *nearest);
  memcpy(best->direction, direction, 3 * sizeof *direction);
}

/** On the piece that its facets tell, or on the nearest piece of those with a closed form. */
static landing land_on_closed(const sliding_points *points, int32_t carrier,
                              const double point[3]) {
  landing best = {.distance = INFINITY};
  if (facet_carriers_know(&points->facets, carrier)) {
    facet_carriers_project(&points->facets, points->pieces, carrier, point, best.nearest,
                           best.direction);
    return best;
  }
  for (int32_t i = points->starts[carrier]; i < points->starts[carrier + 1]; i++) {
    double nearest[3], direction[3] = {0, 0, 0};
    if (!carrier_is_closed(points->pieces[i].kind))
      continue;
    carrier_project(&points->pieces[i], point, nearest, direction);
    take_nearer(&best, point, nearest, direction);
  }
  return best;
}

/** The points that lie on pieces without a closed form, once for each such piece, and the answers.
 */
typedef struct question {
  size_t count;
  double *points, *nearest, *directions; /* [count][3] */
  int32_t *tags;                         /* [count] */
} question;

static void question_free(hexcon_context *context, question *q) {
  context_free(context, q->points);
  context_free(context, q->nearest);
  context_free(context, q->directions);
  context_free(context, q->tags);
}

static hexcon_status question_new(hexcon_context *context, size_t count, question *q) {
  *q = (question){.count = count};
  q->points = context_allocate(context, count, 3 * sizeof *q->points);
  q->nearest = context_allocate_zeroed(context, count, 3 * sizeof *q->nearest);
  q->directions = context_allocate_zeroed(context, count, 3 * sizeof *q->directions);
  q->tags = context_allocate(context, count, sizeof *q->tags);
  return q->points && q->nearest && q->directions && q->tags ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

static int32_t carrier_at(const sliding_points *points, const int32_t *ids, size_t i) {
  return points->carrier_of_point[ids ? (size_t)ids[i] : i];
}

static void pose(const sliding_points *points, const int32_t *ids, size_t count, const double *x,
                 question *q) {
  size_t asked = 0;
  for (size_t i = 0; i < count; i++) {
    int32_t carrier = carrier_at(points, ids, i);
    for (int32_t k = carrier < 0 ? 0 : points->starts[carrier];
         carrier >= 0 && k < points->starts[carrier + 1]; k++) {
      if (carrier_is_closed(points->pieces[k].kind))
        continue;
      memcpy(q->points + 3 * asked, x + 3 * i, 3 * sizeof *x);
      q->tags[asked++] = points->pieces[k].tag;
    }
  }
}

static hexcon_status check_answer(hexcon_context *context, question *q) {
  for (size_t i = 0; i < q->count; i++) {
    double *direction = q->directions + 3 * i, length = vector_length(direction);
    if (!carrier_is_direction(direction) || !carrier_is_place(q->nearest + 3 * i))
      return context_fail(context, HEXCON_BAD_ARGUMENT,
                          "project answers for carrier tag %d at (%g, %g, %g) with a place or a "
                          "direction that is not finite, or a direction of no length",
                          (int)q->tags[i], q->points[3 * i], q->points[3 * i + 1],
                          q->points[3 * i + 2]);
    for (size_t k = 0; k < 3; k++)
      direction[k] /= length;
  }
  return HEXCON_OK;
}

/** Answers in the order of the question, beside the closed pieces. */
static void take_answers(const sliding_points *points, const int32_t *ids, size_t count, double *x,
                         double *directions, const question *q) {
  size_t asked = 0;
  for (size_t i = 0; i < count; i++) {
    int32_t carrier = carrier_at(points, ids, i);
    if (carrier < 0)
      continue;
    landing best = land_on_closed(points, carrier, x + 3 * i);
    for (size_t others = asked_of(points, carrier); others > 0; others--, asked++)
      take_nearer(&best, x + 3 * i, q->nearest + 3 * asked, q->directions + 3 * asked);
    memcpy(x + 3 * i, best.nearest, sizeof best.nearest);
    if (directions)
      memcpy(directions + 3 * i, best.direction, sizeof best.direction);
  }
}

hexcon_status sliding_points_project(hexcon_context *context, const sliding_points *points,
                                     const int32_t *ids, size_t count, double *x,
                                     double *directions) {
  question q = {0};
  size_t others = 0;
  for (size_t i = 0; i < count; i++)
    others += asked_of(points, carrier_at(points, ids, i));
  hexcon_status status = question_new(context, others, &q);
  if (!status && others > 0) {
    pose(points, ids, count, x, &q);
    status =
        points->project(points->project_user, q.count, q.points, q.tags, q.nearest, q.directions)
            ? check_answer(context, &q)
            : context_fail(context, HEXCON_CANCELLED, "cancelled by project");
  }
  if (!status)
    take_answers(points, ids, count, x, directions, &q);
  question_free(context, &q);
  return status ? status : context_after(context, count);
}

hexcon_status hexcon_project_points(hexcon_context *context, const double *points,
                                    size_t point_count, const hexcon_sliding *sliding,
                                    double *positions, double *directions) {
  context_clear(context);
  sliding_points s = {0};
  hexcon_status status = check_points(context, points, point_count, DBL_MAX);
  if (!status)
    status = sliding_points_new(context, sliding, point_count, &s);
  if (!status) {
    memmove(positions, points, 3 * point_count * sizeof *points);
    if (directions)
      memset(directions, 0, 3 * point_count * sizeof *directions);
    status = sliding_points_project(context, &s, NULL, point_count, positions, directions);
  }
  sliding_points_free(context, &s);
  return status;
}
