/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Surfaces that are sweeps, whatever their numbering, and surfaces that are not. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "support.h"

static void mix_ids(uint64_t *random, int32_t *ids, size_t count) {
  for (size_t i = 0; i < count; i++)
    ids[i] = (int32_t)i;
  for (size_t i = count; i > 1; i--) {
    size_t j = random_below(random, i);
    int32_t id = ids[i - 1];
    ids[i - 1] = ids[j];
    ids[j] = id;
  }
}

/** The same surface under other numbers; each quad starts at another corner. */
static test_mesh renumbered(const test_mesh *mesh, uint64_t *random) {
  test_mesh other = test_mesh_copy(mesh);
  int32_t *points = malloc(mesh->surface_point_count * sizeof *points);
  int32_t *quads = malloc(mesh->quad_count * sizeof *quads);
  assert_true(points && quads);
  mix_ids(random, points, mesh->surface_point_count);
  mix_ids(random, quads, mesh->quad_count);
  for (size_t v = 0; v < mesh->surface_point_count; v++)
    memcpy(other.points + 3 * points[v], mesh->points + 3 * v, 3 * sizeof(double));
  for (size_t q = 0; q < mesh->quad_count; q++) {
    size_t turn = random_below(random, 4);
    for (size_t c = 0; c < 4; c++)
      other.quads[4 * quads[q] + (int32_t)c] = points[mesh->quads[4 * q + (c + turn) % 4]];
  }
  free(points);
  free(quads);
  return other;
}

static const hexcon_mesh_options by_sweep = {.method = HEXCON_METHOD_SWEPT};

/** Mesh it, as it is and renumbered; `hex_count` hexes each time. Frees the mesh. */
static void expect_swept(test_mesh mesh, size_t hex_count) {
  test_memory memory = {0};
  hexcon_context *context = hexcon_context_new_with(test_reallocate, &memory);
  uint64_t random = 42;
  for (int round = 0; round < 4; round++) {
    test_mesh other = round ? renumbered(&mesh, &random) : test_mesh_copy(&mesh);
    hexcon_mesh *made = NULL;
    hexcon_status status = hexcon_mesh_surface(context, other.points, other.surface_point_count,
                                               other.quads, other.quad_count, &by_sweep, &made);
    if (status)
      print_message("%s\n", hexcon_context_message(context));
    assert_int_equal(status, HEXCON_OK);
    assert_certified_mesh(context, &other, made);
    assert_int_equal(hexcon_mesh_hex_count(made), hex_count);
    assert_int_equal(hexcon_mesh_order(made), 1);
    assert_string_equal(hexcon_mesh_method(made), "swept");
    assert_close(figure_of(made, "cap quads") * figure_of(made, "rings"), (double)hex_count, 0);
    for (size_t h = 0; h < hex_count; h++)
      assert_true(hexcon_mesh_quality(made)[h] > 0);
    hexcon_mesh_free(context, made);
    test_mesh_free(&other);
  }
  hexcon_context_free(context);
  assert_int_equal(memory.live, 0);
  test_mesh_free(&mesh);
}

static void boxes(void **state) {
  (void)state;
  static const int sizes[][3] = {{1, 1, 1}, {2, 1, 1}, {1, 1, 7}, {2, 2, 2}, {3, 3, 3},
                                 {2, 3, 4}, {5, 1, 3}, {6, 6, 1}, {9, 4, 2}, {4, 4, 12}};
  for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
    const int *n = sizes[i];
    expect_swept(make_box(n[0], n[1], n[2]), (size_t)(n[0] * n[1] * n[2]));
  }
}

static void prisms(void **state) {
  (void)state;
  expect_swept(make_pentagonal_prism(1), 5);
  expect_swept(make_pentagonal_prism(6), 30);
  expect_swept(make_cells(2, 2, 3, "###.###.###."), 9);
  expect_swept(make_cells(3, 2, 2, "####.#####.#"), 10);
}

static void tubes(void **state) {
  (void)state;
  expect_swept(make_tube(8, 4), 32);
  expect_swept(make_tube(5, 3), 15); /* not bipartite, and swept all the same */
  expect_swept(make_tube(3, 1), 3);
  expect_swept(make_cells(3, 3, 2, "####.########.####"), 16);
  expect_swept(make_cells(5, 3, 2, "######.#.############.#.######"), 26);
}

/** Levels that are sheared, scaled and turned: affine images of the cap. */
static void affine_levels(void **state) {
  (void)state;
  test_mesh mesh = make_pentagonal_prism(5);
  for (size_t v = 0; v < mesh.surface_point_count; v++) {
    double *p = mesh.points + 3 * v, z = p[2], angle = 0.15 * z, scale = 1 - 0.1 * z;
    double x = scale * (cos(angle) * p[0] - sin(angle) * p[1]) + 0.4 * z;
    p[1] = scale * (sin(angle) * p[0] + cos(angle) * p[1]) - 0.2 * z;
    p[0] = x;
    p[2] = 0.5 * z * z;
  }
  expect_swept(mesh, 25);
}

/** No mesh, and words that say why. Frees the mesh. */
static hexcon_status refusal(test_mesh mesh) {
  hexcon_context *context = hexcon_context_new();
  hexcon_mesh *made = NULL;
  const int32_t *ids;
  hexcon_mesh_options options = {.method = HEXCON_METHOD_SWEPT, .pillow = HEXCON_PILLOW_NEVER};
  hexcon_status status = hexcon_mesh_surface(context, mesh.points, mesh.surface_point_count,
                                             mesh.quads, mesh.quad_count, &options, &made);
  assert_null(made);
  assert_message(context);
  size_t count = hexcon_context_elements(context, &ids);
  for (size_t i = 0; i < count; i++)
    assert_true(ids[i] >= 0);
  for (size_t i = 0; status == HEXCON_NOT_SWEPT && i < count; i++)
    assert_true((size_t)ids[i] < mesh.quad_count);
  hexcon_context_free(context);
  test_mesh_free(&mesh);
  return status;
}

