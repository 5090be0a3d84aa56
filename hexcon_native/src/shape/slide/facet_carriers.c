/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "facet_carriers.h"

#include <math.h>
#include <string.h>

#include "base/vector.h"
#include "closed_forms.h"

static bool is_facet(const hexcon_sliding *s, size_t facet, int32_t piece_count) {
  bool good = s->piece_of_facet[facet] >= 0 && s->piece_of_facet[facet] < piece_count;
  for (size_t k = 0; good && k < 3; k++) {
    int32_t point = s->facets[3 * facet + k];
    good = point >= 0 && (size_t)point < s->facet_point_count &&
           carrier_is_place(s->facet_points + 3 * (size_t)point) &&
           (!s->facet_normals || carrier_is_direction(s->facet_normals + 9 * facet + 3 * k));
  }
  return good;
}

static hexcon_status check_facets(hexcon_context *context, const hexcon_sliding *s) {
  size_t bad = 0;
  hexcon_status status = HEXCON_OK;
  if (s->facet_count >= CONTEXT_MAX_COUNT || s->facet_point_count >= CONTEXT_MAX_COUNT)
    return context_fail(context, HEXCON_TOO_LARGE, "%zu facets are more than 32-bit ids count",
                        s->facet_count);
  for (size_t f = 0; !status && f < s->facet_count; f++) {
    if (!is_facet(s, f, s->starts[s->carrier_count])) {
      bad++;
      context_add_element(context, (int32_t)f);
    }
    status = context_pass(context, f);
  }
  if (status || bad == 0)
    return status;
  return context_fail(context, HEXCON_INDEX_OUT_OF_RANGE,
                      "%zu facets (listed) name points or pieces that do not exist, or are not "
                      "finite",
                      bad);
}

/** What is wrong with the facets of a carrier; NULL: nothing. @param count  [pieces] */
static const char *fault_of(const hexcon_sliding *s, size_t carrier, const int32_t *count) {
  bool any = false;
  for (int32_t i = s->starts[carrier]; i < s->starts[carrier + 1]; i++)
    any = any || count[i] > 0;
  for (int32_t i = s->starts[carrier]; i < s->starts[carrier + 1]; i++) {
    int kind = s->pieces[i].kind;
    if (kind == HEXCON_CARRIER_FACETS && (count[i] == 0 || !s->facet_normals))
      return "it is made of facets, and has none, or they have no normals";
    if (any && (count[i] == 0 || hexcon_carrier_info(kind)->freedom != 2 ||
                kind == HEXCON_CARRIER_SURFACE))
      return "one of its pieces has facets, and another none, or is no surface that is known here";
  }
  return NULL;
}

static hexcon_status check_carriers(hexcon_context *context, const hexcon_sliding *s,
                                    const int32_t *count) {
  const char *first = NULL;
  for (size_t c = 0; c < s->carrier_count; c++) {
    const char *fault = fault_of(s, c, count);
    if (!fault)
      continue;
    first = first ? first : fault;
    context_add_element(context, (int32_t)c);
  }
  return first ? context_fail(context, HEXCON_BAD_ARGUMENT,
                              "carriers (listed) cannot be used; of the first, %s", first)
               : HEXCON_OK;
}

/** A facet's middle is where its closed form is farthest from it, about. */
static hexcon_status reach_out(hexcon_context *context, facet_carriers *f,
                               const hexcon_carrier *pieces) {
  const double enough = 1.5, rounding = 1e-9;
  const hexcon_sliding *s = f->given;
  hexcon_status status = HEXCON_OK;
  for (size_t i = 0; !status && i < s->facet_count; i++) {
    const hexcon_carrier *piece = &pieces[s->piece_of_facet[i]];
    status = context_pass(context, i);
    if (piece->kind == HEXCON_CARRIER_FACETS)
      continue;
    double middle[3] = {0, 0, 0}, on[3], way[3] = {0, 0, 0}, side[3];
    for (size_t k = 0; k < 3; k++)
      vector_add_scaled(middle, 1.0 / 3, s->facet_points + 3 * (size_t)s->facets[3 * i + k]);
    carrier_project(piece, middle, on, way);
    vector_subtract(on, middle, way);
    vector_subtract(s->facet_points + 3 * (size_t)s->facets[3 * i], middle, side);
    double far = enough * vector_length(way) + rounding * vector_length(side);
    f->reach[s->piece_of_facet[i]] = fmax(f->reach[s->piece_of_facet[i]], far);
  }
  return status;
}

