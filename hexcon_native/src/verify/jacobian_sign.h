/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Proof of the sign of a hex's trilinear Jacobian. */
#ifndef HEXCON_VERIFY_JACOBIAN_SIGN_H
#define HEXCON_VERIFY_JACOBIAN_SIGN_H

#include <stdint.h>

#include "jacobian_verdict.h"

/**
 * Sign of the Jacobian determinant of the trilinear map of a hex.
 * The determinant is a polynomial of degree 2 in each direction; its 27 Bernstein coefficients
 * bound it, and bisection makes the bound tight. Arithmetic is in double precision with a running
 * bound on its rounding error, and exact where that bound leaves the sign open, so that the two
 * decided answers are theorems.
 * @param hex 8 ids, VTK order
 * Source: Johnen, Weill, Remacle, Robust and efficient validation of the linear hexahedral element
 * (2017), for the coefficients; the error bound is ours.
 */
jacobian_sign prove_jacobian_sign(const double *points, const int32_t *hex);

/**
 * The same, with a witness.
 * @param witness  receives local coordinates in [0, 1]^3 of a point where the Jacobian is proved
 *                 zero or negative, exact as they are: corner 0 of the hex lies at (0, 0, 0),
 *                 1 at (1, 0, 0), 3 at (0, 1, 0), 4 at (0, 0, 1). NaN unless NONPOSITIVE.
 */
jacobian_sign prove_jacobian_sign_at(const double *points, const int32_t *hex, double witness[3]);

#endif
