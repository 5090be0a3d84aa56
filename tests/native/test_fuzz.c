/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Random damage to good surfaces: every outcome is a named error or a certified mesh. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "support.h"

enum { ROUNDS = 10000, PAPER_ROUNDS = 3000, MOST_MUTATIONS = 5, SEED_COUNT = 9 };

typedef void (*mutation)(test_mesh *mesh, uint64_t *random);

static int32_t *any_quad(test_mesh *mesh, uint64_t *random) {
  return mesh->quads + 4 * random_below(random, mesh->quad_count);
}

static void change_index(test_mesh *mesh, uint64_t *random) {
  any_quad(mesh, random)[random_below(random, 4)] =
      (int32_t)random_below(random, mesh->surface_point_count);
}

static void index_out_of_range(test_mesh *mesh, uint64_t *random) {
  static const int32_t far[] = {INT32_MIN, -1, INT32_MAX, INT32_MAX - 1, 1 << 30};
  size_t i = random_below(random, 6);
  any_quad(mesh, random)[random_below(random, 4)] =
      i < 5 ? far[i] : (int32_t)(mesh->surface_point_count + random_below(random, 3));
}

static double *any_coordinate(test_mesh *mesh, uint64_t *random) {
  return mesh->points + random_below(random, 3 * mesh->surface_point_count);
}

static void no_number(test_mesh *mesh, uint64_t *random) {
  static const double values[] = {NAN, INFINITY, -INFINITY};
  *any_coordinate(mesh, random) = values[random_below(random, 3)];
}

static void strange_coordinate(test_mesh *mesh, uint64_t *random) {
  static const double values[] = {1.7e308, -1.7e308, 1e200, 1e160, -1e100, 1e20, 5e-324, -0.0};
  *any_coordinate(mesh, random) = values[random_below(random, 8)];
}

static void scale_all(test_mesh *mesh, uint64_t *random) {
  double scale = pow(10, random_between(random, -320, 308));
  for (size_t i = 0; i < 3 * mesh->surface_point_count; i++)
    mesh->points[i] *= scale;
}

static void flatten(test_mesh *mesh, uint64_t *random) {
  size_t axis = random_below(random, 3);
  for (size_t v = 0; v < mesh->surface_point_count; v++)
    mesh->points[3 * v + axis] = 0;
}

static void delete_quad(test_mesh *mesh, uint64_t *random) {
  if (mesh->quad_count > 1) {
    int32_t *quad = any_quad(mesh, random);
    mesh->quad_count--;
    memmove(quad, mesh->quads + 4 * mesh->quad_count, 4 * sizeof *quad);
  }
}

static void duplicate_quad(test_mesh *mesh, uint64_t *random) {
  int32_t copied[4];
  memcpy(copied, any_quad(mesh, random), sizeof copied);
  memcpy(any_quad(mesh, random), copied, sizeof copied);
}

static void flip_quad(test_mesh *mesh, uint64_t *random) {
  test_mesh one = {.quad_count = 1, .quads = any_quad(mesh, random)};
  turn_quads(&one);
}

static void flip_all(test_mesh *mesh, uint64_t *random) {
  (void)random;
  turn_quads(mesh);
}

static void merge_points(test_mesh *mesh, uint64_t *random) {
  if (mesh->surface_point_count == 1)
    return;
  int32_t kept = (int32_t)random_below(random, mesh->surface_point_count);
  int32_t gone = (int32_t)random_below(random, mesh->surface_point_count);
  if (kept == gone)
    return;
  for (size_t i = 0; i < 4 * mesh->quad_count; i++)
    if (mesh->quads[i] == gone)
      mesh->quads[i] = kept;
  for (size_t i = 0; i < 4 * mesh->quad_count; i++) /* the last point takes the free number */
    if (mesh->quads[i] == (int32_t)mesh->surface_point_count - 1)
      mesh->quads[i] = gone;
  mesh->surface_point_count--;
  memmove(mesh->points + 3 * gone, mesh->points + 3 * mesh->surface_point_count,
          3 * sizeof(double));
}

static void rotate_quad(test_mesh *mesh, uint64_t *random) {
  int32_t *quad = any_quad(mesh, random), first = quad[0];
  memmove(quad, quad + 1, 3 * sizeof *quad);
  quad[3] = first;
}

