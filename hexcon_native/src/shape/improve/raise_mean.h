/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The best mean element: optimisation of a valid patch above a floor. */
#ifndef HEXCON_SHAPE_IMPROVE_RAISE_MEAN_H
#define HEXCON_SHAPE_IMPROVE_RAISE_MEAN_H

#include "newton.h"

/** The wall stands this far behind the worst frame where that is below the floor. */
#define RAISE_MEAN_CLEARANCE 1.002

/**
 * Raise the mean scaled Jacobian of a patch whose hexes are all positive, and keep them so. Newton
 * steps for the sum of the frames' energies S, each with the share that makes its slope that of
 * - 1 / S = - scaled Jacobian, shared out over the worst corners of its hex; behind a wall that no
 * frame below `floor` can pass, or, where one is below already, that one.
 * Errors: OUT_OF_MEMORY, CANCELLED. Cost: up to 20 Newton steps.
 * Source: iteratively reweighted majorisation, as for sharpen_patch.
 */
hexcon_status raise_mean_patch(hexcon_context *context, newton *n, patch *p, double floor);

#endif
