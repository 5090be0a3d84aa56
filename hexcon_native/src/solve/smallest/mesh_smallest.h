/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Method `smallest`: surfaces of few quads, from a table. */
#ifndef HEXCON_SOLVE_SMALLEST_MESH_SMALLEST_H
#define HEXCON_SOLVE_SMALLEST_MESH_SMALLEST_H

#include "solve/common/filled_mesh.h"
#include "surface/half_edges.h"

/** A filling with a geometry. */
typedef struct small_mesh {
  filled_mesh mesh;
  const char *way; /**< by which its points were placed, static text */
} small_mesh;

/**
 * Fill a checked surface, given or left over by another method: ids of its points are kept, new
 * ones follow. All its points must be used.
 * @param threads  0: one per processor
 * @param out      free its mesh with filled_mesh_free, also after an error
 * Errors: those of small_class_find, CANCELLED. That some hexes are not positive is none: see
 * inverted. Cost: the improvement of some 50 hexes.
 */
hexcon_status small_mesh_build(hexcon_context *context, const surface *s, int threads,
                               small_mesh *out);

/**
 * Fill a checked surface of one component.
 * @param mesh  its points and hexes are filled; the caller frees
 * Errors: those of small_mesh_build.
 */
hexcon_status mesh_smallest(hexcon_context *context, const surface *s,
                            const hexcon_mesh_options *options, hexcon_mesh *mesh);

#endif
