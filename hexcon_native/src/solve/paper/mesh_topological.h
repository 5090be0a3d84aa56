/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The paper's methods, whose meshes are topological: conforming, but no solver's. */
#ifndef HEXCON_SOLVE_PAPER_MESH_TOPOLOGICAL_H
#define HEXCON_SOLVE_PAPER_MESH_TOPOLOGICAL_H

#include "solve/common/mesh_result.h"
#include "surface/half_edges.h"

/**
 * Fill a checked surface. Points lie in layers nested about the star centre, or, where there is
 * none, between the surface and a copy inside it; then hexes may overlap.
 * @param mesh  its points and hexes are filled, stage by stage from outside; quality is
 *              not. four-split: the front's quads are appended to its quads. The caller frees
 * Errors: UNFILLABLE_QUAD (two quads in all), NO_PAIRING, BAD_PAIRING, SELF_CROSSING, NO_SIDES,
 * NOT_A_BALL, CANCELLED, OUT_OF_MEMORY, TOO_LARGE. Cost: linear in the hexes, after the pairing.
 */
hexcon_status mesh_topological(hexcon_context *context, const surface *s,
                               const hexcon_mesh_options *options, hexcon_mesh *mesh);

#endif
