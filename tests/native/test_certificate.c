/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The certificate: what it accepts, and each thing it refuses. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "support.h"
#include "verify/jacobian_sign.h"

static hexcon_certificate certify(hexcon_context *context, const test_mesh *mesh) {
  hexcon_certificate c;
  assert_int_equal(hexcon_certify(context, mesh->points, mesh->point_count, mesh->hexes,
                                  mesh->hex_count, mesh->quads, mesh->quad_count, &c),
                   HEXCON_OK);
  assert_int_equal(c.certified,
                   c.conforming && c.proper && c.boundary_exact && c.nonpositive_count == 0);
  assert_int_equal(c.proper, c.improper_count == 0);
  size_t undecided = 0;
  for (size_t i = 0; i < c.nonpositive_count; i++) {
    double witness[3];
    jacobian_sign sign =
        prove_jacobian_sign_at(mesh->points, mesh->hexes + 8 * (size_t)c.nonpositive[i], witness);
    assert_int_not_equal(sign, JACOBIAN_POSITIVE);
    assert_memory_equal(c.witnesses + 3 * i, witness, sizeof witness);
    undecided += sign == JACOBIAN_UNDECIDED;
  }
  assert_int_equal(c.undecided_count, undecided);
  return c;
}

/** What a certificate must say, its Euler characteristic, and how many lists have an entry. */
typedef struct verdict {
  bool conforming, proper, boundary_exact;
  int64_t euler;
  size_t nonpositive, doublets;
} verdict;

static void expect(test_mesh mesh, verdict wanted) {
  test_memory memory = {0};
  hexcon_context *context = hexcon_context_new_with(test_reallocate, &memory);
  hexcon_certificate c = certify(context, &mesh);
  assert_int_equal(c.conforming, wanted.conforming);
  assert_int_equal(c.proper, wanted.proper);
  assert_int_equal(c.boundary_exact, wanted.boundary_exact);
  assert_int_equal(c.euler, wanted.euler);
  assert_int_equal(c.nonpositive_count, wanted.nonpositive);
  assert_int_equal(c.doublet_count, wanted.doublets);
  hexcon_certificate_free(context, &c);
  hexcon_context_free(context);
  assert_int_equal(memory.live, 0);
  test_mesh_free(&mesh);
}

static const verdict fine = {true, true, true, 1, 0, 0};

static void good_meshes(void **state) {
  (void)state;
  expect(make_box(1, 1, 1), fine);
  expect(make_box(2, 1, 1), fine);
  expect(make_box(4, 3, 5), fine);
  expect(make_pentagonal_prism(3), fine);
  expect(make_cells(3, 3, 2, "####..##.##......."), fine);
}

static void other_topologies(void **state) {
  (void)state;
  expect(make_tube(5, 2), (verdict){true, true, true, 0, 0, 0});
  expect(make_cells(5, 3, 1, "######.#.######"), (verdict){true, true, true, -1, 0, 0});
  /* a hollow box, and two boxes that do not touch */
  expect(make_cells(3, 3, 3, "#############.#############"), (verdict){true, true, true, 2, 0, 0});
  expect(make_cells(3, 1, 1, "#.#"), (verdict){true, true, true, 2, 0, 0});
}

static void pinched(void **state) {
  (void)state;
  expect(make_cells(2, 2, 1, "#..#"), (verdict){false, true, true, 1, 0, 0});     /* an edge */
  expect(make_cells(2, 2, 2, "#......#"), (verdict){false, true, true, 1, 0, 0}); /* a point */
  /* an edge whose hexes meet around each of its ends */
  expect(make_cells(2, 2, 3, "##.##..###.#"), (verdict){false, true, true, 1, 0, 0});
  /* a ring whose ends meet in an edge only, and one of them in a point */
  expect(make_cells(3, 3, 1, "####..##."), (verdict){true, true, true, 1, 0, 0});
  expect(make_cells(3, 3, 1, "###.##.#."), (verdict){true, true, true, 1, 0, 0});
  expect(make_cells(3, 3, 1, "####.#.#."), (verdict){false, true, true, 0, 0, 0});
}

