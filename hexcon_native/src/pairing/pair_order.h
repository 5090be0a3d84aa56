/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Quads numbered anew so that those near each other have numbers near each other. */
#ifndef HEXCON_PAIRING_PAIR_ORDER_H
#define HEXCON_PAIRING_PAIR_ORDER_H

#include "surface/half_edges.h"

typedef struct pair_order {
  int32_t *quads;   /* [quad_count] old number by new */
  int32_t *numbers; /* [quad_count] new number by old */
  surface s;        /* quad_count and twins alone */
} pair_order;

/** Patch by patch, breadth-first: what surrounds a quad is then in the cache with it. Linear.
 * @param out  free with pair_order_free, also after OUT_OF_MEMORY */
hexcon_status pair_order_create(hexcon_context *context, const surface *s, pair_order *out);
void pair_order_free(hexcon_context *context, pair_order *order);

static inline int32_t pair_order_new(const pair_order *order, int32_t half_edge) {
  return 4 * order->numbers[half_edge_quad(half_edge)] + (half_edge & 3);
}

/** The half-edge as it was numbered before. */
static inline int32_t pair_order_old(const pair_order *order, int32_t half_edge) {
  return 4 * order->quads[half_edge_quad(half_edge)] + (half_edge & 3);
}

#endif
