/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "bench_topological.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench_support.h"

enum { SIZES = 4, STAGES = 12, COPIES = 5 };

/** Quads along an edge of the cube: 6 n^2 quads. */
static const size_t edge_sizes[SIZES] = {13, 41, 129, 408};

typedef struct subject {
  hexcon_method method;
  bool shuffled;
  const char *name;
} subject;

static const subject subjects[] = {{HEXCON_METHOD_FOUR_SPLIT, false, "four-split"},
                                   {HEXCON_METHOD_PYRAMID_ALT, false, "pyramid-alt"},
                                   {HEXCON_METHOD_PYRAMID, false, "pyramid"},
                                   {HEXCON_METHOD_PYRAMID, true, "pyramid, numbered at random"},
                                   {HEXCON_METHOD_GEODE_ALT, false, "geode-alt"},
                                   {HEXCON_METHOD_GEODE, false, "geode"}};

/** What a run tells; plain numbers, as it comes from another process. */
typedef struct outcome {
  size_t quads, hexes;
  double seconds, copy_seconds; /* of the meshing, and of copying the mesh to fresh memory */
  double peak_bytes, mesh_bytes;
  size_t stage_count;
  char stages[STAGES][48];
  double stage_seconds[STAGES];
} outcome;

/* --------------------------------------------------------------------------------- in the child */

