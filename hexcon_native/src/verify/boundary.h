/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Is the boundary of a hex mesh exactly a given quad surface? */
#ifndef HEXCON_VERIFY_BOUNDARY_H
#define HEXCON_VERIFY_BOUNDARY_H

#include "hexmesh/face_table.h"

/** Expected linear. @param exact true if the sides in one hex only are the quads, each once and
 * outward, and nothing else */
hexcon_status boundary_check(hexcon_context *context, const int32_t *hexes, size_t hex_count,
                             const face_table *faces, const int32_t *quads, size_t quad_count,
                             bool *exact);

#endif
