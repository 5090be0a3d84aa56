/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The paper's methods at hand size: counts, loop families, sides, given pairs, damaged options. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "construct/paired_transition.h"
#include "construct/split_front.h"
#include "pairing/given_pairs.h"
#include "pairing/pairing.h"
#include "support.h"
#include "surface/build.h"
#include "surface/colouring.h"
#include "surface/loop_families.h"

static const hexcon_method methods[] = {HEXCON_METHOD_FOUR_SPLIT, HEXCON_METHOD_PYRAMID,
                                        HEXCON_METHOD_PYRAMID_ALT, HEXCON_METHOD_GEODE,
                                        HEXCON_METHOD_GEODE_ALT};
enum { METHODS = sizeof methods / sizeof *methods };

static hexcon_status mesh_surface(hexcon_context *context, const test_mesh *given,
                                  const hexcon_mesh_options *options, hexcon_mesh **mesh) {
  return hexcon_mesh_surface(context, given->points, given->surface_point_count, given->quads,
                             given->quad_count, options, mesh);
}

/* -------------------------------------------------------------------------------------- counts */

/** Mesh, and check what a certificate of its own says and that the surface's points come first. */
static void assert_mesh(const test_mesh *given, const hexcon_mesh_options *options,
                        size_t hex_count, size_t quad_count) {
  hexcon_context *context = hexcon_context_new();
  hexcon_mesh *mesh;
  assert_int_equal(mesh_surface(context, given, options, &mesh), HEXCON_OK);
  assert_int_equal(hexcon_mesh_hex_count(mesh), hex_count);
  assert_int_equal(hexcon_mesh_quad_count(mesh), quad_count);
  assert_true(hexcon_mesh_is_topological(mesh) && hexcon_mesh_is_checked(mesh));
  assert_memory_equal(hexcon_mesh_points(mesh), given->points,
                      3 * given->surface_point_count * sizeof(double));
  assert_memory_equal(hexcon_mesh_quads(mesh), given->quads,
                      4 * given->quad_count * sizeof(int32_t));
  hexcon_certificate c;
  assert_int_equal(hexcon_certify(context, hexcon_mesh_points(mesh), hexcon_mesh_point_count(mesh),
                                  hexcon_mesh_hexes(mesh), hex_count, hexcon_mesh_quads(mesh),
                                  quad_count, &c),
                   HEXCON_OK);
  assert_true(c.conforming && c.boundary_exact);
  assert_int_equal(c.euler, quad_count > given->quad_count ? 2 : 1);
  assert_int_equal(c.nonpositive_count, hexcon_mesh_certificate(mesh)->nonpositive_count);
  hexcon_certificate_free(context, &c);
  hexcon_mesh_free(context, mesh);
  hexcon_context_free(context);
}

/** The cube of six quads, Schneiders' pyramid, the octahedron of eight: all paired. */
static void counts(void **state) {
  (void)state;
  static const size_t each[METHODS] = {28, 76, 58, 130, 112};
  test_mesh surfaces[] = {make_box(1, 1, 1), make_schneiders_pyramid(), make_trapezohedron(),
                          make_cells(3, 1, 1, "###")};
  for (size_t i = 0; i < sizeof surfaces / sizeof *surfaces; i++)
    for (size_t m = 0; m < METHODS; m++) {
      const hexcon_mesh_options options = {.method = methods[m]};
      size_t n = surfaces[i].quad_count;
      assert_mesh(&surfaces[i], &options, each[m] * n, m == 0 ? 13 * n : n);
    }
  for (size_t i = 0; i < sizeof surfaces / sizeof *surfaces; i++)
    test_mesh_free(&surfaces[i]);
}

/** A cube without pairs: three loops, a family each. The first splits four quads in two, and covers
 * one of the two others once and one twice: 3 * 4 + 3. Then 3 * (2 * 2 + 2) + 3 * 2, where the
 * second loop passes two quads that are split. The third passes the split ones: 3 * 4 * 2, and the
 * two left over are in four: 3 * 4. Alternatively 4 + 1, 6 + 2, 8 + 4. */
