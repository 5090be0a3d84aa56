/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Nearest points on curves and surfaces that have a closed form. */
#ifndef HEXCON_SHAPE_SLIDE_CLOSED_FORMS_H
#define HEXCON_SHAPE_SLIDE_CLOSED_FORMS_H

#include <stdbool.h>

#include "hexcon.h"

/** Whether carriers of a kind have one; hexcon_project is asked of the others. */
bool carrier_is_closed(int kind);

/** Whether a place is finite, and not beyond 1e100. */
bool carrier_is_place(const double x[3]);

/** Whether a direction, or a normal, is finite and has a length. */
bool carrier_is_direction(const double v[3]);

/** What is wrong with a carrier; NULL: nothing. */
const char *carrier_fault(const hexcon_carrier *carrier);

/** With an axis of length 1, and `across` of length 1 and at right angles to it. @param carrier
 * without fault */
hexcon_carrier carrier_normalised(const hexcon_carrier *carrier);

/**
 * The nearest point of a normalised carrier that is closed, as near to it as rounding allows; some
 * nearest one where there are several.
 * @param direction  receives the unit tangent of a curve, the unit normal of a surface, either way
 *                   round; is left as it is by a point
 */
void carrier_project(const hexcon_carrier *carrier, const double point[3], double nearest[3],
                     double direction[3]);

#endif
