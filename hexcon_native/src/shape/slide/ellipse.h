/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The nearest point on an ellipse. */
#ifndef HEXCON_SHAPE_SLIDE_ELLIPSE_H
#define HEXCON_SHAPE_SLIDE_ELLIPSE_H

/**
 * @param half_axes  both > 0, in any order
 * @param point      in the ellipse's frame
 * @param angle      receives cosine and sine: (half_axes[0] cos, half_axes[1] sin) is nearest
 * Cost: up to a hundred halvings.
 * Source: Eberly, Distance from a point to an ellipse (2013): the one root of a convex function,
 * bracketed.
 */
void ellipse_nearest(const double half_axes[2], const double point[2], double angle[2]);

#endif
