/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** What a patch's corners are drawn towards while it is relaxed. */
#ifndef HEXCON_SHAPE_RELAX_CORNER_TARGETS_H
#define HEXCON_SHAPE_RELAX_CORNER_TARGETS_H

#include "shape/improve/patch.h"

/** Cubes, each of the mean length of its hex's edges now. */
void target_cubes(patch *p);

/** Half way, in logarithms, from cubes to boxes of the edges' lengths now; and every corner counts
 * by its energy now, so that bad ones count by its square. p->shares must be there. */
void target_right_angles(patch *p);

#endif
