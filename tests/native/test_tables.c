/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The tables of the core: complete, and the options that a method takes are those that it says. */
#include "support.h"

#include <string.h>

#include "base/stages.h"
#include "solve/methods.h"

static void each_method_has_one_row(void **state) {
  (void)state;
  int seen[HEXCON_METHOD_COUNT] = {0};
  size_t row = 0;
  for (const hexcon_method_facts *f; (f = hexcon_method_info(row)); row++) {
    assert_in_range(f->method, 0, HEXCON_METHOD_COUNT - 1);
    seen[f->method]++;
    assert_ptr_equal(&method_find(f->method)->facts, f);
    assert_true(f->name[0] && f->label[0] && f->purpose[0] && f->told[0]);
    assert_true(method_find(f->method)->fill || f->method == HEXCON_METHOD_AUTO);
  }
  assert_int_equal(row, HEXCON_METHOD_COUNT);
  for (int method = 0; method < HEXCON_METHOD_COUNT; method++)
    assert_int_equal(seen[method], 1);
  assert_null(hexcon_method_info(SIZE_MAX));
  assert_null(method_find(HEXCON_METHOD_COUNT));
  assert_null(method_find((hexcon_method)-1));
}

static void turns_of_auto_have_no_gap(void **state) {
  (void)state;
  const method_row *row = NULL;
  int count = 0, turn = 1;
  for (size_t i = 0; i < HEXCON_METHOD_COUNT; i++)
    for (size_t k = 0; k < HEXCON_METHOD_TRIES; k++)
      count += hexcon_method_info(i)->tries[k].turn > 0;
  for (; method_try_of_turn(turn, &row); turn++)
    assert_false(row->facts.topological || row->facts.method == HEXCON_METHOD_AUTO);
  assert_int_equal(turn - 1, count);
}

static bool is_solvers(const hexcon_method_facts *facts) {
  return !facts->topological;
}

static bool is_any(const hexcon_method_facts *facts) {
  (void)facts;
  return true;
}

static void lists_of_methods(void **state) {
  (void)state;
  const char first[] = "auto, proposal, swept, sheets, ";
  char text[METHOD_LIST];
  method_list(is_solvers, text);
  assert_int_equal(strncmp(text, first, strlen(first)), 0);
  assert_null(strstr(text, "pyramid"));
  method_list(is_any, text);
  assert_string_equal(text + strlen(text) - strlen(", pillowed"), ", pillowed"); /* it fits */
}

/** @return what a cube of 6 quads comes to with these options */
static hexcon_status mesh_cube(hexcon_context *context, const hexcon_mesh_options *options) {
  test_mesh cube = make_box(1, 1, 1);
  const hexcon_proposal proposal = {.hex_count = cube.hex_count, .hexes = cube.hexes};
  hexcon_mesh_options given = *options;
  if (given.method == HEXCON_METHOD_PROPOSAL || given.proposal)
    given.proposal = &proposal;
  hexcon_mesh *mesh;
  hexcon_status status = hexcon_mesh_surface(context, cube.points, cube.surface_point_count,
                                             cube.quads, cube.quad_count, &given, &mesh);
  hexcon_mesh_free(context, mesh);
  test_mesh_free(&cube);
  return status;
}

static void options_are_refused_by_the_table(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  const hexcon_proposal any = {0};
  for (size_t i = 0; i < HEXCON_METHOD_COUNT; i++) {
    const hexcon_method_facts *f = hexcon_method_info(i);
    const hexcon_mesh_options given[] = {
        {.method = f->method, .allow_uncertified = true, .layers = 1},
        {.method = f->method, .allow_uncertified = true, .no_core = true},
        {.method = f->method, .allow_uncertified = true, .pairing = HEXCON_PAIRING_FEWEST},
        {.method = f->method, .allow_uncertified = true, .proposal = &any},
        {.method = f->method, .allow_uncertified = true, .pillow = 1}};
    const bool takes[] = {f->layers, f->core, f->pairing, f->proposal, f->pillow};
    for (size_t k = 0; k < 5; k++) {
      bool refused = mesh_cube(context, &given[k]) == HEXCON_BAD_ARGUMENT;
      assert_int_equal(refused, !takes[k]);
      assert_int_equal(refused,
                       strstr(hexcon_context_message(context), ": only for method ") != NULL);
    }
  }
  hexcon_context_free(context);
}

static void faults_and_stages_end(void **state) {
  (void)state;
  for (int status = 0; status < HEXCON_STATUS_COUNT; status++) {
    const hexcon_status_facts *f = hexcon_status_info(status);
    assert_string_equal(f->name, hexcon_status_name(status));
    assert_int_equal(status == HEXCON_OK, f->meaning[0] == '\0');
    assert_int_equal(status == HEXCON_OK, f->advice[0] == '\0');
  }
  assert_string_equal(hexcon_status_name(HEXCON_ODD), "ODD");
  assert_null(hexcon_status_info(-1));
  assert_null(hexcon_status_info(HEXCON_STATUS_COUNT));
  assert_null(hexcon_status_name(HEXCON_STATUS_COUNT));
  assert_null(hexcon_progress_stage(PROGRESS_STAGE_COUNT));
  assert_null(hexcon_hex_stage(HEX_STAGE_COUNT));
  assert_string_equal(hexcon_progress_stage(STAGE_PAIRING)->name, "pairing");
  assert_string_equal(hexcon_hex_stage(HEXES_OF_CORE)->name, "core");
  assert_string_equal(hexcon_pairing_name(HEXCON_PAIRING_GIVEN), "given");
  assert_null(hexcon_pairing_name(HEXCON_PAIRING_COUNT));
  assert_null(hexcon_pairing_name(-1));
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(each_method_has_one_row), cmocka_unit_test(turns_of_auto_have_no_gap),
      cmocka_unit_test(lists_of_methods), cmocka_unit_test(options_are_refused_by_the_table),
      cmocka_unit_test(faults_and_stages_end)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