static void swap_corners(test_mesh *mesh, uint64_t *random) {
  int32_t *quad = any_quad(mesh, random);
  size_t a = random_below(random, 4), b = random_below(random, 4);
  int32_t id = quad[a];
  quad[a] = quad[b];
  quad[b] = id;
}

/** Exchange two numbers everywhere: the surface stays closed, its shape is torn. */
static void swap_points(test_mesh *mesh, uint64_t *random) {
  int32_t a = (int32_t)random_below(random, mesh->surface_point_count);
  int32_t b = (int32_t)random_below(random, mesh->surface_point_count);
  for (size_t i = 0; i < 4 * mesh->quad_count; i++) {
    int32_t id = mesh->quads[i];
    mesh->quads[i] = id == a ? b : id == b ? a : id;
  }
}

static void coincident_points(test_mesh *mesh, uint64_t *random) {
  size_t a = random_below(random, mesh->surface_point_count);
  size_t b = random_below(random, mesh->surface_point_count);
  memmove(mesh->points + 3 * a, mesh->points + 3 * b, 3 * sizeof(double));
}

static void move_point(test_mesh *mesh, uint64_t *random) {
  double *coordinate = any_coordinate(mesh, random);
  double amount = pow(10, random_between(random, -3, 1));
  *coordinate += random_between(random, -amount, amount);
}

static void move_all(test_mesh *mesh, uint64_t *random) {
  double amount = pow(10, random_between(random, -3, 0.3));
  for (size_t i = 0; i < 3 * mesh->surface_point_count; i++)
    mesh->points[i] += random_between(random, -amount, amount);
}

/** Turn an edge between two quads by one corner: the surface stays closed, other loops run. */
static void turn_edge(test_mesh *mesh, uint64_t *random) {
  int32_t *p = any_quad(mesh, random);
  size_t i = random_below(random, 4);
  int32_t a = p[i], b = p[(i + 1) & 3];
  for (size_t h = 0; h < 4 * mesh->quad_count; h++) {
    int32_t *q = mesh->quads + (h & ~(size_t)3);
    size_t j = h & 3;
    if (q == p || q[j] != b || q[(j + 1) & 3] != a)
      continue;
    int32_t c = p[(i + 2) & 3], f = q[(j + 3) & 3], d = p[(i + 3) & 3], e = q[(j + 2) & 3];
    const int32_t first[4] = {c, d, a, e}, second[4] = {e, f, b, c};
    memcpy(p, first, sizeof first);
    memcpy(q, second, sizeof second);
    return;
  }
}

static const mutation mutations[] = {
    change_index, index_out_of_range, no_number,      strange_coordinate, scale_all,
    flatten,      delete_quad,        duplicate_quad, flip_quad,          flip_all,
    merge_points, rotate_quad,        swap_corners,   swap_points,        coincident_points,
    move_point,   move_all,           turn_edge};

/** Mutations that keep the surface closed reach deeper; half of the rounds use only those. */
static const mutation gentle[] = {scale_all,   flip_all,          rotate_quad,
                                  swap_points, coincident_points, move_point,
                                  move_all,    turn_edge,         strange_coordinate};

static test_mesh damaged(const test_mesh *seed, uint64_t *random) {
  test_mesh mesh = test_mesh_copy(seed);
  size_t count = 1 + random_below(random, MOST_MUTATIONS);
  bool is_gentle = random_below(random, 2) == 0;
  for (size_t i = 0; i < count; i++) {
    if (is_gentle)
      gentle[random_below(random, sizeof gentle / sizeof *gentle)](&mesh, random);
    else
      mutations[random_below(random, sizeof mutations / sizeof *mutations)](&mesh, random);
  }
  return mesh;
}

typedef struct outcomes {
  size_t check[HEXCON_STATUS_COUNT], loops[HEXCON_STATUS_COUNT], colouring[HEXCON_STATUS_COUNT],
      mesh[HEXCON_STATUS_COUNT], uncertified;
} outcomes;

/** An error has a name and words, and ids that exist. */
static void expect_named(hexcon_context *context, hexcon_status status, const test_mesh *mesh) {
  const int32_t *ids;
  size_t count = hexcon_context_elements(context, &ids);
  assert_non_null(hexcon_status_name((int)status));
  if (status == HEXCON_OK) {
    assert_string_equal(hexcon_context_message(context), "");
    return;
  }
  assert_message(context);
  assert_true(count <= 1000);
  for (size_t i = 0; i < count; i++) /* quads, points or hexes */
    assert_true(ids[i] >= 0 && (size_t)ids[i] < 64 * (mesh->quad_count + mesh->point_count));
}

