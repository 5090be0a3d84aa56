/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * Time and memory of every stage on swept surfaces of 10^4, 10^5 and 10^6 hexes, numbered at
 * random, and the exponent by which each stage grows, and how a budget of a second is kept; then of
 * cells on rough boxes of 24, 96 and 294 quads; and of the topological methods on 10^3 to 10^6
 * quads, and of bodies with holes. Prints their tables; with the argument `topological` or `cuts`
 * that one alone.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

#include "bench_cuts.h"
#include "bench_support.h"
#include "bench_topological.h"

enum { SIZES = 3, STAGES = 34 };

typedef struct table {
  size_t hexes[SIZES];
  double memory[SIZES];
  size_t stage_count;
  char names[STAGES][48];
  double seconds[STAGES][SIZES];
} table;

static void note(table *t, int size, const char *name, double seconds) {
  size_t stage = 0;
  while (stage < t->stage_count && strcmp(t->names[stage], name) != 0)
    stage++;
  if (stage == STAGES)
    return;
  if (stage == t->stage_count)
    (void)snprintf(t->names[t->stage_count++], sizeof t->names[0], "%s", name);
  t->seconds[stage][size] += seconds;
}

static double worst_of(hexcon_context *context, const double *points, size_t count,
                       const hexcon_mesh *mesh) {
  size_t hex_count = hexcon_mesh_hex_count(mesh);
  double *values = allocate(hex_count, sizeof *values), worst = 1;
  check(context,
        hexcon_quality(context, points, count, hexcon_mesh_hexes(mesh), hex_count, values));
  for (size_t h = 0; h < hex_count; h++)
    worst = fmin(worst, values[h]);
  free(values);
  return worst;
}

typedef struct damage {
  const char *name;
  double amount;
  size_t every;
  double target;
} damage;

/** Damage the mesh's inside and have it repaired. */
static void bench_optimise(hexcon_context *context, table *t, int size, const hexcon_mesh *mesh,
                           size_t fixed_count, const damage *d, int threads) {
  size_t count = hexcon_mesh_point_count(mesh);
  double *points = allocate(3 * count, sizeof *points);
  uint8_t *fixed = allocate(count, 1);
  memset(fixed, 1, fixed_count);
  memcpy(points, hexcon_mesh_points(mesh), 3 * count * sizeof *points);
  scramble(points, count, fixed_count, d->amount, d->every);
  hexcon_optimize_options options = {.target = d->target, .threads = threads};
  double start = now();
  check(context, hexcon_optimize(context, points, count, hexcon_mesh_hexes(mesh),
                                 hexcon_mesh_hex_count(mesh), fixed, &options, points));
  char name[48];
  (void)snprintf(name, sizeof name, "%s, %d thread%s", d->name, threads, threads > 1 ? "s" : "");
  note(t, size, name, now() - start);
  (void)fprintf(stderr, "%s: worst scaled Jacobian %.4f, undamaged %.4f\n", name,
                worst_of(context, points, count, mesh),
                worst_of(context, hexcon_mesh_points(mesh), count, mesh));
  free(points);
  free(fixed);
}

static void bench_damages(hexcon_context *context, table *t, int size, const hexcon_mesh *mesh,
                          size_t fixed_count) {
  static const damage damages[] = {{"untangled 0.1 %", 1, 1000, 0.5},
                                   {"untangled all", 5, 1, 1e-6},
                                   {"untangled all, optimised", 5, 1, 1}};
  for (size_t i = 0; i < sizeof damages / sizeof *damages; i++)
    for (int threads = 1; threads <= 2; threads++)
      bench_optimise(context, t, size, mesh, fixed_count, &damages[i], threads);
}

static void bench_embedding(hexcon_context *context, table *t, int size, const char *name,
                            const surface_arrays *s) {
  hexcon_embedding found;
  double start = now();
  check(context, hexcon_surface_embedding(context, s->points, s->point_count, s->quads,
                                          s->quad_count, &found));
  note(t, size, name, now() - start);
  if (found.embedded != HEXCON_EMBEDDED_YES)
    stop("a surface of the bench crosses itself");
  hexcon_embedding_free(context, &found);
}

