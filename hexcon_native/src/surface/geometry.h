/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Measures of a surface: volume, normals, convexity. */
#ifndef HEXCON_SURFACE_GEOMETRY_H
#define HEXCON_SURFACE_GEOMETRY_H

#include "half_edges.h"

/** Volume enclosed by the bilinear quads, positive if they face outward. Linear. */
double surface_volume(const surface *s);

/** Mean normal of a quad, of length twice its area (half the cross product of its diagonals). */
void surface_quad_normal(const surface *s, int32_t quad, double normal[3]);

/** Angle in radians between the normals of the quads at a half-edge: 0 flat, pi/2 a box's edge. */
double surface_bend(const surface *s, int32_t half_edge);

/**
 * True if no quad rises over the mean plane of a neighbour by more than both are warped: gmsh's
 * quads on a ball are warped, and the ball is convex all the same. Linear.
 */
bool surface_is_convex(const surface *s);

#endif
