/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** A numbering of a mesh that follows from its shape alone. */
#ifndef HEXCON_SHAPE_IMPROVE_CANONICAL_ORDER_H
#define HEXCON_SHAPE_IMPROVE_CANONICAL_ORDER_H

#include "base/context.h"

/**
 * Points in their order along a slant direction; hexes in that of their points, each turned so that
 * its first point is its lowest and the second the lowest of the three neighbours. Whatever is
 * computed on it does not depend, bit for bit, on how the mesh was numbered (as long as no two
 * points tie: those keep their order).
 */
typedef struct canonical_order {
  size_t point_count, hex_count;
  int32_t *point_ids; /**< [point_count] the caller's id of each point */
  double *points;     /**< [point_count][3] */
  uint8_t *fixed;     /**< [point_count] */
  int32_t *hexes;     /**< [hex_count][8] VTK order */
} canonical_order;

/** @param out free with canonical_order_free, also after an error.
 * Cost: point_count log point_count. */
hexcon_status canonical_order_new(hexcon_context *context, const double *points, size_t point_count,
                                  const int32_t *hexes, size_t hex_count, const uint8_t *fixed,
                                  canonical_order *out);
void canonical_order_free(hexcon_context *context, canonical_order *order);

/** Copy the points back to the caller's numbering. */
void canonical_order_write(const canonical_order *order, double *points);

#endif
