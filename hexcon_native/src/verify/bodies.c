/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "bodies.h"

#include <stdio.h>
#include <string.h>

#include "embedding/embedding.h"
#include "surface/build.h"
#include "surface/shells.h"

/** A quad that was turned, and one of another shell. */
static hexcon_status tell_overlap(hexcon_context *context, const surface *s, const int32_t *quads,
                                  hexcon_embedding *embedding) {
  size_t turned = 0, other = 0;
  while (turned < s->quad_count &&
         memcmp(quads + 4 * turned, s->quads + 4 * turned, 4 * sizeof *quads) == 0)
    turned++;
  while (other < s->quad_count && s->component_of_quad[other] == s->component_of_quad[turned])
    other++;
  embedding->pairs = context_allocate(context, 1, 2 * sizeof *embedding->pairs);
  if (!embedding->pairs)
    return HEXCON_OUT_OF_MEMORY;
  embedding->pairs[0] = (int32_t)(turned < other ? turned : other);
  embedding->pairs[1] = (int32_t)(turned < other ? other : turned);
  embedding->pair_count = 1;
  embedding->embedded = HEXCON_EMBEDDED_NO;
  (void)snprintf(embedding->reason, sizeof embedding->reason,
                 "a body lies in the material of another: shells within one another do not face "
                 "out and in by turns");
  return HEXCON_OK;
}

/** Of an embedded boundary. */
static hexcon_status check_nesting(hexcon_context *context, const double *points,
                                   size_t point_count, const int32_t *quads, size_t quad_count,
                                   hexcon_embedding *embedding) {
  surface s;
  hexcon_status status = surface_build(context, NULL, point_count, quads, quad_count, &s);
  s.points = points;
  /* a single shell faces out: it bounds hexes of positive volume */
  if (!status && s.component_count > 1)
    status = surface_orient_shells(context, &s);
  if (!status && s.turned)
    status = tell_overlap(context, &s, quads, embedding);
  surface_free(context, &s);
  return status;
}

hexcon_status bodies_prove(hexcon_context *context, const double *points, size_t point_count,
                           const int32_t *quads, size_t quad_count, hexcon_embedding *embedding) {
  hexcon_status status =
      embedding_prove(context, points, point_count, quads, quad_count, embedding);
  if (!status && embedding->embedded == HEXCON_EMBEDDED_YES)
    status = check_nesting(context, points, point_count, quads, quad_count, embedding);
  return status;
}
