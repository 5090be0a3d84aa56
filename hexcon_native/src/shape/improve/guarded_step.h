/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** A step of Newton's method that leaves every hex of a patch positive. */
#ifndef HEXCON_SHAPE_IMPROVE_GUARDED_STEP_H
#define HEXCON_SHAPE_IMPROVE_GUARDED_STEP_H

#include "newton.h"

/**
 * One step from a valid patch, cut short where a hex comes out not positive inside; that hex is
 * watched from then on.
 * @param backup  [3 free_count] receives where the points were
 * @return false when there is nothing more to be had
 */
bool guarded_step(newton *n, patch *p, const frame_energy_options *options, double *backup);

#endif