static void counts_without_pairs(void **state) {
  (void)state;
  static const size_t layers[2] = {15 + 24 + 36, 5 + 8 + 12};
  static const size_t closures[METHODS] = {0, 16, 16, 34, 34};
  test_mesh cube = make_box(1, 1, 1);
  for (size_t m = 0; m < METHODS; m++) {
    const hexcon_mesh_options options = {.method = methods[m], .pairing = HEXCON_PAIRING_NONE};
    bool alternative =
        methods[m] == HEXCON_METHOD_PYRAMID_ALT || methods[m] == HEXCON_METHOD_GEODE_ALT;
    assert_mesh(&cube, &options, layers[alternative] + 6 * closures[m], m == 0 ? 30 : 6);
  }
  test_mesh_free(&cube);
}

/** Four quads about two poles. */
static test_mesh make_bipyramid(void) {
  static const double points[6][3] = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0},
                                      {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  static const int32_t quads[4][4] = {{0, 2, 1, 3}, {0, 3, 1, 4}, {0, 4, 1, 5}, {0, 5, 1, 2}};
  return make_surface(points, 6, quads, 4);
}

/** All neighbours share two edges, so each pair leaves four quads. */
static void counts_of_doublets(void **state) {
  (void)state;
  static const size_t on_paired[METHODS] = {9, 25, 19, 43, 37};
  test_mesh given = make_bipyramid();
  for (size_t m = 0; m < METHODS; m++) {
    const hexcon_mesh_options options = {.method = methods[m]};
    assert_mesh(&given, &options, 4 + 8 * on_paired[m], m == 0 ? 4 + 32 : 4);
  }
  test_mesh_free(&given);
}

/** Every point of such a mesh is in a hex, though the middle of a pair is not in the front. */
static void no_point_is_left_over(void **state) {
  (void)state;
  test_mesh given = make_bipyramid();
  hexcon_context *context = hexcon_context_new();
  for (size_t m = 0; m < METHODS; m++) {
    const hexcon_mesh_options options = {.method = methods[m]};
    hexcon_mesh *mesh;
    assert_int_equal(mesh_surface(context, &given, &options, &mesh), HEXCON_OK);
    size_t count = hexcon_mesh_point_count(mesh), left = count;
    uint8_t *used = calloc(count, 1);
    assert_non_null(used);
    for (size_t i = 0; i < 8 * hexcon_mesh_hex_count(mesh); i++) {
      left -= used[hexcon_mesh_hexes(mesh)[i]] == 0;
      used[hexcon_mesh_hexes(mesh)[i]] = 1;
    }
    assert_int_equal(left, 0);
    free(used);
    hexcon_mesh_free(context, mesh);
  }
  hexcon_context_free(context);
  test_mesh_free(&given);
}

/* ------------------------------------------------------------------------------------ its parts */

static surface build(hexcon_context *context, const test_mesh *mesh) {
  surface s;
  assert_int_equal(surface_build(context, mesh->points, mesh->surface_point_count, mesh->quads,
                                 mesh->quad_count, &s),
                   HEXCON_OK);
  return s;
}

/** Families of a surface's loops; checks that loops of one family do not cross. Returns how many.
 */
static size_t find_families(hexcon_context *context, const surface *s, surface_loops *loops,
                            int32_t families[64]) {
  size_t count;
  assert_int_equal(surface_find_loops(context, s, loops), HEXCON_OK);
  assert_true(loops->count <= 64);
  assert_int_equal(surface_loop_families(context, s, loops, families, &count), HEXCON_OK);
  for (size_t q = 0; q < s->quad_count; q++)
    assert_int_not_equal(families[loops->loop_of_passage[2 * q]],
                         families[loops->loop_of_passage[2 * q + 1]]);
  for (size_t loop = 0; loop < loops->count; loop++)
    assert_true(families[loop] >= 0 && (size_t)families[loop] < count);
  return count;
}

