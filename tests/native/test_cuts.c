/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Bodies with holes, small enough to count by hand: discs, loops round handles, cuts. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "construct/disc_pattern.h"
#include "solve/cuts/cut_choice.h"
#include "solve/cuts/cut_crossings.h"
#include "support.h"
#include "surface/build.h"
#include "surface/loop_crossings.h"

static surface surface_of(hexcon_context *context, const test_mesh *mesh) {
  surface s;
  assert_int_equal(surface_build(context, mesh->points, mesh->surface_point_count, mesh->quads,
                                 mesh->quad_count, &s),
                   HEXCON_OK);
  return s;
}

/* ------------------------------------------------------------------------------------------ discs
 */

/** Every edge of the rim is in one quad, in the rim's sense, every other one in two. */
static void expect_disc(const disc_pattern *disc) {
  const size_t points = disc->point_count;
  int *uses = calloc(points * points, sizeof *uses);
  assert_non_null(uses);
  for (size_t i = 0; i < 4 * disc->quad_count; i++) {
    size_t a = (size_t)disc->quads[i], b = (size_t)disc->quads[(i & ~(size_t)3) | ((i + 1) & 3)];
    assert_true(a < points && b < points);
    uses[a * points + b]++;
  }
  for (size_t a = 0; a < points; a++)
    for (size_t b = 0; b < points; b++) {
      bool on_rim = a < disc->rim_count && b == (a + 1) % disc->rim_count;
      assert_true(uses[a * points + b] <= 1);
      assert_int_equal(uses[a * points + b] - uses[b * points + a],
                       on_rim - (b < disc->rim_count && a == (b + 1) % disc->rim_count));
      assert_true(!on_rim || uses[a * points + b] == 1);
    }
  free(uses);
}

static void discs(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  for (size_t a = 1; a <= 3; a++)
    for (size_t b = 1; b <= 3; b++)
      for (size_t rings = 0; rings <= 2; rings++) {
        const disc_shape shape = {a, b, rings, (a + rings) % (2 * (a + b))};
        disc_pattern disc;
        assert_int_equal(disc_pattern_build(context, &shape, &disc), HEXCON_OK);
        assert_int_equal(disc.rim_count, 2 * (a + b));
        assert_int_equal(disc.quad_count, a * b + rings * 2 * (a + b));
        assert_int_equal(disc.quad_count, disc_shape_quads(&shape));
        /* Euler: points - edges + quads = 1, and each quad has half of four edges but the rim's */
        assert_int_equal(2 * disc.point_count, 2 * disc.quad_count + disc.rim_count + 2);
        expect_disc(&disc);
        disc_pattern_free(context, &disc);
      }
  const disc_shape huge = {(size_t)1 << 20, (size_t)1 << 20, 0, 0};
  disc_pattern disc;
  assert_int_equal(disc_pattern_build(context, &huge, &disc), HEXCON_TOO_LARGE);
  hexcon_context_free(context);
}

/* ------------------------------------------------------------------------------------------ loops
 */

/** From edge to edge of the rim through opposite sides of quads. */
static size_t walk_across(const disc_pattern *disc, size_t edge) {
  int32_t a = (int32_t)edge, b = (int32_t)((edge + 1) % disc->rim_count);
  for (bool on = true; on;) {
    on = false;
    for (size_t i = 0; i < 4 * disc->quad_count && !on; i++) {
      const int32_t *quad = disc->quads + 4 * (i / 4);
      on = quad[i % 4] == a && quad[(i + 1) % 4] == b;
      if (on) {
        a = quad[(i + 3) % 4];
        b = quad[(i + 2) % 4];
      }
    }
  }
  return (size_t)b; /* the edge is left against the rim's sense */
}

static void rows_of_discs(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  for (size_t a = 1; a <= 3; a++)
    for (size_t b = 1; b <= 3; b++)
      for (size_t first = 0; first < 2 * (a + b); first++)
        for (size_t rings = 0; rings <= 1; rings++) {
          const disc_shape shape = {a, b, rings, first};
          disc_pattern disc;
          assert_int_equal(disc_pattern_build(context, &shape, &disc), HEXCON_OK);
          for (size_t edge = 0; edge < disc.rim_count; edge++)
            assert_int_equal(disc_shape_across(&shape, edge), walk_across(&disc, edge));
          disc_pattern_free(context, &disc);
        }
  hexcon_context_free(context);
}

/** Crossings after a cut as they are counted on the surface that it leaves, for every grid in some
 * rings. Returns the number of cuts; frees the mesh. */
