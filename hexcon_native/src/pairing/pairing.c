/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "pairing.h"

#include "pair_augment.h"
#include "pair_greedy.h"
#include "pair_improve.h"

static hexcon_status check_complete(const pair_state *p) {
  size_t left = 0;
  for (size_t q = 0; q < p->s->quad_count; q++)
    if (p->half_edges[q] == PAIR_FREE) {
      context_add_element(p->context, (int32_t)q);
      left++;
    }
  if (left)
    return context_fail(p->context, HEXCON_NO_PAIRING,
                        "the quads cannot all be paired with a neighbour: %zu are left over at "
                        "best (listed); each separate part of the surface needs an even number of "
                        "quads",
                        left);
  return HEXCON_OK;
}

hexcon_status surface_pair(hexcon_context *context, const surface *s, const double *weights,
                           int32_t *half_edge_of_quad) {
  pair_state p = {context, s, weights, half_edge_of_quad, 0};
  if (s->quad_count % 2)
    return context_fail(context, HEXCON_ODD,
                        "the surface has %zu quads, an odd number: one is left over when they are "
                        "paired; change the size a little or subdivide the quads",
                        s->quad_count);
  for (size_t q = 0; q < s->quad_count; q++)
    half_edge_of_quad[q] = PAIR_FREE;
  hexcon_status status = context_progress(context, STAGE_PAIRING, 0);
  if (!status)
    status = pair_greedily(&p);
  if (!status)
    status = pair_augment(&p);
  if (!status)
    status = check_complete(&p);
  if (!status && weights)
    status = pair_improve(&p);
  return status;
}

/** Whether the quad across a half-edge lies across another one of the quad too. */
static bool shares_more(const surface *s, int32_t half_edge) {
  int32_t other = half_edge_quad(s->twins[half_edge]);
  for (int turn = 1; turn < 4; turn++)
    if (half_edge_quad(s->twins[half_edge_turn(half_edge, turn)]) == other)
      return true;
  return false;
}

hexcon_status surface_pair_across_single_edges(hexcon_context *context, const surface *s,
                                               int32_t *half_edge_of_quad) {
  surface single = *s; /* without the shared edges: there a quad is its own neighbour */
  single.twins = context_allocate(context, 4 * s->quad_count, sizeof *single.twins);
  if (!single.twins)
    return HEXCON_OUT_OF_MEMORY;
  for (int32_t h = 0; h < (int32_t)(4 * s->quad_count); h++)
    single.twins[h] = shares_more(s, h) ? h : s->twins[h];
  hexcon_status status = surface_pair(context, &single, NULL, half_edge_of_quad);
  context_free(context, single.twins);
  if (status != HEXCON_NO_PAIRING)
    return status;
  context_clear(context);
  return surface_pair(context, s, NULL, half_edge_of_quad);
}
