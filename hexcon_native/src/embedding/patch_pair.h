/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Do two quads, as bilinear patches, meet where they do not share corners or sides? */
#ifndef HEXCON_EMBEDDING_PATCH_PAIR_H
#define HEXCON_EMBEDDING_PATCH_PAIR_H

#include <stdint.h>

#include "meeting.h"

/**
 * Both patches are halved both ways until each pair of cells is proved apart, or one to cross the
 * other. Cost: a few cells in general position.
 * @param points    [.][3], none beyond 1 by much
 * @param a, b      corners of the quads; equal ids are shared
 * @param patience  pairs of cells to look at, at most; 1: the quads as they are
 */
meeting patches_meet(const double *points, const int32_t a[4], const int32_t b[4], int patience);

#endif
