/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The foldover-free energy of a corner of a hex. */
#ifndef HEXCON_SHAPE_CORNER_ENERGY_H
#define HEXCON_SHAPE_CORNER_ENERGY_H

/**
 * Energy of three edges at a corner, already divided by their target lengths: 1 for a right-handed
 * orthonormal frame, growing without bound where the frame degenerates (epsilon = 0) or staying
 * finite for inverted frames (epsilon > 0).
 * E = (1 - theta) |F|^2 / (3 chi^(2/3)) + theta (D^2 + 1) / (2 chi), D = det F,
 * chi = (D + sqrt(epsilon^2 + D^2)) / 2; theta = 1/8.
 * @param frame     frame[i] is edge i
 * @param gradient  receives dE / d frame[i]
 * @param determinant receives D
 * Source: Garanzha et al., Foldover-free maps in 50 lines of code (2021), equations (2) to (5).
 */
double corner_energy(double frame[3][3], double epsilon, double gradient[3][3],
                     double *determinant);

#endif
