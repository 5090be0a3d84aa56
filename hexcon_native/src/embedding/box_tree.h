/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Pairs of boxes that meet, found by a tree over boxes along a space-filling curve. */
#ifndef HEXCON_EMBEDDING_BOX_TREE_H
#define HEXCON_EMBEDDING_BOX_TREE_H

#include "base/context.h"

/** Lowest and highest coordinates. */
typedef struct box {
  double low[3], high[3];
} box;

/** Called with two boxes that meet, each pair once. */
typedef hexcon_status (*box_pair_visit)(void *user, hexcon_context *context, int32_t a, int32_t b);

/**
 * Visit every pair of boxes that have a place in common, ends included, until `visit` does not
 * return HEXCON_OK. Cost: linear in boxes and pairs where boxes are in size like what is near them.
 * @param stage  what the user is told
 * @return what `visit` returned last; OUT_OF_MEMORY, CANCELLED, OUT_OF_TIME
 * Source: Karras, Maximizing parallelism in the construction of BVHs (2012), of which only the
 * order along the curve is used: the tree halves the list.
 */
hexcon_status box_tree_visit_pairs(hexcon_context *context, const box *boxes, size_t count,
                                   progress_stage stage, box_pair_visit visit, void *user);

#endif
