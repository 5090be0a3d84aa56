/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Untangling of a patch by all means there are, judged by the certificate's own proof. */
#ifndef HEXCON_SHAPE_REPAIR_H
#define HEXCON_SHAPE_REPAIR_H

#include "untangle.h"

/**
 * Make every hex of a patch positive.
 * Targets are spread from the healthy hexes and the fixed edges; the start is the given one or the
 * reference placement, whichever has the lower energy, and the other if that fails. Hexes that are
 * right-handed at all corners and yet not positive are looked into, and untangled again.
 * @param healthy  [hex_count] whether the hex was proved positive
 * @param bad      receives the number of hexes left that are not; p->x is the best state found, and
 *                 the given one if none is better
 * Errors: OUT_OF_MEMORY, CANCELLED.
 */
hexcon_status repair_patch(hexcon_context *context, patch *p, const uint8_t *healthy, size_t *bad);

/** Hexes not proved positive; watches those among them that are positive at all corners, and says
 * in `watched` how many of these are new. `watched` may be NULL: nothing is then changed. */
size_t patch_count_bad(patch *p, size_t *watched);

#endif
