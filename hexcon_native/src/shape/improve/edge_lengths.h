/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Target lengths of a patch's edges, spread from the edges whose length can be trusted. */
#ifndef HEXCON_SHAPE_IMPROVE_EDGE_LENGTHS_H
#define HEXCON_SHAPE_IMPROVE_EDGE_LENGTHS_H

#include "patch.h"

/**
 * Set p->stretch: trusted edges keep their present length; the logarithms of the others are
 * harmonic between them. Opposite edges of a hex pull each other strongly, so that a length runs
 * along its sheet of the mesh and a graded or anisotropic mesh keeps its grading; other edges of a
 * hex weakly, which decides where a sheet has no trusted edge.
 * @param healthy  [hex_count] whether a hex is: edges whose hexes all are are trusted; NULL: none
 *                 is. Edges between fixed points always are trusted.
 * Cost: hex_count^(4/3).
 */
hexcon_status edge_lengths_spread(hexcon_context *context, patch *p, const uint8_t *healthy);

#endif
