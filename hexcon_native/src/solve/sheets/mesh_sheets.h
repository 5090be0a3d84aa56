/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Method `sheets`. */
#ifndef HEXCON_SOLVE_SHEETS_MESH_SHEETS_H
#define HEXCON_SOLVE_SHEETS_MESH_SHEETS_H

#include "solve/common/mesh_result.h"
#include "surface/half_edges.h"

/**
 * Fill a surface by layers of hexes, each of which takes a dual loop away, until a cube is left; of
 * the ways that were tried, the one with the fewest inverted hexes, then the highest worst scaled
 * Jacobian. Where none is valid, layers as far as they go, and a filling of the core they leave.
 * Bodies with holes are cut to a ball first: see mesh_cuts.
 * @param mesh  receives points, hexes, quality and figures; what it held before must be nothing
 * @return NO_SHEETS with the quads of the core that are the surface's own, where the layers would
 * take next to nothing away, have no valid shape, or leave a core that must not be filled;
 * OUT_OF_MEMORY, TOO_LARGE, CANCELLED, OUT_OF_TIME
 */
hexcon_status mesh_sheets(hexcon_context *context, const surface *s,
                          const hexcon_mesh_options *options, hexcon_mesh *mesh);

#endif
