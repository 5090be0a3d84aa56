/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "conjugate_gradients.h"

#include <string.h>

static double dot(size_t count, const double *a, const double *b) {
  double sum = 0;
  for (size_t i = 0; i < count; i++)
    sum += a[i] * b[i];
  return sum;
}

hexcon_status conjugate_gradients(hexcon_context *context, const linear_system *system,
                                  const double *b, double tolerance, size_t limit, double *x) {
  hexcon_status status = HEXCON_OK;
  size_t count = system->count;
  double *residual = system->work[0], *direction = system->work[1], *image = system->work[2],
         *z = system->work[3];
  system->precondition(system->user, b, z);
  double goal = tolerance * tolerance * dot(count, b, z);
  system->multiply(system->user, x, image);
  for (size_t i = 0; i < count; i++)
    residual[i] = b[i] - image[i];
  system->precondition(system->user, residual, z);
  memcpy(direction, z, count * sizeof *z);
  double norm = dot(count, residual, z);
  for (size_t iteration = 0; !status && iteration < limit && norm > goal; iteration++) {
    system->multiply(system->user, direction, image);
    double curvature = dot(count, direction, image);
    if (!(curvature > 0))
      break;
    for (size_t i = 0; i < count; i++) {
      x[i] += norm / curvature * direction[i];
      residual[i] -= norm / curvature * image[i];
    }
    system->precondition(system->user, residual, z);
    double next = dot(count, residual, z);
    for (size_t i = 0; i < count; i++)
      direction[i] = z[i] + next / norm * direction[i];
    norm = next;
    status = context_after(context, count);
  }
  return status;
}
