/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Families of dual loops that do not cross each other. */
#ifndef HEXCON_SURFACE_LOOP_FAMILIES_H
#define HEXCON_SURFACE_LOOP_FAMILIES_H

#include "loops.h"

/**
 * Part loops that do not cross themselves into few families: two where that is possible, else
 * greedily in the order of the loops.
 * @param family_of_loop  [loops->count]
 * @param family_count    receives their number
 * @return SELF_CROSSING with the quads that a loop passes twice, OUT_OF_MEMORY. Linear, times the
 *         number of families at worst.
 */
hexcon_status surface_loop_families(hexcon_context *context, const surface *s,
                                    const surface_loops *loops, int32_t *family_of_loop,
                                    size_t *family_count);

#endif
