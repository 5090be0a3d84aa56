/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The inward offset without a centre: how deep it goes, and that it meets nothing. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "shape/offset/crossing_triangles.h"
#include "shape/offset/inner_surface.h"
#include "shape/offset/inward_directions.h"
#include "shape/offset/inward_room.h"
#include "support.h"
#include "surface/build.h"

/** A surface and the copy inside it. */
typedef struct offset_case {
  hexcon_context *context;
  surface s;
  double *inner;
} offset_case;

static offset_case offset_of(const test_mesh *mesh, double thickness) {
  offset_case c = {.context = hexcon_context_new()};
  inner_surface_options options = {.thickness = thickness, .no_center = true};
  assert_int_equal(surface_build(c.context, mesh->points, mesh->surface_point_count, mesh->quads,
                                 mesh->quad_count, &c.s),
                   HEXCON_OK);
  c.inner = malloc(c.s.point_count * 3 * sizeof *c.inner);
  assert_int_equal(inner_surface_place(c.context, &c.s, &options, c.inner), HEXCON_OK);
  return c;
}

static void offset_free(offset_case *c) {
  free(c->inner);
  surface_free(c->context, &c->s);
  hexcon_context_free(c->context);
}

/* ----------------------------------------------------------------------- a judge of its own */

static double determinant(const double m[3][3]) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/** Solve from + t (to - from) = a + u (b - a) + v (c - a) by Cramer's rule. */
static bool segment_meets(const double *from, const double *to, const double *a, const double *b,
                          const double *c) {
  double columns[3][3], right[3], solved[3];
  for (int k = 0; k < 3; k++) {
    columns[k][0] = to[k] - from[k];
    columns[k][1] = a[k] - b[k];
    columns[k][2] = a[k] - c[k];
    right[k] = a[k] - from[k];
  }
  double whole = determinant(columns);
  if (fabs(whole) < 1e-14)
    return false;
  for (int i = 0; i < 3; i++) {
    double replaced[3][3];
    memcpy(replaced, columns, sizeof replaced);
    for (int k = 0; k < 3; k++)
      replaced[k][i] = right[k];
    solved[i] = determinant(replaced) / whole;
  }
  return solved[0] > 0 && solved[0] < 1 && solved[1] > 0 && solved[2] > 0 &&
         solved[1] + solved[2] < 1;
}

static const double *place_of(const offset_case *c, size_t triangle, size_t i) {
  static const size_t halves[2][3] = {{0, 1, 2}, {0, 2, 3}};
  size_t quads = c->s.quad_count, copy = triangle >= 2 * quads,
         of = copy ? triangle - 2 * quads : triangle;
  size_t point = (size_t)c->s.quads[4 * (of / 2) + halves[of % 2][i]];
  return (copy ? c->inner : c->s.points) + 3 * point;
}

static bool share_a_point(const offset_case *c, size_t a, size_t b) {
  const int32_t *p = c->s.quads + 4 * (a / 2 % c->s.quad_count);
  const int32_t *q = c->s.quads + 4 * (b / 2 % c->s.quad_count);
  for (size_t i = 0; i < 16; i++)
    if (p[i / 4] == q[i % 4])
      return true;
  return false;
}

/** Every triangle of the copy against every other of it and of the surface. */
static size_t count_crossings(const offset_case *c) {
  size_t outer = 2 * c->s.quad_count, count = 0;
  for (size_t a = outer; a < 2 * outer; a++)
    for (size_t b = 0; b < a; b++) {
      bool met = false;
      for (size_t i = 0; !share_a_point(c, a, b) && i < 3; i++)
        met |= segment_meets(place_of(c, a, i), place_of(c, a, (i + 1) % 3), place_of(c, b, 0),
                             place_of(c, b, 1), place_of(c, b, 2)) ||
               segment_meets(place_of(c, b, i), place_of(c, b, (i + 1) % 3), place_of(c, a, 0),
                             place_of(c, a, 1), place_of(c, a, 2));
      count += met;
    }
  return count;
}

