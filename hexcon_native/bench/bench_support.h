/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** What the benches share: a clock, surfaces, and an end where something goes wrong. */
#ifndef HEXCON_BENCH_SUPPORT_H
#define HEXCON_BENCH_SUPPORT_H

#include "hexcon.h"

typedef struct surface_arrays {
  size_t point_count, quad_count;
  double *points;
  int32_t *quads;
} surface_arrays;

/** Seconds since some day. */
double now(void);
/** Say what went wrong, and end the process. */
_Noreturn void stop(const char *what);
/** stop unless all is well. */
void check(hexcon_context *context, hexcon_status status);
/** Zeros; stop where there is no memory. */
void *allocate(size_t count, size_t size);

/** The six sides of a cube of n^3 cells. */
surface_arrays cube_surface(size_t n);
void surface_arrays_free(surface_arrays *s);
/** Bend the cube, so that no level is an affine image of a cap. */
void bend(surface_arrays *s);
/** Number points and quads at random: real files have no helpful order. */
void shuffle(surface_arrays *s);
/** Move inner points at random by up to `amount` mean edge lengths along each axis: one in `every`.
 */
void scramble(double *points, size_t count, size_t fixed_count, double amount, size_t every);

#endif
