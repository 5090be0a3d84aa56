/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "untangle.h"

#include <math.h>

/** The rule of the paper, section 3.2: sharpen as far as the descent has earned. */
static double next_epsilon(double epsilon, double determinant, double left) {
  double sigma = fmax(1 - left, 0.3);
  double root = sqrt(determinant * determinant + epsilon * epsilon);
  return determinant >= 0 ? epsilon * (1 - sigma)
                          : epsilon * (1 - sigma * root / (fabs(determinant) + root));
}

hexcon_status untangle_patch(hexcon_context *context, newton *n, patch *p, bool patient,
                             bool *done) {
  const double smallest_decrease = 0.01, smallest_epsilon = 1e-6;
  const int steps = 6, rounds = patient ? 40 : 15;
  frame_energy_options options = {.epsilon = 1, .theta = 0.125};
  *done = false;
  hexcon_status status = HEXCON_OK;
  for (int round = 0; !status && round < rounds && !*done; round++) {
    double left = newton_descend(n, p, &options, smallest_decrease, steps);
    if (n->status)
      return n->status;
    double determinant = patch_worst_frame(p, p->x, &options).determinant;
    *done = determinant > 0;
    options.epsilon = next_epsilon(options.epsilon, determinant, left);
    if (!patient)
      options.epsilon = fmin(options.epsilon, fmax(fabs(determinant), smallest_epsilon));
    status = context_progress(context, STAGE_UNTANGLING, (double)round / rounds);
  }
  options.epsilon = 0;
  if (*done && !status)
    (void)newton_descend(n, p, &options, smallest_decrease, 10);
  return status ? status : n->status;
}
