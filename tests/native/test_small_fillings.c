/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The table of small fillings: sound, found under any numbering, and damage is noticed. */
#include <stdlib.h>
#include <string.h>

#include "construct/small_fillings.h"
#include "solve/smallest/mesh_smallest.h"
#include "support.h"
#include "surface/build.h"

static const small_filling_table *const table = &small_fillings_smallest;

static void table_is_sound(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  assert_true(table->count > 0);
  for (size_t i = 0; i < table->count; i++) {
    if (small_filling_check(context, &table->records[i]))
      fail_msg("%s", hexcon_context_message(context));
    if (i > 0)
      assert_true(strcmp(table->records[i - 1].code, table->records[i].code) < 0);
  }
  hexcon_context_free(context);
}

/* ------------------------------------------------------------------------------------- damage */

enum { ROOM = 4096 };

/** A copy of a record that may be changed. */
typedef struct copy {
  small_filling_record record;
  char code[CODE_ROOM], hexes[ROOM], places[ROOM];
} copy;

static void copy_record(const small_filling_record *record, copy *c) {
  assert_true(strlen(record->hexes) < ROOM && strlen(record->places) < ROOM);
  strcpy(c->code, record->code);
  strcpy(c->hexes, record->hexes);
  strcpy(c->places, record->places);
  c->record = (small_filling_record){c->code, record->certified, c->hexes, c->places};
}

typedef void (*damage)(copy *c);

static void no_digit(copy *c) {
  c->hexes[5] = '!';
}
static void no_digit_of_a_place(copy *c) {
  c->places[5] = ' ';
}
static void id_too_large(copy *c) {
  c->hexes[16] = '_';
}
static void other_id(copy *c) {
  memcpy(c->hexes + 2, c->hexes + 16 * 7, 2);
}
static void hex_missing(copy *c) {
  c->hexes[strlen(c->hexes) - 16] = '\0';
}
static void hex_twice(copy *c) {
  memcpy(c->hexes + 16, c->hexes, 16);
}
static void half_a_hex(copy *c) {
  c->hexes[strlen(c->hexes) - 8] = '\0';
}
static void point_missing(copy *c) {
  c->places[strlen(c->places) - 9] = '\0';
}
static void nothing_left(copy *c) {
  c->hexes[0] = '\0';
}
static void inside_out(copy *c) {
  for (char *hex = c->hexes; *hex; hex += 16) {
    char bottom[8];
    memcpy(bottom, hex, 8);
    memcpy(hex, hex + 8, 8);
    memcpy(hex + 8, bottom, 8);
  }
}
static void another_class(copy *c) {
  strcpy(c->code, table->records[0].code);
}

static void damage_is_noticed(void **state) {
  (void)state;
  static const damage damages[] = {no_digit,     no_digit_of_a_place, id_too_large, other_id,
                                   hex_missing,  hex_twice,           half_a_hex,   point_missing,
                                   nothing_left, another_class};
  hexcon_context *context = hexcon_context_new();
  copy c;
  size_t large = 0;
  for (size_t i = 1; i < table->count; i++)
    if (strlen(table->records[i].hexes) > strlen(table->records[large].hexes) &&
        strlen(table->records[i].hexes) < ROOM)
      large = i;
  copy_record(&table->records[large], &c);
  assert_int_equal(small_filling_check(context, &c.record), HEXCON_OK);
  for (size_t i = 0; i < sizeof damages / sizeof *damages; i++) {
    copy_record(&table->records[large], &c);
    damages[i](&c);
    if (small_filling_check(context, &c.record) != HEXCON_BAD_ARGUMENT)
      fail_msg("damage %zu is not noticed", i);
    assert_message(context);
  }
  hexcon_context_free(context);
}

/** Hexes turned inside out have the mirror image for their boundary: noticed where that differs. */
static void mirror_images_differ(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  size_t noticed = 0;
  copy c;
  for (size_t i = 0; i < table->count; i++) {
    if (strlen(table->records[i].hexes) >= ROOM)
      continue;
    copy_record(&table->records[i], &c);
    inside_out(&c);
    noticed += small_filling_check(context, &c.record) == HEXCON_BAD_ARGUMENT;
  }
  assert_true(2 * noticed > table->count);
  hexcon_context_free(context);
}

/* ------------------------------------------------------------------------------------- look-up */

static hexcon_status find(hexcon_context *context, const test_mesh *mesh,
                          const small_filling_table *in, small_filling *out) {
  surface s;
  assert_int_equal(surface_build(context, mesh->points, mesh->surface_point_count, mesh->quads,
                                 mesh->quad_count, &s),
                   HEXCON_OK);
  small_class found;
  *out = (small_filling){0};
  hexcon_status status = small_class_find(context, &s, in, &found);
  if (!status)
    status = small_filling_read(context, &s, &found, 0, out);
  surface_free(context, &s);
  return status;
}

static void assert_refused(const test_mesh *mesh, const small_filling_table *in,
                           hexcon_status expected, const int32_t *elements, size_t count) {
  hexcon_context *context = hexcon_context_new();
  small_filling filling;
  assert_int_equal(find(context, mesh, in, &filling), expected);
  assert_message(context);
  assert_elements(context, elements, count);
  small_filling_free(context, &filling);
  hexcon_context_free(context);
}

