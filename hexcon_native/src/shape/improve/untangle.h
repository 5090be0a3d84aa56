/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Untangling of a patch. */
#ifndef HEXCON_SHAPE_IMPROVE_UNTANGLE_H
#define HEXCON_SHAPE_IMPROVE_UNTANGLE_H

#include "newton.h"

/**
 * Move the free points until every frame is right-handed, from any start, by descent on the
 * regularised energy with epsilon going to zero as fast as the descent earns it. Targets and
 * watched hexes are the patch's.
 * @param patient  whether epsilon goes down by the descent's earnings alone, in up to 40 rounds,
 *                 which reaches more; else it is also kept below the worst determinant, which
 *                 mostly needs a single round
 * @param done     receives whether every frame is right-handed now
 * Errors: CANCELLED. Cost: a few Newton steps a round.
 * Source: Garanzha et al., Foldover-free maps in 50 lines of code (2021), section 3.2, with a least
 * decrease of 0.3 instead of 0.1: Newton steps earn it.
 */
hexcon_status untangle_patch(hexcon_context *context, newton *n, patch *p, bool patient,
                             bool *done);

#endif
