/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Method `shelling`: shells in which edges rotate, until sheets fill what is inside. */
#ifndef HEXCON_SOLVE_SHELLING_MESH_SHELLING_H
#define HEXCON_SOLVE_SHELLING_MESH_SHELLING_H

#include "solve/common/mesh_result.h"
#include "surface/half_edges.h"

/**
 * Fill a checked surface of one component, a sphere. Rotations are searched for, fewest first,
 * after which the dual loops can be taken away one by one as in method `sheets`; under the surface
 * lies a shell of one hex a quad and 38 a rotation, seldom more shells than one.
 * @param mesh  its points, hexes and quality are filled; the caller frees
 * Errors: NOT_A_BALL, UNFILLABLE_QUAD, NO_ROTATIONS, CANCELLED, OUT_OF_MEMORY, TOO_LARGE. Cost: the
 * search looks at all edges of some surfaces for each rotation, quadratic in the quads; it is given
 * up after a fixed number of quads.
 */
hexcon_status mesh_shelling(hexcon_context *context, const surface *s,
                            const hexcon_mesh_options *options, hexcon_mesh *mesh);

#endif
