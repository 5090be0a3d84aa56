/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "guarded_step.h"

#include <string.h>

#include "repair.h"

bool guarded_step(newton *n, patch *p, const frame_energy_options *options, double *backup) {
  const double least_decrease = 1e-9;
  const int most_halvings = 6;
  size_t count = 3 * p->free_count, watched = 0;
  memcpy(backup, p->x, count * sizeof *backup);
  if (newton_step(n, p, options) <= least_decrease)
    return false;
  for (int halving = 0; patch_count_bad(p, &watched) > 0; halving++) {
    for (size_t i = 0; i < count && halving < most_halvings; i++)
      p->x[i] = (p->x[i] + backup[i]) / 2;
    n->status =
        halving < most_halvings ? patch_put_on(n->context, p) : newton_go_back(n, p, backup);
    if (n->status || halving == most_halvings)
      return !n->status && watched > 0;
  }
  return true;
}
