/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** First placement of the points inside hexagonal prisms. */
#ifndef HEXCON_SHAPE_PLACE_PRISM_PLACEMENT_H
#define HEXCON_SHAPE_PLACE_PRISM_PLACEMENT_H

#include "base/context.h"

/**
 * Weights of a hexagonal prism's corners at a place: mean value coordinates in the hexagon
 * (Floater, Mean value coordinates, 2003), linear between its ends.
 * @param corners  [12] the upper hexagon's, counter-clockwise about the z axis from above, then
 * those below them
 * @param weights  [12] receives them; their sum is 1
 */
void prism_weights(const double corners[12][3], const double place[3], double weights[12]);

#endif
