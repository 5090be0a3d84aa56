/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Method sheets on surfaces small enough to count by hand, and the front it is made of. */
#include <stdlib.h>
#include <string.h>

#include "construct/sheet_front.h"
#include "support.h"
#include "surface/build.h"

static const hexcon_mesh_options sheets = {.method = HEXCON_METHOD_SHEETS,
                                           .pillow = HEXCON_PILLOW_NEVER};
static const hexcon_mesh_options sheets_alone = {.method = HEXCON_METHOD_SHEETS, .no_core = true};

static void expect_sheets(test_mesh mesh, size_t hex_count) {
  assert_filled(mesh, &sheets, "sheets", hex_count);
}

static void small_bodies(void **state) {
  (void)state;
  expect_sheets(make_box(1, 1, 1), 1);
  expect_sheets(make_box(2, 1, 1), 2);
  expect_sheets(make_box(2, 2, 2), 8);
  expect_sheets(make_box(3, 1, 4), 12);
  expect_sheets(make_pentagonal_prism(1), 5);
  expect_sheets(make_pentagonal_prism(3), 15);
  expect_sheets(make_cells(2, 2, 1, "###."), 3);
  expect_sheets(make_cells(2, 2, 2, "#####..."), 5);
  expect_sheets(make_cells(2, 2, 2, "#######."), 7);
}

/** Refused, with so many quads in the core; frees the mesh. */
static void expect_refusal(test_mesh mesh, hexcon_status expected, size_t core) {
  hexcon_context *context = hexcon_context_new();
  hexcon_mesh *made = (hexcon_mesh *)context;
  assert_int_equal(hexcon_mesh_surface(context, mesh.points, mesh.surface_point_count, mesh.quads,
                                       mesh.quad_count, &sheets_alone, &made),
                   expected);
  assert_null(made);
  assert_message(context);
  const int32_t *elements;
  assert_true(hexcon_context_elements(context, &elements) <= core);
  hexcon_context_free(context);
  test_mesh_free(&mesh);
}

/** A core of 8 quads, whose smallest proper filling has 40 hexes, under a layer of 4. */
static void filled_core(void **state) {
  (void)state;
  expect_sheets(make_schneiders_pyramid(), 44);
}

static void cores(void **state) {
  (void)state;
  expect_refusal(make_schneiders_pyramid(), HEXCON_NO_SHEETS, 8);
  expect_refusal(make_trapezohedron(), HEXCON_NO_SHEETS, 8); /* its one loop crosses itself */
}

/** The cap of a box goes on and comes off again, and everything is as it was. */
static void layer_and_back(void **state) {
  (void)state;
  test_mesh mesh = make_box(2, 3, 4);
  hexcon_context *context = hexcon_context_new();
  surface s;
  sheet_front front;
  front_region region;
  assert_int_equal(surface_build(context, mesh.points, mesh.surface_point_count, mesh.quads,
                                 mesh.quad_count, &s),
                   HEXCON_OK);
  assert_int_equal(front_begin(context, &s, &front), HEXCON_OK);
  assert_int_equal(front_region_new(context, &front, &region), HEXCON_OK);
  for (size_t loop = 0; loop < front.loops.count; loop++)
    for (int turn = 0; turn < 4; turn += 2) {
      size_t alive = front.alive_count;
      front_region_begin(&front, half_edge_turn(front_loop_start(&front, loop), turn), &region);
      assert_true(front_can_lay(&front, &region));
      assert_false(front_region_fill(&front, 1, &region));
      front_region_begin(&front, half_edge_turn(front_loop_start(&front, loop), turn), &region);
      assert_true(front_region_fill(&front, alive, &region));
      assert_int_equal(front_lay(context, &front, &region), HEXCON_OK);
      assert_int_equal(front.alive_count, alive - region.rung_count);
      assert_int_equal(front.mesh.hex_count, region.quad_count);
      assert_true(front.gone[loop]);
      front_take_back(&front);
      assert_int_equal(front.alive_count, alive);
      assert_int_equal(front.mesh.hex_count + front.layer_count + front.rung_count, 0);
      assert_memory_equal(front.s.quads, s.quads, 4 * s.quad_count * sizeof *s.quads);
      assert_memory_equal(front.s.twins, s.twins, 4 * s.quad_count * sizeof *s.twins);
      assert_false(front.gone[loop]);
    }
  front_region_free(context, &region);
  front_free(context, &front);
  surface_free(context, &s);
  hexcon_context_free(context);
  test_mesh_free(&mesh);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(small_bodies),
      cmocka_unit_test(filled_core),
      cmocka_unit_test(cores),
      cmocka_unit_test(layer_and_back),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
