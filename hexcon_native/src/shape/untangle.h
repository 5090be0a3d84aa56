/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Untangling of a patch. */
#ifndef HEXCON_SHAPE_UNTANGLE_H
#define HEXCON_SHAPE_UNTANGLE_H

#include "newton.h"

/**
 * Move the free points until every frame is right-handed, from any start, by descent on the
 * regularised energy with epsilon going to zero as fast as the descent earns it. Targets and
 * watched hexes are the patch's.
 * @param rounds  of epsilon, at most
 * @param done    receives whether every frame is right-handed now
 * Errors: CANCELLED. Cost: a few Newton steps a round; mostly under 20 rounds.
 * Source: Garanzha et al., Foldover-free maps in 50 lines of code (2021), section 3.2.
 */
hexcon_status untangle_patch(hexcon_context *context, newton *n, patch *p, int rounds, bool *done);

#endif