static void loop_families(void **state) {
  (void)state;
  test_mesh meshes[] = {make_box(1, 1, 1), make_box(2, 3, 4), make_torus(4, 6), make_torus(3, 4),
                        make_pentagonal_prism(2)};
  static const size_t expected[] = {3, 3, 2, 2, 4}, loop_counts[] = {3, 9, 10, 7, 7};
  hexcon_context *context = hexcon_context_new();
  for (size_t i = 0; i < sizeof meshes / sizeof *meshes; i++) {
    surface s = build(context, &meshes[i]);
    surface_loops loops;
    int32_t families[64];
    assert_int_equal(find_families(context, &s, &loops, families), expected[i]);
    assert_int_equal(loops.count, loop_counts[i]);
    surface_loops_free(context, &loops);
    surface_free(context, &s);
    test_mesh_free(&meshes[i]);
  }
  hexcon_context_free(context);
}

/** The one loop of the octahedron of eight passes every quad twice. */
static void loops_that_cross_themselves(void **state) {
  (void)state;
  static const int32_t all[] = {0, 1, 2, 3, 4, 5, 6, 7};
  test_mesh given = make_trapezohedron();
  const hexcon_mesh_options options = {.method = HEXCON_METHOD_PYRAMID,
                                       .pairing = HEXCON_PAIRING_NONE};
  hexcon_context *context = hexcon_context_new();
  hexcon_mesh *mesh;
  hexcon_loops loops;
  assert_int_equal(hexcon_surface_loops(context, given.quads, 8, &loops), HEXCON_OK);
  assert_int_equal(loops.count, 1);
  hexcon_loops_free(context, &loops);
  assert_int_equal(mesh_surface(context, &given, &options, &mesh), HEXCON_SELF_CROSSING);
  assert_null(mesh);
  assert_elements(context, all, 8);
  hexcon_context_free(context);
  test_mesh_free(&given);
}

/** A pair leaves the quads of no pair last; those that cross themselves are told as given. */
static void crossings_beside_pairs(void **state) {
  (void)state;
  test_mesh given = make_trapezohedron();
  static const int32_t pair[2] = {2, 4};
  const hexcon_mesh_options options = {.method = HEXCON_METHOD_PYRAMID,
                                       .pairing = HEXCON_PAIRING_GIVEN,
                                       .pairs = pair,
                                       .pair_count = 1};
  hexcon_context *context = hexcon_context_new();
  hexcon_mesh *mesh;
  const int32_t *wrong;
  assert_int_equal(mesh_surface(context, &given, &options, &mesh), HEXCON_SELF_CROSSING);
  size_t count = hexcon_context_elements(context, &wrong);
  assert_true(count > 0 && count <= 6);
  for (size_t i = 0; i < count; i++)
    assert_true(wrong[i] >= 0 && wrong[i] < 8 && wrong[i] != 2 && wrong[i] != 4 &&
                (i == 0 || wrong[i - 1] < wrong[i]));
  hexcon_context_free(context);
  test_mesh_free(&given);
}

/** Half-edges that the loops of a family cross. */
static void mark_family(const surface *s, const surface_loops *loops, const int32_t *families,
                        int32_t family, uint8_t *crossed) {
  for (int32_t h = 0; h < (int32_t)(4 * s->quad_count); h++)
    crossed[h] = families[loops->loop_of_passage[surface_passage(h)]] == family;
}

/** On a torus of 4 * 6 both families part the points in two; on one of 3 * 4 one does not, and the
 * proof is a closed path of three points. */
