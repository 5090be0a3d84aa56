/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "handle_cut.h"

#include <string.h>

int32_t handle_cut_point(const surface *s, const handle_cut *cut, int32_t corner, int side) {
  const size_t rim = cut->disc->rim_count, inner = cut->disc->point_count - rim;
  if ((size_t)corner >= rim)
    return (int32_t)(cut->first_point + (side == CUT_RIGHT ? inner : 0) + (size_t)corner - rim);
  return side == CUT_RIGHT ? half_edge_end(s, cut->ring[corner])
                           : half_edge_start(s, cut->ring[corner]);
}

/** The left disc lies against the layer's hexes, which are on its counter-clockwise side. */
static void write_disc(const surface *s, const handle_cut *cut, int side, int32_t *quads) {
  for (size_t i = 0; i < 4 * cut->disc->quad_count; i++) {
    const size_t to = side == CUT_LEFT ? (i & ~(size_t)3) | (-i & 3) : i;
    quads[to] = handle_cut_point(s, cut, cut->disc->quads[i], side);
  }
}

void handle_cut_write_quads(const surface *s, const handle_cut *cut, const uint8_t *in_ring,
                            int32_t *quads) {
  for (size_t q = 0; q < s->quad_count; q++)
    if (!in_ring[q]) {
      memcpy(quads, s->quads + 4 * q, 4 * sizeof *quads);
      quads += 4;
    }
  write_disc(s, cut, CUT_LEFT, quads);
  write_disc(s, cut, CUT_RIGHT, quads + 4 * cut->disc->quad_count);
}

void handle_cut_write_hexes(const surface *s, const handle_cut *cut, int32_t *hexes) {
  for (size_t i = 0; i < 4 * cut->disc->quad_count; i++) {
    int32_t *hex = hexes + 8 * (i / 4), corner = cut->disc->quads[i];
    hex[i % 4] = handle_cut_point(s, cut, corner, CUT_RIGHT);
    hex[i % 4 + 4] = handle_cut_point(s, cut, corner, CUT_LEFT);
  }
}
