/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Method `proposal`: hexes that whoever made the quads has in mind inside them. */
#ifndef HEXCON_SOLVE_PROPOSAL_MESH_PROPOSAL_H
#define HEXCON_SOLVE_PROPOSAL_MESH_PROPOSAL_H

#include "solve/common/mesh_result.h"
#include "surface/half_edges.h"

/**
 * Take the proposed hexes, place inner points that have no place, and improve what falls short of
 * what the surface allows; places that are good already stay, bit for bit.
 * @param options  with a proposal whose arrays are checked
 * @param mesh     its points, hexes and quality are filled; the caller frees, also after an error
 * Errors: BAD_PROPOSAL (the hexes are no mesh, or their boundary is not the surface), CANCELLED,
 * OUT_OF_TIME, OUT_OF_MEMORY. Cost: linear, plus the improvement.
 */
hexcon_status mesh_proposal(hexcon_context *context, const surface *s,
                            const hexcon_mesh_options *options, hexcon_mesh *mesh);

/**
 * Check a proposal's arrays against a surface of so many points.
 * Errors: BAD_ARGUMENT, EMPTY, TOO_LARGE, INDEX_OUT_OF_RANGE, REPEATED_VERTEX (elements: hexes),
 * NOT_FINITE (elements: rows of its points), BAD_PROPOSAL (elements: rows of its points that are in
 * no hex). Linear.
 */
hexcon_status proposal_check(hexcon_context *context, const hexcon_proposal *proposal,
                             size_t surface_point_count);

#endif