static double processor_seconds(void) {
  struct rusage usage;
  (void)getrusage(RUSAGE_SELF, &usage);
  return (double)(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * (double)(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

static double peak_bytes(void) {
  struct rusage usage;
  (void)getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * (double)usage.ru_maxrss;
}

static int by_value(const void *a, const void *b) {
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/** Median of some copies of the points and hexes. */
static double copy_seconds(const hexcon_mesh *mesh) {
  size_t points = 3 * hexcon_mesh_point_count(mesh) * sizeof(double);
  size_t hexes = 8 * hexcon_mesh_hex_count(mesh) * sizeof(int32_t);
  double seconds[COPIES];
  for (size_t i = 0; i < COPIES; i++) {
    double start = processor_seconds();
    char *copy = malloc(points + hexes);
    if (!copy)
      stop("out of memory");
    memcpy(copy, hexcon_mesh_points(mesh), points);
    memcpy(copy + points, hexcon_mesh_hexes(mesh), hexes);
    volatile char used = copy[(points + hexes) / 2];
    (void)used;
    seconds[i] = processor_seconds() - start;
    free(copy);
  }
  qsort(seconds, COPIES, sizeof *seconds, by_value);
  return seconds[COPIES / 2];
}

static void read_stages(const hexcon_mesh *mesh, outcome *out) {
  const hexcon_figure *figures;
  size_t count = hexcon_mesh_report(mesh, &figures);
  for (size_t i = 0; i < count && out->stage_count < STAGES; i++)
    if (strncmp(figures[i].name, "seconds ", 8) == 0) {
      (void)snprintf(out->stages[out->stage_count], sizeof out->stages[0], "%.39s",
                     figures[i].name + 8);
      out->stage_seconds[out->stage_count++] = figures[i].value;
    }
}

static outcome run(const subject *made, size_t edge) {
  outcome out = {0};
  surface_arrays s = cube_surface(edge);
  bend(&s);
  if (made->shuffled)
    shuffle(&s);
  hexcon_context *context = hexcon_context_new();
  if (!context)
    stop("out of memory");
  const hexcon_mesh_options options = {.method = made->method, .skip_certificate = true};
  hexcon_mesh *mesh;
  double start = processor_seconds();
  check(context, hexcon_mesh_surface(context, s.points, s.point_count, s.quads, s.quad_count,
                                     &options, &mesh));
  out.seconds = processor_seconds() - start;
  out.peak_bytes = peak_bytes();
  out.quads = s.quad_count;
  out.hexes = hexcon_mesh_hex_count(mesh);
  out.mesh_bytes = (double)(3 * hexcon_mesh_point_count(mesh) * sizeof(double) +
                            8 * out.hexes * sizeof(int32_t));
  read_stages(mesh, &out);
  surface_arrays_free(&s);
  out.copy_seconds = copy_seconds(mesh);
  hexcon_mesh_free(context, mesh);
  hexcon_context_free(context);
  return out;
}

/* -------------------------------------------------------------------------------- in the parent */

/** Run in a process of its own, so that its peak memory is its own. */
static outcome run_apart(const subject *made, size_t edge) {
  int ends[2], status;
  outcome out = {0};
  if (pipe(ends) != 0)
    stop("no pipe");
  (void)fflush(stdout);
  pid_t child = fork();
  if (child < 0)
    stop("no process");
  if (child == 0) {
    out = run(made, edge);
    _exit(write(ends[1], &out, sizeof out) == (ssize_t)sizeof out ? 0 : 1);
  }
  (void)close(ends[1]);
  bool told = read(ends[0], &out, sizeof out) == (ssize_t)sizeof out;
  (void)close(ends[0]);
  if (waitpid(child, &status, 0) != child || status != 0 || !told)
    stop("a process failed: out of memory?");
  return out;
}

static double free_bytes(void) {
  return (double)sysconf(_SC_AVPHYS_PAGES) * (double)sysconf(_SC_PAGESIZE);
}

/** Whether a run fits, judged by the one before: memory is linear, up to doubling tables; and the
 * mesh is copied afterwards. */
static bool fits(const char *name, const outcome *before, size_t edge) {
  double quads = 6.0 * (double)edge * (double)edge;
  double per_quad = (before->peak_bytes + before->mesh_bytes) / (double)before->quads;
  double needed = 1.2 * per_quad * quads, available = free_bytes();
  if (needed <= available)
    return true;
  (void)printf("%s: %.0f quads left out: they need up to %.1f GiB, and %.1f GiB are free\n", name,
               quads, needed / (1 << 30), available / (1 << 30));
  return false;
}

/** Nothing is printed for sizes that were left out. */
static void print_values(const char *name, const double values[SIZES], int digits) {
  (void)printf("%-36s", name);
  for (int i = 0; i < SIZES; i++)
    if (values[i] > 0)
      (void)printf("%12.*f", digits, values[i]);
    else
      (void)printf("%12s", "");
}

static void print_row(const outcome runs[SIZES], const char *name, const double values[SIZES]) {
  print_values(name, values, 4);
  for (int i = 1; i < SIZES; i++)
    if (values[i - 1] > 0 && values[i] > 0)
      (void)printf("%8.2f", log(values[i] / values[i - 1]) /
                                log((double)runs[i].quads / (double)runs[i - 1].quads));
    else
      (void)printf("%8s", "");
  (void)printf("\n");
}

static void print_subject(const char *name, const outcome runs[SIZES]) {
  double seconds[SIZES], copies[SIZES], memory[SIZES];
  char line[64];
  for (int i = 0; i < SIZES; i++) {
    seconds[i] = runs[i].seconds;
    copies[i] = runs[i].quads ? runs[i].seconds / runs[i].copy_seconds : 0;
    memory[i] = runs[i].quads ? runs[i].peak_bytes / runs[i].mesh_bytes : 0;
  }
  print_row(runs, name, seconds);
  for (size_t stage = 0; stage < runs[0].stage_count; stage++) {
    double of_stage[SIZES];
    for (int i = 0; i < SIZES; i++)
      of_stage[i] = runs[i].stage_seconds[stage];
    (void)snprintf(line, sizeof line, "  %s", runs[0].stages[stage]);
    print_row(runs, line, of_stage);
  }
  print_values("  times a copy of the mesh", copies, 1);
  (void)printf("\n");
  print_values("  peak memory over the mesh's", memory, 2);
  (void)printf("\n");
}

void bench_topological(void) {
  (void)printf("%-36s", "quads");
  for (int i = 0; i < SIZES; i++)
    (void)printf("%12zu", 6 * edge_sizes[i] * edge_sizes[i]);
  (void)printf("%24s\n", "exponents");
  for (size_t m = 0; m < sizeof subjects / sizeof *subjects; m++) {
    outcome runs[SIZES] = {{0}};
    for (int i = 0; i < SIZES; i++)
      if (i == 0 || fits(subjects[m].name, &runs[i - 1], edge_sizes[i]))
        runs[i] = run_apart(&subjects[m], edge_sizes[i]);
      else
        break;
    print_subject(subjects[m].name, runs);
  }
  (void)printf(
      "topological methods: seconds of processor time, of the stages by the clock; points and "
      "quads numbered side by side unless said otherwise\n\n");
}
