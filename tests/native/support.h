/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** What the native tests share: meshes made by formula, a counting allocator, random numbers. */
#ifndef HEXCON_TESTS_SUPPORT_H
#define HEXCON_TESTS_SUPPORT_H

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "hexcon.h"

/* ------------------------------------------------------------------------------------- meshes */

/** A hex mesh and its boundary, or a surface alone (no hexes). Points 0 .. surface_point_count - 1
 * are those of the boundary. Quads face outward. */
typedef struct test_mesh {
  size_t point_count, surface_point_count, quad_count, hex_count;
  double *points;
  int32_t *quads, *hexes;
} test_mesh;

void test_mesh_free(test_mesh *mesh);
test_mesh test_mesh_copy(const test_mesh *mesh);

/** Unit cells of a grid nx * ny * nz, x fastest; `cells` has a '#' for each one that exists. */
test_mesh make_cells(int nx, int ny, int nz, const char *cells);
/** All cells. */
test_mesh make_box(int nx, int ny, int nz);
/** A cap in the plane, times `rings` layers of height 1. */
test_mesh make_prism(const double (*cap_points)[2], size_t cap_point_count,
                     const int32_t (*cap_quads)[4], size_t cap_quad_count, int rings);
/** A prism over five quads around the middle of a pentagon. */
test_mesh make_pentagonal_prism(int rings);
/** An annulus of `sectors` quads one wide, times `rings`: genus 1. */
test_mesh make_tube(int sectors, int rings);
/** A grid of m * n quads on a torus: no hexes. */
test_mesh make_torus(int m, int n);
/** A pyramid with all edges split, 4 quads on its base and 3 on each triangle: no hexes. */
test_mesh make_schneiders_pyramid(void);
/** Two apices and a zigzag of 8 points between: 8 kites, no hexes. */
test_mesh make_trapezohedron(void);
/** A surface from arrays, copied. */
test_mesh make_surface(const double (*points)[3], size_t point_count, const int32_t (*quads)[4],
                       size_t quad_count);

/** Turn every quad round. */
void turn_quads(test_mesh *mesh);
/** True if some quad has the two points as an edge. */
bool has_edge(const test_mesh *mesh, int32_t a, int32_t b);

/* ------------------------------------------------------------------------------------- memory */

/** Counts what is allocated, fails at will. */
typedef struct test_memory {
  size_t calls;                  /**< allocations so far */
  size_t fail_at;                /**< number of the allocation that fails, from 1; 0: none */
  size_t live;                   /**< blocks not freed */
  size_t live_bytes, most_bytes; /**< most_bytes 0: no limit */
} test_memory;

/** A hexcon_reallocate; user is a test_memory. */
void *test_reallocate(void *user, void *memory, size_t size);

/* ----------------------------------------------------------------------------------- patience */

/** Counts calls of progress, and cancels. */
typedef struct test_patience {
  size_t calls;
  size_t cancel_at; /**< number of the call that cancels, from 1; 0: none */
} test_patience;

/** A hexcon_progress; user is a test_patience. */
bool lose_patience(void *user, const char *stage, double fraction);

/* ------------------------------------------------------------------------------------- random */

/** splitmix64; any start value will do. */
uint64_t random_bits(uint64_t *state);
/** Even in 0 .. count - 1. */
size_t random_below(uint64_t *state, size_t count);
/** Even in low .. high. */
double random_between(uint64_t *state, double low, double high);

/* ---------------------------------------------------------------------------------- assertions */

/** The last error has words, and exactly these ids in any order. */
void assert_elements(const hexcon_context *context, const int32_t *expected, size_t count);
/** |a - b| <= tolerance; cmocka compares floats only. */
void assert_close(double a, double b, double tolerance);
/** The last error has words. */
void assert_message(const hexcon_context *context);
/** The mesh exists, is certified by a fresh hexcon_certify, and starts with the surface's points.
 */
void assert_certified_mesh(hexcon_context *context, const test_mesh *surface,
                           const hexcon_mesh *mesh);
/** The surface, which is freed, gets so many certified hexes by the method named; nothing is left
 * in memory. */
void assert_filled(test_mesh surface, const hexcon_mesh_options *options, const char *method,
                   size_t hex_count);
/** A place in the unit cube where something was proved, else no number. */
void assert_witness(bool proved, const double witness[3]);
/** A figure of the mesh's report. */
double figure_of(const hexcon_mesh *mesh, const char *name);

#endif
