/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "pair_order.h"

#include <string.h>

/** Quads of a patch: all that is known of them fits into the cache. */
enum { PATCH = 1 << 12 };

static void append(pair_order *order, int32_t quad, size_t *count) {
  order->numbers[quad] = (int32_t)*count;
  order->quads[(*count)++] = quad;
}

/**
 * A quad without a number, next to one that has a number if there is such a one.
 * @param rim     new number before which no quad has a neighbour without; moves on
 * @param lowest  old number before which all quads have new ones; moves on
 */
static int32_t next_seed(const surface *s, const pair_order *order, size_t count, size_t *rim,
                         int32_t *lowest) {
  for (; *rim < count; (*rim)++)
    for (int side = 0; side < 4; side++) {
      int32_t other = half_edge_quad(s->twins[4 * order->quads[*rim] + side]);
      if (order->numbers[other] < 0)
        return other;
    }
  while (order->numbers[*lowest] >= 0)
    (*lowest)++;
  return *lowest;
}

/** Number what surrounds a quad, breadth-first, up to a whole patch. */
static void number_patch(const surface *s, pair_order *order, int32_t seed, size_t *count) {
  size_t head = *count, last = *count + PATCH;
  append(order, seed, count);
  for (; head < *count; head++)
    for (int side = 0; side < 4; side++) {
      int32_t other = half_edge_quad(s->twins[4 * order->quads[head] + side]);
      if (*count < last && order->numbers[other] < 0)
        append(order, other, count);
    }
}

static void number_quads(const surface *s, pair_order *order) {
  size_t count = 0, rim = 0;
  int32_t lowest = 0;
  memset(order->numbers, -1, s->quad_count * sizeof *order->numbers);
  while (count < s->quad_count)
    number_patch(s, order, next_seed(s, order, count, &rim, &lowest), &count);
}

hexcon_status pair_order_create(hexcon_context *context, const surface *s, pair_order *out) {
  size_t count = s->quad_count;
  *out = (pair_order){.quads = context_allocate(context, count, sizeof *out->quads),
                      .numbers = context_allocate(context, count, sizeof *out->numbers)};
  out->s.quad_count = count;
  out->s.twins = context_allocate(context, 4 * count, sizeof *out->s.twins);
  if (!out->quads || !out->numbers || !out->s.twins)
    return HEXCON_OUT_OF_MEMORY;
  number_quads(s, out);
  for (size_t h = 0; h < 4 * count; h++)
    out->s.twins[h] = pair_order_new(out, s->twins[pair_order_old(out, (int32_t)h)]);
  return HEXCON_OK;
}

void pair_order_free(hexcon_context *context, pair_order *order) {
  context_free(context, order->quads);
  context_free(context, order->numbers);
  surface_free(context, &order->s);
}