/** The boundary is that of the hexes, whatever the quads say. */
static void wrong_boundary(void **state) {
  (void)state;
  const verdict wrong = {true, true, false, 1, 0, 0};
  test_mesh mesh = make_box(2, 2, 2);
  mesh.quad_count--; /* one missing */
  expect(mesh, wrong);
  mesh = make_box(2, 2, 2);
  mesh.quad_count = 0; /* all missing */
  expect(mesh, wrong);
  mesh = make_box(2, 2, 2);
  memcpy(mesh.quads + 8, mesh.quads, 4 * sizeof(int32_t)); /* one twice */
  expect(mesh, wrong);
  mesh = make_box(2, 2, 2);
  turn_quads(&mesh); /* inward */
  expect(mesh, wrong);
  mesh = make_box(2, 2, 2);
  int32_t corner = mesh.quads[0]; /* the same corners in another order */
  mesh.quads[0] = mesh.quads[1];
  mesh.quads[1] = corner;
  expect(mesh, wrong);
  mesh = make_box(2, 2, 2);
  test_mesh turned = {.quad_count = 1, .quads = mesh.quads + 12}; /* one inward */
  turn_quads(&turned);
  expect(mesh, wrong);
}

/** Quads may start at any corner and come in any order. */
static void any_order_of_quads(void **state) {
  (void)state;
  uint64_t random = 3;
  test_mesh mesh = make_box(3, 2, 2);
  for (size_t q = 0; q < mesh.quad_count; q++) {
    int32_t here[4], there[4], *a = mesh.quads + 4 * q;
    int32_t *b = mesh.quads + 4 * random_below(&random, mesh.quad_count);
    memcpy(here, a, sizeof here);
    memcpy(there, b, sizeof there);
    for (size_t i = 0, turn = random_below(&random, 4); i < 4; i++) {
      b[i] = here[(i + turn) % 4];
      a[i] = a == b ? b[i] : there[i];
    }
  }
  expect(mesh, fine);
}

/** One more hex on given points; the boundary stays as it was. */
static void add_hex(test_mesh *mesh, const int32_t hex[8]) {
  int32_t *hexes = realloc(mesh->hexes, 8 * (mesh->hex_count + 1) * sizeof *hexes);
  assert_non_null(hexes);
  mesh->hexes = hexes;
  memcpy(hexes + 8 * mesh->hex_count++, hex, 8 * sizeof *hexes);
}

static int32_t point_at(const test_mesh *mesh, double x, double y, double z) {
  for (size_t v = 0; v < mesh->point_count; v++)
    if (mesh->points[3 * v] == x && mesh->points[3 * v + 1] == y && mesh->points[3 * v + 2] == z)
      return (int32_t)v;
  return -1;
}

static void duplicated_hex(void **state) {
  (void)state;
  test_mesh mesh = make_box(2, 1, 1);
  int32_t hex[8];
  memcpy(hex, mesh.hexes, sizeof hex);
  add_hex(&mesh, hex);
  hexcon_context *context = hexcon_context_new();
  hexcon_certificate c = certify(context, &mesh);
  assert_false(c.certified || c.conforming || c.proper || c.boundary_exact);
  hexcon_certificate_free(context, &c);
  hexcon_context_free(context);
  test_mesh_free(&mesh);
}

/** A third hex at the face between two. */
static void face_in_three_hexes(void **state) {
  (void)state;
  test_mesh mesh = make_cells(2, 2, 1, "####");
  int32_t lower[4] = {point_at(&mesh, 1, 0, 0), point_at(&mesh, 1, 1, 0), point_at(&mesh, 1, 1, 1),
                      point_at(&mesh, 1, 0, 1)};
  int32_t third[8] = {lower[0],
                      lower[3],
                      lower[2],
                      lower[1],
                      point_at(&mesh, 2, 1, 0),
                      point_at(&mesh, 2, 1, 1),
                      point_at(&mesh, 2, 2, 1),
                      point_at(&mesh, 2, 2, 0)};
  add_hex(&mesh, third);
  hexcon_context *context = hexcon_context_new();
  hexcon_certificate c = certify(context, &mesh);
  assert_false(c.certified);
  assert_false(c.conforming);
  assert_false(c.boundary_exact);
  hexcon_certificate_free(context, &c);
  hexcon_context_free(context);
  test_mesh_free(&mesh);
}

