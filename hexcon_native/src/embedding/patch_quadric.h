/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The quadric surface that a patch is part of, as a wall that another patch does not pass. */
#ifndef HEXCON_EMBEDDING_PATCH_QUADRIC_H
#define HEXCON_EMBEDDING_PATCH_QUADRIC_H

#include <stdbool.h>

#include "patch_cell.h"

/**
 * A patch is a + u e + v f + u v t. With the affine functions U = det(x - a, f, t),
 * W = det(e, x - a, t) and Z = det(e, f, x - a), and V = det(e, f, t), its places are U = u V,
 * W = v V, Z = u v V, and so U W - V Z is 0 on it. On another patch that is a polynomial of degree
 * 2 in each parameter: where its Bernstein coefficients have one sign the two have no place in
 * common. It separates what no plane does: the faces of a thin curved wall.
 */
typedef struct patch_quadric {
  ball u[4], w[4], z[4]; /**< at the corners of the other patch */
  ball volume;           /**< V */
} patch_quadric;

void patch_quadric_set(patch_quadric *quadric, const patch *of, const patch *other);

/**
 * Proved: a cell of the other patch has no place on the quadric but on what it shares with the
 * first: there the coefficients are zero, and those of one sign elsewhere keep the rest off it.
 * @param corners, sides  [4] those of the cell that are the first's, too
 */
bool patch_quadric_clears(const patch_quadric *quadric, const cell *other, const bool corners[4],
                          const bool sides[4]);

#endif
