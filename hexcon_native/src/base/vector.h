/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Vectors of three doubles. */
#ifndef HEXCON_BASE_VECTOR_H
#define HEXCON_BASE_VECTOR_H

#include <math.h>

static inline void vector_subtract(const double a[3], const double b[3], double out[3]) {
  out[0] = a[0] - b[0];
  out[1] = a[1] - b[1];
  out[2] = a[2] - b[2];
}

static inline void vector_add_scaled(double out[3], double factor, const double a[3]) {
  out[0] += factor * a[0];
  out[1] += factor * a[1];
  out[2] += factor * a[2];
}

static inline double vector_dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void vector_cross(const double a[3], const double b[3], double out[3]) {
  out[0] = a[1] * b[2] - a[2] * b[1];
  out[1] = a[2] * b[0] - a[0] * b[2];
  out[2] = a[0] * b[1] - a[1] * b[0];
}

static inline double vector_determinant(const double a[3], const double b[3], const double c[3]) {
  double product[3];
  vector_cross(b, c, product);
  return vector_dot(a, product);
}

static inline double vector_length(const double a[3]) {
  return sqrt(vector_dot(a, a));
}

#endif