static void sides_on_tori(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  for (int m = 3; m <= 4; m++) {
    test_mesh torus = make_torus(m, m == 3 ? 4 : 6);
    surface s = build(context, &torus);
    surface_loops loops;
    int32_t families[64];
    uint8_t crossed[96], sides[24];
    size_t without = 0;
    assert_int_equal(find_families(context, &s, &loops, families), 2);
    for (int32_t family = 0; family < 2; family++) {
      mark_family(&s, &loops, families, family, crossed);
      hexcon_status status = surface_sides(context, &s, crossed, sides);
      without += status == HEXCON_NO_SIDES;
      if (status) {
        const int32_t *path;
        assert_int_equal(hexcon_context_elements(context, &path), 3);
        for (int i = 0; i < 3; i++)
          assert_true(has_edge(&torus, path[i], path[(i + 1) % 3]));
        context_clear(context);
        continue;
      }
      for (int32_t h = 0; h < (int32_t)(4 * s.quad_count); h++)
        assert_int_equal(sides[half_edge_start(&s, h)] != sides[half_edge_end(&s, h)], crossed[h]);
    }
    assert_int_equal(without, m == 3);
    surface_loops_free(context, &loops);
    surface_free(context, &s);
    test_mesh_free(&torus);
  }
  hexcon_context_free(context);
}

/** Ids of the path are the caller's, though the surface under pairs has more points. */
static void no_sides_under_pairs(void **state) {
  (void)state;
  test_mesh torus = make_torus(3, 4);
  hexcon_context *context = hexcon_context_new();
  for (int pairing = 0; pairing < 2; pairing++) {
    const hexcon_mesh_options options = {.method = HEXCON_METHOD_FOUR_SPLIT,
                                         .pairing = (hexcon_pairing)pairing};
    hexcon_mesh *mesh;
    const int32_t *path;
    assert_int_equal(mesh_surface(context, &torus, &options, &mesh), HEXCON_NO_SIDES);
    assert_message(context);
    size_t count = hexcon_context_elements(context, &path);
    assert_int_equal(count % 2, 1);
    for (size_t i = 0; i < count; i++)
      assert_true(has_edge(&torus, path[i], path[(i + 1) % count]));
  }
  hexcon_context_free(context);
  test_mesh_free(&torus);
}

/** Two hexes, four points, six quads in place of two; and the ends over which its points lie. */
static void paired_transition(void **state) {
  (void)state;
  test_mesh cube = make_box(1, 1, 1);
  hexcon_context *context = hexcon_context_new();
  surface s = build(context, &cube), under;
  int32_t partner[6];
  const int32_t neighbour = half_edge_quad(s.twins[0]), pairs[2] = {0, neighbour};
  assert_int_equal(surface_read_pairs(context, &s, pairs, 1, partner), HEXCON_OK);
  growing_mesh mesh = {.point_count = 8};
  paired_quads paired;
  assert_int_equal(paired_transition_build(context, &s, partner, &mesh, &paired), HEXCON_OK);
  assert_int_equal(mesh.hex_count, 2);
  assert_int_equal(mesh.point_count, 12);
  assert_int_equal(paired.quad_count, 10);
  assert_int_equal(paired.points.first, 8);
  for (int32_t point = 0; point < 12; point++) {
    int32_t end = paired_transition_end(8, 1, mesh.hexes, point);
    assert_true(point < 8 ? end == point
                          : end == half_edge_start(&s, partner[0]) ||
                                end == half_edge_end(&s, partner[0]));
  }
  assert_int_equal(surface_build(context, NULL, 12, paired.quads, 10, &under), HEXCON_OK);
  surface_free(context, &under);
  paired_quads_free(context, &paired);
  context_free(context, mesh.hexes);
  surface_free(context, &s);
  hexcon_context_free(context);
  test_mesh_free(&cube);
}

/** A cube, two quads of which are cut in two by points of two neighbours: the halves share two
 * edges, and are not paired with each other, as there is another way. */
