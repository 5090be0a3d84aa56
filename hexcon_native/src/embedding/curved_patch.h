/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * A quad of 8 nodes as the curved patch it is: corners, sides and cells as of patch_cell.h, the
 * middle of side i at node 4 + i. Of degree 2 in each parameter, so every cell lies in the hull of
 * nine control points, at 3 i + j: i counts the first parameter.
 */
#ifndef HEXCON_EMBEDDING_CURVED_PATCH_H
#define HEXCON_EMBEDDING_CURVED_PATCH_H

#include "patch_cell.h"

enum { CURVED_CONTROLS = 9 };

typedef struct curved_patch {
  ball controls[CURVED_CONTROLS][3];
} curved_patch;

/** Of the serendipity quad: its control point in the middle follows from the others. */
void curved_patch_set(curved_patch *p, const double *const nodes[8], const double origin[3]);

/** The control points of a cell. */
void curved_cell_controls(const curved_patch *p, const cell *c, ball controls[CURVED_CONTROLS][3]);

/** Where a corner is among control points. */
int curved_corner_place(int corner);

/** Control points as seen from a corner: the first parameter runs to corner `next`, a neighbour,
 * the second one inwards. */
void curved_controls_from(ball controls[CURVED_CONTROLS][3], int corner, int next,
                          ball out[CURVED_CONTROLS][3]);

#endif
