/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Proof of the sign of the Jacobian of a curved hex of 20 nodes. */
#ifndef HEXCON_VERIFY_CURVED_JACOBIAN_H
#define HEXCON_VERIFY_CURVED_JACOBIAN_H

#include <stddef.h>
#include <stdint.h>

#include "jacobian_verdict.h"

/** Bytes that one proof may work in: exact arithmetic on curved hexes is too large for a stack. */
size_t curved_jacobian_room(void);

/**
 * Sign of the Jacobian determinant of the serendipity map of a hex. The determinant is a polynomial
 * of degree 5 in each direction; its 216 Bernstein coefficients bound it, and bisection makes the
 * bound tight. Arithmetic as in prove_jacobian_sign: doubles with a bound on their rounding error,
 * exact where that leaves the sign open; the decided answers are theorems on the nodes as given.
 * @param nodes    [20][3], VTK_QUADRATIC_HEXAHEDRON order
 * @param room     curved_jacobian_room() bytes, aligned for doubles
 * @param witness  as prove_jacobian_sign_at
 * Source: Johnen, Remacle, Geuzaine, Geometrical validity of curvilinear finite elements (2013),
 * sections 2 and 3; the product form of the coefficients and the error bound are ours.
 */
jacobian_sign prove_curved_jacobian_sign(double nodes[20][3], void *room, double witness[3]);

#endif
