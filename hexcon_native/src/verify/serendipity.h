/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * The serendipity hex of 20 nodes as a Bezier volume of degree 2 in each direction: control point
 * (i, j, k) at 9 i + 3 j + k.
 *
 * The 20 shape functions span the polynomials of degree 2 in each direction without the monomials
 * that hold two squares. That a second difference of second differences vanishes gives the control
 * points which are no nodes: b = 2 m - (p + q) / 2 on an edge with ends p, q and middle m;
 * (2 (its 4 edges) - (its 4 corners)) / 4 on a face; and the same rule in a layer through the
 * middle for the centre. In the nodes: sums with the weights below.
 */
#ifndef HEXCON_VERIFY_SERENDIPITY_H
#define HEXCON_VERIFY_SERENDIPITY_H

/** The control point over each node: corners, and then the edges' control points. */
static const unsigned char serendipity_places[20] = {0,  18, 24, 6,  2,  20, 26, 8,  9,  21,
                                                     15, 3,  11, 23, 17, 5,  1,  19, 25, 7};

/** Weights in a control point of the corners and middle nodes of its edge, face or hex, by the
 * number of directions in which it is in the middle. */
static const double serendipity_corner_weights[4] = {1, -0.5, -0.75, -0.625};
static const double serendipity_middle_weights[4] = {0, 2, 1, 0.5};

/** Binomials (2, i), and what (5, i) is of 10: with them products of Bernstein forms are integer
 * sums. */
static const double serendipity_binomials[3] = {1, 2, 1};
static const double serendipity_tenths[6] = {10, 2, 1, 1, 2, 10};

/** Corner coefficients of degree 5, at 36 i + 6 j + k, in the order of box_corners. */
static const int serendipity_corners[8] = {0, 5, 30, 35, 180, 185, 210, 215};

#endif
