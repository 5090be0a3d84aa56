/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Measures of a surface: volume, normals, convexity. */
#ifndef HEXCON_SURFACE_GEOMETRY_H
#define HEXCON_SURFACE_GEOMETRY_H

#include "half_edges.h"

/** Volume enclosed by the bilinear quads, less that of cavities; positive if they face out of the
 * solid. Linear. */
double surface_volume(const surface *s);

/** What one quad adds to it: its volume under the bilinear quad, seen from `origin`. */
double surface_quad_volume(const surface *s, int32_t quad, const double origin[3]);

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
