/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** A mesh with sheets of hexes more under its whole boundary, placed and improved. */
#ifndef HEXCON_SOLVE_COMMON_PILLOWED_MESH_H
#define HEXCON_SOLVE_COMMON_PILLOWED_MESH_H

#include "filled_mesh.h"

/**
 * Lay sheets under the boundary, untangle, raise the worst hexes, then the mean. The boundary stays
 * as it is.
 * @param from    a mesh; its quality need not be known
 * @param fixed   [from->point_count] non-zero: the point stays; the new points are free
 * @param sheets  1 or more
 * @param out     measured; its points and hexes are those of `from`, then the new ones, the
 *                outermost sheet's last. Free with filled_mesh_free, also after an error
 * Errors: OUT_OF_MEMORY, TOO_LARGE, CANCELLED, OUT_OF_TIME. Linear, but for the improvement.
 */
hexcon_status pillowed_mesh_make(hexcon_context *context, const filled_mesh *from,
                                 const uint8_t *fixed, size_t sheets, int threads,
                                 filled_mesh *out);

#endif
