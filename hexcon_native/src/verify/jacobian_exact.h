/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The sign of a hex's Jacobian in exact arithmetic, for what rounding could decide. */
#ifndef HEXCON_VERIFY_JACOBIAN_EXACT_H
#define HEXCON_VERIFY_JACOBIAN_EXACT_H

#include <stdint.h>

#include "jacobian_verdict.h"

/**
 * As prove_jacobian_sign_at, with every Bernstein coefficient exact: a corner of exactly zero is
 * told from one that is just positive. Some thousand times as slow as the filter before it.
 * UNDECIDED is left for Jacobians that touch zero, nowhere negative, at a point that is not dyadic
 * (seen: a third, fifth or seventh of an edge, in 2 of 10^5 hexes of small integers), or nearly
 * do so along a curve; and for coordinates along one axis that span more than a double's range.
 */
jacobian_sign prove_jacobian_sign_exactly(const double *points, const int32_t *hex,
                                          double witness[3]);

#endif
