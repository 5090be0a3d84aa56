/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The foldover-free energy of a frame of three edges. */
#ifndef HEXCON_SHAPE_IMPROVE_FRAME_ENERGY_H
#define HEXCON_SHAPE_IMPROVE_FRAME_ENERGY_H

#include <stdbool.h>

/** Which energy; see frame_energy. */
typedef struct frame_energy_options {
  double epsilon;       /**< > 0: finite for inverted frames too */
  double theta;         /**< weight of volume against shape, in [0, 1) */
  double ceiling;       /**< > 0: a wall at this value of the energy */
  double inner_ceiling; /**< of frames inside a hex; 0: patch_energy takes it from the ceiling */
} frame_energy_options;

/**
 * Value and derivatives at a frame F, in terms of F, its cofactors K and the identity:
 * gradient = f F + k K; second derivative = identity I + ff F F' + fk (F K' + K F') + kk K K'.
 */
typedef struct frame_derivatives {
  double value, determinant;
  double cofactors[3][3];
  double f, k;
  double identity, ff, fk, kk;
} frame_derivatives;

/**
 * Energy of three edges, already divided by their target lengths (frame[i] is edge i):
 *   E = (1 - theta) S + theta V,  S = (|F|^2 / 3)^(3/2) / chi,  V = (D^2 + 1) / (2 chi),
 *   D = det F,  chi = (D + sqrt(epsilon^2 + D^2)) / 2;
 * with a ceiling c > 0, -log(1 - E / c) instead of E.
 * S is the foldover-free shape energy to the power 3/2: no cube root, and by the inequality of the
 * means S >= 1 / scaled Jacobian whatever the targets, with equality where they are the edges' own
 * lengths. The minimum over frames is 1. The second derivative leaves out the indefinite part that
 * comes from D being a cubic, and what epsilon adds of concavity: it is positive definite, since E
 * is convex in (F, D) otherwise.
 * @param slopes  whether `out` shall hold more than value and determinant
 * @return false where the energy is infinite (inverted at epsilon = 0, or at the ceiling)
 * Source: Garanzha et al., Foldover-free maps in 50 lines of code (2021), equations (2) to (5).
 */
bool frame_energy(double frame[3][3], const frame_energy_options *options, bool slopes,
                  frame_derivatives *out);

#endif
