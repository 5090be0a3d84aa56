/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Every fault of a surface: the exact code and the exact ids. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "support.h"

static hexcon_status check(hexcon_context *context, const test_mesh *mesh) {
  hexcon_surface_report report;
  return hexcon_check_surface(context, mesh->points, mesh->point_count, mesh->quads,
                              mesh->quad_count, &report);
}

/** All calls that take a surface find the same fault with the same ids, once and again. */
static void expect_fault(test_mesh mesh, hexcon_status fault, const int32_t *ids, size_t count) {
  hexcon_context *context = hexcon_context_new();
  hexcon_mesh *made = (hexcon_mesh *)context;
  for (int round = 0; round < 2; round++) {
    assert_int_equal(check(context, &mesh), fault);
    assert_elements(context, ids, count);
    assert_int_equal(hexcon_mesh_surface(context, mesh.points, mesh.point_count, mesh.quads,
                                         mesh.quad_count, NULL, &made),
                     fault);
    assert_null(made);
    assert_elements(context, ids, count);
  }
  hexcon_context_free(context);
  test_mesh_free(&mesh);
}

/** A fault that the topological calls find as well. */
static void expect_topological_fault(test_mesh mesh, hexcon_status fault, const int32_t *ids,
                                     size_t count) {
  hexcon_context *context = hexcon_context_new();
  hexcon_loops loops;
  uint8_t colours[256];
  assert_true(mesh.point_count <= sizeof colours);
  assert_int_equal(hexcon_surface_loops(context, mesh.quads, mesh.quad_count, &loops), fault);
  assert_null(loops.quads);
  assert_elements(context, ids, count);
  assert_int_equal(
      hexcon_surface_colouring(context, mesh.quads, mesh.quad_count, mesh.point_count, colours),
      fault);
  assert_elements(context, ids, count);
  hexcon_context_free(context);
  expect_fault(mesh, fault, ids, count);
}

/** A fault of meshing only: the surface is fine. */
static void expect_unfillable(test_mesh mesh, hexcon_status fault, const int32_t *ids,
                              size_t count) {
  hexcon_context *context = hexcon_context_new();
  hexcon_mesh *made = NULL;
  assert_int_equal(check(context, &mesh), HEXCON_OK);
  assert_int_equal(hexcon_mesh_surface(context, mesh.points, mesh.point_count, mesh.quads,
                                       mesh.quad_count, NULL, &made),
                   fault);
  assert_null(made);
  assert_elements(context, ids, count);
  hexcon_context_free(context);
  test_mesh_free(&mesh);
}

static void empty(void **state) {
  (void)state;
  test_mesh cube = make_box(1, 1, 1);
  cube.quad_count = 0;
  expect_topological_fault(cube, HEXCON_EMPTY, NULL, 0);
}

static void too_large(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  test_mesh cube = make_box(1, 1, 1);
  hexcon_surface_report report;
  hexcon_loops loops;
  uint8_t colours[8];
  const size_t quads = (size_t)INT32_MAX / 4 + 1, points = (size_t)INT32_MAX + 1;
  assert_int_equal(hexcon_check_surface(context, cube.points, 8, cube.quads, quads, &report),
                   HEXCON_TOO_LARGE);
  assert_elements(context, NULL, 0);
  assert_int_equal(hexcon_check_surface(context, cube.points, points, cube.quads, 6, &report),
                   HEXCON_TOO_LARGE);
  assert_int_equal(hexcon_surface_loops(context, cube.quads, quads, &loops), HEXCON_TOO_LARGE);
  assert_int_equal(hexcon_surface_loops(context, cube.quads, SIZE_MAX, &loops), HEXCON_TOO_LARGE);
  assert_int_equal(hexcon_surface_colouring(context, cube.quads, quads, 8, colours),
                   HEXCON_TOO_LARGE);
  test_mesh_free(&cube);
  hexcon_context_free(context);
}

