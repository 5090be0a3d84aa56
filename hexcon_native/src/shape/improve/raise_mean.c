/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "raise_mean.h"

#include <math.h>
#include <string.h>

#include "guarded_step.h"
#include "hexmesh/hex_tables.h"
#include "hexmesh/scaled_jacobian.h"
#include "patch_energy.h"

/** Corners this much better than their hex's worst count a third of it. */
static const double blur = 0.03;

/** Every corner counts this much, lest a point be left without a minimum. */
static const double least_share = 0.01;

/** Frames this near to the wall, relative to it, count as that far from it. */
static const double least_room = 0.02;

/** Set the shares from the present shape: the slope of share * -log(1 - S / ceiling) becomes that
 * of -1 / S. @return the sum of the hexes' scaled Jacobians */
static double share_out(const patch *p, double ceiling) {
  double total = 0;
  for (size_t h = 0; h < p->hex_count; h++) {
    int32_t hex[8];
    double quality[8], worst = 1, sum = 0;
    for (size_t c = 0; c < 8; c++)
      hex[c] = p->corners[8 * h + hex_corner_bits[c]];
    for (int c = 0; c < 8; c++) {
      quality[c] = corner_scaled_jacobian(p->x, hex, c);
      worst = fmin(worst, quality[c]);
    }
    for (size_t c = 0; c < 8; c++)
      sum += exp((worst - quality[c]) / blur);
    for (size_t c = 0; c < 8; c++) {
      double room = fmax(1 - 1 / (fmax(quality[c], 1e-9) * ceiling), least_room);
      p->shares[8 * h + hex_corner_bits[c]] =
          room * (least_share + quality[c] * quality[c] * exp((worst - quality[c]) / blur) / sum);
    }
    total += worst;
  }
  return total;
}

hexcon_status raise_mean_patch(hexcon_context *context, newton *n, patch *p, double floor) {
  const int most_steps = 20;
  const double least_gain = 1e-3, inner_room = 4; /* frames inside hexes only guard positivity */
  frame_energy_options options = {0};
  double *backup = context_allocate(context, p->free_count, 3 * sizeof *backup), before = 0;
  p->shares = context_allocate(context, p->hex_count, 8 * sizeof *p->shares);
  hexcon_status status = backup && p->shares ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  patch_target_own_lengths(p, p->smallest_edge);
  patch_watch_thin(p);
  for (int step = 0; !status && step < most_steps; step++) {
    patch_target_own_lengths(p, p->smallest_edge);
    patch_state worst = patch_worst_frame(p, p->x, &options);
    if (step == 0)
      options.ceiling = fmax(worst.energy * RAISE_MEAN_CLEARANCE, 1 / floor);
    options.inner_ceiling = fmax(worst.inner_energy * RAISE_MEAN_CLEARANCE, inner_room / floor);
    double now = share_out(p, options.ceiling);
    if (now < before)
      status = newton_go_back(n, p, backup);
    if (!isfinite(worst.energy + worst.inner_energy) ||
        now < before + least_gain * (double)p->hex_count || !guarded_step(n, p, &options, backup))
      break;
    before = now;
    status = context_progress(context, STAGE_OPTIMISATION, (double)step / most_steps);
  }
  context_free(context, p->shares);
  p->shares = NULL;
  context_free(context, backup);
  return status ? status : n->status;
}
