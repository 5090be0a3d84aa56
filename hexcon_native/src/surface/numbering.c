/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "numbering.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------------------------------------- sorting */

/** Something to be sorted: by its key, then by what it is. */
typedef struct item {
  uint64_t key;
  const void *what;
} item;

enum { DIGIT_BITS = 11, DIGITS = 6, BUCKETS = 1 << DIGIT_BITS };

/** One stable pass, by one digit of the keys. */
static void sort_by_digit(const item *from, item *to, size_t count, int digit) {
  size_t starts[BUCKETS + 1] = {0};
  const int shift = digit * DIGIT_BITS;
  for (size_t i = 0; i < count; i++)
    starts[(from[i].key >> shift) % BUCKETS + 1]++;
  for (size_t b = 0; b < BUCKETS; b++)
    starts[b + 1] += starts[b];
  for (size_t i = 0; i < count; i++)
    to[starts[(from[i].key >> shift) % BUCKETS]++] = from[i];
}

/** By key (digit by digit, from the lowest), and items of one key by `compare`. */
static hexcon_status sort_items(hexcon_context *context, item *items, size_t count,
                                int (*compare)(const void *, const void *)) {
  item *scratch = context_allocate(context, count, sizeof *scratch);
  if (!scratch)
    return HEXCON_OUT_OF_MEMORY;
  for (int digit = 0; digit < DIGITS; digit += 2) { /* even in number: they end where they began */
    sort_by_digit(items, scratch, count, digit);
    sort_by_digit(scratch, items, count, digit + 1);
  }
  context_free(context, scratch);
  hexcon_status status = context_after(context, count);
  for (size_t first = 0, end; !status && first < count; first = end) {
    for (end = first + 1; end < count && items[end].key == items[first].key;)
      end++;
    if (end - first > 1)
      qsort(items + first, end - first, sizeof *items, compare);
  }
  return status;
}

/* -------------------------------------------------------------------------------------- points */

enum { CELL_BITS = 21 }; /* a coordinate: three of them fill a key */

/** Bits 0 .. 20 of a number, each to the third place after the one before. */
static uint64_t spread_bits(uint64_t x) {
  x = (x | x << 32) & UINT64_C(0x001f00000000ffff);
  x = (x | x << 16) & UINT64_C(0x001f0000ff0000ff);
  x = (x | x << 8) & UINT64_C(0x100f00f00f00f00f);
  x = (x | x << 4) & UINT64_C(0x10c30c30c30c30c3);
  return (x | x << 2) & UINT64_C(0x1249249249249249);
}

typedef struct box {
  double low[3], side; /* of a cube */
} box;

static box bounding_cube(const double *points, size_t count) {
  box b = {{points[0], points[1], points[2]}, 0};
  double high[3] = {points[0], points[1], points[2]};
  for (size_t v = 1; v < count; v++)
    for (size_t k = 0; k < 3; k++) {
      b.low[k] = fmin(b.low[k], points[3 * v + k]);
      high[k] = fmax(high[k], points[3 * v + k]);
    }
  for (size_t k = 0; k < 3; k++)
    b.side = fmax(b.side, high[k] - b.low[k]);
  return b;
}

/** Of the cell in which a point lies; cells are passed along a Morton curve. */
static uint64_t cell_key(const box *b, const double point[3]) {
  const double most = (double)((1 << CELL_BITS) - 1);
  uint64_t key = 0;
  for (int k = 0; k < 3; k++) {
    double part = b->side > 0 ? (point[k] - b->low[k]) / b->side : 0;
    key |= spread_bits((uint64_t)(fmin(fmax(part, 0), 1) * most)) << k;
  }
  return key;
}

/** Points that coincide keep their order. */
static int compare_points(const void *a, const void *b) {
  const double *p = ((const item *)a)->what, *q = ((const item *)b)->what;
  for (int k = 0; k < 3; k++)
    if (p[k] != q[k])
      return p[k] < q[k] ? -1 : 1;
  return p < q ? -1 : p > q;
}

static hexcon_status sort_points(hexcon_context *context, numbering *names) {
  const size_t count = names->point_count;
  const double *points = names->given_points;
  item *items = context_allocate(context, count, sizeof *items);
  if (!items)
    return HEXCON_OUT_OF_MEMORY;
  const box b = bounding_cube(points, count);
  for (size_t v = 0; v < count; v++)
    items[v] = (item){cell_key(&b, points + 3 * v), points + 3 * v};
  hexcon_status status = sort_items(context, items, count, compare_points);
  for (size_t v = 0; !status && v < count; v++)
    names->points[v] = (int32_t)(((const double *)items[v].what - points) / 3);
  context_free(context, items);
  return status;
}

