/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "sharpen.h"

#include <math.h>
#include <string.h>

#include "repair.h"

/** Shorter edges count as this part of the longest of their hex: lest they vanish. */
static const double smallest_edge = 0.01;

/** One step, cut short where a hex comes out not positive inside; that hex is watched from then on.
 * @return false when there is nothing more to be had */
static bool try_step(newton *n, patch *p, const frame_energy_options *options, double *backup) {
  const double least_decrease = 1e-9;
  const int most_halvings = 6;
  size_t count = 3 * p->free_count, watched = 0;
  memcpy(backup, p->x, count * sizeof *backup);
  if (newton_step(n, p, options) <= least_decrease)
    return false;
  for (int halving = 0; patch_count_bad(p, &watched) > 0; halving++) {
    for (size_t i = 0; i < count; i++)
      p->x[i] = halving < most_halvings ? (p->x[i] + backup[i]) / 2 : backup[i];
    if (halving == most_halvings)
      return watched > 0;
  }
  return true;
}

hexcon_status sharpen_patch(hexcon_context *context, newton *n, patch *p, double distance,
                            double target) {
  const int most_steps = 60, most_idle = 2;
  const double worth = 0.03; /* of the distance, as gain of a step */
  double best = INFINITY, *backup = context_allocate(context, p->free_count, 3 * sizeof *backup);
  hexcon_status status = backup ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  int idle = 0;
  patch_target_own_lengths(p, smallest_edge);
  patch_watch_thin(p);
  for (int step = 0; !status && step < most_steps && idle <= most_idle; step++) {
    frame_energy_options options = {0};
    patch_target_own_lengths(p, smallest_edge);
    double worst = patch_worst_frame(p, p->x, &options).energy;
    idle = worst > best * (1 - worth * distance) ? idle + 1 : 0;
    best = fmin(best, worst);
    options.ceiling = worst * (1 + distance);
    if (!isfinite(worst) || worst * target <= 1 || !try_step(n, p, &options, backup))
      break;
    status = context_progress(context, "optimisation", (double)step / most_steps);
  }
  context_free(context, backup);
  return status;
}
