/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** How well a layer on a region of a front would fit the front's geometry. */
#ifndef HEXCON_SOLVE_SHEETS_REGION_SCORE_H
#define HEXCON_SOLVE_SHEETS_REGION_SCORE_H

#include "construct/sheet_front.h"

/**
 * What laying the layer spoils, in square radians, summed over the edges it touches: their dihedral
 * angles against the right angles that so many hexes fill. At the region's rim stands one hex: 90
 * degrees; at edges inside it two: 180; at a rung as many as the region has quads at its end; at
 * the rings' outer rims 90 degrees are taken, and 90 must be left.
 */

/** The part of the rims and rings, or as much of it as is more than `limit`. front->s.points must
 * be set. Linear in the rims. */
double region_rim_score(const sheet_front *front, const front_region *region, double limit);

/** The part of the edges inside the region, which must be filled. Linear in it. */
double region_inner_score(const sheet_front *front, const front_region *region);

/** The worst scaled Jacobian of the layer's hex corners that have all four points on the first
 * front, and so at rest; 1 if there is none. Linear in the region. */
double region_fixed_bound(sheet_front *front, const front_region *region);

#endif
