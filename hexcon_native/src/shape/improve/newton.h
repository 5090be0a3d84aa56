/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Newton's method for the energy of a patch. */
#ifndef HEXCON_SHAPE_IMPROVE_NEWTON_H
#define HEXCON_SHAPE_IMPROVE_NEWTON_H

#include "patch_energy.h"
#include "tangent_spaces.h"

/** Buffers for one patch; its targets and energy may change between calls, its hexes may not. */
typedef struct newton {
  hexcon_context *context;
  hexcon_status status; /**< of the last step: CANCELLED, OUT_OF_TIME; the patch stays as it was */
  block_matrix hessian;
  double *gradient, *step; /**< [3 free_count] */
  double *trial;           /**< [3 point_count] */
} newton;

/** @param out free with newton_free, also after an error. Linear in the patch. */
hexcon_status newton_new(hexcon_context *context, const patch *p, newton *out);
void newton_free(hexcon_context *context, newton *n);

/**
 * One step: p->x goes downhill along the Newton direction, by the first of 1, 1/2, 1/4 .. that
 * lowers the energy enough.
 * @return the relative decrease of the energy; 0 where no step was found (p->x is then unchanged)
 * Cost: one second derivative, up to 60 products of it, a few energies.
 */
double newton_step(newton *n, patch *p, const frame_energy_options *options);

/** The free points at an earlier state, bit for bit, that was on what they slide on.
 * @param state  [3 free_count] */
hexcon_status newton_go_back(newton *n, patch *p, const double *state);

/** Steps until the energy falls by less than `smallest_decrease` in one, at most `most`.
 * @return the energy at the end over that at the start */
double newton_descend(newton *n, patch *p, const frame_energy_options *options,
                      double smallest_decrease, int most);

#endif
