/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "sliding_patch.h"

#include <string.h>

/** Where the boundary gives way, hexes would become as thin as they may. */
static const double smallest_edge = 0.2;

static hexcon_status retract(void *user, hexcon_context *context, double *x, double *directions) {
  const sliding_patch *s = user;
  return sliding_points_project(context, s->sliding, s->ids, s->spaces.count, x, directions);
}

hexcon_status sliding_patch_new(hexcon_context *context, const sliding_points *sliding,
                                const int32_t *point_ids, patch *p, sliding_patch *out) {
  *out = (sliding_patch){.sliding = sliding};
  hexcon_status status = tangent_spaces_new(context, p->free_count, &out->spaces);
  out->ids = context_allocate(context, p->free_count, sizeof *out->ids);
  if (status || !out->ids)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t i = 0; i < p->free_count; i++) {
    out->ids[i] = point_ids[p->points[i]];
    out->spaces.freedom[i] = sliding_freedom(sliding, out->ids[i]);
  }
  out->spaces.retract = retract;
  out->spaces.user = out;
  p->spaces = &out->spaces;
  p->smallest_edge = smallest_edge;
  return patch_put_on(context, p);
}

void sliding_patch_free(hexcon_context *context, sliding_patch *sliding) {
  tangent_spaces_free(context, &sliding->spaces);
  context_free(context, sliding->ids);
  memset(sliding, 0, sizeof *sliding);
}
