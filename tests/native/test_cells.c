/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Cells: templates, dicing, what cannot be filled, and meshing them without memory or patience. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "construct/cells.h"
#include "construct/dice.h"
#include "construct/hex_template.h"
#include "pairing/pairing.h"
#include "support.h"
#include "surface/build.h"
#include "surface/colouring.h"
#include "surface/corner_angles.h"
#include "verify/jacobian_sign.h"

/* ---------------------------------------------------------------------------------- templates */

static void template_is_sound(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  const hex_template *t = &template_domino_62;
  assert_int_equal(t->hex_count, 62);
  assert_int_equal(template_check(context, t), HEXCON_OK);
  for (size_t h = 0; h < t->hex_count; h++)
    for (size_t i = 0; i < 8; i++)
      for (size_t k = 0; k < i; k++)
        assert_int_not_equal(t->hexes[h][i], t->hexes[h][k]);
  assert_true(template_row(t, "O0") >= 0);
  assert_int_equal(template_row(t, "no such label"), -1);
  hexcon_context_free(context);
}

/** A copy that may be changed. */
typedef struct template_copy {
  hex_template t;
  int32_t (*hexes)[8], (*quads)[4];
} template_copy;

static template_copy copy_template(const hex_template *t) {
  template_copy copy = {*t, malloc(t->hex_count * sizeof *copy.hexes),
                        malloc(t->quad_count * sizeof *copy.quads)};
  assert_true(copy.hexes && copy.quads);
  memcpy(copy.hexes, t->hexes, t->hex_count * sizeof *copy.hexes);
  memcpy(copy.quads, t->quads, t->quad_count * sizeof *copy.quads);
  copy.t.hexes = (const int32_t(*)[8])copy.hexes;
  copy.t.quads = (const int32_t(*)[4])copy.quads;
  return copy;
}

typedef void (*template_damage)(template_copy *copy);

static void no_damage(template_copy *copy) {
  (void)copy;
}

static void id_too_large(template_copy *copy) {
  copy->hexes[61][7] = (int32_t)copy->t.point_count;
}

static void id_negative(template_copy *copy) {
  copy->quads[3][2] = -1;
}

static void other_id(template_copy *copy) {
  int32_t *id = &copy->hexes[30][4];
  *id = (*id + 1) % (int32_t)copy->t.point_count;
}

static void hex_missing(template_copy *copy) {
  copy->t.hex_count--;
}

static void hex_twice(template_copy *copy) {
  memcpy(copy->hexes[10], copy->hexes[11], sizeof copy->hexes[10]);
}

static void quad_missing(template_copy *copy) {
  copy->t.quad_count--;
}

static void too_many_points(template_copy *copy) {
  copy->t.point_count = 256; /* its faces' keys would not be unique */
}

static void damaged_templates(void **state) {
  (void)state;
  static const template_damage damages[] = {no_damage,    id_too_large,   id_negative,
                                            other_id,     hex_missing,    hex_twice,
                                            quad_missing, too_many_points};
  for (size_t i = 0; i < sizeof damages / sizeof *damages; i++) {
    hexcon_context *context = hexcon_context_new();
    template_copy copy = copy_template(&template_domino_62);
    damages[i](&copy);
    hexcon_status status = template_check(context, &copy.t);
    assert_int_equal(status, i ? HEXCON_BAD_ARGUMENT : HEXCON_OK);
    if (status) {
      assert_message(context);
      assert_non_null(strstr(hexcon_context_message(context), copy.t.name));
    }
    free(copy.hexes);
    free(copy.quads);
    hexcon_context_free(context);
  }
}

/* ------------------------------------------------------------------------------------- dicing */

