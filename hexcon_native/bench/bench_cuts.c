/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "bench_cuts.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "bench_support.h"

enum { ROWS = 4, THICK = 2 };

/** Cells of a plate: `holes` in a row, each as wide as the bars around it, all of `finer` cells. */
typedef struct plate {
  size_t holes, finer, size[3];
} plate;

static bool is_filled(const plate *p, const size_t at[3], size_t axis, int step) {
  size_t next[3] = {at[0], at[1], at[2]};
  if (step < 0 && next[axis] == 0)
    return false;
  next[axis] += (size_t)step;
  if (next[axis] >= p->size[axis])
    return false;
  return next[1] / p->finer != 1 || next[0] / p->finer % 2 == 0;
}

/** The quad between a filled cell and one that is not. */
static void add_quad(const plate *p, const size_t at[3], size_t axis, int step, int32_t *ids,
                     surface_arrays *s) {
  static const size_t corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (size_t c = 0; c < 4; c++) {
    const size_t *corner = corners[step > 0 ? c : 3 - c];
    size_t point[3] = {at[0], at[1], at[2]};
    point[axis] += step > 0;
    point[(axis + 1) % 3] += corner[0];
    point[(axis + 2) % 3] += corner[1];
    int32_t *id = &ids[(point[2] * (p->size[1] + 1) + point[1]) * (p->size[0] + 1) + point[0]];
    if (*id < 0) {
      *id = (int32_t)s->point_count++;
      for (size_t i = 0; i < 3; i++)
        s->points[3 * (size_t)*id + i] = (double)point[i];
    }
    s->quads[4 * s->quad_count + c] = *id;
  }
  s->quad_count++;
}

static surface_arrays plate_surface(size_t holes, size_t finer) {
  const plate p = {holes, finer, {(2 * holes + 1) * finer, 3 * finer, THICK}};
  const size_t cells = p.size[0] * p.size[1] * p.size[2];
  const size_t lattice = (p.size[0] + 1) * (p.size[1] + 1) * (p.size[2] + 1);
  int32_t *ids = allocate(lattice, sizeof *ids);
  surface_arrays s = {0, 0, allocate(3 * lattice, sizeof(double)),
                      allocate(24 * cells, sizeof(int32_t))};
  memset(ids, -1, lattice * sizeof *ids);
  for (size_t cell = 0; cell < cells; cell++) {
    const size_t at[3] = {cell % p.size[0], cell / p.size[0] % p.size[1],
                          cell / p.size[0] / p.size[1]};
    for (size_t axis = 0; axis < 3 && is_filled(&p, at, 0, 0); axis++)
      for (int step = -1; step <= 1; step += 2)
        if (!is_filled(&p, at, axis, step))
          add_quad(&p, at, axis, step, ids, &s);
  }
  free(ids);
  return s;
}

static void bench_rows(const size_t holes[ROWS], const size_t finer[ROWS]) {
  double seconds_before = 0;
  size_t quads_before = 0;
  (void)printf("%8s%10s%10s%12s%10s\n", "holes", "quads", "hexes", "seconds", "exponent");
  for (int row = 0; row < ROWS; row++) {
    hexcon_context *context = hexcon_context_new();
    surface_arrays s = plate_surface(holes[row], finer[row]);
    const hexcon_mesh_options options = {
        .method = HEXCON_METHOD_SHEETS, .no_core = true, .threads = 1};
    hexcon_mesh *mesh;
    if (!context)
      stop("out of memory");
    shuffle(&s);
    clock_t start = clock();
    check(context, hexcon_mesh_surface(context, s.points, s.point_count, s.quads, s.quad_count,
                                       &options, &mesh));
    double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    (void)printf("%8zu%10zu%10zu%12.3f", holes[row], s.quad_count, hexcon_mesh_hex_count(mesh),
                 seconds);
    if (row > 0)
      (void)printf("%10.2f", log(seconds / seconds_before) /
                                 log((double)s.quad_count / (double)quads_before));
    (void)printf("\n");
    seconds_before = seconds;
    quads_before = s.quad_count;
    hexcon_mesh_free(context, mesh);
    surface_arrays_free(&s);
    hexcon_context_free(context);
  }
}

void bench_cuts(void) {
  static const size_t few[ROWS] = {4, 4, 4, 4}, finer[ROWS] = {3, 9, 27, 81};
  static const size_t many[ROWS] = {5, 15, 45, 135}, as_fine[ROWS] = {2, 2, 2, 2};
  (void)printf(
      "plates with holes by sheets: seconds of processor time, exponents by the number of quads\n");
  bench_rows(few, finer);
  bench_rows(many, as_fine);
}
