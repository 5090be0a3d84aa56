/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "growing_mesh.h"

hexcon_status growing_mesh_reserve(hexcon_context *context, growing_mesh *mesh, size_t more_hexes,
                                   size_t more_points) {
  if (more_hexes > CONTEXT_MAX_COUNT - mesh->hex_count ||
      more_points > CONTEXT_MAX_COUNT - mesh->point_count)
    return context_fail(context, HEXCON_TOO_LARGE,
                        "the mesh has more points or hexes than 32-bit ids hold; mesh with larger "
                        "quads");
  int32_t *grown =
      context_grow(context, mesh->hexes, mesh->hex_count + more_hexes, 8 * sizeof *mesh->hexes);
  if (!grown)
    return HEXCON_OUT_OF_MEMORY;
  mesh->hexes = grown;
  return HEXCON_OK;
}
