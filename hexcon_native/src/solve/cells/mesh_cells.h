/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Method `cells`: any even surface of a star-shaped body. */
#ifndef HEXCON_SOLVE_CELLS_MESH_CELLS_H
#define HEXCON_SOLVE_CELLS_MESH_CELLS_H

#include "solve/common/mesh_result.h"
#include "surface/half_edges.h"

/**
 * Fill a checked surface of one component. Tries closures and thicknesses in a fixed order, logged
 * in the mesh, and keeps the best.
 * @param mesh  its points, hexes and quality are filled; the caller frees
 * Errors: UNFILLABLE_QUAD, NOT_STAR_SHAPED, NOT_BIPARTITE, NO_PAIRING, CANCELLED, OUT_OF_MEMORY,
 * TOO_LARGE. Cost: linear in the hexes, plus their improvement.
 */
hexcon_status mesh_cells(hexcon_context *context, const surface *s,
                         const hexcon_mesh_options *options, hexcon_mesh *mesh);

#endif