/** Pairs of a surface of about as many quads as there are hexes. */
static void bench_pairing(hexcon_context *context, table *t, int size, size_t hexes) {
  size_t n = (size_t)sqrt((double)hexes / 6);
  surface_arrays s = cube_surface(n + n % 2);
  bend(&s);
  shuffle(&s);
  bench_embedding(context, t, size, "embedding, as many quads", &s);
  int32_t *pairs = allocate(s.quad_count, sizeof *pairs);
  for (int shaken = 0; shaken < 2; shaken++) {
    double start = now();
    check(context,
          hexcon_surface_pairing(context, s.points, s.point_count, s.quads, s.quad_count, pairs));
    note(t, size, shaken ? "pairing, quads shaken" : "pairing, as many quads", now() - start);
    scramble(s.points, s.point_count, 0, 0.3 * cbrt((double)s.point_count) / (double)n, 1);
  }
  free(pairs);
  surface_arrays_free(&s);
}

/** What is stopped by a budget comes back in time, on about as many quads as there are hexes: no
 * method is done with them by then. */
static void bench_budget(hexcon_context *context, table *t, int size, size_t hexes) {
  static const struct {
    const char *name;
    hexcon_method method;
  } stopped[] = {{"pillowed, budget 1 s", HEXCON_METHOD_PILLOWED},
                 {"cells, budget 1 s", HEXCON_METHOD_CELLS},
                 {"sheets, budget 1 s", HEXCON_METHOD_SHEETS},
                 {"auto, budget 1 s", HEXCON_METHOD_AUTO}};
  surface_arrays s = cube_surface((size_t)sqrt((double)hexes / 6));
  bend(&s);
  shuffle(&s);
  for (size_t i = 0; i < sizeof stopped / sizeof *stopped; i++) {
    hexcon_mesh_options options = {.method = stopped[i].method, .budget = 1};
    hexcon_mesh *mesh;
    double start = now();
    hexcon_status status = hexcon_mesh_surface(context, s.points, s.point_count, s.quads,
                                               s.quad_count, &options, &mesh);
    hexcon_mesh_free(context, mesh);
    note(t, size, stopped[i].name, now() - start);
    (void)fprintf(stderr, "%s, %zu quads: %s\n", stopped[i].name, s.quad_count,
                  hexcon_status_name((int)status));
  }
  surface_arrays_free(&s);
}

/** The stages that the mesh's report tells of. */
static void note_stages(table *t, int size, const hexcon_mesh *mesh) {
  const hexcon_figure *figures;
  size_t figure_count = hexcon_mesh_report(mesh, &figures);
  for (size_t i = 0; i < figure_count; i++)
    if (strncmp(figures[i].name, "seconds ", 8) == 0) {
      char name[48];
      (void)snprintf(name, sizeof name, "  %.40s", figures[i].name + 8);
      note(t, size, name, figures[i].value);
    }
}

static void bench_size(hexcon_context *context, table *t, int size, size_t n) {
  surface_arrays s = cube_surface(n);
  bend(&s);
  shuffle(&s);
  hexcon_surface_report report;
  double start = now();
  check(context,
        hexcon_check_surface(context, s.points, s.point_count, s.quads, s.quad_count, &report));
  note(t, size, "surface report", now() - start);
  hexcon_mesh *mesh;
  start = now();
  check(context,
        hexcon_mesh_surface(context, s.points, s.point_count, s.quads, s.quad_count, NULL, &mesh));
  note(t, size, "swept, in all", now() - start);
  struct rusage usage;
  (void)getrusage(RUSAGE_SELF, &usage);
  t->memory[size] = (double)usage.ru_maxrss / 1024;
  t->hexes[size] = hexcon_mesh_hex_count(mesh);
  note_stages(t, size, mesh);
  bench_embedding(context, t, size, "embedding of its surface", &s);
  double *values = allocate(t->hexes[size], sizeof *values);
  start = now();
  check(context, hexcon_quality(context, hexcon_mesh_points(mesh), hexcon_mesh_point_count(mesh),
                                hexcon_mesh_hexes(mesh), t->hexes[size], values));
  note(t, size, "quality", now() - start);
  free(values);
  hexcon_second_order raised;
  start = now();
  check(context,
        hexcon_raise_order(context, hexcon_mesh_points(mesh), hexcon_mesh_point_count(mesh),
                           hexcon_mesh_hexes(mesh), t->hexes[size], &raised));
  note(t, size, "second order", now() - start);
  hexcon_second_order_free(context, &raised);
  bench_damages(context, t, size, mesh, s.point_count);
  bench_pairing(context, t, size, t->hexes[size]);
  bench_budget(context, t, size, t->hexes[size]);
  hexcon_mesh_free(context, mesh);
  surface_arrays_free(&s);
}

