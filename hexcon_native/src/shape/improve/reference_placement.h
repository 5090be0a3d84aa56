/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Placement of a patch's free points by its targets alone. */
#ifndef HEXCON_SHAPE_IMPROVE_REFERENCE_PLACEMENT_H
#define HEXCON_SHAPE_IMPROVE_REFERENCE_PLACEMENT_H

#include "patch.h"

/**
 * Put the free points where the map from boxes with the target edge lengths is harmonic, as finite
 * volumes see it: an edge of length l between boxes of cross-section A pulls with A / l. Exact for
 * any box that is graded along its axes; where the start is tangled beyond use, the start of
 * choice. Cost: hex_count^(4/3).
 */
hexcon_status reference_placement(hexcon_context *context, patch *p);

#endif
