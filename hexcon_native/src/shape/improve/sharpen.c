/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "sharpen.h"

#include <math.h>

#include "guarded_step.h"

hexcon_status sharpen_patch(hexcon_context *context, newton *n, patch *p, double distance,
                            double target) {
  const int most_steps = 60, most_idle = 2;
  const double worth = 0.03; /* of the distance, as gain of a step */
  double best = INFINITY, *backup = context_allocate(context, p->free_count, 3 * sizeof *backup);
  hexcon_status status = backup ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  int idle = 0;
  patch_target_own_lengths(p, p->smallest_edge);
  patch_watch_thin(p);
  for (int step = 0; !status && step < most_steps && idle <= most_idle; step++) {
    frame_energy_options options = {0};
    patch_target_own_lengths(p, p->smallest_edge);
    double worst = patch_guarded_worst(p);
    idle = worst > best * (1 - worth * distance) ? idle + 1 : 0;
    best = fmin(best, worst);
    options.ceiling = worst * (1 + distance);
    if (!isfinite(worst) || worst * target <= 1 || !guarded_step(n, p, &options, backup))
      break;
    status = context_progress(context, STAGE_OPTIMISATION, (double)step / most_steps);
  }
  context_free(context, backup);
  return status ? status : n->status;
}
