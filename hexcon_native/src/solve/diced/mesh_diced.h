/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Method `diced`: surfaces that are subdivisions of coarser ones of triangles and quads. */
#ifndef HEXCON_SOLVE_DICED_MESH_DICED_H
#define HEXCON_SOLVE_DICED_MESH_DICED_H

#include "solve/common/mesh_result.h"
#include "surface/half_edges.h"

/**
 * Fill a checked surface of one component, of any genus. Reads it in the ways that there are, the
 * best first; puts Geodes or pyramids of several heights on coarse quads, closes what is left by
 * one tetrahedron, a star, or the caller's tetrahedra; logs what was tried and keeps the best.
 * @param mesh  its points, hexes and quality are filled; the caller frees
 * Errors: NOT_DICED, UNFILLABLE_QUAD, NOT_STAR_SHAPED (nor were tetrahedra found), CANCELLED,
 * OUT_OF_MEMORY, TOO_LARGE. That some hexes are not positive is none. Cost: linear in the hexes,
 * plus their improvement.
 */
hexcon_status mesh_diced(hexcon_context *context, const surface *s,
                         const hexcon_mesh_options *options, hexcon_mesh *mesh);

#endif