/* --------------------------------------------------------------------------------------- quads */

/** Quads that begin with the same edge: there are some where points are joined by several. */
static int compare_quads(const void *a, const void *b) {
  const int32_t *p = ((const item *)a)->what, *q = ((const item *)b)->what;
  for (int k = 2; k < 4; k++)
    if (p[k] != q[k])
      return p[k] < q[k] ? -1 : 1;
  return p < q ? -1 : p > q;
}

/** The given quads in canonical points, each from its lowest on. @param shifts [quad_count]
 * receives the corner with which it begins */
static hexcon_status turn_quads(hexcon_context *context, const numbering *names, int32_t *turned,
                                uint8_t *shifts) {
  int32_t *ranks = context_allocate(context, names->point_count, sizeof *ranks);
  if (!ranks)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t v = 0; v < names->point_count; v++)
    ranks[names->points[v]] = (int32_t)v;
  for (size_t q = 0; q < names->quad_count; q++) {
    int32_t corners[4];
    uint8_t lowest = 0;
    for (uint8_t i = 0; i < 4; i++) {
      corners[i] = ranks[names->given_quads[4 * q + i]];
      lowest = corners[i] < corners[lowest] ? i : lowest;
    }
    shifts[q] = lowest;
    for (size_t i = 0; i < 4; i++)
      turned[4 * q + i] = corners[(i + lowest) % 4];
  }
  context_free(context, ranks);
  return HEXCON_OK;
}

/** @param quads [quad_count][4] receives the turned quads in their canonical order */
static hexcon_status sort_quads(hexcon_context *context, const int32_t *turned, numbering *names,
                                int32_t *quads) {
  const size_t count = names->quad_count;
  item *items = context_allocate(context, count, sizeof *items);
  if (!items)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t q = 0; q < count; q++)
    items[q] = (item){(uint64_t)turned[4 * q] << 31 | (uint64_t)turned[4 * q + 1], turned + 4 * q};
  hexcon_status status = sort_items(context, items, count, compare_quads);
  for (size_t q = 0; !status && q < count; q++) {
    const int32_t *quad = items[q].what;
    names->quads[q] = (int32_t)((quad - turned) / 4);
    names->quad_ranks[names->quads[q]] = (int32_t)q;
    memcpy(quads + 4 * q, quad, 4 * sizeof *quad);
  }
  context_free(context, items);
  return status;
}

/** The adjacency of the given surface, in canonical half-edges. */
static void copy_twins(const surface *given, const numbering *names, const uint8_t *shifts,
                       surface *canonical) {
  for (size_t q = 0; q < names->quad_count; q++) {
    const int32_t from = names->quads[q];
    for (int32_t i = 0; i < 4; i++) {
      const int32_t twin = given->twins[4 * from + ((i + shifts[from]) & 3)],
                    other = half_edge_quad(twin);
      canonical->twins[4 * q + (size_t)i] =
          4 * names->quad_ranks[other] + ((twin - shifts[other]) & 3);
    }
  }
}

static hexcon_status number_quads(hexcon_context *context, const surface *given, numbering *names,
                                  surface *canonical) {
  int32_t *turned = context_allocate(context, names->quad_count, 4 * sizeof *turned);
  uint8_t *shifts = context_allocate(context, names->quad_count, sizeof *shifts);
  hexcon_status status = turned && shifts ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  if (!status)
    status = turn_quads(context, names, turned, shifts);
  if (!status)
    status = sort_quads(context, turned, names, canonical->quads);
  if (!status)
    copy_twins(given, names, shifts, canonical);
  context_free(context, turned);
  context_free(context, shifts);
  return status;
}

/* ------------------------------------------------------------------------------------- surface */

/** Components in the order of their first quads. */
static hexcon_status number_components(hexcon_context *context, const surface *given,
                                       const numbering *names, surface *canonical) {
  int32_t *ranks = context_allocate(context, given->component_count, sizeof *ranks), next = 0;
  if (!ranks)
    return HEXCON_OUT_OF_MEMORY;
  memset(ranks, -1, given->component_count * sizeof *ranks);
  for (size_t q = 0; q < names->quad_count; q++) {
    const int32_t from = given->component_of_quad[names->quads[q]];
    if (ranks[from] < 0) {
      canonical->is_cavity[next] = given->is_cavity[from];
      ranks[from] = next++;
    }
    canonical->component_of_quad[q] = ranks[from];
  }
  context_free(context, ranks);
  return HEXCON_OK;
}

