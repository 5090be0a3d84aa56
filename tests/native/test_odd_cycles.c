/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Bases of homology, linking numbers, and the closed paths that allow or forbid a hex mesh. */
#include <string.h>

#include "homology/bit_matrix.h"
#include "homology/handle_cycles.h"
#include "homology/linking_numbers.h"
#include "homology/odd_cycles.h"
#include "support.h"
#include "surface/build.h"
#include "surface/shell_copy.h"

static void build(hexcon_context *context, const test_mesh *m, surface *s) {
  assert_int_equal(
      surface_build(context, m->points, m->surface_point_count, m->quads, m->quad_count, s),
      HEXCON_OK);
}

static test_mesh surface_of(int number) {
  switch (number) {
  case 0:
    return make_torus(3, 4);
  case 1:
    return make_torus(6, 5);
  case 2:
    return make_cells(5, 3, 1, "######.#.######"); /* two holes */
  case 3:
    return make_cells(5, 5, 3, /* a ring-shaped cavity */
                      "#########################"
                      "######...##.#.##...######"
                      "#########################");
  default:
    return make_tube(5, 2);
  }
}
enum { SURFACES = 5 };

/* ------------------------------------------------------------------------------------ matrices */

static void matrices(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  bit_matrix m;
  bool projection = true;
  size_t rank = 9;
  assert_int_equal(bit_matrix_new(context, 70, &m), HEXCON_OK);
  assert_int_equal(bit_matrix_is_projection(context, &m, &projection), HEXCON_OK);
  assert_true(projection);
  assert_int_equal(bit_matrix_rank(context, &m, &rank), HEXCON_OK);
  assert_int_equal(rank, 0);
  bit_matrix_add(&m, 0, 0, true);
  bit_matrix_add(&m, 69, 69, true);
  bit_matrix_add(&m, 69, 3, true); /* rows 0 and 69 stay what they are */
  assert_true(bit_matrix_get(&m, 69, 3) && !bit_matrix_get(&m, 3, 69));
  assert_int_equal(bit_matrix_is_projection(context, &m, &projection), HEXCON_OK);
  assert_true(projection);
  bit_matrix_add(&m, 3, 69, true); /* rows 3 and 69 go round */
  assert_int_equal(bit_matrix_is_projection(context, &m, &projection), HEXCON_OK);
  assert_false(projection);
  assert_int_equal(bit_matrix_rank(context, &m, &rank), HEXCON_OK);
  assert_int_equal(rank, 3);
  bit_matrix_add(&m, 69, 69, true); /* row 69 is row 3's transpose: still independent */
  bit_matrix_add(&m, 3, 69, true);
  bit_matrix_add(&m, 68, 3, true); /* the same as row 69 */
  assert_int_equal(bit_matrix_rank(context, &m, &rank), HEXCON_OK);
  assert_int_equal(rank, 2);
  bit_matrix_free(context, &m);
  hexcon_context_free(context);
}

/* ---------------------------------------------------------------------------------------- bases */

static void assert_closed(const surface *s, const handle_cycles *c, size_t i) {
  const int32_t *along = c->along + c->first_along[i], *across = c->across + c->first_across[i];
  size_t length = c->first_along[i + 1] - c->first_along[i];
  size_t passed = c->first_across[i + 1] - c->first_across[i];
  for (size_t k = 0; k < length; k++)
    assert_int_equal(half_edge_end(s, along[k]), half_edge_start(s, along[(k + 1) % length]));
  for (size_t k = 0; k < passed; k++)
    assert_int_equal(half_edge_quad(s->twins[across[k]]), half_edge_quad(across[(k + 1) % passed]));
  assert_int_equal(along[0], across[0]);
}

/** Cycles and rings meet as they should: an odd number of times if and only if they belong
 * together. */
static void bases_are_dual(void **state) {
  (void)state;
  for (int number = 0; number < SURFACES; number++) {
    hexcon_context *context = hexcon_context_new();
    test_mesh m = surface_of(number);
    surface s;
    handle_cycles c;
    bool complete = false;
    build(context, &m, &s);
    assert_int_equal(handle_cycles_find(context, &s, &c, &complete), HEXCON_OK);
    assert_true(complete);
    assert_int_equal(c.count, 2 * s.component_count + s.quad_count - s.point_count);
    for (size_t i = 0; i < c.count; i++) {
      assert_closed(&s, &c, i);
      for (size_t j = 0; j < c.count; j++) {
        size_t met = 0;
        for (size_t k = c.first_along[i]; k < c.first_along[i + 1]; k++)
          for (size_t l = c.first_across[j]; l < c.first_across[j + 1]; l++)
            met += c.along[k] == c.across[l] || c.along[k] == s.twins[c.across[l]];
        assert_int_equal(met, i == j);
      }
    }
    handle_cycles_free(context, &c);
    surface_free(context, &s);
    test_mesh_free(&m);
    hexcon_context_free(context);
  }
}

