/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "given_pairs.h"

#include <string.h>

static bool exists(const surface *s, int32_t quad) {
  return quad >= 0 && (size_t)quad < s->quad_count;
}

/** The half-edge of one quad whose other side is another quad; -1 if there is none. */
static int32_t shared_half_edge(const surface *s, int32_t quad, int32_t other) {
  for (int32_t h = 4 * quad; h < 4 * quad + 4; h++)
    if (half_edge_quad(s->twins[h]) == other)
      return h;
  return -1;
}

hexcon_status surface_read_pairs(hexcon_context *context, const surface *s, const int32_t *pairs,
                                 size_t pair_count, int32_t *half_edge_of_quad) {
  size_t faults = 0;
  memset(half_edge_of_quad, -1, s->quad_count * sizeof *half_edge_of_quad);
  for (size_t p = 0; p < pair_count; p++) {
    int32_t one = pairs[2 * p], two = pairs[2 * p + 1];
    int32_t shared = exists(s, one) && exists(s, two) ? shared_half_edge(s, one, two) : -1;
    if (shared < 0 || half_edge_of_quad[one] >= 0 || half_edge_of_quad[two] >= 0) {
      context_add_element(context, one);
      context_add_element(context, two);
      faults++;
      continue;
    }
    half_edge_of_quad[one] = shared;
    half_edge_of_quad[two] = s->twins[shared];
  }
  if (faults)
    return context_fail(context, HEXCON_BAD_PAIRING,
                        "%zu of %zu given pairs (listed) are not of two quads that share an edge, "
                        "or hold a quad that is in another pair",
                        faults, pair_count);
  return HEXCON_OK;
}
