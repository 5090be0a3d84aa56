/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** What fills a nested mesh once its front is split in four. Cost: linear (expected: hashing), and
 * what the caller's tetrahedra take. */
#ifndef HEXCON_SOLVE_PAPER_NESTED_CLOSURE_H
#define HEXCON_SOLVE_PAPER_NESTED_CLOSURE_H

#include "nested_mesh.h"

/** By pyramids that meet in the centre. @param tetrahedra receives 0 */
hexcon_status nested_mesh_close_by_pyramids(hexcon_context *context, const split_front *front,
                                            const hexcon_mesh_options *options, nested_mesh *mesh,
                                            size_t *tetrahedra);

/**
 * By Geodes, and by diced tetrahedra inside: two on each Geode that meet in the centre, or, where
 * that does not see the whole surface, those that the caller's mesher finds between the Geodes.
 * @param tetrahedra  receives their number
 * Errors: NOT_A_BALL (such tetrahedra were needed, and there are none), OUT_OF_MEMORY, TOO_LARGE.
 * Source: Carbonera and Shepherd (2006), sections 4.3 and 6; Mitchell, The all-hex Geode-template
 * for conforming a diced tetrahedral mesh to any diced hexahedral mesh (1998).
 */
hexcon_status nested_mesh_close_by_geodes(hexcon_context *context, const split_front *front,
                                          const hexcon_mesh_options *options, nested_mesh *mesh,
                                          size_t *tetrahedra);

#endif
