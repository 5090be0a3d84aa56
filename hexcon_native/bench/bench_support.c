/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "bench_support.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

double now(void) {
  struct timespec t;
  (void)timespec_get(&t, TIME_UTC);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

void stop(const char *what) {
  (void)fprintf(stderr, "bench: %s\n", what);
  exit(1);
}

void *allocate(size_t count, size_t size) {
  void *memory = calloc(count, size);
  if (!memory)
    stop("out of memory");
  return memory;
}

/** Id of a lattice point, given out at first use. */
static int32_t point_id(int32_t *ids, surface_arrays *s, size_t n, const size_t at[3]) {
  int32_t *id = &ids[(at[0] * (n + 1) + at[1]) * (n + 1) + at[2]];
  if (*id < 0) {
    *id = (int32_t)s->point_count++;
    for (int i = 0; i < 3; i++)
      s->points[3 * (size_t)*id + (size_t)i] = (double)at[i] / (double)n;
  }
  return *id;
}

surface_arrays cube_surface(size_t n) {
  surface_arrays s = {0, 0, allocate(18 * (n + 1) * (n + 1), sizeof(double)),
                      allocate(24 * n * n, sizeof(int32_t))};
  size_t lattice = (n + 1) * (n + 1) * (n + 1);
  int32_t *ids = allocate(lattice, sizeof *ids);
  memset(ids, -1, lattice * sizeof *ids);
  static const size_t corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (size_t axis = 0; axis < 3; axis++)
    for (size_t side = 0; side < 2; side++)
      for (size_t cell = 0; cell < n * n; cell++) {
        for (size_t c = 0; c < 4; c++) {
          const size_t *corner = corners[side ? c : 3 - c];
          size_t at[3];
          at[axis] = side * n;
          at[(axis + 1) % 3] = cell / n + corner[0];
          at[(axis + 2) % 3] = cell % n + corner[1];
          s.quads[4 * s.quad_count + c] = point_id(ids, &s, n, at);
        }
        s.quad_count++;
      }
  free(ids);
  return s;
}

void bend(surface_arrays *s) {
  for (size_t v = 0; v < s->point_count; v++) {
    double *p = s->points + 3 * v, x = p[0], y = p[1], z = p[2];
    p[0] = x + 0.1 * sin(3 * y) * z;
    p[2] = z + 0.05 * sin(3 * x * y);
  }
}

static size_t random_below(uint64_t *state, size_t bound) {
  *state = *state * 6364136223846793005u + 1442695040888963407u;
  return (size_t)((*state >> 33) % bound);
}

void shuffle(surface_arrays *s) {
  uint64_t state = 1;
  int32_t *place = allocate(s->point_count, sizeof *place);
  double *points = allocate(3 * s->point_count, sizeof *points);
  for (size_t v = 0; v < s->point_count; v++) {
    size_t other = random_below(&state, v + 1);
    place[v] = place[other];
    place[other] = (int32_t)v;
  }
  for (size_t v = 0; v < s->point_count; v++)
    memcpy(points + 3 * (size_t)place[v], s->points + 3 * v, 3 * sizeof *points);
  for (size_t i = 0; i < 4 * s->quad_count; i++)
    s->quads[i] = place[s->quads[i]];
  for (size_t q = s->quad_count; q > 1; q--) {
    size_t other = random_below(&state, q);
    int32_t quad[4];
    memcpy(quad, s->quads + 4 * other, sizeof quad);
    memcpy(s->quads + 4 * other, s->quads + 4 * (q - 1), sizeof quad);
    memcpy(s->quads + 4 * (q - 1), quad, sizeof quad);
  }
  free(place);
  free(s->points);
  s->points = points;
}

void check(hexcon_context *context, hexcon_status status) {
  if (status)
    stop(hexcon_context_message(context));
}

void scramble(double *points, size_t count, size_t fixed_count, double amount, size_t every) {
  uint64_t state = 2;
  double edge = 1 / cbrt((double)count);
  for (size_t i = 0; i < (count - fixed_count) / every; i++) {
    size_t v =
        every == 1 ? fixed_count + i : fixed_count + random_below(&state, count - fixed_count);
    for (size_t k = 0; k < 3; k++)
      points[3 * v + k] += amount * edge * ((double)random_below(&state, 2001) / 1000 - 1);
  }
}

void surface_arrays_free(surface_arrays *s) {
  free(s->points);
  free(s->quads);
}
