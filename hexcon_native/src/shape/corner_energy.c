/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "corner_energy.h"

#include "base/vector.h"

static const double theta = 0.125; /* weight of volume against shape */

double corner_energy(double frame[3][3], double epsilon, double gradient[3][3],
                     double *determinant) {
  double cofactors[3][3];
  for (int i = 0; i < 3; i++)
    vector_cross(frame[(i + 1) % 3], frame[(i + 2) % 3], cofactors[i]);
  double d = vector_dot(frame[0], cofactors[0]);
  double root = sqrt(epsilon * epsilon + d * d);
  /* For d < 0 the sum cancels: use the conjugate form. */
  double chi = d >= 0 ? (d + root) / 2 : epsilon * epsilon / (2 * (root - d));
  double chi_slope = root > 0 ? chi / root : 0.5;
  double norm = vector_dot(frame[0], frame[0]) + vector_dot(frame[1], frame[1]) +
                vector_dot(frame[2], frame[2]);
  double power = 1 / cbrt(chi * chi);
  double shape = norm * power / 3, volume = (d * d + 1) / (2 * chi);
  double shape_slope = -2 * shape / (3 * chi) * chi_slope;
  double volume_slope = d / chi - volume / chi * chi_slope;
  double along_cofactor = (1 - theta) * shape_slope + theta * volume_slope;
  double along_frame = (1 - theta) * 2 * power / 3;
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      gradient[i][j] = along_frame * frame[i][j] + along_cofactor * cofactors[i][j];
  *determinant = d;
  return (1 - theta) * shape + theta * volume;
}