/** Two hexes on the same four points: only one way round, from any of its corners, fits. */
static void ways_to_meet_in_a_face(void **state) {
  (void)state;
  int conforming = 0;
  for (int way = 0; way < 256; way++) {
    int32_t ids[4] = {way & 3, way >> 2 & 3, way >> 4 & 3, way >> 6};
    if ((1 << ids[0] | 1 << ids[1] | 1 << ids[2] | 1 << ids[3]) != 15)
      continue;
    test_mesh mesh = make_surface((const double[12][3]){{0}}, 12, NULL, 0);
    add_hex(&mesh, (int32_t[]){0, 1, 2, 3, 4, 5, 6, 7});
    add_hex(&mesh, (int32_t[]){ids[0], ids[1], ids[2], ids[3], 8, 9, 10, 11});
    hexcon_context *context = hexcon_context_new();
    hexcon_certificate c = certify(context, &mesh);
    bool cycle = ((ids[0] ^ ids[2]) & 3) == 2;
    bool against = cycle && ((ids[0] - ids[1]) & 3) == 1;
    assert_int_equal(c.conforming, against);
    assert_int_equal(c.proper, cycle);
    conforming += c.conforming;
    hexcon_certificate_free(context, &c);
    hexcon_context_free(context);
    test_mesh_free(&mesh);
  }
  assert_int_equal(conforming, 4);
}

/** A ring of hexes around a point, and one more hex at it: the link is an annulus and a disc, whose
 * Euler characteristic is that of a disc. */
static void ring_and_one_more(void **state) {
  (void)state;
  test_mesh mesh = make_cells(2, 2, 2, ".######.");
  int32_t n = (int32_t)mesh.point_count;
  double *points = realloc(mesh.points, 3 * (size_t)(n + 7) * sizeof *points);
  assert_non_null(points);
  mesh.points = points;
  memset(points + 3 * n, 0, 21 * sizeof *points);
  mesh.point_count += 7;
  add_hex(&mesh,
          (int32_t[]){point_at(&mesh, 1, 1, 1), n, n + 1, n + 2, n + 3, n + 4, n + 5, n + 6});
  hexcon_context *context = hexcon_context_new();
  hexcon_certificate c = certify(context, &mesh);
  assert_true(c.proper);
  assert_false(c.conforming);
  hexcon_certificate_free(context, &c);
  hexcon_context_free(context);
  test_mesh_free(&mesh);
}

/** Two hexes that share two neighbouring faces. */
static void doublet(void **state) {
  (void)state;
  const double points[10][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},   {0, 0, 1},
                                {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {-1, -1, 0}, {-1, -1, 1}};
  test_mesh mesh = make_surface(points, 10, NULL, 0);
  /* the second one beyond x = 0 and y = 0 */
  add_hex(&mesh, (int32_t[]){0, 1, 2, 3, 4, 5, 6, 7});
  add_hex(&mesh, (int32_t[]){8, 1, 0, 3, 9, 5, 4, 7});
  hexcon_context *context = hexcon_context_new();
  hexcon_certificate c = certify(context, &mesh);
  assert_true(c.conforming);
  assert_false(c.proper || c.certified);
  assert_int_equal(c.euler, 1);
  assert_int_equal(c.doublet_count, 1);
  assert_int_equal(c.doublets[0], 0);
  assert_int_equal(c.doublets[1], 1);
  assert_true(c.improper_count > 0);
  assert_int_equal(c.nonpositive_count, 1); /* flat at the points 0 and 4 */
  assert_int_equal(c.nonpositive[0], 1);
  hexcon_certificate_free(context, &c);
  hexcon_context_free(context);
  test_mesh_free(&mesh);
}