static hexcon_status run_facts(hexcon_context *context, const test_mesh *mesh, outcomes *seen) {
  hexcon_surface_report report;
  hexcon_loops loops;
  uint8_t colours[512];
  hexcon_status status = hexcon_surface_loops(context, mesh->quads, mesh->quad_count, &loops);
  expect_named(context, status, mesh);
  seen->loops[status]++;
  if (!status) {
    assert_int_equal(loops.offsets[loops.count], 2 * mesh->quad_count);
    hexcon_loops_free(context, &loops);
  }
  status = hexcon_surface_colouring(context, mesh->quads, mesh->quad_count,
                                    mesh->surface_point_count, colours);
  expect_named(context, status, mesh);
  seen->colouring[status]++;
  status = hexcon_check_surface(context, mesh->points, mesh->surface_point_count, mesh->quads,
                                mesh->quad_count, &report);
  expect_named(context, status, mesh);
  seen->check[status]++;
  if (!status)
    assert_int_equal(report.euler, 2 * (int64_t)report.component_count - 2 * report.genus);
  return status;
}

static bool all_finite(const hexcon_mesh *mesh) {
  bool finite = true;
  for (size_t i = 0; i < 3 * hexcon_mesh_point_count(mesh); i++)
    finite &= isfinite(hexcon_mesh_points(mesh)[i]) != 0;
  return finite;
}

static void run_mesh(hexcon_context *context, const test_mesh *mesh, hexcon_status facts,
                     bool allow_uncertified, outcomes *seen) {
  hexcon_mesh *made = NULL;
  const hexcon_mesh_options options = {.method = HEXCON_METHOD_SWEPT,
                                       .allow_uncertified = allow_uncertified};
  hexcon_status status = hexcon_mesh_surface(context, mesh->points, mesh->surface_point_count,
                                             mesh->quads, mesh->quad_count, &options, &made);
  expect_named(context, status, mesh);
  seen->mesh[status]++;
  assert_int_equal(made != NULL, status == HEXCON_OK);
  if (facts)
    assert_int_equal(status, facts);
  if (!made)
    return;
  if (hexcon_mesh_certificate(made)->certified) {
    assert_true(all_finite(made));
    assert_certified_mesh(context, mesh, made);
  } else {
    assert_true(allow_uncertified);
    seen->uncertified++;
  }
  hexcon_mesh_free(context, made);
}

static void print_outcomes(const outcomes *seen) {
  print_message("%-26s %8s %8s %8s %8s\n", "outcome", "check", "loops", "colours", "mesh");
  for (int status = 0; status < HEXCON_STATUS_COUNT; status++)
    if (seen->check[status] + seen->loops[status] + seen->colouring[status] + seen->mesh[status])
      print_message("%-26s %8zu %8zu %8zu %8zu\n", hexcon_status_name(status), seen->check[status],
                    seen->loops[status], seen->colouring[status], seen->mesh[status]);
  print_message("of the meshes, %zu uncertified and asked for\n", seen->uncertified);
}

static void damaged_surfaces(void **state) {
  (void)state;
  test_mesh seeds[SEED_COUNT] = {make_box(1, 1, 1),
                                 make_box(2, 2, 2),
                                 make_box(3, 2, 1),
                                 make_pentagonal_prism(2),
                                 make_torus(4, 4),
                                 make_tube(6, 2),
                                 make_cells(2, 2, 2, "###.###."),
                                 make_cells(2, 2, 2, "#####..."),
                                 make_schneiders_pyramid()};
  uint64_t random = 2024;
  outcomes seen = {{0}, {0}, {0}, {0}, 0};
  for (int round = 0; round < ROUNDS; round++) {
    test_memory memory = {.most_bytes = (size_t)1 << 26};
    hexcon_context *context = hexcon_context_new_with(test_reallocate, &memory);
    test_mesh mesh = damaged(&seeds[round % SEED_COUNT], &random);
    hexcon_status facts = run_facts(context, &mesh, &seen);
    run_mesh(context, &mesh, facts, round % 4 == 0, &seen);
    test_mesh_free(&mesh);
    hexcon_context_free(context);
    assert_int_equal(memory.live, 0);
  }
  print_outcomes(&seen);
  for (int i = 0; i < SEED_COUNT; i++)
    test_mesh_free(&seeds[i]);
}

