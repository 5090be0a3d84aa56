/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The energy of a patch: the sum of frame_energy over the frames of its hexes. */
#ifndef HEXCON_SHAPE_IMPROVE_PATCH_ENERGY_H
#define HEXCON_SHAPE_IMPROVE_PATCH_ENERGY_H

#include "block_matrix.h"
#include "frame_energy.h"

/** What an evaluation saw. */
typedef struct patch_state {
  double energy;       /**< infinite if some frame's is */
  double inner_energy; /**< patch_worst_frame: of the frames inside hexes */
  double determinant;  /**< smallest of any frame, against its targets */
} patch_state;

/**
 * Sum over the eight corner frames of every hex, by their shares, and over the frames on a grid of
 * 3, 5 or 9 places along each axis of the watched hexes. Frames of fixed points only are left out.
 * @param x         [point_count][3] instead of p->x
 * @param gradient  [3 free_count]; NULL if not wanted
 * @param hessian   receives the second derivative with the gradient; NULL if not wanted
 * Stops at the first infinite energy if no gradient is wanted. Linear in the hexes.
 */
patch_state patch_energy(const patch *p, const double *x, const frame_energy_options *options,
                         double *gradient, block_matrix *hessian);

/** Largest energy of a single corner frame and of a single one inside a hex (before any ceiling),
 * and the smallest determinant. */
patch_state patch_worst_frame(const patch *p, const double *x, const frame_energy_options *options);

/** Largest energy of a single frame, where those inside hexes only guard positivity: they count a
 * part. */
double patch_guarded_worst(const patch *p);

/** Watch the hexes that are thinner inside than their corners let expect: four times. */
void patch_watch_thin(patch *p);

#endif
