/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Rotated edges, crossings of loops, and shells in which edges rotate. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "construct/rotated_shell.h"
#include "shape/place/prism_placement.h"
#include "solve/shelling/rotation_search.h"
#include "solve/shelling/shell_filling.h"
#include "support.h"
#include "surface/build.h"
#include "surface/edge_rotation.h"
#include "surface/loop_crossings.h"
#include "surface/loops.h"

static surface surface_of(hexcon_context *context, const test_mesh *mesh) {
  surface s;
  assert_int_equal(surface_build(context, mesh->points, mesh->surface_point_count, mesh->quads,
                                 mesh->quad_count, &s),
                   HEXCON_OK);
  return s;
}

static loop_crossings crossings_of(hexcon_context *context, const surface *s) {
  crossing_counter counter;
  assert_int_equal(crossing_counter_new(context, s->quad_count, &counter), HEXCON_OK);
  loop_crossings c = count_crossings(s, &counter);
  crossing_counter_free(context, &counter);
  return c;
}

/** As counted pair by pair; frees the mesh. */
static loop_crossings expect_crossings(test_mesh mesh) {
  hexcon_context *context = hexcon_context_new();
  surface s = surface_of(context, &mesh);
  surface_loops loops;
  assert_int_equal(surface_find_loops(context, &s, &loops), HEXCON_OK);
  loop_crossings c = crossings_of(context, &s);
  size_t of_themselves = 0, in_excess = 0;
  for (int32_t i = 0; i < (int32_t)loops.count; i++)
    for (int32_t j = 0; j <= i; j++) {
      size_t crossings = 0;
      for (size_t q = 0; q < s.quad_count; q++) {
        int32_t a = loops.loop_of_passage[2 * q], b = loops.loop_of_passage[2 * q + 1];
        crossings += (a == i && b == j) || (a == j && b == i);
      }
      of_themselves += i == j ? crossings : 0;
      in_excess += i != j && crossings > 2 ? (crossings - 2) / 2 : 0;
    }
  assert_int_equal(c.loops, loops.count);
  assert_int_equal(c.of_themselves, of_themselves);
  assert_int_equal(c.in_excess, in_excess);
  surface_loops_free(context, &loops);
  surface_free(context, &s);
  test_mesh_free(&mesh);
  hexcon_context_free(context);
  return c;
}

static void crossings_of_small_surfaces(void **state) {
  (void)state;
  loop_crossings box = expect_crossings(make_box(2, 3, 1));
  assert_int_equal(box.loops, 6);
  assert_int_equal(box.of_themselves + box.in_excess, 0);
  assert_int_equal(expect_crossings(make_trapezohedron()).of_themselves, 8);
  (void)expect_crossings(make_cells(3, 3, 1, "#.##.####"));
  (void)expect_crossings(make_schneiders_pyramid());
  (void)expect_crossings(make_tube(8, 2));
}

/** Every edge that can be rotated, and back: nothing has changed. Three times: neither, up to where
 * the two quads begin. */
static void rotated_and_back(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  test_mesh box = make_box(3, 3, 3);
  surface s = surface_of(context, &box);
  size_t sides = 4 * s.quad_count, rotated = 0;
  int32_t *quads = malloc(sides * sizeof *quads), *twins = malloc(sides * sizeof *twins);
  assert_true(quads && twins);
  memcpy(quads, s.quads, sides * sizeof *quads);
  memcpy(twins, s.twins, sides * sizeof *twins);
  for (int32_t h = 0; h < (int32_t)sides; h++)
    for (uint8_t step = 1; step <= 2; step++) {
      rotation_undo undo;
      int32_t corners[6], after[6];
      rotation_hexagon(&s, h, corners);
      assert_int_equal(corners[0], half_edge_end(&s, h));
      assert_int_equal(corners[3], half_edge_start(&s, h));
      if (!surface_rotate(&s, (edge_rotation){h, step}, &undo)) {
        assert_memory_equal(s.quads, quads, sides * sizeof *quads);
        assert_memory_equal(s.twins, twins, sides * sizeof *twins);
        continue;
      }
      rotated++;
      rotation_hexagon(&s, 4 * undo.quads[0] + 3, after);
      for (int k = 0; k < 6; k++)
        assert_int_equal(after[k], corners[(step + k) % 6]);
      for (int32_t i = 0; i < (int32_t)sides; i++)
        assert_int_equal(s.twins[s.twins[i]], i);
      surface_rotate_back(&s, &undo);
      assert_memory_equal(s.quads, quads, sides * sizeof *quads);
      assert_memory_equal(s.twins, twins, sides * sizeof *twins);
    }
  assert_in_range(rotated, sides, 2 * sides - 1); /* not those at the corners */
  free(quads);
  free(twins);
  surface_free(context, &s);
  test_mesh_free(&box);
  hexcon_context_free(context);
}