/** Pairs that may be missing, far away or damaged. */
static hexcon_mesh_options any_paper_options(const test_mesh *mesh, int32_t pairs[8],
                                             uint64_t *random) {
  for (int i = 0; i < 8; i++)
    pairs[i] = (int32_t)random_below(random, mesh->quad_count + 2) - 1;
  return (hexcon_mesh_options){
      .method = HEXCON_METHOD_FOUR_SPLIT + (hexcon_method)random_below(random, 5),
      .pairing = (hexcon_pairing)random_below(random, HEXCON_PAIRING_COUNT + 1),
      .pairs = random_below(random, 8) ? pairs : NULL,
      .pair_count = random_below(random, 5)};
}

/** The paper's methods: a named error, or a mesh that is conforming with an exact boundary. */
static void damaged_surfaces_of_the_paper(void **state) {
  (void)state;
  test_mesh seeds[4] = {make_box(1, 1, 1), make_torus(3, 4), make_tube(4, 1),
                        make_schneiders_pyramid()};
  uint64_t random = 2026;
  size_t seen[HEXCON_STATUS_COUNT] = {0};
  for (int round = 0; round < PAPER_ROUNDS; round++) {
    test_memory memory = {.most_bytes = (size_t)1 << 26};
    hexcon_context *context = hexcon_context_new_with(test_reallocate, &memory);
    test_mesh mesh = damaged(&seeds[round % 4], &random);
    int32_t pairs[8];
    const hexcon_mesh_options options = any_paper_options(&mesh, pairs, &random);
    hexcon_mesh *made = NULL;
    hexcon_status status = hexcon_mesh_surface(context, mesh.points, mesh.surface_point_count,
                                               mesh.quads, mesh.quad_count, &options, &made);
    seen[status]++;
    assert_int_equal(made != NULL, status == HEXCON_OK);
    if (status != HEXCON_BAD_PAIRING) /* whose ids are as given */
      expect_named(context, status, &mesh);
    if (made)
      assert_true(hexcon_mesh_certificate(made)->conforming &&
                  hexcon_mesh_certificate(made)->boundary_exact && all_finite(made));
    hexcon_mesh_free(context, made);
    test_mesh_free(&mesh);
    hexcon_context_free(context);
    assert_int_equal(memory.live, 0);
  }
  for (int status = 0; status < HEXCON_STATUS_COUNT; status++)
    if (seen[status])
      print_message("%-26s %8zu\n", hexcon_status_name(status), seen[status]);
  assert_true(seen[HEXCON_OK] && seen[HEXCON_SELF_CROSSING] && seen[HEXCON_BAD_PAIRING] &&
              seen[HEXCON_NOT_A_BALL] && seen[HEXCON_NO_SIDES]);
  for (int i = 0; i < 4; i++)
    test_mesh_free(&seeds[i]);
}

/** Meshes with damaged hexes: an error, or a certificate that does not claim what is false. */
static void damaged_hexes(void **state) {
  (void)state;
  uint64_t random = 2025;
  size_t certified = 0, refused = 0, faults = 0;
  test_mesh seed = make_box(3, 2, 2);
  for (int round = 0; round < 3000; round++) {
    test_memory memory = {0};
    hexcon_context *context = hexcon_context_new_with(test_reallocate, &memory);
    test_mesh mesh = test_mesh_copy(&seed);
    size_t at = random_below(&random, 8 * mesh.hex_count);
    int32_t before = mesh.hexes[at];
    mesh.hexes[at] = (int32_t)random_below(&random, mesh.point_count + 2) - 1;
    bool same = mesh.hexes[at] == before;
    hexcon_certificate c;
    hexcon_status status = hexcon_certify(context, mesh.points, mesh.point_count, mesh.hexes,
                                          mesh.hex_count, mesh.quads, mesh.quad_count, &c);
    expect_named(context, status, &mesh);
    if (status) {
      faults++;
    } else {
      assert_int_equal(c.certified, same);
      certified += c.certified;
      refused += !c.certified;
      hexcon_certificate_free(context, &c);
    }
    test_mesh_free(&mesh);
    hexcon_context_free(context);
    assert_int_equal(memory.live, 0);
  }
  print_message("damaged hexes: %zu certified (unchanged), %zu refused, %zu faults\n", certified,
                refused, faults);
  test_mesh_free(&seed);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(damaged_surfaces),
      cmocka_unit_test(damaged_surfaces_of_the_paper),
      cmocka_unit_test(damaged_hexes),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
