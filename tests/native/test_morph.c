/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Homotopy of meshes that are given in odd ways: points of no hex, all or none of them fixed. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "support.h"
#include "verify/jacobian_sign.h"

enum { LOOSE = 40 }; /* points of no hex, before and after those of the mesh */

typedef struct journey {
  test_mesh mesh;
  uint8_t *fixed;
  double *goal, *positions, reached;
} journey;

/** A grid with loose points round it, every second of them fixed; the goal is twice as high. */
static journey make_journey(void) {
  test_mesh grid = make_box(2, 2, 2);
  journey j = {.mesh = test_mesh_copy(&grid)};
  size_t count = grid.point_count + 2 * (size_t)LOOSE;
  free(j.mesh.points);
  j.mesh.points = calloc(3 * count, sizeof(double));
  j.fixed = calloc(count, 1);
  j.goal = calloc(3 * count, sizeof(double));
  j.positions = calloc(3 * count, sizeof(double));
  assert_true(j.mesh.points && j.fixed && j.goal && j.positions);
  for (size_t v = 0; v < count; v++) {
    bool loose = v < LOOSE || v >= LOOSE + grid.point_count;
    j.fixed[v] = (uint8_t)(loose ? v % 2 : v - LOOSE < grid.surface_point_count);
    for (size_t k = 0; k < 3; k++) {
      j.mesh.points[3 * v + k] = loose ? (double)(3 * v + k) : grid.points[3 * (v - LOOSE) + k];
      j.goal[3 * v + k] = (k == 2 ? 2 : 1) * j.mesh.points[3 * v + k];
    }
  }
  for (size_t i = 0; i < 8 * grid.hex_count; i++)
    j.mesh.hexes[i] += LOOSE;
  j.mesh.point_count = count;
  test_mesh_free(&grid);
  return j;
}

static void journey_free(journey *j) {
  test_mesh_free(&j->mesh);
  free(j->fixed);
  free(j->goal);
  free(j->positions);
}

static hexcon_status go(journey *j, bool boundary_only, bool in_place) {
  test_memory memory = {0};
  hexcon_context *context = hexcon_context_new_with(test_reallocate, &memory);
  const hexcon_morph_options options = {.boundary_only = boundary_only};
  if (in_place)
    memcpy(j->positions, j->mesh.points, 3 * j->mesh.point_count * sizeof(double));
  hexcon_status status = hexcon_morph(context, in_place ? j->positions : j->mesh.points,
                                      j->mesh.point_count, j->mesh.hexes, j->mesh.hex_count,
                                      j->fixed, j->goal, &options, j->positions, &j->reached);
  hexcon_context_free(context);
  assert_int_equal(memory.live, 0);
  return status;
}

static void expect_row(const journey *j, size_t v, const double *expected) {
  assert_memory_equal(j->positions + 3 * v, expected + 3 * v, 3 * sizeof(double));
}

static void points_of_no_hex(void **state) {
  (void)state;
  for (int way = 0; way < 4; way++) {
    journey j = make_journey();
    assert_int_equal(go(&j, way & 1, way & 2), HEXCON_OK);
    assert_true(j.reached == 1);
    for (size_t v = 0; v < j.mesh.point_count; v++)
      if (j.fixed[v])
        expect_row(&j, v, j.goal);
      else if (v < LOOSE || v >= j.mesh.point_count - LOOSE)
        expect_row(&j, v, j.mesh.points);
    for (size_t h = 0; h < j.mesh.hex_count; h++)
      assert_int_equal(prove_jacobian_sign(j.positions, j.mesh.hexes + 8 * h), JACOBIAN_POSITIVE);
    journey_free(&j);
  }
}

/** A way that ends early: fixed points of no hex are as far on theirs as the others. */
static void part_of_the_way(void **state) {
  (void)state;
  journey j = make_journey();
  for (size_t v = LOOSE; v < j.mesh.point_count - LOOSE; v++)
    if (j.mesh.points[3 * v + 2] > 1.5)
      j.goal[3 * v + 2] = -1; /* the top under the bottom */
  assert_int_equal(go(&j, true, false), HEXCON_OK);
  assert_true(j.reached > 0 && j.reached < 1);
  for (size_t i = 0; i < 3 * j.mesh.point_count; i++)
    if (j.fixed[i / 3])
      assert_close(j.positions[i], (1 - j.reached) * j.mesh.points[i] + j.reached * j.goal[i],
                   1e-9);
  journey_free(&j);
}

static void all_or_none_fixed(void **state) {
  (void)state;
  for (int fixed = 0; fixed < 2; fixed++)
    for (int boundary_only = 0; boundary_only < 2; boundary_only++) {
      journey j = make_journey();
      memset(j.fixed, fixed, j.mesh.point_count);
      assert_int_equal(go(&j, boundary_only, false), HEXCON_OK);
      assert_true(j.reached == 1);
      for (size_t v = 0; fixed && v < j.mesh.point_count; v++)
        expect_row(&j, v, j.goal);
      journey_free(&j);
    }
}

/** The same hex twice, a goal at the end of the numbers: no crash, nothing that is no number where
 * the way ends. */
static void doubled_hexes_and_far_goals(void **state) {
  (void)state;
  static const double scales[] = {DBL_MAX, -DBL_MAX / 2, 1e200, 1e100, 1e-300, 5e-324, 0};
  for (size_t i = 0; i < sizeof scales / sizeof *scales; i++) {
    journey j = make_journey();
    memcpy(j.mesh.hexes + 8, j.mesh.hexes, 8 * sizeof *j.mesh.hexes);
    for (size_t k = 0; k < 3 * j.mesh.point_count; k++)
      j.goal[k] = fmin(j.goal[k], 1) * scales[i];
    assert_int_equal(go(&j, i % 2, false), HEXCON_OK);
    for (size_t k = 0; k < 3 * j.mesh.point_count; k++)
      assert_true(isfinite(j.positions[k]));
    journey_free(&j);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(points_of_no_hex),
      cmocka_unit_test(part_of_the_way),
      cmocka_unit_test(all_or_none_fixed),
      cmocka_unit_test(doubled_hexes_and_far_goals),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