/** Facets by carrier, in their order, and where each carrier's begin. */
static void sort_facets(const hexcon_sliding *s, const int32_t *carrier_of_piece, int32_t *starts,
                        int32_t *sorted) {
  for (size_t f = 0; f < s->facet_count; f++)
    starts[carrier_of_piece[s->piece_of_facet[f]] + 2]++;
  for (size_t c = 2; c < s->carrier_count + 2; c++)
    starts[c] += starts[c - 1];
  for (size_t f = 0; f < s->facet_count; f++)
    sorted[starts[carrier_of_piece[s->piece_of_facet[f]] + 1]++] = (int32_t)f;
}

static hexcon_status plant(hexcon_context *context, facet_carriers *f, int32_t *carrier_of_piece) {
  const hexcon_sliding *s = f->given;
  int32_t *starts = context_allocate_zeroed(context, s->carrier_count + 2, sizeof *starts);
  int32_t *sorted = context_allocate(context, s->facet_count, sizeof *sorted);
  hexcon_status status = starts && sorted ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  if (!status) {
    for (size_t c = 0; c < s->carrier_count; c++)
      for (int32_t i = s->starts[c]; i < s->starts[c + 1]; i++)
        carrier_of_piece[i] = (int32_t)c;
    sort_facets(s, carrier_of_piece, starts, sorted);
  }
  for (size_t c = 0; !status && c < s->carrier_count; c++)
    if (starts[c + 1] > starts[c])
      status = facet_tree_new(context, s->facet_points, s->facets, sorted + starts[c],
                              (size_t)(starts[c + 1] - starts[c]), &f->trees[c]);
  context_free(context, starts);
  context_free(context, sorted);
  return status;
}

hexcon_status facet_carriers_new(hexcon_context *context, const hexcon_sliding *given,
                                 const hexcon_carrier *pieces, facet_carriers *out) {
  *out = (facet_carriers){0};
  size_t piece_count = given->carrier_count > 0 ? (size_t)given->starts[given->carrier_count] : 0;
  hexcon_status status = check_facets(context, given);
  if (status)
    return status;
  int32_t *of_piece = context_allocate_zeroed(context, piece_count, sizeof *of_piece);
  if (!of_piece)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t f = 0; f < given->facet_count; f++)
    of_piece[given->piece_of_facet[f]]++;
  status = check_carriers(context, given, of_piece);
  if (!status && given->facet_count > 0) {
    out->given = given;
    out->trees = context_allocate_zeroed(context, given->carrier_count, sizeof *out->trees);
    out->reach = context_allocate_zeroed(context, piece_count, sizeof *out->reach);
    status = out->trees && out->reach ? plant(context, out, of_piece) : HEXCON_OUT_OF_MEMORY;
  }
  if (!status && out->given)
    status = reach_out(context, out, pieces);
  context_free(context, of_piece);
  return status;
}

void facet_carriers_free(hexcon_context *context, facet_carriers *facets) {
  for (size_t c = 0; facets->trees && c < facets->given->carrier_count; c++)
    facet_tree_free(context, &facets->trees[c]);
  context_free(context, facets->trees);
  context_free(context, facets->reach);
  memset(facets, 0, sizeof *facets);
}

bool facet_carriers_know(const facet_carriers *facets, int32_t carrier) {
  return facets->given && facets->trees[carrier].count > 0;
}

