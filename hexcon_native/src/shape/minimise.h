/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Minimisation of the foldover-free energy over a region. */
#ifndef HEXCON_SHAPE_MINIMISE_H
#define HEXCON_SHAPE_MINIMISE_H

#include "region.h"

typedef struct minimise_options {
  int iterations; /**< of L-BFGS, in all */
  int power;      /**< of the corner energies: high powers look at the worst corner only */
  bool untangle;  /**< start from inverted corners: regularise, and sharpen step by step */
} minimise_options;

/**
 * Move the points of a region to lower the sum of its hexes' corner energies. Each hex aims at a
 * box whose edges are the means of its own present edges: local targets, as hexes of one mesh may
 * differ in volume by orders of magnitude.
 * @param positions  [mesh->point_count][3] rows of the region's points are changed
 * Errors: OUT_OF_MEMORY, CANCELLED. Cost: linear in the region, per iteration.
 */
hexcon_status region_minimise(hexcon_context *context, const region_mesh *mesh, const region *r,
                              const minimise_options *options, double *positions);

#endif
