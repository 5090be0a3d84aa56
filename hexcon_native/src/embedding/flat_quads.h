/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Quads that lie in a plane, exactly: there the question is decided, touching included. */
#ifndef HEXCON_EMBEDDING_FLAT_QUADS_H
#define HEXCON_EMBEDDING_FLAT_QUADS_H

#include <stddef.h>
#include <stdint.h>

#include "patch_pair.h"

typedef enum quad_form {
  QUAD_WARPED, /**< not in a plane: then no place of the patch is there twice */
  QUAD_CONVEX, /**< in a plane and convex: the patch is the polygon */
  QUAD_FOLDED, /**< in a plane, and not convex: the patch covers a part of it twice */
  QUAD_UNKNOWN /**< coordinates too far apart for exact arithmetic */
} quad_form;

typedef struct flat_quad {
  quad_form form;
  const double *corners[4];
  int32_t ids[4];
  int axis; /**< convex: an axis along which it does not look like a line .. */
  int turn; /**< .. the sign of its turns, seen along that axis .. */
  int apex; /**< .. and a corner where it turns */
} flat_quad;

void flat_quad_set(flat_quad *quad, const double *points, const int32_t ids[4]);

/** Whether two convex quads have a place in common that they do not share by their ids. Open only
 * where the arithmetic is too narrow. */
meeting flat_quads_meet(const flat_quad *a, const flat_quad *b);

/** Two segments of one plane, by their ends, which belong to them, as seen along an axis. */
meeting segments_meet_along(int axis, const double *const a[2], const double *const b[2]);

/** The same as flat_quads_meet of side `side` of a quad of any form and a convex one. */
meeting side_meets_flat_quad(const flat_quad *a, int side, const flat_quad *b);

#endif
