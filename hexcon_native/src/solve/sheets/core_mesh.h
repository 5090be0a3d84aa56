/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** One mesh of layers of hexes and of a filling of the core that they leave. */
#ifndef HEXCON_SOLVE_SHEETS_CORE_MESH_H
#define HEXCON_SOLVE_SHEETS_CORE_MESH_H

#include "layered_core.h"
#include "solve/common/filled_mesh.h"
#include "solve/common/mesh_result.h"

typedef struct core_mesh {
  filled_mesh mesh; /**< no points: nothing has been found */
  size_t core_quads, core_hexes, layer_count;
  size_t core_count, attempt_count; /**< cores looked into, and fillings of them that were tried */
  double bound; /**< of the worst scaled Jacobian, from the surface's own corners */
} core_mesh;

/**
 * Fill cores in turn, in all ways that suit them, until a mesh is good; the best is kept.
 * @param cores  [core_count] of the surface, the most promising first; their points are moved
 * @param told   receives a line of log for each attempt
 * @param best   free its mesh with filled_mesh_free, also after an error
 * Errors: OUT_OF_MEMORY, TOO_LARGE, CANCELLED; OUT_OF_TIME, with a mesh if there is one by then.
 */
hexcon_status core_mesh_make(hexcon_context *context, const surface *s,
                             const hexcon_mesh_options *options, layered_core *cores,
                             size_t core_count, hexcon_mesh *told, core_mesh *best);

#endif