/* --------------------------------------------------------------------------------------- cells */

/** Finds nothing: the core then closes with a star once, instead of trying more for its worst
 * hexes, which no closure by one point of so many quads makes good. */
static bool no_tetrahedra(void *user, const double *points, size_t point_count,
                          const int32_t *triangles, size_t triangle_count, hexcon_tetrahedra *out) {
  (void)user, (void)points, (void)point_count, (void)triangles, (void)triangle_count, (void)out;
  return false;
}

/** Cells on a bent box of n * n quads a side, numbered at random, its points shaken by up to a
 * tenth of an edge: construction, placement and optimisation of one star. */
static void bench_cells(hexcon_context *context, table *t, int size, size_t n) {
  surface_arrays s = cube_surface(n);
  bend(&s);
  shuffle(&s);
  scramble(s.points, s.point_count, 0, 0.1 * cbrt((double)s.point_count) / (double)n, 1);
  hexcon_mesh_options options = {
      .method = HEXCON_METHOD_CELLS, .threads = 1, .tetrahedralise = no_tetrahedra};
  hexcon_mesh *mesh;
  double start = now();
  check(context, hexcon_mesh_surface(context, s.points, s.point_count, s.quads, s.quad_count,
                                     &options, &mesh));
  note(t, size, "cells, in all", now() - start);
  t->hexes[size] = hexcon_mesh_hex_count(mesh);
  note_stages(t, size, mesh);
  (void)fprintf(stderr, "cells on %zu quads: worst scaled Jacobian %.4f\n", s.quad_count,
                worst_of(context, hexcon_mesh_points(mesh), hexcon_mesh_point_count(mesh), mesh));
  hexcon_mesh_free(context, mesh);
  surface_arrays_free(&s);
}

static void print_row(const table *t, const char *name, const double values[SIZES]) {
  (void)printf("%-36s", name);
  for (int i = 0; i < SIZES; i++)
    (void)printf(i == 0 ? "%8.3f" : "%12.3f", values[i]);
  for (int i = 1; i < SIZES; i++)
    (void)printf("%10.2f", values[i - 1] > 0 && values[i] > 0
                               ? log(values[i] / values[i - 1]) /
                                     log((double)t->hexes[i] / (double)t->hexes[i - 1])
                               : 0.0);
  (void)printf("\n");
}

static void print_rates(const table *t, size_t stage) {
  (void)printf("%-36s", t->names[stage]);
  for (int i = 0; i < SIZES; i++)
    (void)printf(i == 0 ? "%8.0f" : "%12.0f", (double)t->hexes[i] / t->seconds[stage][i]);
  (void)printf("   hexes per second\n");
}

static void print_head(const table *t) {
  (void)printf("%-36s%8zu%12zu%12zu%20s\n", "hexes", t->hexes[0], t->hexes[1], t->hexes[2],
               "exponents");
  for (size_t stage = 0; stage < t->stage_count; stage++)
    print_row(t, t->names[stage], t->seconds[stage]);
}

int main(int argument_count, char **arguments) {
  const char *alone = argument_count > 1 ? arguments[1] : "";
  if (strcmp(alone, "cuts") != 0)
    bench_topological(); /* first: its processes begin as large as this one */
  if (strcmp(alone, "topological") == 0)
    return 0;
  bench_cuts();
  if (strcmp(alone, "cuts") == 0)
    return 0;
  static const size_t cells[SIZES] = {22, 46, 100}, cell_sides[SIZES] = {2, 4, 7};
  table t = {{0}, {0}, 0, {{0}}, {{0}}}, of_cells = t;
  hexcon_context *context = hexcon_context_new();
  if (!context)
    stop("out of memory");
  for (int size = 0; size < SIZES; size++)
    bench_cells(context, &of_cells, size, cell_sides[size]);
  for (int size = 0; size < SIZES; size++)
    bench_size(context, &t, size, cells[size]);
  hexcon_context_free(context);
  print_head(&t);
  print_row(&t, "peak memory after swept, MiB", t.memory);
  for (size_t stage = 0; stage < t.stage_count; stage++)
    if (strncmp(t.names[stage], "untangled all", 13) == 0)
      print_rates(&t, stage);
  print_head(&of_cells);
  print_rates(&of_cells, 0);
  (void)printf("seconds unless said otherwise; one thread unless said otherwise; exponents between "
               "neighbouring sizes\n");
  return 0;
}
