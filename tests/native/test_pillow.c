/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** A sheet of hexes under the whole surface: what the surface's corners allow of it, and what it
 * does. */
#include <math.h>
#include <string.h>

#include "solve/common/pillow_bound.h"
#include "support.h"

static void bounds_of(const test_mesh *s, double *bounds) {
  hexcon_context *context = hexcon_context_new();
  assert_int_equal(
      pillow_bounds(context, s->points, s->surface_point_count, s->quads, s->quad_count, bounds),
      HEXCON_OK);
  hexcon_context_free(context);
}

/** One edge goes inwards at each point: along the diagonal of as many normals as there are sides.
 */
static void bounds_of_a_box(void **state) {
  (void)state;
  test_mesh box = make_box(2, 2, 2);
  double bounds[26];
  bounds_of(&box, bounds);
  for (size_t v = 0; v < box.surface_point_count; v++) {
    double sides = 0;
    for (size_t axis = 0; axis < 3; axis++)
      sides += box.points[3 * v + axis] != 1;
    assert_close(bounds[v], 1 / sqrt(sides), 2e-3);
  }
  size_t worst;
  assert_close(pillow_bound_least(bounds, box.surface_point_count, &worst), 1 / sqrt(3), 2e-3);
  assert_close(fabs(box.points[3 * worst] - 1), 1, 0);
  test_mesh_free(&box);
}

/** Nothing helps a quad that has an edge of no length. */
static void a_lost_edge_leaves_no_room(void **state) {
  (void)state;
  test_mesh box = make_box(1, 1, 1);
  double bounds[8];
  size_t worst;
  memcpy(box.points + 3 * 3, box.points + 3 * 1, 3 * sizeof(double));
  bounds_of(&box, bounds);
  assert_close(pillow_bound_least(bounds, 8, &worst), 0, 1e-9);
  test_mesh_free(&box);
}

static hexcon_mesh *fill(hexcon_context *context, const test_mesh *s, int pillow) {
  const hexcon_mesh_options options = {
      .method = HEXCON_METHOD_SWEPT, .pillow = pillow, .threads = 1};
  hexcon_mesh *mesh = NULL;
  assert_int_equal(hexcon_mesh_surface(context, s->points, s->surface_point_count, s->quads,
                                       s->quad_count, &options, &mesh),
                   HEXCON_OK);
  assert_certified_mesh(context, s, mesh);
  return mesh;
}

/** A hex more for each quad and sheet, outermost, whether it helps or not; none that does not. */
static void sheets_of_a_cube(void **state) {
  (void)state;
  test_mesh cube = make_box(1, 1, 1);
  const size_t hexes[] = {1, 1, 7, 13};
  for (int pillow = HEXCON_PILLOW_NEVER; pillow <= 2; pillow++) {
    hexcon_context *context = hexcon_context_new();
    hexcon_mesh *mesh = fill(context, &cube, pillow);
    assert_int_equal(hexcon_mesh_hex_count(mesh), hexes[pillow + 1]);
    assert_int_equal(figure_of(mesh, "pillows"), pillow > 0 ? pillow : 0);
    if (pillow > 0) {
      const hexcon_figure *first;
      assert_true(hexcon_mesh_report(mesh, &first) > 1);
      assert_string_equal(first->name, "hexes of pillows");
      assert_int_equal(first->value, 6 * pillow);
      assert_int_equal(figure_of(mesh, "hexes of inside"), 1);
      assert_close(hexcon_mesh_quality(mesh)[0], 1 / sqrt(3), 0.02);
    }
    hexcon_mesh_free(context, mesh);
    hexcon_context_free(context);
  }
  test_mesh_free(&cube);
}

/** A cube blown up to a ball: edges between two quads that lie in nearly one plane. */
static test_mesh make_ball(void) {
  test_mesh ball = make_box(4, 4, 4);
  for (size_t v = 0; v < ball.surface_point_count; v++) {
    double *point = ball.points + 3 * v, length = 0;
    for (size_t axis = 0; axis < 3; axis++) {
      point[axis] = tan((point[axis] - 2) * atan(1) / 2); /* even angles */
      length += point[axis] * point[axis];
    }
    for (size_t axis = 0; axis < 3; axis++)
      point[axis] /= sqrt(length);
  }
  return ball;
}

static double worst_of(const hexcon_mesh *mesh) {
  double worst = 1;
  for (size_t h = 0; h < hexcon_mesh_hex_count(mesh); h++)
    worst = fmin(worst, hexcon_mesh_quality(mesh)[h]);
  return worst;
}

static void a_ball_gets_one(void **state) {
  (void)state;
  test_mesh ball = make_ball();
  hexcon_context *context = hexcon_context_new();
  hexcon_mesh *plain = fill(context, &ball, HEXCON_PILLOW_NEVER),
              *mesh = fill(context, &ball, HEXCON_PILLOW_AUTO);
  assert_int_equal(figure_of(mesh, "pillows"), 1);
  assert_int_equal(hexcon_mesh_hex_count(mesh), hexcon_mesh_hex_count(plain) + ball.quad_count);
  assert_true(worst_of(mesh) > 2 * worst_of(plain));
  assert_true(worst_of(mesh) <= figure_of(mesh, "pillow bound") + 1e-3);
  assert_non_null(strstr(hexcon_mesh_log(mesh), "taken"));
  hexcon_mesh_free(context, plain);
  hexcon_mesh_free(context, mesh);
  hexcon_context_free(context);
  test_mesh_free(&ball);
}

static void numbers_of_sheets_are_checked(void **state) {
  (void)state;
  test_mesh cube = make_box(1, 1, 1);
  const int bad[] = {HEXCON_PILLOW_NEVER - 1, HEXCON_PILLOW_MOST + 1};
  for (size_t i = 0; i < 2; i++) {
    hexcon_context *context = hexcon_context_new();
    const hexcon_mesh_options options = {.pillow = bad[i]};
    hexcon_mesh *mesh = NULL;
    assert_int_equal(hexcon_mesh_surface(context, cube.points, cube.surface_point_count, cube.quads,
                                         cube.quad_count, &options, &mesh),
                     HEXCON_BAD_ARGUMENT);
    assert_message(context);
    hexcon_context_free(context);
  }
  test_mesh_free(&cube);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(bounds_of_a_box),
      cmocka_unit_test(a_lost_edge_leaves_no_room),
      cmocka_unit_test(sheets_of_a_cube),
      cmocka_unit_test(a_ball_gets_one),
      cmocka_unit_test(numbers_of_sheets_are_checked),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
