/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The last step of every method for solvers: a pillow, where it helps. */
#ifndef HEXCON_SOLVE_COMMON_MESH_PILLOW_H
#define HEXCON_SOLVE_COMMON_MESH_PILLOW_H

#include "mesh_result.h"
#include "surface/half_edges.h"

/**
 * Lay sheets of hexes under the whole surface as options->pillow has it. By default one, where the
 * worst hex is poor and the surface's corners let it become clearly better so, and keep the better
 * mesh: fewer hexes that are not positive, then a higher worst scaled Jacobian, then a higher mean;
 * then the fewer hexes. The log tells what was done, or why nothing could be won.
 * @param mesh  as a method made it, of order 1; its points begin with those of the surface
 * Errors: OUT_OF_MEMORY, TOO_LARGE, CANCELLED. If the time runs out the mesh stays as it is. Linear
 * in the hexes, plus their improvement.
 */
hexcon_status mesh_pillow(hexcon_context *context, const surface *s,
                          const hexcon_mesh_options *options, hexcon_mesh *mesh);

#endif