/** One edge in the middle of a box's side: 38 hexes and one under each other quad. */
static void one_rotation(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  test_mesh box = make_box(3, 3, 3);
  surface s = surface_of(context, &box);
  for (uint8_t step = 1; step <= 2; step++) {
    rotation_undo undo;
    int32_t h = 0;
    while (!surface_rotate(&s, (edge_rotation){h, step}, &undo))
      h++;
    surface_rotate_back(&s, &undo);
    edge_rotation rotation = {h, step};
    uint8_t level = 0;
    rotation_plan plan = {1, 1, &rotation, &level};
    rotated_shell shell;
    bool fits = false;
    assert_int_equal(rotated_shell_build(context, &s, &plan, &shell, &fits), HEXCON_OK);
    assert_true(fits);
    assert_int_equal(shell.mesh.hex_count, 52 + 38);
    assert_int_equal(shell.mirrored[0], step == 2);
    assert_int_equal(shell.inner.quad_count, 54);
    rotated_shell_free(context, &shell);
    level = 1; /* nothing in the first shell */
    plan.shell_count = 2;
    assert_int_equal(rotated_shell_build(context, &s, &plan, &shell, &fits), HEXCON_OK);
    assert_int_equal(shell.mesh.hex_count, 54 + 52 + 38);
    rotated_shell_free(context, &shell);
  }
  surface_free(context, &s);
  test_mesh_free(&box);
  hexcon_context_free(context);
}

/** Mean value coordinates give back every place. */
static void weights_of_a_prism(void **state) {
  (void)state;
  const double root = 0.75 * 1.1547005383792515;
  const double corners[12][3] = {{1, 0, 0},   {0.5, root, 0},    {-0.5, root, 0},
                                 {-1, 0, 0},  {-0.5, -root, 0},  {0.5, -root, 0},
                                 {1, 0, -2},  {0.5, root, -2},   {-0.5, root, -2},
                                 {-1, 0, -2}, {-0.5, -root, -2}, {0.5, -root, -2}};
  const double place[3] = {0.31, -0.17, -0.6};
  double weights[12], sum = 0, back[3] = {0};
  prism_weights(corners, place, weights);
  for (int i = 0; i < 12; i++) {
    assert_true(weights[i] > 0);
    sum += weights[i];
    for (int k = 0; k < 3; k++)
      back[k] += weights[i] * corners[i][k];
  }
  assert_true(fabs(sum - 1) < 1e-12);
  for (int k = 0; k < 3; k++)
    assert_true(fabs(back[k] - place[k]) < 1e-12);
}

/** Two steps of a narrow beam, and the first surface kept, filled if its loops go. */
static hexcon_status search_and_fill(hexcon_context *context, const surface *s) {
  rotation_search search;
  rotation_plan plan = {0};
  filled_mesh filled = {0};
  const shell_space space = {.center = {1.5, 1.5, 1.5}, .thickness = 0.3};
  hexcon_status status = rotation_search_begin(context, s, 2, 1, 1, &search);
  for (int step = 0; !status && step < 2; step++)
    status = rotation_search_advance(context, &search);
  if (!status) {
    assert_int_equal(search.step, 2);
    assert_in_range(search.count, 1, 2);
    status = rotation_search_plan(context, &search, 0, &plan);
  }
  if (!status) {
    assert_int_equal(plan.count, 2);
    status = shell_filling_build(context, s, &plan, &space, 40 * s->quad_count, &filled);
  }
  if (!status)
    assert_true(filled.hex_count > s->quad_count);
  filled_mesh_free(context, &filled);
  rotation_plan_free(context, &plan);
  rotation_search_free(context, &search);
  return status;
}

/** Nothing leaks, whichever allocation fails. */
static void every_allocation_fails_once(void **state) {
  (void)state;
  test_memory memory = {0};
  hexcon_context *context = hexcon_context_new_with(test_reallocate, &memory);
  test_mesh box = make_box(2, 2, 2);
  surface s = surface_of(context, &box);
  size_t live = memory.live;
  hexcon_status status = HEXCON_OUT_OF_MEMORY;
  for (size_t fail_at = 1; status; fail_at++) {
    memory.calls = 0;
    memory.fail_at = fail_at;
    status = search_and_fill(context, &s);
    assert_true(status == HEXCON_OK || status == HEXCON_OUT_OF_MEMORY);
    assert_int_equal(memory.live, live);
  }
  assert_in_range(memory.calls, 100, 100000);
  memory.fail_at = 0;
  surface_free(context, &s);
  test_mesh_free(&box);
  hexcon_context_free(context);
}

static void refusals(void **state) {
  (void)state;
  const hexcon_mesh_options options = {.method = HEXCON_METHOD_SHELLING};
  hexcon_context *context = hexcon_context_new();
  test_mesh tube = make_tube(8, 2), trapezohedron = make_trapezohedron();
  hexcon_mesh *made = NULL;
  assert_int_equal(hexcon_mesh_surface(context, tube.points, tube.surface_point_count, tube.quads,
                                       tube.quad_count, &options, &made),
                   HEXCON_NOT_A_BALL);
  assert_message(context);
  assert_int_equal(hexcon_mesh_surface(context, trapezohedron.points,
                                       trapezohedron.surface_point_count, trapezohedron.quads,
                                       trapezohedron.quad_count, &options, &made),
                   HEXCON_NO_ROTATIONS);
  assert_message(context);
  assert_null(made);
  test_mesh_free(&tube);
  test_mesh_free(&trapezohedron);
  hexcon_context_free(context);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(crossings_of_small_surfaces),
      cmocka_unit_test(rotated_and_back),
      cmocka_unit_test(one_rotation),
      cmocka_unit_test(weights_of_a_prism),
      cmocka_unit_test(every_allocation_fails_once),
      cmocka_unit_test(refusals),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