static hexcon_status allocate(hexcon_context *context, numbering *names, surface *canonical) {
  const size_t points = names->point_count, quads = names->quad_count;
  names->points = context_allocate(context, points, sizeof *names->points);
  names->quads = context_allocate(context, quads, sizeof *names->quads);
  names->quad_ranks = context_allocate(context, quads, sizeof *names->quad_ranks);
  canonical->points = context_allocate(context, points, 3 * sizeof *canonical->points);
  canonical->quads = context_allocate(context, quads, 4 * sizeof *canonical->quads);
  canonical->twins = context_allocate(context, quads, 4 * sizeof *canonical->twins);
  canonical->component_of_quad =
      context_allocate(context, quads, sizeof *canonical->component_of_quad);
  canonical->is_cavity =
      context_allocate(context, canonical->component_count, sizeof *canonical->is_cavity);
  return names->points && names->quads && names->quad_ranks && canonical->points &&
                 canonical->quads && canonical->twins && canonical->component_of_quad &&
                 canonical->is_cavity
             ? HEXCON_OK
             : HEXCON_OUT_OF_MEMORY;
}

static void copy_points(const numbering *names, double *points) {
  for (size_t v = 0; v < names->point_count; v++)
    memcpy(points + 3 * v, names->given_points + 3 * (size_t)names->points[v], 3 * sizeof *points);
}

hexcon_status numbering_new(hexcon_context *context, surface *given, numbering *out,
                            surface *canonical) {
  *out = (numbering){.point_count = given->point_count,
                     .quad_count = given->quad_count,
                     .given_points = given->points,
                     .given_quads = given->quads};
  given->quads = NULL;
  *canonical = (surface){.point_count = given->point_count,
                         .quad_count = given->quad_count,
                         .component_count = given->component_count,
                         .cavity_count = given->cavity_count,
                         .turned = given->turned,
                         .names = out};
  hexcon_status status = allocate(context, out, canonical);
  if (!status)
    status = sort_points(context, out);
  if (!status)
    status = context_after(context, out->point_count);
  if (!status)
    status = number_quads(context, given, out, canonical);
  if (!status)
    status = context_after(context, out->quad_count);
  if (!status)
    status = number_components(context, given, out, canonical);
  if (!status)
    copy_points(out, (double *)canonical->points);
  return status;
}

void numbering_free(hexcon_context *context, numbering *names, surface *canonical) {
  context_free(context, (void *)canonical->points);
  surface_free(context, canonical);
  context_free(context, names->given_quads);
  context_free(context, names->points);
  context_free(context, names->quads);
  context_free(context, names->quad_ranks);
  *names = (numbering){0};
}

/* --------------------------------------------------------------------------------------- names */

static void name(const int32_t *names, size_t name_count, int32_t *ids, size_t count) {
  for (size_t i = 0; i < count; i++)
    if (ids[i] >= 0 && (size_t)ids[i] < name_count)
      ids[i] = names[ids[i]];
}

int32_t numbering_quad_name(const surface *s, int32_t quad) {
  return s->names ? s->names->quads[quad] : quad;
}

void numbering_name_points(const numbering *names, int32_t *ids, size_t count) {
  name(names->points, names->point_count, ids, count);
}

void numbering_rank_points(const numbering *names, int32_t *ranks) {
  for (size_t v = 0; v < names->point_count; v++)
    ranks[names->points[v]] = (int32_t)v;
}

void numbering_rank_quads(const numbering *names, const int32_t *ids, size_t count,
                          int32_t *ranks) {
  if (count > 0)
    memcpy(ranks, ids, count * sizeof *ids);
  name(names->quad_ranks, names->quad_count, ranks, count);
}

static int compare_ids(const void *a, const void *b) {
  const int32_t one = *(const int32_t *)a, other = *(const int32_t *)b;
  return (one > other) - (one < other);
}

void numbering_name_elements(hexcon_context *context, const numbering *names,
                             hexcon_status status) {
  switch (status) {
  case HEXCON_NOT_BIPARTITE:
  case HEXCON_NO_SIDES:
  case HEXCON_NO_HEX_MESH:
    numbering_name_points(names, context->elements, context->element_count);
    break;
  case HEXCON_NOT_CERTIFIED: /* hexes */
  case HEXCON_BAD_PROPOSAL:
    break;
  case HEXCON_BAD_PAIRING: /* two by two */
    name(names->quads, names->quad_count, context->elements, context->element_count);
    break;
  default:
    name(names->quads, names->quad_count, context->elements, context->element_count);
    qsort(context->elements, context->element_count, sizeof *context->elements, compare_ids);
  }
}