/** Two hexes, by their numbering alone, meet properly or not. */
static void expect_pair(const int32_t first[8], const int32_t second[8], bool proper) {
  double points[16][3] = {{0}};
  for (int i = 0; i < 8; i++)
    for (int k = 0; k < 3; k++) {
      points[first[i]][k] = (int[8][3]){{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                        {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}[i][k];
      points[second[i]][k] += 0.25 * i * k;
    }
  test_mesh mesh = make_surface((const double(*)[3])points, 16, NULL, 0);
  add_hex(&mesh, first);
  add_hex(&mesh, second);
  hexcon_context *context = hexcon_context_new();
  hexcon_certificate c = certify(context, &mesh);
  assert_int_equal(c.proper, proper);
  for (size_t i = 0; i < c.improper_count; i++)
    assert_int_equal(c.improper[i], 1);
  hexcon_certificate_free(context, &c);
  hexcon_context_free(context);
  test_mesh_free(&mesh);
}

static void proper_pairs(void **state) {
  (void)state;
  const int32_t first[8] = {0, 1, 2, 3, 4, 5, 6, 7};
  /* proper: nothing, a point, an edge, a face */
  expect_pair(first, (int32_t[]){8, 9, 10, 11, 12, 13, 14, 15}, true);
  expect_pair(first, (int32_t[]){0, 9, 10, 11, 12, 13, 14, 15}, true);
  expect_pair(first, (int32_t[]){1, 0, 10, 11, 12, 13, 14, 15}, true);
  expect_pair(first, (int32_t[]){4, 5, 6, 7, 12, 13, 14, 15}, true);
  expect_pair(first, (int32_t[]){6, 7, 4, 5, 12, 13, 14, 15}, true);
  /* improper: two opposite edges; two and three points; a face and more */
  expect_pair(first, (int32_t[]){0, 1, 10, 11, 2, 3, 14, 15}, false);
  expect_pair(first, (int32_t[]){0, 1, 10, 11, 12, 13, 6, 7}, false);
  expect_pair(first, (int32_t[]){0, 9, 2, 11, 12, 13, 14, 15}, false);
  expect_pair(first, (int32_t[]){0, 9, 10, 11, 12, 13, 6, 15}, false);
  expect_pair(first, (int32_t[]){0, 2, 10, 11, 12, 13, 14, 15}, false);
  expect_pair(first, (int32_t[]){0, 1, 2, 11, 12, 13, 14, 15}, false);
  expect_pair(first, (int32_t[]){0, 1, 2, 3, 12, 13, 14, 4}, false);
  expect_pair(first, (int32_t[]){0, 2, 1, 3, 12, 13, 14, 15}, false);
  expect_pair(first, (int32_t[]){0, 1, 10, 11, 12, 13, 2, 15}, false);
}

/** By the definition: the shared corners are all corners of one point, edge or face in both hexes,
 * and lie to each other alike. */
static bool shares_properly(const int32_t second[8]) {
  static const int bits[8] = {0, 1, 3, 2, 4, 5, 7, 6};
  int all[2] = {7, 7}, some[2] = {0, 0}, count = 0;
  for (int i = 0; i < 8; i++) {
    if (second[i] >= 8)
      continue;
    count++;
    int corner[2] = {bits[second[i]], bits[i]};
    for (int hex = 0; hex < 2; hex++) {
      all[hex] &= corner[hex];
      some[hex] |= corner[hex];
    }
    for (int j = 0; j < 8; j++)
      if (second[j] < 8 && __builtin_popcount((unsigned)(bits[i] ^ bits[j])) !=
                               __builtin_popcount((unsigned)(corner[0] ^ bits[second[j]])))
        return false;
  }
  for (int hex = 0; count && hex < 2; hex++)
    if (count != 1 << __builtin_popcount((unsigned)(all[hex] ^ some[hex])))
      return false;
  return count < 8;
}

static void swap(int32_t *a, int32_t *b) {
  int32_t id = *a;
  *a = *b;
  *b = id;
}

/** All ways to share 1 .. 5 points, by random numbering. */
static void random_pairs(void **state) {
  (void)state;
  const int32_t first[8] = {0, 1, 2, 3, 4, 5, 6, 7};
  uint64_t random = 4;
  int proper_count = 0;
  for (int round = 0; round < 5000; round++) {
    int32_t second[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    size_t shared = 1 + random_below(&random, 5);
    for (size_t i = 0; i < 8; i++)
      swap(&second[i], &second[i + random_below(&random, 8 - i)]);
    for (size_t i = shared; i < 8; i++)
      second[i] = (int32_t)(8 + i);
    for (size_t i = 0; i < 8; i++)
      swap(&second[i], &second[i + random_below(&random, 8 - i)]);
    bool proper = shares_properly(second);
    proper_count += proper && shared > 1;
    expect_pair(first, second, proper);
  }
  assert_true(proper_count > 100);
}

static void nonpositive_hexes(void **state) {
  (void)state;
  test_mesh mesh = make_box(3, 1, 1);
  for (int c = 0; c < 4; c++) { /* the second hex mirrored: its faces run the wrong way */
    int32_t id = mesh.hexes[8 + c];
    mesh.hexes[8 + c] = mesh.hexes[12 + c];
    mesh.hexes[12 + c] = id;
  }
  hexcon_context *context = hexcon_context_new();
  hexcon_certificate c = certify(context, &mesh);
  assert_false(c.certified || c.conforming || c.boundary_exact);
  assert_int_equal(c.nonpositive_count, 1);
  assert_int_equal(c.nonpositive[0], 1);
  assert_int_equal(c.undecided_count, 0);
  hexcon_certificate_free(context, &c);
  test_mesh_free(&mesh);
  mesh = make_box(2, 2, 2); /* the middle point moved out: all hexes but one suffer */
  for (int k = 0; k < 3; k++)
    mesh.points[3 * 26 + k] = 2.5;
  c = certify(context, &mesh);
  assert_true(c.conforming && c.proper && c.boundary_exact);
  assert_false(c.certified);
  assert_true(c.nonpositive_count >= 1);
  for (size_t i = 1; i < c.nonpositive_count; i++)
    assert_true(c.nonpositive[i - 1] < c.nonpositive[i]);
  hexcon_certificate_free(context, &c);
  test_mesh_free(&mesh);
  hexcon_context_free(context);
}

static void faults(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  test_mesh mesh = make_box(2, 1, 1);
  hexcon_certificate c;
  const size_t n = mesh.point_count;
  const int32_t one = 1;
#define CERTIFY(h, q) hexcon_certify(context, mesh.points, n, mesh.hexes, h, mesh.quads, q, &c)
  assert_int_equal(CERTIFY(0, 10), HEXCON_EMPTY);
  assert_elements(context, NULL, 0);
  assert_int_equal(CERTIFY((size_t)INT32_MAX, 10), HEXCON_TOO_LARGE);
  assert_int_equal(CERTIFY(2, (size_t)INT32_MAX), HEXCON_TOO_LARGE);
  int32_t saved = mesh.quads[7];
  mesh.quads[7] = (int32_t)n;
  assert_int_equal(CERTIFY(2, 10), HEXCON_INDEX_OUT_OF_RANGE);
  assert_elements(context, &one, 1);
  mesh.quads[7] = saved;
  saved = mesh.hexes[9];
  mesh.hexes[9] = -3;
  assert_int_equal(CERTIFY(2, 10), HEXCON_INDEX_OUT_OF_RANGE);
  assert_elements(context, &one, 1);
  mesh.hexes[9] = mesh.hexes[10];
  assert_int_equal(CERTIFY(2, 10), HEXCON_REPEATED_VERTEX);
  assert_elements(context, &one, 1);
  mesh.hexes[9] = saved;
  mesh.points[3] = INFINITY;
  assert_int_equal(CERTIFY(2, 10), HEXCON_NOT_FINITE);
  assert_elements(context, &one, 1);
  assert_null(c.nonpositive);
#undef CERTIFY
  test_mesh_free(&mesh);
  hexcon_context_free(context);
}

static hexcon_certificate certify_second_order(hexcon_context *context, const test_mesh *mesh,
                                               const hexcon_second_order *raised) {
  hexcon_certificate c;
  assert_int_equal(hexcon_certify_second_order(context, raised->points, raised->point_count,
                                               raised->hexes, mesh->hex_count, mesh->quads,
                                               mesh->quad_count, &c),
                   HEXCON_OK);
  return c;
}

static void expect_second_order(hexcon_context *context, const test_mesh *mesh,
                                const hexcon_second_order *raised, bool proper,
                                size_t nonpositive) {
  hexcon_certificate c = certify_second_order(context, mesh, raised);
  assert_true(c.conforming && c.boundary_exact);
  assert_int_equal(c.proper, proper);
  assert_int_equal(c.nonpositive_count, nonpositive);
  assert_int_equal(c.certified, proper && nonpositive == 0);
  for (size_t i = 0; i < nonpositive; i++)
    assert_witness(true, c.witnesses + 3 * i);
  hexcon_certificate_free(context, &c);
}

/** Two cubes: middle nodes at a quarter of an edge fold both hexes; one node for two edges, two for
 * one, or a corner, let them meet improperly. */
static void second_order(void **state) {
  (void)state;
  test_memory memory = {0};
  hexcon_context *context = hexcon_context_new_with(test_reallocate, &memory);
  test_mesh mesh = make_box(2, 1, 1);
  hexcon_second_order raised;
  assert_int_equal(hexcon_raise_order(context, mesh.points, mesh.point_count, mesh.hexes,
                                      mesh.hex_count, &raised),
                   HEXCON_OK);
  expect_second_order(context, &mesh, &raised, true, 0);
  int32_t *first = raised.hexes, *second = raised.hexes + 20;
  int32_t shared = -1;
  for (int i = 8; i < 20; i++)
    for (int j = 8; j < 20; j++)
      shared = first[i] == second[j] ? first[i] : shared;
  assert_true(shared >= 0);
  double *middle = raised.points + 3 * (size_t)shared, saved[3];
  memcpy(saved, middle, sizeof saved);
  middle[0] += 0.2; /* both hexes can bear it */
  expect_second_order(context, &mesh, &raised, true, 0);
  middle[0] = saved[0];
  for (int k = 1; k < 3; k++)
    middle[k] += middle[k] == 0.5 ? 0.3 : 0;
  expect_second_order(context, &mesh, &raised, true, 2);
  memcpy(middle, saved, sizeof saved);
  int32_t before = first[8];
  first[8] = first[9];
  expect_second_order(context, &mesh, &raised, false, 1);
  first[8] = first[0];
  expect_second_order(context, &mesh, &raised, false, 1);
  first[8] = before;
  for (int i = 8; i < 20; i++)
    if (first[i] == shared) { /* a twin of the shared node, at its place */
      memcpy(raised.points + 3 * (size_t)first[8], saved, sizeof saved);
      first[i] = first[8];
      first[8] = shared;
      memcpy(middle, saved, sizeof saved);
      break;
    }
  hexcon_certificate c = certify_second_order(context, &mesh, &raised);
  assert_true(!c.proper && !c.certified && c.improper_count > 0);
  hexcon_certificate_free(context, &c);
  raised.hexes[39] = (int32_t)raised.point_count;
  assert_int_equal(hexcon_certify_second_order(context, raised.points, raised.point_count,
                                               raised.hexes, mesh.hex_count, mesh.quads,
                                               mesh.quad_count, &c),
                   HEXCON_INDEX_OUT_OF_RANGE);
  hexcon_second_order_free(context, &raised);
  hexcon_context_free(context);
  assert_int_equal(memory.live, 0);
  test_mesh_free(&mesh);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(second_order),
      cmocka_unit_test(good_meshes),
      cmocka_unit_test(other_topologies),
      cmocka_unit_test(pinched),
      cmocka_unit_test(wrong_boundary),
      cmocka_unit_test(any_order_of_quads),
      cmocka_unit_test(duplicated_hex),
      cmocka_unit_test(face_in_three_hexes),
      cmocka_unit_test(ways_to_meet_in_a_face),
      cmocka_unit_test(ring_and_one_more),
      cmocka_unit_test(doublet),
      cmocka_unit_test(proper_pairs),
      cmocka_unit_test(random_pairs),
      cmocka_unit_test(nonpositive_hexes),
      cmocka_unit_test(faults),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
