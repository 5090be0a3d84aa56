/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Loops, colouring, genus, orientation, convexity and star centre. */
#include <math.h>
#include <string.h>

#include "support.h"

/** Facts of a surface that owns nothing but its boundary; frees the mesh. */
static hexcon_surface_report facts_of(test_mesh mesh) {
  hexcon_context *context = hexcon_context_new();
  hexcon_surface_report report;
  assert_int_equal(hexcon_check_surface(context, mesh.points, mesh.surface_point_count, mesh.quads,
                                        mesh.quad_count, &report),
                   HEXCON_OK);
  assert_string_equal(hexcon_context_message(context), "");
  hexcon_context_free(context);
  test_mesh_free(&mesh);
  return report;
}

/** Loop lengths and self-crossings by loop, and that the loops are what they say. */
static void expect_loops(test_mesh mesh, const size_t *lengths, const size_t *crossings,
                         size_t count) {
  hexcon_context *context = hexcon_context_new();
  hexcon_loops loops;
  assert_int_equal(hexcon_surface_loops(context, mesh.quads, mesh.quad_count, &loops), HEXCON_OK);
  assert_int_equal(loops.count, count);
  assert_int_equal(loops.offsets[0], 0);
  assert_int_equal(loops.offsets[count], 2 * mesh.quad_count);
  for (size_t i = 0; i < count; i++) {
    const int32_t *passed = loops.quads + loops.offsets[i];
    size_t length = loops.offsets[i + 1] - loops.offsets[i], twice = 0;
    assert_int_equal(length, lengths[i]);
    assert_int_equal(loops.self_crossings[i], crossings[i]);
    for (size_t a = 0; a < length; a++)
      for (size_t b = 0; b < a; b++)
        twice += passed[a] == passed[b];
    assert_int_equal(twice, crossings[i]);
  }
  hexcon_loops_free(context, &loops);
  hexcon_surface_report report = facts_of(mesh);
  assert_int_equal(report.loop_count, count);
  hexcon_context_free(context);
}

static void loops_by_hand(void **state) {
  (void)state;
  static const size_t four[] = {4, 4, 4}, none[12] = {0};
  expect_loops(make_box(1, 1, 1), four, none, 3);
  /* Each kite is crossed three kites on: one loop passes every one twice. */
  expect_loops(make_trapezohedron(), (size_t[]){16}, (size_t[]){8}, 1);
  static const size_t torus[] = {5, 4, 4, 4, 4, 4, 5, 5, 5};
  expect_loops(make_torus(4, 5), torus, none, 9);
}

/** Where all edges are split, a loop follows edges of the coarse surface on one side, and at each
 * point leaves one edge out: once round the base outside, and twelve steps for all the rest. */
static void loops_of_schneiders_pyramid(void **state) {
  (void)state;
  expect_loops(make_schneiders_pyramid(), (size_t[]){24, 8}, (size_t[]){8, 0}, 2);
  hexcon_surface_report report = facts_of(make_schneiders_pyramid());
  assert_int_equal(report.quad_count, 16);
  assert_int_equal(report.point_count, 18);
  assert_int_equal(report.genus, 0);
  assert_true(report.even && report.bipartite && report.oriented && report.convex);
}

static void box_loops(void **state) {
  (void)state;
  test_mesh box = make_box(2, 3, 5);
  hexcon_surface_report report = facts_of(box);
  assert_int_equal(report.loop_count, 2 + 3 + 5);
  assert_int_equal(report.self_crossing_count, 0);
  assert_int_equal(report.quad_count, 2 * (6 + 10 + 15));
  assert_int_equal(report.edge_count, 2 * report.quad_count);
  assert_int_equal(report.euler, 2);
}

static void colouring(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  test_mesh box = make_box(3, 4, 2), torus = make_torus(4, 6);
  test_mesh *meshes[] = {&box, &torus};
  for (int m = 0; m < 2; m++) {
    uint8_t colours[64];
    memset(colours, 7, sizeof colours);
    size_t count = meshes[m]->surface_point_count;
    assert_int_equal(hexcon_surface_colouring(context, meshes[m]->quads, meshes[m]->quad_count,
                                              count + 1, colours),
                     HEXCON_OK);
    assert_int_equal(colours[0], 0);
    assert_int_equal(colours[count], 0); /* a point of no quad is black */
    for (size_t h = 0; h < 4 * meshes[m]->quad_count; h++) {
      int32_t a = meshes[m]->quads[h], b = meshes[m]->quads[(h & ~(size_t)3) | ((h + 1) & 3)];
      assert_int_equal(colours[a] + colours[b], 1);
    }
    test_mesh_free(meshes[m]);
  }
  hexcon_context_free(context);
}