static const double corner_places[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/** Positions of a diced complex whose old points are the four corners, then `spare` others. */
static void place_diced(const diced_complex *d, double (*places)[3], size_t first_point) {
  for (size_t p = 0; p < d->point_count; p++) {
    double count = 0, *place = places[first_point + p];
    memset(place, 0, sizeof *places);
    for (size_t i = 0; i < 4 && d->means[4 * p + i] >= 0; i++, count++)
      for (size_t k = 0; k < 3; k++)
        place[k] += places[d->means[4 * p + i]][k];
    for (size_t k = 0; k < 3; k++)
      place[k] /= count;
  }
}

static void dice_one_tetrahedron(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  const int32_t tetrahedron[4] = {0, 1, 2, 3};
  const diced_triangles nothing = {0};
  diced_complex d;
  assert_int_equal(dice(context, tetrahedron, 1, &nothing, 4, &d), HEXCON_OK);
  assert_int_equal(d.hex_count, 4);
  assert_int_equal(d.point_count, 11); /* 15 with the corners: 6 edges, 4 faces, a body */
  double places[15][3];
  memcpy(places, corner_places, sizeof corner_places);
  place_diced(&d, places, 4);
  int used[15] = {0};
  for (size_t i = 0; i < 8 * d.hex_count; i++) {
    assert_in_range(d.hexes[i], 0, 14);
    used[d.hexes[i]]++;
  }
  for (size_t v = 0; v < 15; v++)
    assert_true(used[v] > 0);
  for (size_t h = 0; h < d.hex_count; h++)
    assert_int_equal(prove_jacobian_sign(&places[0][0], d.hexes + 8 * h), JACOBIAN_POSITIVE);
  dice_free(context, &d);
  hexcon_context_free(context);
}

static void dice_nothing(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  const diced_triangles nothing = {0};
  diced_complex d;
  assert_int_equal(dice(context, NULL, 0, &nothing, 4, &d), HEXCON_OK);
  assert_true(d.hex_count == 0 && d.point_count == 0);
  dice_free(context, &d);
  hexcon_context_free(context);
}

static bool has_hex_with(const diced_complex *d, int32_t a, int32_t b) {
  for (size_t h = 0; h < d->hex_count; h++) {
    int found = 0;
    for (size_t i = 0; i < 8; i++)
      found += d->hexes[8 * h + i] == a || d->hexes[8 * h + i] == b;
    if (found == 2)
      return true;
  }
  return false;
}

/** Two tetrahedra upon each other; one outer triangle and its edges have their middles already. */
static void dice_next_to_known(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  const int32_t tetrahedra[8] = {0, 1, 2, 3, 2, 1, 0, 4};
  const int32_t corners[3] = {3, 0, 1}, mean = 8, middles[3] = {5, 6, 7};
  const diced_triangles known = {1, corners, &mean, middles};
  diced_complex d;
  assert_int_equal(dice(context, tetrahedra, 2, &known, 9, &d), HEXCON_OK);
  assert_int_equal(d.hex_count, 8);
  /* 9 edges and 7 faces less the known ones, and two bodies */
  assert_int_equal(d.point_count, 9 - 3 + 7 - 1 + 2);
  bool used[9] = {false};
  for (size_t i = 0; i < 8 * d.hex_count; i++) {
    assert_in_range(d.hexes[i], 0, 9 + d.point_count - 1);
    if (d.hexes[i] < 9)
      used[d.hexes[i]] = true;
  }
  for (size_t v = 0; v < 9; v++)
    assert_true(used[v]);
  /* each middle belongs to its own edge, and the mean to all */
  for (int32_t i = 0; i < 3; i++)
    assert_true(has_hex_with(&d, corners[i], middles[i]) && has_hex_with(&d, middles[i], mean));
  assert_false(has_hex_with(&d, 2, 5));
  dice_free(context, &d);
  hexcon_context_free(context);
}

static void dice_too_many(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  const diced_triangles nothing = {0};
  diced_complex d;
  assert_int_equal(dice(context, NULL, (size_t)INT32_MAX, &nothing, 4, &d), HEXCON_TOO_LARGE);
  assert_message(context);
  dice_free(context, &d);
  const int32_t tetrahedron[4] = {0, 1, 2, 3};
  assert_int_equal(dice(context, tetrahedron, 1, &nothing, (size_t)INT32_MAX - 5, &d),
                   HEXCON_TOO_LARGE);
  dice_free(context, &d);
  hexcon_context_free(context);
}

/* --------------------------------------------------------------------------- what is refused */

static void build_surface(hexcon_context *context, const test_mesh *m, surface *s) {
  assert_int_equal(surface_build(context, m->points, m->point_count, m->quads, m->quad_count, s),
                   HEXCON_OK);
}

/** A cube of which one corner of quad 0 is drawn on to the diagonal beside it. */
static void flat_corners_are_named(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  test_mesh m = make_box(1, 1, 1);
  surface s;
  build_surface(context, &m, &s);
  assert_int_equal(surface_check_fillable(context, &s, true), HEXCON_OK);
  assert_int_equal(surface_check_fillable(context, &s, false), HEXCON_OK);
  for (int32_t h = 0; h < 24; h++)
    assert_close(surface_corner_angle(&s, h), acos(-1.0) / 2, 1e-12);
  int32_t flat = m.quads[1], before = m.quads[0], after = m.quads[2];
  for (size_t k = 0; k < 3; k++)
    m.points[3 * flat + (int)k] =
        (m.points[3 * before + (int)k] + m.points[3 * after + (int)k]) / 2;
  assert_int_equal(surface_check_fillable(context, &s, true), HEXCON_UNFILLABLE_QUAD);
  const int32_t first = 0;
  assert_elements(context, &first, 1);
  surface_free(context, &s);
  test_mesh_free(&m);
  hexcon_context_free(context);
}

/** A cube with a point on one side that but two quads see: they share the edges 1 8 and 8 3. */
static void quads_that_share_two_edges_are_named(void **state) {
  (void)state;
  static const double points[9][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},    {0, 0, 1},
                                      {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0.6, 0.6, 0}};
  static const int32_t quads[7][4] = {{0, 3, 8, 1}, {1, 8, 3, 2}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                      {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  hexcon_context *context = hexcon_context_new();
  test_mesh m = make_surface(points, 9, quads, 7);
  surface s;
  build_surface(context, &m, &s);
  const int32_t doubled[2] = {0, 1};
  for (int star = 0; star < 2; star++) {
    context_clear(context);
    assert_int_equal(surface_check_fillable(context, &s, star), HEXCON_UNFILLABLE_QUAD);
    assert_elements(context, doubled, 2);
  }
  surface_free(context, &s);
  test_mesh_free(&m);
  hexcon_context_free(context);
}

/* ------------------------------------------------------------------------------------- cells */

/** The complex over a box, without positions: conforming and bounded by the quads outside. */
static void cells_of_a_box(void **state) {
  (void)state;
  for (size_t layers = 0; layers < 3; layers++) {
    hexcon_context *context = hexcon_context_new();
    test_mesh m = make_box(2, 2, 1);
    surface s;
    build_surface(context, &m, &s);
    uint8_t colours[64];
    int32_t partner[64];
    assert_int_equal(surface_colour(context, &s, colours), HEXCON_OK);
    assert_int_equal(surface_pair(context, &s, NULL, partner), HEXCON_OK);
    cell_complex cells;
    assert_int_equal(cells_build(context, &s, colours, partner, layers, &cells), HEXCON_OK);
    assert_int_equal(cells.cell_count, m.quad_count / 2);
    assert_int_equal(cells.hex_count, m.quad_count * (31 + layers));
    assert_int_equal(cells.first_inner, (layers + 1) * m.point_count);
    for (size_t i = 0; i < 8 * cells.hex_count; i++)
      assert_in_range(cells.hexes[i], 0, cells.point_count - 1);
    for (size_t i = 0; i < 2 * m.quad_count; i++)
      assert_in_range(cells.triangle_means[i], cells.first_inner, cells.point_count - 1);
    cells_free(context, &cells);
    surface_free(context, &s);
    test_mesh_free(&m);
    hexcon_context_free(context);
  }
}

/* ------------------------------------------------------------------- without memory or patience */

/** A mesher's result, kept by its caller. */
typedef struct star_mesher {
  double center[3];
  int32_t tetrahedra[4 * 256];
  size_t calls;
} star_mesher;

/** All to the mean. */
static bool make_star(void *user, const double *points, size_t point_count,
                      const int32_t *triangles, size_t triangle_count, hexcon_tetrahedra *out) {
  star_mesher *m = user;
  assert_true(triangle_count <= 256);
  m->calls++;
  for (size_t k = 0; k < 3; k++) {
    m->center[k] = 0;
    for (size_t v = 0; v < point_count; v++)
      m->center[k] += points[3 * v + k] / (double)point_count;
  }
  for (size_t t = 0; t < triangle_count; t++) {
    const int32_t *from = triangles + 3 * t;
    int32_t to[4] = {from[0], from[2], from[1], (int32_t)point_count};
    memcpy(m->tetrahedra + 4 * t, to, sizeof to);
  }
  *out = (hexcon_tetrahedra){1, m->center, triangle_count, m->tetrahedra};
  return true;
}

static hexcon_status mesh_cube(hexcon_context *context, const test_mesh *cube, bool with_mesher) {
  hexcon_mesh *mesh = (hexcon_mesh *)context;
  star_mesher mesher = {.calls = 0};
  hexcon_mesh_options options = {.method = HEXCON_METHOD_CELLS, .threads = 1};
  if (with_mesher) {
    options.tetrahedralise = make_star;
    options.tetrahedralise_user = &mesher;
  }
  hexcon_status status = hexcon_mesh_surface(context, cube->points, cube->point_count, cube->quads,
                                             cube->quad_count, &options, &mesh);
  if (status) {
    assert_null(mesh);
  } else {
    hexcon_context *judge = hexcon_context_new(); /* whose memory does not fail */
    assert_certified_mesh(judge, cube, mesh);
    assert_true(!with_mesher || mesher.calls > 0);
    hexcon_context_free(judge);
  }
  hexcon_mesh_free(context, mesh);
  return status;
}

/** Every one of the first, then a few: each costs all that comes before it. */
static size_t next_to_fail(size_t k, size_t every_one) {
  return k < every_one ? k + 1 : k + 97;
}

static void out_of_memory(void **state) {
  for (int with_mesher = 0; with_mesher < 2; with_mesher++) {
    test_memory all = {0};
    hexcon_context *context = hexcon_context_new_with(test_reallocate, &all);
    assert_int_equal(mesh_cube(context, *state, with_mesher), HEXCON_OK);
    size_t total = all.calls, tried = 0;
    hexcon_context_free(context);
    assert_int_equal(all.live, 0);
    for (size_t k = 2; k < total; k = next_to_fail(k, with_mesher ? 60 : 200), tried++) {
      test_memory memory = {.fail_at = k};
      context = hexcon_context_new_with(test_reallocate, &memory);
      hexcon_status status = mesh_cube(context, *state, with_mesher);
      if (memory.calls >= k)
        assert_int_equal(status, HEXCON_OUT_OF_MEMORY);
      if (status)
        assert_message(context);
      assert_int_equal(memory.live, 1);
      hexcon_context_free(context);
      assert_int_equal(memory.live, 0);
    }
    print_message("%zu of %zu allocations fail\n", tried, total);
  }
}

static void cancellation(void **state) {
  test_patience whole = {0};
  hexcon_context *context = hexcon_context_new();
  hexcon_context_set_progress(context, lose_patience, &whole);
  assert_int_equal(mesh_cube(context, *state, true), HEXCON_OK);
  hexcon_context_free(context);
  for (size_t k = 1; k < whole.calls; k += k < 4 ? 1 : whole.calls / 4) {
    test_memory memory = {0};
    test_patience left = {.cancel_at = k};
    context = hexcon_context_new_with(test_reallocate, &memory);
    hexcon_context_set_progress(context, lose_patience, &left);
    assert_int_equal(mesh_cube(context, *state, true), HEXCON_CANCELLED);
    assert_int_equal(left.calls, k); /* not asked again */
    assert_message(context);
    hexcon_context_free(context);
    assert_int_equal(memory.live, 0);
  }
  print_message("%zu calls of progress\n", whole.calls);
}

static int set_up(void **state) {
  static test_mesh cube;
  cube = make_box(1, 1, 1);
  *state = &cube;
  return 0;
}

static int tear_down(void **state) {
  test_mesh_free(*state);
  return 0;
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(template_is_sound),
      cmocka_unit_test(damaged_templates),
      cmocka_unit_test(dice_one_tetrahedron),
      cmocka_unit_test(dice_nothing),
      cmocka_unit_test(dice_next_to_known),
      cmocka_unit_test(dice_too_many),
      cmocka_unit_test(flat_corners_are_named),
      cmocka_unit_test(quads_that_share_two_edges_are_named),
      cmocka_unit_test(cells_of_a_box),
      cmocka_unit_test(out_of_memory),
      cmocka_unit_test(cancellation),
  };
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
