/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** What a method is to those who call it, and what its faults mean. */
#ifndef HEXCON_SOLVE_COMMON_METHOD_FUNCTION_H
#define HEXCON_SOLVE_COMMON_METHOD_FUNCTION_H

#include "mesh_result.h"
#include "surface/half_edges.h"

/**
 * Fill a checked surface.
 * @param mesh  its points and hexes are filled, and its quality, if the method looked at
 * it; the caller frees, also after an error
 */
typedef hexcon_status (*method_function)(hexcon_context *context, const surface *s,
                                         const hexcon_mesh_options *options, hexcon_mesh *mesh);

/** Whether a fault only says that the method is not for this surface. */
static inline bool fault_is_about_method(hexcon_status status) {
  return status != HEXCON_OUT_OF_MEMORY && status != HEXCON_CANCELLED &&
         status != HEXCON_OUT_OF_TIME;
}

#endif