/** An id at the end of the range is no fault in itself, and 2^31 - 1 must not overflow. */
static void largest_ids(void **state) {
  (void)state;
  test_memory memory = {.most_bytes = (size_t)1 << 28};
  hexcon_context *context = hexcon_context_new_with(test_reallocate, &memory);
  test_mesh cube = make_box(1, 1, 1);
  hexcon_loops loops;
  cube.quads[9] = INT32_MAX;
  assert_int_not_equal(hexcon_surface_loops(context, cube.quads, 6, &loops), HEXCON_OK);
  assert_message(context);
  cube.quads[9] = INT32_MAX - 1;
  assert_int_not_equal(hexcon_surface_loops(context, cube.quads, 6, &loops), HEXCON_OK);
  assert_message(context);
  test_mesh_free(&cube);
  hexcon_context_free(context);
  assert_int_equal(memory.live, 0);
}

static void index_out_of_range(void **state) {
  (void)state;
  test_mesh cube = make_box(1, 1, 1);
  cube.quads[4 * 2 + 1] = 8;
  cube.quads[4 * 4 + 3] = -1;
  cube.quads[4 * 5 + 3] = INT32_MIN;
  expect_fault(cube, HEXCON_INDEX_OUT_OF_RANGE, (int32_t[]){2, 4, 5}, 3);
}

static void repeated_vertex(void **state) {
  (void)state;
  test_mesh cube = make_box(1, 1, 1);
  cube.quads[4 * 3 + 2] = cube.quads[4 * 3];
  cube.quads[4 * 1 + 3] = cube.quads[4 * 1];
  expect_topological_fault(cube, HEXCON_REPEATED_VERTEX, (int32_t[]){1, 3}, 2);
}

static void not_finite(void **state) {
  (void)state;
  test_mesh cube = make_box(1, 1, 1);
  cube.points[3 * 5 + 2] = NAN;
  cube.points[3 * 6] = -INFINITY;
  expect_fault(cube, HEXCON_NOT_FINITE, (int32_t[]){5, 6}, 2);
}

static void unused_point(void **state) {
  (void)state;
  test_mesh box = make_box(2, 2, 2); /* its only inner point belongs to no quad */
  expect_fault(box, HEXCON_UNUSED_POINT, (int32_t[]){26}, 1);
}

/** Quads that have the edge. */
static size_t quads_at(const test_mesh *mesh, int32_t a, int32_t b, int32_t *ids) {
  size_t count = 0;
  for (size_t q = 0; q < mesh->quad_count; q++) {
    test_mesh single = {.quad_count = 1, .quads = mesh->quads + 4 * q};
    if (has_edge(&single, a, b))
      ids[count++] = (int32_t)q;
  }
  return count;
}

static void not_closed(void **state) {
  (void)state;
  test_mesh cube = make_box(1, 1, 1);
  int32_t ids[4], around[2];
  cube.quad_count = 5;
  for (int side = 0; side < 4; side++) {
    assert_int_equal(
        quads_at(&cube, cube.quads[20 + side], cube.quads[20 + (side + 1) % 4], around), 1);
    ids[side] = around[0];
  }
  expect_topological_fault(cube, HEXCON_NOT_CLOSED, ids, 4);
}

/** At most 1000 ids, however many are at fault. */
static void many_elements(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  test_mesh box = make_box(20, 20, 20);
  const int32_t *ids;
  for (size_t v = 0; v < box.point_count; v++)
    box.points[3 * v] = NAN;
  assert_int_equal(check(context, &box), HEXCON_NOT_FINITE);
  assert_int_equal(hexcon_context_elements(context, &ids), 1000);
  test_mesh_free(&box);
  hexcon_context_free(context);
}

static void non_manifold_edge(void **state) {
  (void)state;
  test_mesh pair = make_cells(2, 2, 1, "#..#");
  int32_t ids[8], found[8];
  size_t count = 0;
  for (int32_t a = 0; a < (int32_t)pair.point_count; a++)
    for (int32_t b = 0; b < a; b++)
      if (quads_at(&pair, a, b, found) == 4) {
        memcpy(ids, found, 4 * sizeof *ids);
        count += 4;
      }
  assert_int_equal(count, 4);
  expect_topological_fault(pair, HEXCON_NON_MANIFOLD_EDGE, ids, 4);
}