/** The cubic patch over a facet at some weights of its corners, and its normal. */
static void curved_place(const hexcon_sliding *s, const facet_place *at, double place[3],
                         double normal[3]) {
  const double *corner[3], *n[3];
  const double *w = at->weights;
  double unit[3][3], sum[3] = {0, 0, 0}, centre[3] = {0, 0, 0};
  memset(place, 0, 3 * sizeof *place);
  memset(normal, 0, 3 * sizeof *normal);
  for (size_t k = 0; k < 3; k++) {
    corner[k] = s->facet_points + 3 * (size_t)s->facets[3 * (size_t)at->facet + k];
    n[k] = s->facet_normals + 9 * (size_t)at->facet + 3 * k;
    memset(unit[k], 0, sizeof unit[k]);
    vector_add_scaled(unit[k], 1 / vector_length(n[k]), n[k]);
    vector_add_scaled(normal, w[k], unit[k]);
    vector_add_scaled(place, w[k] * w[k] * w[k], corner[k]);
    vector_add_scaled(centre, 1.0 / 3, corner[k]);
  }
  for (size_t i = 0; i < 3; i++)
    for (size_t j = 0; j < 3; j++) {
      if (i == j)
        continue;
      double edge[3], control[3] = {0, 0, 0}; /* a third along from i to j */
      vector_subtract(corner[j], corner[i], edge);
      vector_add_scaled(control, 2.0 / 3, corner[i]);
      vector_add_scaled(control, 1.0 / 3, corner[j]);
      vector_add_scaled(control, -vector_dot(edge, unit[i]) / 3, unit[i]);
      vector_add_scaled(place, 3 * w[i] * w[i] * w[j], control);
      vector_add_scaled(sum, 1.0 / 6, control);
    }
  vector_add_scaled(place, 6 * w[0] * w[1] * w[2] * 1.5, sum);
  vector_add_scaled(place, -6 * w[0] * w[1] * w[2] * 0.5, centre);
  double length = vector_length(normal);
  memcpy(normal, length > 1e-12 ? normal : unit[0], 3 * sizeof *normal);
  length = vector_length(normal);
  for (size_t k = 0; k < 3; k++)
    normal[k] /= length;
}

/** The place below a point on the curved facets, from the nearest flat one on. */
static void land_on_curved(const facet_carriers *f, int32_t carrier, const double point[3],
                           facet_place at, double nearest[3], double direction[3]) {
  const int steps = 2;
  for (int step = 0;; step++) {
    double gap[3], ahead[3];
    curved_place(f->given, &at, nearest, direction);
    if (step == steps)
      return;
    vector_subtract(point, nearest, gap);
    memcpy(ahead, at.foot, sizeof ahead);
    vector_add_scaled(ahead, 1, gap);
    vector_add_scaled(ahead, -vector_dot(gap, direction), direction);
    at = facet_tree_nearest(&f->trees[carrier], ahead);
  }
}

void facet_carriers_project(const facet_carriers *facets, const hexcon_carrier *pieces,
                            int32_t carrier, const double point[3], double nearest[3],
                            double direction[3]) {
  const int passes = 3; /* from a place a little beyond a border the neighbour's is nearer */
  const facet_tree *tree = &facets->trees[carrier];
  facet_place at = facet_tree_nearest(tree, point);
  double from[3] = {point[0], point[1], point[2]};
  for (int pass = 0; pass < passes; pass++) {
    int32_t number = facets->given->piece_of_facet[at.facet];
    double gap[3];
    if (pieces[number].kind == HEXCON_CARRIER_FACETS) {
      land_on_curved(facets, carrier, from, at, nearest, direction);
      return;
    }
    carrier_project(&pieces[number], from, nearest, direction);
    facet_place there = facet_tree_nearest(tree, nearest);
    vector_subtract(nearest, there.foot, gap);
    if (!(vector_length(gap) <= facets->reach[number])) {
      carrier_project(&pieces[number], at.foot, nearest, direction);
      there = facet_tree_nearest(tree, nearest);
    }
    if (facets->given->piece_of_facet[there.facet] == number)
      return;
    at = there;
    memcpy(from, nearest, sizeof from);
  }
}
