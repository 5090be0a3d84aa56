/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The proof that a side of one cell passes through another cell. */
#ifndef HEXCON_EMBEDDING_PATCH_CROSSING_H
#define HEXCON_EMBEDDING_PATCH_CROSSING_H

#include <stdbool.h>

#include "ball.h"

/**
 * Proved: the segment from a to b has a place in common with the bilinear patch on four corners.
 * Both ends must lie out of the corners' hull, on either side of a slab around it. The patch and
 * the two triangles over a diagonal bound a solid in the hull, so the segment goes through patch
 * and triangles an even number of times: where it goes through the triangles once it meets the
 * patch.
 */
bool segment_crosses_patch(const ball a[3], const ball b[3], ball corners[4][3]);

#endif
