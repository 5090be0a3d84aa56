/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "canonical_order.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/sorting.h"
#include "base/vector.h"
#include "hexmesh/hex_tables.h"

typedef struct placed_point {
  double place; /* along a slant direction: symmetric meshes have few ties there */
  int32_t id;
} placed_point;

static int compare_points(const void *a, const void *b) {
  const placed_point *left = a, *right = b;
  if (left->place != right->place)
    return left->place < right->place ? -1 : 1;
  return (left->id > right->id) - (left->id < right->id);
}

static hexcon_status order_points(hexcon_context *context, const double *points,
                                  const uint8_t *fixed, int32_t *rank, canonical_order *out) {
  static const double slant[3] = {0.809017, 0.4812118, 0.3370621};
  placed_point *placed = context_allocate(context, out->point_count, sizeof *placed);
  if (!placed)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t v = 0; v < out->point_count; v++) {
    double place = vector_dot(slant, points + 3 * v);
    placed[v].place =
        isnan(place) ? 0 : place; /* a sum beyond all numbers; sorting needs an order */
    placed[v].id = (int32_t)v;
  }
  hexcon_status status =
      context_sort(context, placed, out->point_count, sizeof *placed, compare_points);
  for (size_t i = 0; !status && i < out->point_count; i++) {
    rank[placed[i].id] = (int32_t)i;
    out->point_ids[i] = placed[i].id;
    out->fixed[i] = fixed[placed[i].id];
    memcpy(out->points + 3 * i, points + 3 * (size_t)placed[i].id, 3 * sizeof *points);
  }
  context_free(context, placed);
  return status ? status : context_after(context, out->point_count);
}

/** The same hex, from its lowest point on, towards the lowest of that point's neighbours. */
static void turn_hex(const int32_t *hex, const int32_t *rank, int32_t *out) {
  int first = 0, axis = 0;
  for (int c = 1; c < 8; c++)
    if (rank[hex[c]] < rank[hex[first]])
      first = c;
  const unsigned char *neighbours = hex_corner_neighbours[first];
  for (int i = 1; i < 3; i++)
    if (rank[hex[neighbours[i]]] < rank[hex[neighbours[axis]]])
      axis = i;
  int by_bits[8];
  for (int c = 0; c < 8; c++)
    by_bits[hex_corner_bits[c]] = c;
  for (int c = 0; c < 8; c++) {
    int bits = hex_corner_bits[first];
    for (int i = 0; i < 3; i++)
      if (hex_corner_bits[c] >> i & 1)
        bits ^= hex_corner_bits[first] ^ hex_corner_bits[neighbours[(axis + i) % 3]];
    out[c] = rank[hex[by_bits[bits]]];
  }
}

static int compare_hexes(const void *a, const void *b) {
  const int32_t *left = a, *right = b;
  for (int c = 0; c < 8; c++)
    if (left[c] != right[c])
      return left[c] < right[c] ? -1 : 1;
  return 0;
}

/** Buckets by first point, and those sorted: few hexes have the same lowest point. */
static hexcon_status order_hexes(hexcon_context *context, const int32_t *hexes, const int32_t *rank,
                                 canonical_order *out) {
  size_t *starts = context_allocate_zeroed(context, out->point_count + 2, sizeof *starts);
  if (!starts)
    return HEXCON_OUT_OF_MEMORY;
  int32_t turned[8];
  hexcon_status status = HEXCON_OK;
  for (size_t h = 0; !status && h < out->hex_count; h++) {
    turn_hex(hexes + 8 * h, rank, turned);
    starts[turned[0] + 2]++;
    status = context_pass(context, h);
  }
  for (size_t v = 2; v < out->point_count + 2; v++)
    starts[v] += starts[v - 1];
  for (size_t h = 0; !status && h < out->hex_count; h++) {
    turn_hex(hexes + 8 * h, rank, turned);
    memcpy(out->hexes + 8 * starts[turned[0] + 1]++, turned, sizeof turned);
    status = context_pass(context, h);
  }
  for (size_t v = 0; !status && v < out->point_count; v++) {
    qsort(out->hexes + 8 * starts[v], starts[v + 1] - starts[v], sizeof turned, compare_hexes);
    status = context_pass(context, v);
  }
  context_free(context, starts);
  return status;
}

hexcon_status canonical_order_new(hexcon_context *context, const double *points, size_t point_count,
                                  const int32_t *hexes, size_t hex_count, const uint8_t *fixed,
                                  canonical_order *out) {
  *out = (canonical_order){.point_count = point_count, .hex_count = hex_count};
  int32_t *rank = context_allocate(context, point_count, sizeof *rank);
  out->point_ids = context_allocate(context, point_count, sizeof *out->point_ids);
  out->points = context_allocate(context, point_count, 3 * sizeof *out->points);
  out->fixed = context_allocate(context, point_count, sizeof *out->fixed);
  out->hexes = context_allocate(context, hex_count, 8 * sizeof *out->hexes);
  hexcon_status status = HEXCON_OUT_OF_MEMORY;
  if (rank && out->point_ids && out->points && out->fixed && out->hexes)
    status = order_points(context, points, fixed, rank, out);
  if (!status)
    status = order_hexes(context, hexes, rank, out);
  context_free(context, rank);
  return status;
}

void canonical_order_free(hexcon_context *context, canonical_order *order) {
  context_free(context, order->point_ids);
  context_free(context, order->points);
  context_free(context, order->fixed);
  context_free(context, order->hexes);
  memset(order, 0, sizeof *order);
}

void canonical_order_write(const canonical_order *order, double *points) {
  for (size_t i = 0; i < order->point_count; i++)
    memcpy(points + 3 * (size_t)order->point_ids[i], order->points + 3 * i, 3 * sizeof *points);
}