/** Volume between the surface and its copy, as boxes whose corners are all positive. */
static void expect_boxes(const offset_case *c) {
  for (int32_t h = 0; h < (int32_t)(4 * c->s.quad_count); h++) {
    size_t v = (size_t)half_edge_start(&c->s, h);
    double rows[2][3][3];
    const int32_t ends[2] = {half_edge_end(&c->s, h),
                             half_edge_start(&c->s, half_edge_turn(h, -1))};
    for (int k = 0; k < 3; k++) {
      for (int i = 0; i < 2; i++) {
        rows[0][i][k] =
            c->s.points[3 * (size_t)ends[i] + (size_t)k] - c->s.points[3 * v + (size_t)k];
        rows[1][i][k] = c->inner[3 * (size_t)ends[i] + (size_t)k] - c->inner[3 * v + (size_t)k];
      }
      rows[0][2][k] = rows[1][2][k] = c->inner[3 * v + (size_t)k] - c->s.points[3 * v + (size_t)k];
    }
    assert_true(determinant(rows[0]) < 0 && determinant(rows[1]) < 0);
  }
}

/* -------------------------------------------------------------------------------------- tests */

static test_mesh make_plate(double height) {
  test_mesh plate = make_box(4, 4, 1);
  for (size_t v = 0; v < plate.surface_point_count; v++)
    plate.points[3 * v + 2] *= height;
  return plate;
}

static void a_cube_has_the_depth_that_is_wanted(void **state) {
  (void)state;
  test_mesh cube = make_box(3, 3, 3);
  offset_case c = offset_of(&cube, 0.25);
  for (size_t v = 0; v < c.s.point_count; v++)
    for (size_t k = 0; k < 3; k++) {
      double p = c.s.points[3 * v + k], inside = p < 0.5 ? 0.25 : p > 2.5 ? 2.75 : p;
      assert_close(c.inner[3 * v + k], inside, 1e-3);
    }
  offset_free(&c);
  test_mesh_free(&cube);
}

static void a_thin_plate_keeps_its_sides_apart(void **state) {
  (void)state;
  const double height = 0.1;
  test_mesh plate = make_plate(height);
  offset_case c = offset_of(&plate, 0.6);
  for (size_t v = 0; v < c.s.point_count; v++) {
    double below = c.s.points[3 * v + 2], inside = c.inner[3 * v + 2];
    assert_true(below < 0.05 ? inside > 0 && inside < 0.36 * height
                             : inside < height && inside > 0.64 * height);
  }
  assert_int_equal(count_crossings(&c), 0);
  expect_boxes(&c);
  offset_free(&c);
  test_mesh_free(&plate);
}

/** Offsets three edges deep would go through each other everywhere. */
static void nothing_is_crossed(void **state) {
  (void)state;
  test_mesh bodies[] = {make_torus(12, 6), make_tube(8, 2),
                        make_cells(4, 3, 2, "#####...#...#####...#..."),
                        make_cells(3, 3, 1, "####.#####"), make_plate(0.3)};
  for (size_t b = 0; b < sizeof bodies / sizeof *bodies; b++)
    for (int deep = 0; deep < 2; deep++) {
      offset_case c = offset_of(&bodies[b], deep ? 3 : 0.5);
      assert_int_equal(count_crossings(&c), 0);
      expect_boxes(&c);
      offset_free(&c);
    }
  for (size_t b = 0; b < sizeof bodies / sizeof *bodies; b++)
    test_mesh_free(&bodies[b]);
}

/** A cube's copy, of which one corner is pushed out through the opposite side. */
static void crossings_are_found(void **state) {
  (void)state;
  test_mesh cube = make_box(3, 3, 3);
  offset_case c = offset_of(&cube, 0.25);
  uint8_t *marked = calloc(c.s.point_count, 1);
  size_t count = 1, corner = 0;
  assert_int_equal(crossing_triangles_mark(c.context, &c.s, c.inner, marked, &count), HEXCON_OK);
  assert_int_equal(count, 0);
  assert_null(memchr(marked, 1, c.s.point_count));
  while (c.s.points[3 * corner] + c.s.points[3 * corner + 1] + c.s.points[3 * corner + 2] > 0)
    corner++;
  for (size_t k = 0; k < 3; k++)
    c.inner[3 * corner + k] = 3.3;
  assert_int_equal(crossing_triangles_mark(c.context, &c.s, c.inner, marked, &count), HEXCON_OK);
  assert_true(count > 0 && count_crossings(&c) > 0 && marked[corner]);
  free(marked);
  offset_free(&c);
  test_mesh_free(&cube);
}