static size_t expect_crossings(test_mesh mesh) {
  hexcon_context *context = hexcon_context_new();
  surface s = surface_of(context, &mesh);
  cut_body body;
  cut_choice choice;
  size_t cuts = 0;
  assert_int_equal(cut_body_begin(context, &s, &body), HEXCON_OK);
  assert_int_equal(cut_choice_find(context, &body, &choice), HEXCON_OK);
  for (size_t k = 0; k < choice.count; k++) {
    cut_crossings crossings;
    const int32_t *ring = cut_choice_ring(&choice, &choice.candidates[k]);
    assert_int_equal(
        cut_crossings_new(context, &s, &choice.loops, choice.candidates[k].loop, &crossings),
        HEXCON_OK);
    for (size_t a = 1; a < crossings.length / 2; a++)
      for (size_t first = 0; first < crossings.length; first++) {
        const disc_shape shape = {a, crossings.length / 2 - a, 0, first};
        const crossing_counts told = cut_crossings_count(&crossings, &shape);
        placed_cut cut;
        cut_body rest;
        assert_int_equal(placed_cut_new(context, &s, ring, &shape, &cut), HEXCON_OK);
        assert_int_equal(cut_body_cut(context, &body, ring, &cut, &rest), HEXCON_OK);
        if (rest.points) {
          crossing_counter counter;
          assert_int_equal(crossing_counter_new(context, rest.s.quad_count, &counter), HEXCON_OK);
          const loop_crossings found = count_crossings(&rest.s, &counter);
          assert_int_equal(told.of_themselves, found.of_themselves);
          assert_int_equal(told.in_excess, found.in_excess);
          crossing_counter_free(context, &counter);
          cuts++;
        }
        placed_cut_free(context, &cut);
        cut_body_free(context, &rest);
      }
    cut_crossings_free(context, &crossings);
  }
  cut_choice_free(context, &choice);
  cut_body_free(context, &body);
  surface_free(context, &s);
  test_mesh_free(&mesh);
  hexcon_context_free(context);
  return cuts;
}

static void crossings_after_cuts(void **state) {
  static const char tunnels[] = "####.####"
                                "#.#...#.#"
                                "####.####";
  static const char holes[] = "######.#.######"
                              "######...######";
  (void)state;
  assert_true(expect_crossings(make_torus(6, 8)) > 20);
  assert_true(expect_crossings(make_tube(8, 2)) > 10);
  assert_true(expect_crossings(make_cells(3, 3, 3, tunnels)) > 10);
  assert_true(expect_crossings(make_cells(5, 3, 2, holes)) > 10);
}

/** Of a torus's rows those round the tube cut it, those along it do not: they bound outside. */
static void loops_that_cut(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  test_mesh torus = make_torus(6, 4);
  surface s = surface_of(context, &torus);
  cut_body body, ball;
  cut_choice choice;
  placed_cut cut;
  assert_int_equal(cut_body_begin(context, &s, &body), HEXCON_OK);
  assert_int_equal(body_handle_count(&body.s), 1);
  assert_int_equal(cut_choice_find(context, &body, &choice), HEXCON_OK);
  assert_int_equal(choice.loops.count, 10);
  assert_int_equal(choice.simple_count, 10);
  assert_int_equal(choice.cutting_count, 6);
  assert_true(choice.count > 0);
  const cut_candidate *best = &choice.candidates[0];
  assert_true(best->shape.a == 1 && best->shape.b == 1 && best->shape.rings == 0);
  assert_true(best->worst > 0.5);
  const int32_t *ring = cut_choice_ring(&choice, best);
  assert_int_equal(placed_cut_new(context, &body.s, ring, &best->shape, &cut), HEXCON_OK);
  assert_int_equal(cut_body_cut(context, &body, ring, &cut, &ball), HEXCON_OK);
  assert_true(ball.points && surface_is_sphere(&ball.s));
  assert_int_equal(ball.hex_count, 1);
  assert_int_equal(ball.s.quad_count, 24 - 4 + 2);
  assert_memory_equal(ball.points, s.points, 3 * s.point_count * sizeof *s.points);
  placed_cut_free(context, &cut);
  cut_choice_free(context, &choice);
  cut_body_free(context, &ball);
  cut_body_free(context, &body);
  surface_free(context, &s);
  test_mesh_free(&torus);
  hexcon_context_free(context);
}

/** After each cut the loops of the rest, also those through the discs, are told by carried labels
 * as by ones found anew. */
