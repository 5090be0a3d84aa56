/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Optimisation: repairs, moves nothing that is fixed, and never makes a mesh worse. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "support.h"
#include "verify/jacobian_sign.h"

typedef struct standing {
  size_t inverted;
  double worst;
} standing;

static standing measure(hexcon_context *context, const test_mesh *mesh, const double *points) {
  standing s = {0, 1};
  double *values = malloc(mesh->hex_count * sizeof *values);
  assert_non_null(values);
  assert_int_equal(
      hexcon_quality(context, points, mesh->point_count, mesh->hexes, mesh->hex_count, values),
      HEXCON_OK);
  for (size_t h = 0; h < mesh->hex_count; h++) {
    s.inverted += prove_jacobian_sign(points, mesh->hexes + 8 * h) != JACOBIAN_POSITIVE;
    s.worst = fmin(s.worst, values[h]);
  }
  free(values);
  return s;
}

static uint8_t *fix_boundary(const test_mesh *mesh) {
  uint8_t *fixed = calloc(mesh->point_count, 1);
  assert_non_null(fixed);
  memset(fixed, 1, mesh->surface_point_count);
  return fixed;
}

static void scramble(test_mesh *mesh, uint64_t *random, double amount) {
  for (size_t i = 3 * mesh->surface_point_count; i < 3 * mesh->point_count; i++)
    mesh->points[i] += random_between(random, -amount, amount);
}

/** Optimise; fixed rows stay bit for bit, the outcome is not worse. Returns the outcome. */
static standing optimize(test_mesh *mesh, const uint8_t *fixed,
                         const hexcon_optimize_options *options) {
  hexcon_context *context = hexcon_context_new();
  double *positions = malloc(3 * mesh->point_count * sizeof *positions);
  assert_non_null(positions);
  standing before = measure(context, mesh, mesh->points);
  assert_int_equal(hexcon_optimize(context, mesh->points, mesh->point_count, mesh->hexes,
                                   mesh->hex_count, fixed, options, positions),
                   HEXCON_OK);
  for (size_t v = 0; v < mesh->point_count; v++)
    if (fixed[v])
      assert_memory_equal(positions + 3 * v, mesh->points + 3 * v, 3 * sizeof *positions);
  standing after = measure(context, mesh, positions);
  assert_true(after.inverted <= before.inverted);
  assert_true(after.inverted < before.inverted || after.worst >= before.worst);
  /* in place gives the same */
  assert_int_equal(hexcon_optimize(context, mesh->points, mesh->point_count, mesh->hexes,
                                   mesh->hex_count, fixed, options, mesh->points),
                   HEXCON_OK);
  assert_memory_equal(positions, mesh->points, 3 * mesh->point_count * sizeof *positions);
  free(positions);
  hexcon_context_free(context);
  return after;
}

static void scrambled_grid_is_repaired(void **state) {
  (void)state;
  uint64_t random = 11;
  for (int round = 0; round < 6; round++) {
    test_mesh grid = make_box(4, 4, 4);
    uint8_t *fixed = fix_boundary(&grid);
    scramble(&grid, &random, 0.3 + 0.2 * round);
    standing after = optimize(&grid, fixed, NULL);
    assert_int_equal(after.inverted, 0);
    assert_true(after.worst > 0.3);
    free(fixed);
    test_mesh_free(&grid);
  }
}

/** Random boundaries that may allow no valid mesh at all, any points fixed, few iterations. */
static void never_worse(void **state) {
  (void)state;
  uint64_t random = 12;
  for (int round = 0; round < 40; round++) {
    test_mesh mesh = round % 2 ? make_box(3, 2, 3) : make_pentagonal_prism(3);
    uint8_t *fixed = fix_boundary(&mesh);
    for (size_t i = 0; i < 3 * mesh.point_count; i++)
      mesh.points[i] += random_between(&random, -0.4, 0.4);
    for (size_t v = 0; v < mesh.point_count; v++)
      fixed[v] = random_below(&random, 3) == 0;
    const hexcon_optimize_options options = {
        .max_rounds = 1 + round % 5, .threads = 1 + round % 3, .target = round % 3 ? 0 : 0.3};
    (void)optimize(&mesh, fixed, &options);
    free(fixed);
    test_mesh_free(&mesh);
  }
}

/** All fixed, collapsed, or enormous: nothing breaks. */
static void hopeless_meshes(void **state) {
  (void)state;
  static const double scales[] = {0, 1e-200, 1e-30, 1e30, 1e100, 1e200, 1e300};
  uint64_t random = 13;
  test_mesh grid = make_box(3, 3, 3);
  uint8_t *fixed = malloc(grid.point_count);
  assert_non_null(fixed);
  memset(fixed, 1, grid.point_count);
  (void)optimize(&grid, fixed, NULL);
  test_mesh_free(&grid);
  free(fixed);
  for (size_t i = 0; i < sizeof scales / sizeof *scales; i++) {
    grid = make_box(3, 3, 3);
    fixed = fix_boundary(&grid);
    scramble(&grid, &random, 0.7);
    for (size_t k = 0; k < 3 * grid.point_count; k++)
      grid.points[k] *= scales[i];
    (void)optimize(&grid, fixed, NULL);
    for (size_t k = 0; k < 3 * grid.point_count; k++)
      assert_true(isfinite(grid.points[k]));
    free(fixed);
    test_mesh_free(&grid);
  }
}

static void good_mesh_stays(void **state) {
  (void)state;
  test_mesh grid = make_box(3, 3, 3), copy = test_mesh_copy(&grid);
  uint8_t *fixed = fix_boundary(&grid);
  (void)optimize(&grid, fixed, NULL);
  assert_memory_equal(grid.points, copy.points, 3 * grid.point_count * sizeof(double));
  free(fixed);
  test_mesh_free(&grid);
  test_mesh_free(&copy);
}

static void faults(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  test_mesh grid = make_box(2, 2, 2);
  uint8_t *fixed = fix_boundary(&grid);
  double out[81];
  const hexcon_optimize_options wrong[] = {
      {.max_rounds = -1}, {.threads = -1}, {.target = -0.5}, {.target = 1.5}, {.target = NAN}};
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    assert_int_equal(
        hexcon_optimize(context, grid.points, 27, grid.hexes, 8, fixed, &wrong[i], out),
        HEXCON_BAD_ARGUMENT);
    assert_elements(context, NULL, 0);
  }
  assert_int_equal(hexcon_optimize(context, grid.points, 27, grid.hexes, 0, fixed, NULL, out),
                   HEXCON_EMPTY);
  assert_int_equal(hexcon_optimize(context, grid.points, 20, grid.hexes, 8, fixed, NULL, out),
                   HEXCON_INDEX_OUT_OF_RANGE);
  assert_message(context);
  grid.points[80] = NAN;
  assert_int_equal(hexcon_optimize(context, grid.points, 27, grid.hexes, 8, fixed, NULL, out),
                   HEXCON_NOT_FINITE);
  assert_elements(context, (int32_t[]){26}, 1);
  grid.points[80] = 1;
  grid.hexes[12] = grid.hexes[13];
  assert_int_equal(hexcon_optimize(context, grid.points, 27, grid.hexes, 8, fixed, NULL, out),
                   HEXCON_REPEATED_VERTEX);
  assert_elements(context, (int32_t[]){1}, 1);
  free(fixed);
  test_mesh_free(&grid);
  hexcon_context_free(context);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(scrambled_grid_is_repaired),
      cmocka_unit_test(never_worse),
      cmocka_unit_test(hopeless_meshes),
      cmocka_unit_test(good_mesh_stays),
      cmocka_unit_test(faults),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
