/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Preconditioned conjugate gradients for any symmetric positive system. */
#ifndef HEXCON_SHAPE_PLACE_CONJUGATE_GRADIENTS_H
#define HEXCON_SHAPE_PLACE_CONJUGATE_GRADIENTS_H

#include "base/context.h"

/** Write a linear image of `in` to `out`; both [count], and not the same. */
typedef void (*linear_map)(void *user, const double *in, double *out);

typedef struct linear_system {
  size_t count;
  linear_map multiply, precondition;
  void *user;
  double *work[4]; /**< [count] each: residual, direction, image, preconditioned residual */
} linear_system;

/**
 * Improve x until the residual's norm, measured by the preconditioner, has fallen to `tolerance`
 * times that of `b`, or for `limit` iterations.
 * @param b  [count]
 * @param x  [count] start and result
 * Cost: a product and a preconditioning per iteration.
 * @return CANCELLED, OUT_OF_TIME: x is then what it had come to
 */
hexcon_status conjugate_gradients(hexcon_context *context, const linear_system *system,
                                  const double *b, double tolerance, size_t limit, double *x);

#endif
