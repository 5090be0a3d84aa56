/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * A quad as the bilinear patch it is, and its cells: squares of a grid of 2^depth by 2^depth in its
 * parameters. Corner 0 of the quad lies at (0, 0), 1 at (1, 0), 2 at (1, 1), 3 at (0, 1); side i
 * runs from corner i to the next, of quads and cells alike.
 */
#ifndef HEXCON_EMBEDDING_PATCH_CELL_H
#define HEXCON_EMBEDDING_PATCH_CELL_H

#include <stdint.h>

#include "ball.h"

enum { CELL_MAX_DEPTH = 20 };

typedef struct patch {
  ball corners[4][3]; /**< from an origin that the patches of a pair share */
  ball sides[4][3];   /**< from each corner to the next */
} patch;

typedef struct cell {
  int32_t i, j; /**< of 0 .. 2^depth - 1 */
  int depth;
} cell;

/** Parameters of the corners of a quad, and of a cell from its first. */
static const int32_t cell_corner_steps[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

void patch_set(patch *p, const double *const corners[4], const double origin[3]);

/** The four corners of a cell. */
void cell_corners(const patch *p, const cell *c, ball corners[4][3]);

/**
 * What leads from corner `corner` of a cell to the next one, to the last one, and to the opposite
 * one, divided by the cell's width: every place of the cell lies in the cone of the three.
 */
void cell_cone(const patch *p, const cell *c, int corner, ball arms[3][3]);

/** Along `side` of a cell, and inwards at its start and at its end: any lengths. Exact enough for a
 * side on the quad's own side only: there the patch is ruled by lines that go inwards. */
void cell_rulings(const patch *p, const cell *c, int side, ball along[3], ball inwards[2][3]);

/** The mixed derivative: how far the patch is from a parallelogram. */
void patch_twist(const patch *p, ball twist[3]);

#endif