static void what_has_no_filling(void **state) {
  (void)state;
  /* Four quads about two poles: every two of them have the poles in common. */
  static const double points[][3] = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0},
                                     {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  static const int32_t quads[][4] = {{0, 2, 1, 3}, {0, 3, 1, 4}, {0, 4, 1, 5}, {0, 5, 1, 2}};
  static const int32_t first_two[] = {0, 1};
  const small_filling_table one = {1, table->records};
  test_mesh melon = make_surface(points, 6, quads, 4), torus = make_torus(3, 4);
  test_mesh large = make_box(2, 2, 2), trapezohedron = make_trapezohedron();
  assert_refused(&melon, table, HEXCON_NO_SMALL_FILLING, first_two, 2);
  assert_refused(&torus, table, HEXCON_NOT_A_BALL, NULL, 0);
  assert_refused(&large, table, HEXCON_NO_SMALL_FILLING, NULL, 0);
  if (strcmp(table->records[0].code, "bcd.aef.afg.aghe.bdi.bijc.cjd.dji.ehf.fhg.") != 0)
    assert_refused(&trapezohedron, &one, HEXCON_NO_SMALL_FILLING, NULL, 0);
  test_mesh_free(&melon);
  test_mesh_free(&torus);
  test_mesh_free(&large);
  test_mesh_free(&trapezohedron);
}

/** Renumber the points by a random order, and the quads. */
static void shuffle(test_mesh *mesh, uint64_t random) {
  test_mesh old = test_mesh_copy(mesh);
  int32_t number[64];
  for (size_t i = 0; i < mesh->point_count; i++) {
    const size_t k = random_below(&random, i + 1);
    number[i] = number[k];
    number[k] = (int32_t)i;
  }
  for (size_t i = 0; i < mesh->point_count; i++)
    memcpy(mesh->points + 3 * number[i], old.points + 3 * i, 3 * sizeof *mesh->points);
  for (size_t q = 0; q < mesh->quad_count; q++) {
    const size_t to = (q + 3) % mesh->quad_count, turn = random_below(&random, 4);
    for (size_t k = 0; k < 4; k++)
      mesh->quads[4 * to + k] = number[old.quads[4 * q + (k + turn) % 4]];
  }
  test_mesh_free(&old);
}

static void mesh_smallest_of(test_mesh *surface_mesh, size_t hex_count) {
  hexcon_context *context = hexcon_context_new();
  const hexcon_mesh_options options = {
      .method = HEXCON_METHOD_SMALLEST, .pillow = HEXCON_PILLOW_NEVER, .threads = 1};
  hexcon_mesh *mesh = NULL;
  if (hexcon_mesh_surface(context, surface_mesh->points, surface_mesh->point_count,
                          surface_mesh->quads, surface_mesh->quad_count, &options, &mesh))
    fail_msg("%s", hexcon_context_message(context));
  assert_int_equal(hexcon_mesh_hex_count(mesh), hex_count);
  assert_string_equal(hexcon_mesh_method(mesh), "smallest");
  assert_certified_mesh(context, surface_mesh, mesh);
  hexcon_mesh_free(context, mesh);
  hexcon_context_free(context);
}

static void known_records_in_any_numbering(void **state) {
  (void)state;
  for (uint64_t seed = 0; seed < 4; seed++) {
    test_mesh trapezohedron = make_trapezohedron(), bar = make_box(2, 1, 1),
              cube = make_box(1, 1, 1);
    shuffle(&trapezohedron, seed);
    if (seed % 2)
      for (size_t v = 0; v < trapezohedron.point_count; v++)
        trapezohedron.points[3 * v] *= -1; /* quads face inward now: they are turned */
    mesh_smallest_of(&trapezohedron, 40);
    shuffle(&bar, seed);
    mesh_smallest_of(&bar, 2);
    shuffle(&cube, seed);
    mesh_smallest_of(&cube, 1);
    test_mesh_free(&trapezohedron);
    test_mesh_free(&bar);
    test_mesh_free(&cube);
  }
}

/** What another method left over is filled through the same call: its points keep their ids. */
static void a_core_is_filled(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  test_mesh core = make_trapezohedron();
  surface s;
  small_mesh m;
  assert_int_equal(
      surface_build(context, core.points, core.point_count, core.quads, core.quad_count, &s),
      HEXCON_OK);
  assert_int_equal(small_mesh_build(context, &s, 1, &m), HEXCON_OK);
  assert_int_equal(m.mesh.inverted, 0);
  assert_true(m.mesh.worst > 0.1);
  assert_memory_equal(m.mesh.points, core.points, 3 * core.point_count * sizeof *core.points);
  filled_mesh_free(context, &m.mesh);
  surface_free(context, &s);
  test_mesh_free(&core);
  hexcon_context_free(context);
}

/** Its sides are flat: only some of the class's symmetries put no two of their quads on one hex. */
static void flat_sides_choose_the_symmetry(void **state) {
  (void)state;
  const hexcon_mesh_options options = {
      .method = HEXCON_METHOD_SMALLEST, .pillow = HEXCON_PILLOW_NEVER, .threads = 1};
  test_mesh pyramid = make_schneiders_pyramid();
  hexcon_context *context = hexcon_context_new();
  hexcon_mesh *made = NULL;
  assert_int_equal(hexcon_mesh_surface(context, pyramid.points, pyramid.surface_point_count,
                                       pyramid.quads, pyramid.quad_count, &options, &made),
                   HEXCON_OK);
  assert_int_equal(hexcon_mesh_hex_count(made), 36);
  assert_certified_mesh(context, &pyramid, made);
  hexcon_mesh_free(context, made);
  hexcon_context_free(context);
  test_mesh_free(&pyramid);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(table_is_sound),
      cmocka_unit_test(damage_is_noticed),
      cmocka_unit_test(mirror_images_differ),
      cmocka_unit_test(what_has_no_filling),
      cmocka_unit_test(known_records_in_any_numbering),
      cmocka_unit_test(a_core_is_filled),
      cmocka_unit_test(flat_sides_choose_the_symmetry),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
