/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** What can be said of the sign of a hex's Jacobian. */
#ifndef HEXCON_VERIFY_JACOBIAN_VERDICT_H
#define HEXCON_VERIFY_JACOBIAN_VERDICT_H

typedef enum jacobian_sign {
  JACOBIAN_POSITIVE,    /**< proved positive on the whole closed hex */
  JACOBIAN_NONPOSITIVE, /**< proved zero or negative at some point of the hex */
  JACOBIAN_UNDECIDED    /**< touches zero, as far as can be told; see jacobian_exact.h */
} jacobian_sign;

#endif
