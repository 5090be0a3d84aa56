/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Method `swept`. */
#ifndef HEXCON_SOLVE_SWEPT_MESH_SWEPT_H
#define HEXCON_SOLVE_SWEPT_MESH_SWEPT_H

#include "solve/common/mesh_result.h"
#include "surface/half_edges.h"

/**
 * Fill a surface as a sweep, by the best of the sweeps it allows: fewest inverted hexes, then the
 * highest worst scaled Jacobian, then the mean.
 * @param options  it takes none of its own
 * @param mesh  receives points, hexes, quality and figures; what it held before must be nothing
 * @return NOT_SWEPT with the quads where the most promising attempt failed; OUT_OF_MEMORY,
 *         TOO_LARGE, CANCELLED
 */
hexcon_status mesh_swept(hexcon_context *context, const surface *s,
                         const hexcon_mesh_options *options, hexcon_mesh *mesh);

#endif
