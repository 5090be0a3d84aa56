/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The best worst element: max-min optimisation of a valid patch. */
#ifndef HEXCON_SHAPE_IMPROVE_SHARPEN_H
#define HEXCON_SHAPE_IMPROVE_SHARPEN_H

#include "newton.h"

/**
 * Raise the smallest scaled Jacobian of the frames of a patch whose hexes are all positive, and
 * keep them so. Steps of Newton's method for the sum of -log(1 - S / c): the wall c comes down
 * behind the worst frame, at a relative distance from it, until the steps cease to help. Each step
 * sets the targets to the edges' present lengths, so that S is 1 / scaled Jacobian there and never
 * below it: no step passes the wall. What is far from the wall is improved on the way. A step that
 * leaves a hex not positive inside is undone, and the hex watched from then on.
 * @param distance  relative, of the wall behind the worst frame: the smaller, the more the worst
 *                  counts against all others
 * @param target    stop at this worst scaled Jacobian
 * Errors: OUT_OF_MEMORY, CANCELLED. Cost: 5 to 60 Newton steps.
 * Source: the method of centres (Huard 1967); majorisation by the inequality of the means.
 */
hexcon_status sharpen_patch(hexcon_context *context, newton *n, patch *p, double distance,
                            double target);

#endif
