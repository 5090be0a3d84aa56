/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Which corners cells of two quads have in common: by the quads' ids, not by places. */
#ifndef HEXCON_EMBEDDING_CELL_SHARING_H
#define HEXCON_EMBEDDING_CELL_SHARING_H

#include "patch_cell.h"

/** Corners that two cells share: a[i] of the one is b[i] of the other. */
typedef struct shared {
  int count, a[4], b[4];
} shared;

/** Which corner of a quad an id is; -1 for none. */
int shared_partner(int32_t id, const int32_t quad[4]);

/**
 * Cells of two quads, of the same depth. Sides of quads are the same where their ends are.
 * @param partner  of each corner of a's quad: the same corner of b's, or -1
 */
void shared_find(const int partner[4], const cell *a, const cell *b, shared *out);

/** Two cells of one quad, of the same depth. */
void shared_find_within(const cell *a, const cell *b, shared *out);

/** Of three shared corners the one whose neighbours the others are; -1 if there is none. */
int shared_middle(const shared *s);

/** The side that two of a cell's corners end; -1 if they are opposite. */
int cell_side_of(int corner, int other);

/** @param index  0 .. 3 */
cell cell_child(const cell *c, int index);

#endif
