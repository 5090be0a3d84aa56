/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Untangling of a patch by all means there are, judged by the certificate's own proof. */
#ifndef HEXCON_SHAPE_IMPROVE_REPAIR_H
#define HEXCON_SHAPE_IMPROVE_REPAIR_H

#include "untangle.h"

/**
 * Make every hex of a patch positive.
 * Targets are spread from the healthy hexes and the fixed edges; the start is the given one or the
 * reference placement, whichever has the lower energy, then the other.
 * Hexes that are right-handed at all corners and yet not positive are looked into, and untangled
 * again.
 * @param patient  see untangle_patch
 * @param healthy  [hex_count] whether the hex was proved positive
 * @param bad      receives the number of hexes left that are not; p->x is the best state found, and
 *                 the given one if none is better
 * Errors: OUT_OF_MEMORY, CANCELLED.
 */
hexcon_status repair_patch(hexcon_context *context, patch *p, const uint8_t *healthy, bool patient,
                           size_t *bad);

/** Untangle p->x with the targets that are set, and look closer where it takes that.
 * @param patient  see untangle_patch
 * @param bad      receives the number of hexes not proved positive */
hexcon_status untangle_watching(hexcon_context *context, newton *n, patch *p, bool patient,
                                size_t *bad);

/** Hexes not proved positive; watches those among them that are positive at all corners, and more
 * closely each time. `watched` receives how many of these there were; it may be NULL: nothing is
 * then watched. */
size_t patch_count_bad(patch *p, size_t *watched);

#endif