static void room_is_the_way_to_the_other_side(void **state) {
  (void)state;
  test_mesh box = make_box(2, 3, 4);
  offset_case c = offset_of(&box, 0.25);
  double *directions = calloc(c.s.point_count, 3 * sizeof *directions);
  double *room = malloc(c.s.point_count * sizeof *room);
  for (size_t v = 0; v < c.s.point_count; v++) {
    directions[3 * v + 2] = 1;
    room[v] = v % 2 ? 10 : 1.5; /* some do not look so far */
  }
  assert_int_equal(inward_room_find(c.context, &c.s, directions, room), HEXCON_OK);
  for (size_t v = 0; v < c.s.point_count; v++) {
    const double *p = c.s.points + 3 * v;
    bool inside = p[0] > 0 && p[0] < 2 && p[1] > 0 && p[1] < 3;
    if (inside && p[2] < 1)
      assert_close(room[v], v % 2 ? 4 : 1.5, 1e-12);
    if (p[2] > 3) /* they start on the top, and look away from the box */
      assert_close(room[v], v % 2 ? 10 : 1.5, 0);
  }
  free(directions);
  free(room);
  offset_free(&c);
  test_mesh_free(&box);
}

/** At a point of a cube's corner, edge, face, and of a notch. */
static void directions_sink_all_planes_alike(void **state) {
  (void)state;
  test_mesh notched = make_cells(2, 2, 1, "###.");
  offset_case c = offset_of(&notched, 0.2);
  inward_directions in = {0};
  assert_int_equal(inward_directions_new(c.context, &c.s, &in), HEXCON_OK);
  for (size_t v = 0; v < c.s.point_count; v++) {
    double least = 2, length = 0;
    for (int32_t i = in.starts[v]; i < in.starts[v + 1]; i++) {
      const double *normal = in.normals + 3 * (size_t)in.corners[i];
      double sinking = 0;
      for (size_t k = 0; k < 3; k++)
        sinking -= normal[k] * in.directions[3 * v + k];
      least = fmin(least, sinking);
    }
    for (size_t k = 0; k < 3; k++)
      length += in.directions[3 * v + k] * in.directions[3 * v + k];
    assert_close(length, 1, 1e-12);
    assert_close(least, in.sinking[v], 1e-12);
    assert_true(least > 1 / sqrt(3) - 0.01); /* three planes at right angles at most */
  }
  inward_directions_free(c.context, &in);
  offset_free(&c);
  test_mesh_free(&notched);
}

static void without_memory(void **state) {
  (void)state;
  test_mesh torus = make_torus(6, 4);
  for (size_t fail_at = 1, done = 0; !done; fail_at++) {
    test_memory memory = {0};
    surface s;
    double inner[3 * 24];
    inner_surface_options options = {.thickness = 0.5, .no_center = true};
    hexcon_context *context = hexcon_context_new_with(test_reallocate, &memory);
    assert_int_equal(surface_build(context, torus.points, torus.surface_point_count, torus.quads,
                                   torus.quad_count, &s),
                     HEXCON_OK);
    memory.fail_at = memory.calls + fail_at;
    hexcon_status status = inner_surface_place(context, &s, &options, inner);
    done = memory.calls < memory.fail_at;
    assert_int_equal(status, done ? HEXCON_OK : HEXCON_OUT_OF_MEMORY);
    surface_free(context, &s);
    hexcon_context_free(context);
    assert_int_equal(memory.live, 0);
  }
  test_mesh_free(&torus);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(a_cube_has_the_depth_that_is_wanted),
      cmocka_unit_test(a_thin_plate_keeps_its_sides_apart),
      cmocka_unit_test(nothing_is_crossed),
      cmocka_unit_test(crossings_are_found),
      cmocka_unit_test(room_is_the_way_to_the_other_side),
      cmocka_unit_test(directions_sink_all_planes_alike),
      cmocka_unit_test(without_memory),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