static void pairs_across_single_edges(void **state) {
  (void)state;
  test_mesh cube = make_box(1, 1, 1);
  double points[10][3];
  int32_t quads[8][4];
  memcpy(points, cube.points, 24 * sizeof(double));
  memcpy(quads, cube.quads, 24 * sizeof(int32_t));
  for (int extra = 0; extra < 2; extra++) { /* a point in the first quad, then in the second */
    int32_t *q = quads[extra];
    int32_t middle = 8 + extra;
    for (int k = 0; k < 3; k++)
      points[middle][k] = (points[q[0]][k] + points[q[2]][k]) / 2;
    const int32_t rest[4] = {middle, q[2], q[3], q[0]};
    memcpy(quads[6 + extra], rest, sizeof rest);
    q[3] = middle;
  }
  test_mesh given = make_surface((const double(*)[3])points, 10, (const int32_t(*)[4])quads, 8);
  hexcon_context *context = hexcon_context_new();
  surface s = build(context, &given);
  int32_t partner[8];
  assert_int_equal(surface_pair_across_single_edges(context, &s, partner), HEXCON_OK);
  for (int32_t q = 0; q < 8; q++) {
    int32_t other = half_edge_quad(s.twins[partner[q]]);
    assert_int_equal(half_edge_quad(s.twins[partner[other]]), q);
    assert_false((q % 6 == other % 6) && q != other); /* the halves of a quad share two */
  }
  surface_free(context, &s);
  hexcon_context_free(context);
  test_mesh_free(&given);
  test_mesh_free(&cube);
}

/* --------------------------------------------------------------------------------------- options
 */

static hexcon_status try_options(const test_mesh *given, hexcon_mesh_options options,
                                 const int32_t *elements, size_t count) {
  hexcon_context *context = hexcon_context_new();
  hexcon_mesh *mesh = (hexcon_mesh *)context;
  hexcon_status status = mesh_surface(context, given, &options, &mesh);
  if (status) {
    assert_null(mesh);
    assert_message(context);
    if (elements)
      assert_elements(context, elements, count);
  }
  hexcon_mesh_free(context, mesh);
  hexcon_context_free(context);
  return status;
}

static void given_pairs(void **state) {
  (void)state;
  test_mesh cube = make_box(1, 1, 1);
  hexcon_context *context = hexcon_context_new();
  int32_t perfect[6], missing[2] = {0, -1};
  assert_int_equal(hexcon_surface_pairing(context, NULL, 8, cube.quads, 6, perfect), HEXCON_OK);
  surface s = build(context, &cube);
  for (int32_t q = 1; q < 6; q++) { /* the quad opposite the first one */
    bool shares = false;
    for (int32_t h = 0; h < 4; h++)
      shares |= half_edge_quad(s.twins[h]) == q;
    if (!shares)
      missing[1] = q;
  }
  surface_free(context, &s);
  hexcon_context_free(context);
  hexcon_mesh_options options = {.method = HEXCON_METHOD_PYRAMID,
                                 .pairing = HEXCON_PAIRING_GIVEN,
                                 .pairs = perfect,
                                 .pair_count = 3};
  assert_mesh(&cube, &options, 76 * 6, 6);
  options.pairs = missing;
  options.pair_count = 1;
  assert_int_equal(try_options(&cube, options, missing, 2), HEXCON_BAD_PAIRING);
  static const int32_t far[][2] = {{0, 6}, {0, INT32_MAX}, {-1, 0}, {INT32_MIN, 0}, {1, 1}};
  for (size_t i = 0; i < sizeof far / sizeof *far; i++) {
    options.pairs = far[i];
    assert_int_equal(try_options(&cube, options, far[i], 2), HEXCON_BAD_PAIRING);
  }
  int32_t twice[8] = {0};
  memcpy(twice, perfect, sizeof perfect);
  memcpy(twice + 6, perfect + 2, 2 * sizeof *twice);
  options.pairs = twice;
  options.pair_count = 4;
  assert_int_equal(try_options(&cube, options, perfect + 2, 2), HEXCON_BAD_PAIRING);
  test_mesh_free(&cube);
}