static void non_manifold_vertex(void **state) {
  (void)state;
  test_mesh pair = make_cells(2, 2, 2, "#......#");
  int32_t shared = -1;
  for (int32_t v = 0; v < (int32_t)pair.point_count; v++)
    if (pair.points[3 * v] == 1 && pair.points[3 * v + 1] == 1 && pair.points[3 * v + 2] == 1)
      shared = v;
  expect_topological_fault(pair, HEXCON_NON_MANIFOLD_VERTEX, &shared, 1);
}

/** Two different quads with a common edge are named. */
static void expect_one_sided(test_mesh mesh) {
  hexcon_context *context = hexcon_context_new();
  const int32_t *ids;
  assert_int_equal(check(context, &mesh), HEXCON_NOT_ORIENTABLE);
  assert_message(context);
  assert_int_equal(hexcon_context_elements(context, &ids), 2);
  assert_int_not_equal(ids[0], ids[1]);
  test_mesh other = {.quad_count = 1, .quads = mesh.quads + 4 * ids[1]};
  const int32_t *first = mesh.quads + 4 * ids[0];
  bool neighbours = false;
  for (int side = 0; side < 4; side++)
    neighbours |= has_edge(&other, first[side], first[(side + 1) % 4]);
  assert_true(neighbours);
  hexcon_context_free(context);
  test_mesh_free(&mesh);
}

static void klein_bottle(void **state) {
  (void)state;
  enum { M = 5, N = 4 };
  double points[M * N][3];
  int32_t quads[M * N][4];
  for (int32_t i = 0; i < M; i++)
    for (int32_t j = 0; j < N; j++) {
      int32_t up = (j + 1) % N, at[4][2] = {{i, j}, {i + 1, j}, {i + 1, up}, {i, up}};
      for (int c = 0; c < 4; c++) /* the last column meets the first one upside down */
        quads[i * N + j][c] = at[c][0] == M ? (N - at[c][1]) % N : at[c][0] * N + at[c][1];
      points[i * N + j][0] = i;
      points[i * N + j][1] = j;
      points[i * N + j][2] = i * j;
    }
  expect_one_sided(
      make_surface((const double(*)[3])points, M * N, (const int32_t(*)[4])quads, M * N));
}

static void projective_plane(void **state) {
  (void)state;
  const double points[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const int32_t quads[3][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 1, 3, 2}}; /* half a cube */
  expect_one_sided(make_surface(points, 4, quads, 3));
}

static void turn_quad(test_mesh *mesh, size_t q) {
  test_mesh one = {.quad_count = 1, .quads = mesh->quads + 4 * q};
  turn_quads(&one);
}

static void inconsistent_orientation(void **state) {
  (void)state;
  test_mesh cube = make_box(1, 1, 1);
  turn_quad(&cube, 3);
  expect_topological_fault(cube, HEXCON_INCONSISTENT_ORIENTATION, (int32_t[]){3}, 1);
  cube = make_box(1, 1, 1);
  for (size_t q = 0; q < 4; q++) /* the majority is turned: the others are at fault */
    turn_quad(&cube, q);
  expect_topological_fault(cube, HEXCON_INCONSISTENT_ORIENTATION, (int32_t[]){4, 5}, 2);
  cube = make_box(1, 1, 1);
  turn_quad(&cube, 0); /* the first quad itself */
  expect_topological_fault(cube, HEXCON_INCONSISTENT_ORIENTATION, (int32_t[]){0}, 1);
}

static void several_components(void **state) {
  (void)state;
  test_mesh pair = make_cells(3, 1, 1, "#.#");
  int32_t second = 0, ids[2] = {0, 0};
  bool left = pair.points[3 * pair.quads[0]] < 1.5;
  while ((pair.points[3 * pair.quads[4 * second]] < 1.5) == left)
    second++;
  ids[1] = second;
  expect_unfillable(pair, HEXCON_SEVERAL_COMPONENTS, ids, 2);
}