static void linking_is_a_projection(void **state) {
  (void)state;
  for (int number = 0; number < SURFACES; number++) {
    hexcon_context *context = hexcon_context_new();
    test_mesh m = surface_of(number);
    surface s;
    handle_cycles c;
    bit_matrix linking;
    bool known = false;
    build(context, &m, &s);
    assert_int_equal(handle_cycles_find(context, &s, &c, &known), HEXCON_OK);
    assert_int_equal(linking_numbers_find(context, &s, &c, &linking, &known), HEXCON_OK);
    assert_true(known);
    assert_int_equal(linking.count, c.count);
    bit_matrix_free(context, &linking);
    handle_cycles_free(context, &c);
    surface_free(context, &s);
    test_mesh_free(&m);
    hexcon_context_free(context);
  }
}

/* ---------------------------------------------------------------------------------------- tori */

/** The section, of n edges, bounds inside; the way round, of m, does not. */
static void tori(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  for (int m = 3; m <= 8; m++)
    for (int n = 3; n <= 8; n++) {
      test_mesh torus = make_torus(m, n);
      surface s;
      odd_cycles found;
      build(context, &torus, &s);
      assert_int_equal(odd_cycles_find(context, &s, &found), HEXCON_OK);
      assert_int_equal(found.fillable, n % 2 ? HEXCON_FILLABLE_NO : HEXCON_FILLABLE_YES);
      assert_int_equal(found.path_count, n % 2);
      assert_int_equal(found.point_count, n % 2 ? n : 0);
      for (size_t i = 0; i < found.point_count; i++)
        assert_true(has_edge(&torus, found.points[i], found.points[(i + 1) % found.point_count]));
      odd_cycles_free(context, &found);
      surface_free(context, &s);
      test_mesh_free(&torus);
    }
  hexcon_context_free(context);
}

static void refusals(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  test_mesh torus = make_torus(4, 3);
  for (int method = 0; method < HEXCON_METHOD_COUNT; method++) {
    static const int32_t hex[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    const hexcon_proposal proposal = {.hex_count = 1, .hexes = hex}; /* is not looked at any more */
    hexcon_mesh_options options = {.method = (hexcon_method)method};
    if (method == HEXCON_METHOD_PROPOSAL)
      options.proposal = &proposal;
    hexcon_mesh *mesh = NULL;
    const int32_t *ids;
    hexcon_status status = hexcon_mesh_surface(context, torus.points, torus.surface_point_count,
                                               torus.quads, torus.quad_count, &options, &mesh);
    assert_null(mesh);
    assert_int_equal(status,
                     method == HEXCON_METHOD_FOUR_SPLIT ? HEXCON_NO_SIDES : HEXCON_NO_HEX_MESH);
    assert_int_equal(hexcon_context_elements(context, &ids), 3);
  }
  test_mesh_free(&torus);
  hexcon_context_free(context);
}

/* --------------------------------------------------------------------------------------- shells */

/** Each shell as a surface of its own has the same quads. */
static void shells_are_copied(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  test_mesh m = make_cells(3, 3, 3, "#############.#############");
  surface s;
  shell_copies copies;
  build(context, &m, &s);
  assert_int_equal(shell_copies_new(context, &s, &copies), HEXCON_OK);
  for (size_t c = 0; c < s.component_count; c++) {
    surface shell;
    assert_int_equal(shell_copies_take(context, &copies, c, &shell), HEXCON_OK);
    assert_int_equal(shell.quad_count, s.is_cavity[c] ? 6 : 54);
    assert_true(surface_is_sphere(&shell));
    for (int32_t h = 0; h < (int32_t)(4 * shell.quad_count); h++) {
      int32_t from = 4 * shell_copies_quad(&copies, c, half_edge_quad(h)) + (h & 3);
      assert_int_equal(s.component_of_quad[half_edge_quad(from)], c);
      assert_memory_equal(shell.points + 3 * shell.quads[h], s.points + 3 * s.quads[from],
                          3 * sizeof(double));
      assert_int_equal(shell.twins[shell.twins[h]], h);
      assert_int_equal(half_edge_start(&shell, h), half_edge_end(&shell, shell.twins[h]));
    }
    shell_copy_free(context, &shell);
  }
  shell_copies_free(context, &copies);
  surface_free(context, &s);
  test_mesh_free(&m);
  hexcon_context_free(context);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(matrices), cmocka_unit_test(bases_are_dual),
      cmocka_unit_test(tori),     cmocka_unit_test(linking_is_a_projection),
      cmocka_unit_test(refusals), cmocka_unit_test(shells_are_copied),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
