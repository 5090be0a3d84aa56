/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** A surface from arrays: checked, connected, its shells turned out of the solid. */
#ifndef HEXCON_SURFACE_BUILD_H
#define HEXCON_SURFACE_BUILD_H

#include "half_edges.h"

/**
 * Check a surface and build its adjacency; with points, turn its shells out of the solid. Linear,
 * but for the nesting of several shells: see surface_orient_shells.
 * @param points  [point_count][3], or NULL: then orientation is only made consistent, point_count
 *                only bounds the ids, and unused ids are allowed
 * @param out     filled; free with surface_free, also after an error
 * @return the faults listed at hexcon_check_surface
 */
hexcon_status surface_build(hexcon_context *context, const double *points, size_t point_count,
                            const int32_t *quads, size_t quad_count, surface *out);

/** As surface_build, of quads in any sense: never INCONSISTENT_ORIENTATION. */
hexcon_status surface_build_turning(hexcon_context *context, const double *points,
                                    size_t point_count, const int32_t *quads, size_t quad_count,
                                    surface *out);

#endif
