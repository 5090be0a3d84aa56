/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "pillow_worth.h"

#include <math.h>

/** The worst must rise by this much, or by this part of it; .. */
static const double least_gain = 0.1, least_part = 0.25;
/** .. or, where it does not, the mean by this much. */
static const double least_mean_gain = 0.05;

double pillow_least_worth(double worst) {
  return worst + fmin(least_gain, fmax(least_part * worst, 1e-3));
}

bool pillow_is_worth(const filled_mesh *pillowed, const filled_mesh *plain) {
  const mesh_taste preference = {.enough = 1,
                                 .clearly = pillow_least_worth(plain->worst) - plain->worst,
                                 .clear_mean = least_mean_gain,
                                 .fewer = true};
  bool lower = pillowed->inverted == plain->inverted && pillowed->worst < plain->worst;
  return !lower && filled_mesh_is_better(pillowed, plain, &preference);
}
