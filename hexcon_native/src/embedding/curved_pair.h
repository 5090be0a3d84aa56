/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Do two quads of 8 nodes, as curved patches, meet where they do not share corners or sides? */
#ifndef HEXCON_EMBEDDING_CURVED_PAIR_H
#define HEXCON_EMBEDDING_CURVED_PAIR_H

#include <stdbool.h>
#include <stdint.h>

#include "meeting.h"

/**
 * As patches_meet, of curved patches.
 * @param points  [.][3], none beyond 1 by much
 * @param a, b    nodes of the quads, corners first; sides with equal ends have equal middles
 * @param joint   NONE only if besides, on the way along straight lines to the bilinear patches on
 *                their corners, the two as a whole do not meet either: of quads without common
 * nodes
 */
meeting curved_patches_meet(const double *points, const int32_t a[8], const int32_t b[8],
                            bool joint, int patience);

/** Whether a curved patch has no place twice: NONE or OPEN. */
meeting curved_patch_meets_itself(const double *points, const int32_t nodes[8], int patience);

#endif
