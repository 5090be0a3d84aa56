/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The sign of a curved hex's Jacobian in exact arithmetic, for what rounding could decide. */
#ifndef HEXCON_VERIFY_CURVED_JACOBIAN_EXACT_H
#define HEXCON_VERIFY_CURVED_JACOBIAN_EXACT_H

#include <stddef.h>

#include "jacobian_verdict.h"

/** Bytes of `room` below. */
size_t exact_curved_room(void);

/** Of some of the hex's corners, bits in the order of box_corners, the first where the Jacobian is
 * not positive; -1 if none is proved so. */
int nonpositive_curved_corner(double nodes[20][3], unsigned corners);

/**
 * As prove_curved_jacobian_sign, every Bernstein coefficient exact, with bisection. UNDECIDED is
 * left for what prove_jacobian_sign_exactly leaves, and for Jacobians that nearly touch zero on a
 * surface.
 */
jacobian_sign prove_curved_jacobian_exactly(double nodes[20][3], void *room, double witness[3]);

#endif
