/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** One way to fill a surface by shells and sheets: built, joined and placed. */
#ifndef HEXCON_SOLVE_SHELLING_SHELL_FILLING_H
#define HEXCON_SOLVE_SHELLING_SHELL_FILLING_H

#include "construct/rotated_shell.h"
#include "solve/common/filled_mesh.h"

/** Where shells lie. */
typedef struct shell_space {
  double center[3];
  bool no_center;   /**< no point sees the surface */
  double thickness; /**< of one shell, in mean edge lengths */
} shell_space;

/**
 * Lay a plan's shells under a surface, and fill what is inside by sheets.
 * @param s      with points
 * @param limit  of the sheets' search, in quads
 * @param out    not improved yet; stays without points where the loops cannot be taken away; free
 *               with filled_mesh_free, also after an error
 * Errors: OUT_OF_MEMORY, TOO_LARGE, CANCELLED. Cost: that of sheet_search_run.
 */
hexcon_status shell_filling_build(hexcon_context *context, const surface *s,
                                  const rotation_plan *plan, const shell_space *space, size_t limit,
                                  filled_mesh *out);

#endif
