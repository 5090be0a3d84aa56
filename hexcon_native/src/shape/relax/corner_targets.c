/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "corner_targets.h"

#include <math.h>

#include "hexmesh/hex_tables.h"
#include "hexmesh/scaled_jacobian.h"

/** An edge is never taken for shorter than this part of its hex's mean, lest it vanish. */
static const double shortest = 1e-3;

/** 1 / the mean of a hex's edge lengths, which `lengths` receives. */
static double inverse_mean(const patch *p, size_t hex, double lengths[PATCH_EDGES]) {
  double sum = 0;
  patch_edge_lengths(p, hex, lengths);
  for (int e = 0; e < PATCH_EDGES; e++)
    sum += lengths[e];
  return sum > 0 ? (double)PATCH_EDGES / sum : 1;
}

void target_cubes(patch *p) {
  double lengths[PATCH_EDGES];
  for (size_t h = 0; h < p->hex_count; h++) {
    double inverse = inverse_mean(p, h, lengths);
    for (size_t e = 0; e < PATCH_EDGES; e++)
      p->stretch[PATCH_EDGES * h + e] = inverse;
  }
}

void target_right_angles(patch *p) {
  const double least_quality = 0.05;
  double lengths[PATCH_EDGES];
  for (size_t h = 0; h < p->hex_count; h++) {
    double inverse = inverse_mean(p, h, lengths);
    int32_t hex[8];
    for (size_t e = 0; e < PATCH_EDGES; e++)
      p->stretch[PATCH_EDGES * h + e] = inverse / sqrt(fmax(lengths[e] * inverse, shortest));
    for (size_t c = 0; c < 8; c++)
      hex[c] = p->corners[8 * h + hex_corner_bits[c]];
    for (int c = 0; c < 8; c++)
      p->shares[8 * h + hex_corner_bits[c]] =
          1 / fmax(corner_scaled_jacobian(p->x, hex, c), least_quality);
  }
}
