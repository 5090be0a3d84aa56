/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "frame_energy.h"

#include <math.h>

#include "base/vector.h"

/** Regularised determinant and its first and second derivative. */
typedef struct regularised {
  double value, slope, bend;
} regularised;

static bool regularise(double d, double epsilon, regularised *chi) {
  if (epsilon == 0) {
    *chi = (regularised){d, 1, 0};
    return d > 0;
  }
  double root = sqrt(epsilon * epsilon + d * d);
  /* For d < 0 the sum cancels: use the conjugate form. */
  chi->value = d >= 0 ? (d + root) / 2 : epsilon * epsilon / (2 * (root - d));
  chi->slope = chi->value / root;
  chi->bend = epsilon * epsilon / (2 * root * root * root);
  return true;
}

/** A function of the frame and its determinant: f F and d are its first derivatives, the rest its
 * second ones, ff times F F'. */
typedef struct expansion_terms {
  double value, f, d, identity, ff, fd, dd;
} expansion_terms;

static void add_shape(double squares, const regularised *chi, double weight, expansion_terms *out) {
  static const double scale = 0.19245008972987526; /* 3^(-3/2) */
  double length = sqrt(squares), slope = chi->slope / chi->value;
  double value = weight * scale * squares * length / chi->value;
  out->value += value;
  out->f += 3 * value / squares;
  out->d -= value * slope;
  out->identity += 3 * value / squares;
  out->ff += 3 * value / (squares * squares);
  out->fd -= 3 * value / squares * slope;
  /* At least 3/2 slope^2, or the whole would not be positive. */
  out->dd += value * fmax(2 * slope * slope - chi->bend / chi->value, 1.5 * slope * slope);
}

static void add_volume(double d, const regularised *chi, double weight, expansion_terms *out) {
  double half = (d * d + 1) / 2, slope = chi->slope / chi->value;
  double value = weight * half / chi->value;
  out->value += value;
  out->d += weight * d / chi->value - value * slope;
  double bend = weight / chi->value * (1 - 2 * d * slope) +
                value * (2 * slope * slope - chi->bend / chi->value);
  out->dd += fmax(bend, 0);
}

/** Put the wall in front: w(E) = -log(1 - E / c). */
static bool apply_ceiling(double ceiling, expansion_terms *terms) {
  double room = ceiling - terms->value;
  if (room <= 0)
    return false;
  double slope = 1 / room, bend = slope * slope, f = terms->f, d = terms->d;
  terms->value = log(ceiling * slope);
  terms->f = slope * f;
  terms->d = slope * d;
  terms->identity *= slope;
  terms->ff = slope * terms->ff + bend * f * f;
  terms->fd = slope * terms->fd + bend * f * d;
  terms->dd = slope * terms->dd + bend * d * d;
  return true;
}

/** A frame of no length counts as this short: it has no direction to shrink to, but an energy. */
static const double smallest_squares = 1e-60;

bool frame_energy(double frame[3][3], const frame_energy_options *options, bool slopes,
                  frame_derivatives *out) {
  for (int i = 0; i < 3; i++)
    vector_cross(frame[(i + 1) % 3], frame[(i + 2) % 3], out->cofactors[i]);
  out->determinant = vector_dot(frame[0], out->cofactors[0]);
  double squares = vector_dot(frame[0], frame[0]) + vector_dot(frame[1], frame[1]) +
                   vector_dot(frame[2], frame[2]);
  regularised chi;
  if (!regularise(out->determinant, options->epsilon, &chi))
    return false;
  squares = fmax(squares, smallest_squares);
  expansion_terms terms = {0};
  add_shape(squares, &chi, 1 - options->theta, &terms);
  if (options->theta > 0)
    add_volume(out->determinant, &chi, options->theta, &terms);
  if (options->ceiling > 0 && !apply_ceiling(options->ceiling, &terms))
    return false;
  out->value = terms.value;
  if (slopes) {
    out->f = terms.f;
    out->k = terms.d;
    out->identity = terms.identity;
    out->ff = terms.ff;
    out->fk = terms.fd;
    out->kk = terms.dd;
  }
  return isfinite(terms.value) != 0;
}
