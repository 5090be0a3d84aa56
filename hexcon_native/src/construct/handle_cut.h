/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * A layer of hexes across a handle.
 *
 * A dual loop that does not cross itself is a ring of quads between two rails. A disc of quads is
 * put into each rail, the same in both, and hexes between the discs: the ring is what the layer has
 * on the surface. The rest of the body has the discs in its surface, and a handle less where the
 * rails bound inside and do not part the surface. As the discs are a layer apart, the cut is no
 * crack: no hexes meet across it that do not share its faces.
 */
#ifndef HEXCON_CONSTRUCT_HANDLE_CUT_H
#define HEXCON_CONSTRUCT_HANDLE_CUT_H

#include "disc_pattern.h"
#include "surface/half_edges.h"

typedef struct handle_cut {
  const int32_t *ring;      /**< [disc->rim_count] entries to the ring's quads in order: corner i of
                                 the left rail is where entry i starts, of the right where it ends */
  const disc_pattern *disc; /**< in the left rail it is counter-clockwise seen from the ring */
  size_t first_point; /**< id of the left disc's first inner point; then come those of the right */
} handle_cut;

enum { CUT_LEFT, CUT_RIGHT };

/** Number of points inside both discs. */
static inline size_t handle_cut_points(const handle_cut *cut) {
  return 2 * (cut->disc->point_count - cut->disc->rim_count);
}

/** Number of quads of the surface after the cut. */
static inline size_t handle_cut_quads(const surface *s, const handle_cut *cut) {
  return s->quad_count - cut->disc->rim_count + 2 * cut->disc->quad_count;
}

/** Point of the surface after the cut that a disc's corner is. @param side  CUT_LEFT or CUT_RIGHT
 */
int32_t handle_cut_point(const surface *s, const handle_cut *cut, int32_t corner, int side);

/**
 * Write the quads after the cut: those kept in their order, then the left disc's, then the right's.
 * @param in_ring  [quad_count] non-zero: the quad goes
 * @param quads    [handle_cut_quads][4]
 * Linear.
 */
void handle_cut_write_quads(const surface *s, const handle_cut *cut, const uint8_t *in_ring,
                            int32_t *quads);

/** Write the layer's hexes. @param hexes [disc->quad_count][8] */
void handle_cut_write_hexes(const surface *s, const handle_cut *cut, int32_t *hexes);

#endif