static void labels_are_carried(void **state) {
  static const char frame_cells[] = "######.#.#######.#.######"
                                    "######.#.#######.#.######";
  (void)state;
  hexcon_context *context = hexcon_context_new();
  test_mesh frame = make_cells(5, 5, 2, frame_cells);
  surface s = surface_of(context, &frame);
  cut_body body;
  assert_int_equal(cut_body_begin(context, &s, &body), HEXCON_OK);
  for (size_t handles = body_handle_count(&s); handles > 0; handles--) {
    cut_choice choice, anew;
    cut_body fresh, next;
    placed_cut cut;
    assert_int_equal(body_handle_count(&body.s), handles);
    assert_int_equal(cut_choice_find(context, &body, &choice), HEXCON_OK);
    assert_int_equal(cut_body_begin(context, &body.s, &fresh), HEXCON_OK);
    assert_int_equal(cut_choice_find(context, &fresh, &anew), HEXCON_OK);
    assert_int_equal(choice.cutting_count, anew.cutting_count);
    assert_true(choice.count > 0 && choice.candidates[0].loop == anew.candidates[0].loop);
    const int32_t *ring = cut_choice_ring(&choice, &choice.candidates[0]);
    assert_int_equal(placed_cut_new(context, &body.s, ring, &choice.candidates[0].shape, &cut),
                     HEXCON_OK);
    assert_int_equal(cut_body_cut(context, &body, ring, &cut, &next), HEXCON_OK);
    assert_non_null(next.points);
    cut_choice_free(context, &choice);
    cut_choice_free(context, &anew);
    placed_cut_free(context, &cut);
    cut_body_free(context, &fresh);
    cut_body_free(context, &body);
    body = next;
  }
  assert_true(surface_is_sphere(&body.s));
  cut_body_free(context, &body);
  surface_free(context, &s);
  test_mesh_free(&frame);
  hexcon_context_free(context);
}

/* ----------------------------------------------------------------------------------------- bodies
 */

static const hexcon_mesh_options sheets_alone = {
    .method = HEXCON_METHOD_SHEETS, .no_core = true, .pillow = HEXCON_PILLOW_NEVER};

static void expect_hexes(test_mesh mesh, size_t hex_count) {
  assert_filled(mesh, &sheets_alone, "sheets", hex_count);
}

static void bodies_with_holes(void **state) {
  (void)state;
  expect_hexes(make_tube(8, 2), 16);
  expect_hexes(make_tube(3, 1), 3);
  expect_hexes(make_torus(3, 4), 3);
  expect_hexes(make_torus(8, 8), 24);
  expect_hexes(make_cells(3, 3, 1, "####.####"), 8);
  expect_hexes(make_cells(5, 3, 1, "######.#.######"), 13);
  expect_hexes(make_cells(3, 3, 3,
                          "####.####"
                          "#.#...#.#"
                          "####.####"),
               20);
}

/** A torus whose rows round the tube are one helix: the other rows bound outside only. */
static test_mesh make_helical_torus(int m, int n) {
  test_mesh mesh = make_torus(m, n);
  for (int i = 0; i < m; i++)
    for (int j = 0; j < n; j++) {
      double u = 2 * 3.14159265358979 * (i + (double)j / n) / m, v = 2 * 3.14159265358979 * j / n;
      double *point = mesh.points + 3 * (i * n + j);
      point[0] = (3 + cos(v)) * cos(u);
      point[1] = (3 + cos(v)) * sin(u);
      point[2] = sin(v);
      int32_t *quad = mesh.quads + 4 * (i * n + j);
      for (int corner = 0; corner < 4; corner++)
        if (j == n - 1 && quad[corner] % n == 0)
          quad[corner] = (quad[corner] + n) % (m * n);
    }
  return mesh;
}

static void nothing_to_cut(void **state) {
  (void)state;
  test_mesh mesh = make_helical_torus(8, 5);
  hexcon_context *context = hexcon_context_new();
  hexcon_mesh *made = NULL;
  assert_int_equal(hexcon_mesh_surface(context, mesh.points, mesh.surface_point_count, mesh.quads,
                                       mesh.quad_count, &sheets_alone, &made),
                   HEXCON_NO_SHEETS);
  assert_null(made);
  assert_non_null(strstr(hexcon_context_message(context), "go round a handle"));
  hexcon_context_free(context);
  test_mesh_free(&mesh);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(discs),
      cmocka_unit_test(rows_of_discs),
      cmocka_unit_test(crossings_after_cuts),
      cmocka_unit_test(loops_that_cut),
      cmocka_unit_test(labels_are_carried),
      cmocka_unit_test(bodies_with_holes),
      cmocka_unit_test(nothing_to_cut),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