static void damaged_options(void **state) {
  (void)state;
  test_mesh cube = make_box(1, 1, 1), torus = make_torus(4, 4);
  const hexcon_mesh_options bad[] = {
      {.method = HEXCON_METHOD_COUNT},
      {.method = (hexcon_method)-1},
      {.method = HEXCON_METHOD_PYRAMID, .pairing = HEXCON_PAIRING_COUNT},
      {.method = HEXCON_METHOD_PYRAMID, .pairing = (hexcon_pairing)-1},
      {.method = HEXCON_METHOD_PYRAMID, .pairing = HEXCON_PAIRING_GIVEN, .pair_count = 1},
      {.method = HEXCON_METHOD_CELLS, .pairing = HEXCON_PAIRING_NONE},
      {.method = HEXCON_METHOD_AUTO, .pairing = HEXCON_PAIRING_GIVEN},
      {.method = HEXCON_METHOD_GEODE, .layers = 1},
      {.method = HEXCON_METHOD_GEODE, .order = 3},
      {.method = HEXCON_METHOD_GEODE, .threads = -1}};
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
    assert_int_equal(try_options(&cube, bad[i], NULL, 0), HEXCON_BAD_ARGUMENT);
  for (size_t m = 1; m < METHODS; m++)
    assert_int_equal(try_options(&torus, (hexcon_mesh_options){.method = methods[m]}, NULL, 0),
                     HEXCON_NOT_A_BALL);
  assert_int_equal(
      try_options(&torus, (hexcon_mesh_options){.method = HEXCON_METHOD_FOUR_SPLIT}, NULL, 0),
      HEXCON_OK);
  test_mesh_free(&cube);
  test_mesh_free(&torus);
}

/** Two quads have the same corners: in a mesh, both would be one face; and they are one patch. */
static void two_quads(void **state) {
  (void)state;
  static const double points[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}};
  static const int32_t quads[2][4] = {{0, 1, 2, 3}, {3, 2, 1, 0}}, both[2] = {0, 1};
  test_mesh pillow = make_surface(points, 4, quads, 2);
  for (size_t m = 0; m < METHODS; m++) {
    hexcon_mesh_options options = {.method = methods[m], .allow_topological = true};
    assert_int_equal(try_options(&pillow, options, both, 2), HEXCON_UNFILLABLE_QUAD);
    options.allow_topological = false;
    assert_int_equal(try_options(&pillow, options, both, 2), HEXCON_SELF_INTERSECTING);
  }
  test_mesh_free(&pillow);
}

/** Without a certificate there is nothing to read, and nothing to free twice. */
static void skipped_certificate(void **state) {
  (void)state;
  test_mesh cube = make_box(1, 1, 1);
  hexcon_context *context = hexcon_context_new();
  const hexcon_mesh_options options = {.method = HEXCON_METHOD_GEODE_ALT, .skip_certificate = true};
  hexcon_mesh *mesh;
  assert_int_equal(mesh_surface(context, &cube, &options, &mesh), HEXCON_OK);
  assert_false(hexcon_mesh_is_checked(mesh));
  assert_null(hexcon_mesh_quality(mesh));
  assert_false(hexcon_mesh_certificate(mesh)->certified);
  assert_int_equal(hexcon_mesh_certificate(mesh)->nonpositive_count, 0);
  assert_string_equal(hexcon_mesh_method(mesh), "geode-alt");
  hexcon_mesh_free(context, mesh);
  hexcon_context_free(context);
  test_mesh_free(&cube);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(counts),
      cmocka_unit_test(counts_without_pairs),
      cmocka_unit_test(counts_of_doublets),
      cmocka_unit_test(no_point_is_left_over),
      cmocka_unit_test(loop_families),
      cmocka_unit_test(loops_that_cross_themselves),
      cmocka_unit_test(crossings_beside_pairs),
      cmocka_unit_test(sides_on_tori),
      cmocka_unit_test(no_sides_under_pairs),
      cmocka_unit_test(paired_transition),
      cmocka_unit_test(pairs_across_single_edges),
      cmocka_unit_test(given_pairs),
      cmocka_unit_test(damaged_options),
      cmocka_unit_test(two_quads),
      cmocka_unit_test(skipped_certificate),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