static void genus(void **state) {
  (void)state;
  assert_int_equal(facts_of(make_box(2, 2, 2)).genus, 0);
  assert_int_equal(facts_of(make_torus(3, 4)).genus, 1);
  assert_int_equal(facts_of(make_cells(3, 3, 1, "####.####")).genus, 1);
  hexcon_surface_report twice = facts_of(make_cells(5, 3, 1, "######.#.######"));
  assert_int_equal(twice.genus, 2);
  assert_int_equal(twice.euler, -2);
  hexcon_surface_report pair = facts_of(make_cells(3, 1, 1, "#.#"));
  assert_int_equal(pair.genus, 0);
  assert_int_equal(pair.component_count, 2);
  assert_int_equal(pair.euler, 4);
  /* A hollow box: the inner surface faces into the hole. */
  hexcon_surface_report hollow = facts_of(make_cells(3, 3, 3, "#############.#############"));
  assert_int_equal(hollow.component_count, 2);
  assert_int_equal(hollow.genus, 0);
  assert_int_equal(hollow.cavity_count, 1);
  assert_int_equal(pair.cavity_count, 0);
  assert_true(hollow.oriented);
  assert_close(hollow.volume, 26, 1e-12);
}

static void parity(void **state) {
  (void)state;
  assert_true(facts_of(make_box(1, 2, 3)).even);
  assert_false(facts_of(make_torus(3, 3)).even);
  assert_false(facts_of(make_torus(3, 4)).bipartite);
  assert_true(facts_of(make_torus(4, 6)).bipartite);
}

static void orientation(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  test_mesh box = make_box(2, 1, 3), inward = make_box(2, 1, 3);
  hexcon_mesh *mesh = NULL;
  turn_quads(&inward);
  assert_int_equal(hexcon_mesh_surface(context, inward.points, inward.surface_point_count,
                                       inward.quads, inward.quad_count, NULL, &mesh),
                   HEXCON_OK);
  assert_certified_mesh(context, &inward, mesh);
  assert_memory_equal(hexcon_mesh_quads(mesh), box.quads, 4 * box.quad_count * sizeof(int32_t));
  hexcon_mesh_free(context, mesh);
  hexcon_surface_report out = facts_of(box), in = facts_of(inward);
  assert_true(out.oriented);
  assert_false(in.oriented);
  assert_close(out.volume, 6, 1e-12);
  assert_close(in.volume, 6, 1e-12);
  assert_true(in.convex && in.star_shaped);
  hexcon_context_free(context);
}

static test_mesh move_and_scale(test_mesh mesh, double scale, double offset) {
  for (size_t i = 0; i < 3 * mesh.point_count; i++)
    mesh.points[i] = scale * mesh.points[i] + offset;
  return mesh;
}

static test_mesh make_ball(int n) {
  test_mesh ball = move_and_scale(make_box(n, n, n), 2.0 / n, -1);
  for (size_t v = 0; v < ball.surface_point_count; v++) {
    double *p = ball.points + 3 * v;
    double length = sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    for (int i = 0; i < 3; i++)
      p[i] /= length;
  }
  return ball;
}

static void convexity(void **state) {
  (void)state;
  assert_true(facts_of(make_box(3, 2, 1)).convex);
  assert_true(facts_of(make_ball(4)).convex);
  assert_true(facts_of(make_ball(9)).convex);
  assert_true(facts_of(make_trapezohedron()).convex);
  assert_true(facts_of(make_pentagonal_prism(3)).convex);
  assert_false(facts_of(make_cells(2, 2, 1, "###.")).convex);
  assert_false(facts_of(make_cells(3, 1, 2, "####.#")).convex);
  assert_true(facts_of(move_and_scale(make_ball(6), 1e-3, 100)).convex);
}

static void star_center(void **state) {
  (void)state;
  hexcon_surface_report box = facts_of(make_box(1, 1, 1));
  assert_true(box.star_shaped);
  assert_close(box.star_margin, 0.5, 1e-9);
  for (int i = 0; i < 3; i++)
    assert_close(box.star_center[i], 0.5, 1e-9);
  hexcon_surface_report corner = facts_of(make_cells(2, 2, 1, "###.")); /* sees all: [0, 1]^3 */
  assert_true(corner.star_shaped);
  assert_close(corner.star_margin, 0.5, 1e-9);
  for (int i = 0; i < 3; i++)
    assert_close(corner.star_center[i], 0.5, 1e-9);
  hexcon_surface_report u_shape = facts_of(make_cells(3, 2, 1, "####.#"));
  assert_false(u_shape.star_shaped);
  assert_true(u_shape.star_margin <= 0);
  hexcon_surface_report ring = facts_of(make_cells(3, 3, 1, "####.####"));
  assert_false(ring.star_shaped);
  assert_true(ring.star_margin < 0);
}

static void star_center_anywhere(void **state) {
  (void)state;
  for (int exponent = -50; exponent <= 50; exponent += 25) {
    double scale = pow(10, exponent);
    hexcon_surface_report far = facts_of(move_and_scale(make_box(2, 3, 4), scale, 1e3 * scale));
    assert_true(far.star_shaped);
    assert_close(far.star_margin / scale, 1, 1e-6);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(loops_by_hand), cmocka_unit_test(loops_of_schneiders_pyramid),
      cmocka_unit_test(box_loops),     cmocka_unit_test(colouring),
      cmocka_unit_test(genus),         cmocka_unit_test(parity),
      cmocka_unit_test(orientation),   cmocka_unit_test(convexity),
      cmocka_unit_test(star_center),   cmocka_unit_test(star_center_anywhere),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