static void odd(void **state) {
  (void)state;
  expect_unfillable(make_torus(3, 3), HEXCON_ODD, NULL, 0);
  /* A cube, one side cut in two quads by a point of two edges. */
  test_mesh cube = make_box(1, 1, 1);
  double points[9][3];
  int32_t quads[7][4], *q = quads[5];
  memcpy(points, cube.points, 24 * sizeof(double));
  memcpy(quads, cube.quads, 24 * sizeof(int32_t));
  for (int k = 0; k < 3; k++)
    points[8][k] = (points[q[0]][k] + points[q[2]][k]) / 2;
  int32_t second[4] = {q[0], 8, q[2], q[3]};
  memcpy(quads[6], second, sizeof second);
  q[3] = 8;
  test_mesh_free(&cube);
  expect_unfillable(make_surface((const double(*)[3])points, 9, (const int32_t(*)[4])quads, 7),
                    HEXCON_ODD, NULL, 0);
}

static void not_bipartite(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  test_mesh torus = make_torus(3, 4);
  uint8_t colours[12];
  const int32_t *ids;
  assert_int_equal(hexcon_surface_colouring(context, torus.quads, torus.quad_count, 12, colours),
                   HEXCON_NOT_BIPARTITE);
  assert_message(context);
  size_t count = hexcon_context_elements(context, &ids);
  assert_true(count % 2 == 1 && count >= 3);
  for (size_t i = 0; i < count; i++) {
    assert_true(has_edge(&torus, ids[i], ids[(i + 1) % count]));
    for (size_t j = 0; j < i; j++)
      assert_int_not_equal(ids[i], ids[j]);
  }
  test_mesh_free(&torus);
  hexcon_context_free(context);
}

/** An error leaves no trace in the next call. */
static void error_is_forgotten(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  test_mesh cube = make_box(1, 1, 1);
  const int32_t *ids;
  assert_string_equal(hexcon_context_message(context), "");
  cube.quads[0] = 99;
  assert_int_equal(check(context, &cube), HEXCON_INDEX_OUT_OF_RANGE);
  test_mesh_free(&cube);
  cube = make_box(1, 1, 1);
  assert_int_equal(check(context, &cube), HEXCON_OK);
  assert_string_equal(hexcon_context_message(context), "");
  assert_int_equal(hexcon_context_elements(context, &ids), 0);
  test_mesh_free(&cube);
  hexcon_context_free(context);
}

static void bad_options(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  test_mesh cube = make_box(1, 1, 1);
  hexcon_mesh *made = NULL;
  const hexcon_mesh_options wrong[] = {{.order = 3}, {.order = -1}, {.method = (hexcon_method)17}};
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    assert_int_equal(hexcon_mesh_surface(context, cube.points, 8, cube.quads, 6, &wrong[i], &made),
                     HEXCON_BAD_ARGUMENT);
    assert_elements(context, NULL, 0);
    assert_null(made);
  }
  test_mesh_free(&cube);
  hexcon_context_free(context);
}

static void status_names(void **state) {
  (void)state;
  for (int status = 0; status < HEXCON_STATUS_COUNT; status++) {
    assert_non_null(hexcon_status_name(status));
    for (int other = 0; other < status; other++)
      assert_string_not_equal(hexcon_status_name(status), hexcon_status_name(other));
  }
  assert_string_equal(hexcon_status_name(HEXCON_NOT_CLOSED), "NOT_CLOSED");
  assert_null(hexcon_status_name(-1));
  assert_null(hexcon_status_name(HEXCON_STATUS_COUNT));
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(empty),
      cmocka_unit_test(too_large),
      cmocka_unit_test(largest_ids),
      cmocka_unit_test(index_out_of_range),
      cmocka_unit_test(repeated_vertex),
      cmocka_unit_test(not_finite),
      cmocka_unit_test(unused_point),
      cmocka_unit_test(not_closed),
      cmocka_unit_test(many_elements),
      cmocka_unit_test(non_manifold_edge),
      cmocka_unit_test(non_manifold_vertex),
      cmocka_unit_test(klein_bottle),
      cmocka_unit_test(projective_plane),
      cmocka_unit_test(inconsistent_orientation),
      cmocka_unit_test(several_components),
      cmocka_unit_test(odd),
      cmocka_unit_test(not_bipartite),
      cmocka_unit_test(error_is_forgotten),
      cmocka_unit_test(bad_options),
      cmocka_unit_test(status_names),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