static void no_sweeps(void **state) {
  (void)state;
  assert_int_equal(refusal(make_schneiders_pyramid()), HEXCON_NOT_SWEPT);
  assert_int_equal(refusal(make_trapezohedron()), HEXCON_NOT_SWEPT);
  /* a tower on a slab; a corner cut out; two loops more on one side than on the other */
  assert_int_equal(refusal(make_cells(2, 2, 2, "#####...")), HEXCON_NOT_SWEPT);
  assert_int_equal(refusal(make_cells(2, 2, 2, "#######.")), HEXCON_NOT_SWEPT);
  assert_int_equal(refusal(make_cells(4, 4, 3, "################################.....#..........")),
                   HEXCON_NOT_SWEPT);
}

/** A knob on a slab sweeps by its quads alone, but not in this shape. */
static void wrong_shape_for_a_sweep(void **state) {
  (void)state;
  assert_int_equal(refusal(make_cells(3, 3, 2, "#########....#....")), HEXCON_NOT_CERTIFIED);
}

static void second_order(void **state) {
  (void)state;
  static const int edges[12][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                                   {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
  hexcon_context *context = hexcon_context_new();
  test_mesh box = make_box(3, 2, 4);
  hexcon_mesh *made = NULL;
  const hexcon_mesh_options options = {.order = 2};
  assert_int_equal(hexcon_mesh_surface(context, box.points, box.surface_point_count, box.quads,
                                       box.quad_count, &options, &made),
                   HEXCON_OK);
  assert_int_equal(hexcon_mesh_order(made), 2);
  const size_t hexes = hexcon_mesh_hex_count(made), points = hexcon_mesh_point_count(made);
  assert_int_equal(hexes, 24);
  assert_int_equal(points, 4 * 3 * 5 + 3 * 3 * 5 + 4 * 2 * 5 + 4 * 3 * 4);
  assert_memory_equal(hexcon_mesh_points(made), box.points,
                      3 * box.surface_point_count * sizeof(double));
  for (size_t h = 0; h < hexes; h++)
    for (int e = 0; e < 12; e++) {
      const int32_t *hex = hexcon_mesh_hexes(made) + 20 * h;
      for (int k = 0; k < 3; k++) {
        double a = hexcon_mesh_points(made)[3 * hex[edges[e][0]] + k];
        double b = hexcon_mesh_points(made)[3 * hex[edges[e][1]] + k];
        assert_close(hexcon_mesh_points(made)[3 * hex[8 + e] + k], (a + b) / 2, 1e-15);
      }
    }
  hexcon_mesh_free(context, made);
  test_mesh_free(&box);
  hexcon_context_free(context);
}

/** A surface that no sweep can fill without inversion: refused, or handed over as it is. */
static void uncertified(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  test_mesh box = make_box(2, 2, 2);
  for (size_t v = 0; v < box.surface_point_count; v++) /* one corner pushed far through the box */
    if (box.points[3 * v] == 0 && box.points[3 * v + 1] == 0 && box.points[3 * v + 2] == 0)
      box.points[3 * v] = box.points[3 * v + 1] = box.points[3 * v + 2] = 1.9;
  hexcon_mesh *made = NULL;
  hexcon_mesh_options options = {.method = HEXCON_METHOD_SWEPT};
  const int32_t *ids;
  assert_int_equal(hexcon_mesh_surface(context, box.points, box.surface_point_count, box.quads,
                                       box.quad_count, &options, &made),
                   HEXCON_NOT_CERTIFIED);
  assert_null(made);
  assert_message(context);
  assert_true(hexcon_context_elements(context, &ids) > 0);
  options.allow_uncertified = true;
  assert_int_equal(hexcon_mesh_surface(context, box.points, box.surface_point_count, box.quads,
                                       box.quad_count, &options, &made),
                   HEXCON_OK);
  const hexcon_certificate *c = hexcon_mesh_certificate(made);
  assert_false(c->certified);
  assert_true(c->conforming && c->proper && c->boundary_exact && c->nonpositive_count > 0);
  hexcon_mesh_free(context, made);
  test_mesh_free(&box);
  hexcon_context_free(context);
}

/** Any unit of length: the same mesh. */
static void any_scale(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  for (int exponent = -900; exponent <= 900; exponent += 100) {
    test_mesh box = make_box(3, 3, 3);
    hexcon_mesh *made = NULL;
    for (size_t i = 0; i < 3 * box.point_count; i++)
      box.points[i] = ldexp(box.points[i], exponent);
    hexcon_status status = hexcon_mesh_surface(context, box.points, box.surface_point_count,
                                               box.quads, box.quad_count, &by_sweep, &made);
    if (status)
      print_message("unit 2^%d: %s\n", exponent, hexcon_context_message(context));
    else
      assert_certified_mesh(context, &box, made);
    if (abs(exponent) <= 300)
      assert_int_equal(status, HEXCON_OK);
    hexcon_mesh_free(context, made);
    test_mesh_free(&box);
  }
  hexcon_context_free(context);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(boxes),        cmocka_unit_test(prisms),
      cmocka_unit_test(tubes),        cmocka_unit_test(affine_levels),
      cmocka_unit_test(no_sweeps),    cmocka_unit_test(wrong_shape_for_a_sweep),
      cmocka_unit_test(second_order), cmocka_unit_test(uncertified),
      cmocka_unit_test(any_scale),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
