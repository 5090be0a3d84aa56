/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Subdivided surfaces: reading them, what is no subdivision, and filling small ones. */
#include <math.h>
#include <string.h>

#include "construct/coarse_front.h"
#include "construct/coarse_ways.h"
#include "support.h"
#include "surface/build.h"

/* ---------------------------------------------------------------------------------- surfaces */

enum { MOST_FACES = 32, MOST_POINTS = 128 };

static int32_t put_mean(double (*points)[3], int32_t *count, const int32_t *of, size_t size) {
  double *to = points[*count];
  memset(to, 0, 3 * sizeof *to);
  for (size_t i = 0; i < size; i++)
    for (size_t k = 0; k < 3; k++)
      to[k] += points[of[i]][k] / (double)size;
  return (*count)++;
}

/** Every edge halved, every face of 3 or 4 corners (-1 last) cut about its mean. */
static test_mesh subdivide(const double (*corners)[3], int32_t corner_count,
                           const int32_t (*faces)[4], size_t face_count) {
  double points[MOST_POINTS][3];
  int32_t quads[4 * MOST_FACES][4], middles[MOST_POINTS][MOST_POINTS], count = corner_count;
  size_t quad_count = 0;
  memset(middles, -1, sizeof middles);
  memcpy(points, corners, (size_t)corner_count * sizeof *points);
  for (size_t f = 0; f < face_count; f++) {
    size_t size = faces[f][3] < 0 ? 3 : 4;
    int32_t center = put_mean(points, &count, faces[f], size), sides[4];
    for (size_t i = 0; i < size; i++) {
      int32_t ends[2] = {faces[f][i], faces[f][(i + 1) % size]};
      if (middles[ends[1]][ends[0]] < 0)
        middles[ends[0]][ends[1]] = middles[ends[1]][ends[0]] = put_mean(points, &count, ends, 2);
      sides[i] = middles[ends[1]][ends[0]];
    }
    for (size_t i = 0; i < size; i++, quad_count++) {
      const int32_t quad[4] = {faces[f][i], sides[i], center, sides[(i + size - 1) % size]};
      memcpy(quads[quad_count], quad, sizeof quad);
    }
  }
  return make_surface((const double(*)[3])points, (size_t)count, (const int32_t(*)[4])quads,
                      quad_count);
}

static test_mesh make_diced_tetrahedron(void) {
  static const double corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 1}};
  static const int32_t faces[4][4] = {{0, 2, 1, -1}, {0, 1, 3, -1}, {1, 2, 3, -1}, {2, 0, 3, -1}};
  return subdivide(corners, 4, faces, 4);
}

static test_mesh make_diced_octahedron(void) {
  static const double corners[6][3] = {{1, 0, 0},  {0, 1, 0}, {-1, 0, 0},
                                       {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  static const int32_t faces[8][4] = {{0, 1, 4, -1}, {1, 2, 4, -1}, {2, 3, 4, -1}, {3, 0, 4, -1},
                                      {1, 0, 5, -1}, {2, 1, 5, -1}, {3, 2, 5, -1}, {0, 3, 5, -1}};
  return subdivide(corners, 6, faces, 8);
}

/** A prism over a triangle: two triangles and three quads. */
static test_mesh make_diced_prism(void) {
  static const double corners[6][3] = {{0, 0, 0}, {1, 0, 0}, {0.4, 0.9, 0},
                                       {0, 0, 1}, {1, 0, 1}, {0.4, 0.9, 1}};
  static const int32_t faces[5][4] = {
      {0, 2, 1, -1}, {3, 4, 5, -1}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
  return subdivide(corners, 6, faces, 5);
}

static void build(hexcon_context *context, const test_mesh *m, surface *s) {
  assert_int_equal(
      surface_build(context, m->points, m->surface_point_count, m->quads, m->quad_count, s),
      HEXCON_OK);
}

/* ----------------------------------------------------------------------------------- reading */

/** Every quad is named once by a face's corner, two middles and the centre, in order. */
static void assert_covers(const surface *s, const coarse_surface *c) {
  size_t met = 0;
  for (size_t f = 0; f < c->triangle_count + c->quad_count; f++) {
    size_t size = f < c->triangle_count ? 3 : 4;
    for (size_t i = 0; i < size; i++, met++) {
      const int32_t expected[4] = {c->points[c->faces[4 * f + i]], c->middles[4 * f + i],
                                   c->centers[f], c->middles[4 * f + (i + size - 1) % size]};
      bool found = false;
      for (size_t q = 0; q < s->quad_count; q++)
        for (size_t turn = 0; turn < 4; turn++) {
          bool same = true;
          for (size_t k = 0; k < 4; k++)
            same &= s->quads[4 * q + (k + turn) % 4] == expected[k];
          found |= same;
        }
      assert_true(found);
    }
    if (size == 3)
      assert_true(c->faces[4 * f + 3] == -1 && c->middles[4 * f + 3] == -1);
  }
  assert_int_equal(met, s->quad_count);
}

static void reading(test_mesh m, size_t triangles, size_t quads) {
  hexcon_context *context = hexcon_context_new();
  surface s;
  build(context, &m, &s);
  coarse_ways ways;
  assert_int_equal(coarse_ways_find(context, &s, &ways), HEXCON_OK);
  assert_true(ways.count > 0);
  coarse_surface c;
  assert_int_equal(coarse_surface_read(context, &s, ways.of_shells, &c, NULL), HEXCON_OK);
  assert_int_equal(c.triangle_count, triangles);
  assert_int_equal(c.quad_count, quads);
  assert_covers(&s, &c);
  coarse_surface_free(context, &c);
  surface_free(context, &s);
  coarse_ways_free(context, &ways);
  test_mesh_free(&m);
  hexcon_context_free(context);
}

static void subdivisions_are_read(void **state) {
  (void)state;
  reading(make_diced_tetrahedron(), 4, 0);
  reading(make_diced_octahedron(), 8, 0);
  reading(make_diced_prism(), 6, 0); /* all its corners are of three quads: as its dual */
  reading(make_schneiders_pyramid(), 4, 1);
  reading(make_torus(6, 8), 0, 12);
  reading(make_pentagonal_prism(2), 10, 0); /* its caps' middles are corners of five triangles */
  reading(make_box(2, 2, 2), 8, 0); /* an octahedron: the corners are centres of triangles */
  reading(make_box(4, 4, 2), 0, 16);
}

/** A box of 4 * 4 * 4 can be read about its corners as well as between them. */
static void ways_are_ranked(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  test_mesh m = make_box(4, 4, 4);
  surface s;
  build(context, &m, &s);
  coarse_ways ways;
  assert_int_equal(coarse_ways_find(context, &s, &ways), HEXCON_OK);
  assert_int_equal(ways.count, 2);
  coarse_surface c[2];
  for (size_t i = 0; i < 2; i++)
    assert_int_equal(coarse_surface_read(context, &s, ways.of_shells + i, &c[i], NULL), HEXCON_OK);
  assert_close(c[0].departure, 0, 1e-12); /* the straight one first */
  assert_int_equal(c[0].quad_count, 24);
  assert_int_equal(c[1].triangle_count, 8);
  assert_true(c[1].departure > 0.01);
  for (size_t i = 0; i < 2; i++)
    coarse_surface_free(context, &c[i]);
  surface_free(context, &s);
  coarse_ways_free(context, &ways);
  test_mesh_free(&m);
  hexcon_context_free(context);
}

static void refusal(test_mesh m) {
  hexcon_context *context = hexcon_context_new();
  surface s;
  build(context, &m, &s);
  coarse_ways ways;
  assert_int_equal(coarse_ways_find(context, &s, &ways), HEXCON_NOT_DICED);
  assert_int_equal(ways.count, 0);
  assert_message(context);
  const int32_t *elements;
  assert_true(hexcon_context_elements(context, &elements) > 0);
  for (size_t i = 0; i < hexcon_context_elements(context, &elements); i++)
    assert_in_range(elements[i], 0, m.quad_count - 1);
  surface_free(context, &s);
  coarse_ways_free(context, &ways);
  test_mesh_free(&m);
  hexcon_context_free(context);
}

static void others_are_refused(void **state) {
  (void)state;
  refusal(make_box(1, 1, 1));
  refusal(make_box(3, 2, 4));
  refusal(make_box(3, 3, 3));
  refusal(make_trapezohedron());
  refusal(make_pentagonal_prism(3));
  refusal(make_torus(3, 4));
  refusal(make_torus(4, 4)); /* its two coarse edges around share their ends */
}

/* ----------------------------------------------------------------------------------- filling */

/** The front is closed, and seen from the same side everywhere: every edge once either way. */
static void fronts_are_closed(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  test_mesh m = make_schneiders_pyramid();
  surface s;
  build(context, &m, &s);
  coarse_ways ways;
  coarse_surface c;
  coarse_front front;
  assert_int_equal(coarse_ways_find(context, &s, &ways), HEXCON_OK);
  assert_int_equal(coarse_surface_read(context, &s, ways.of_shells, &c, NULL), HEXCON_OK);
  assert_int_equal(coarse_front_of_pyramids(context, &c, s.point_count, &front), HEXCON_OK);
  assert_int_equal(front.triangle_count, 4 + 4 * 1);
  assert_int_equal(front.point_count, 5 + 1);
  for (size_t i = 0; i < 3 * front.triangle_count; i++) {
    size_t j = i / 3 * 3 + (i + 1) % 3, found = 0;
    for (size_t a = 0; a < 3 * front.triangle_count; a++) {
      size_t b = a / 3 * 3 + (a + 1) % 3;
      if (front.triangles[a] != front.triangles[j] || front.triangles[b] != front.triangles[i])
        continue;
      found++;
      assert_int_equal(front.side_middles[a], front.side_middles[i]);
    }
    assert_int_equal(found, 1);
  }
  coarse_front_free(context, &front);
  coarse_surface_free(context, &c);
  surface_free(context, &s);
  coarse_ways_free(context, &ways);
  test_mesh_free(&m);
  hexcon_context_free(context);
}

static void filling(test_mesh m, size_t hexes, double worst) {
  hexcon_context *context = hexcon_context_new();
  hexcon_mesh *mesh = NULL;
  const hexcon_mesh_options options = {
      .method = HEXCON_METHOD_DICED, .pillow = HEXCON_PILLOW_NEVER, .threads = 1};
  hexcon_status status = hexcon_mesh_surface(context, m.points, m.surface_point_count, m.quads,
                                             m.quad_count, &options, &mesh);
  if (status)
    fail_msg("%s", hexcon_context_message(context));
  assert_certified_mesh(context, &m, mesh);
  assert_string_equal(hexcon_mesh_method(mesh), "diced");
  assert_int_equal(hexcon_mesh_hex_count(mesh), hexes);
  for (size_t h = 0; h < hexes; h++)
    assert_true(hexcon_mesh_quality(mesh)[h] >= worst);
  hexcon_mesh_free(context, mesh);
  test_mesh_free(&m);
  hexcon_context_free(context);
}

static void small_ones_are_filled(void **state) {
  (void)state;
  filling(make_diced_tetrahedron(), 4, 0.4); /* itself */
  filling(make_diced_octahedron(), 8 * 4, 0.3);
  filling(make_box(2, 2, 2), 8 * 4, 0.5);
  filling(make_diced_prism(), 6 * 4, 0.3);
  filling(make_box(4, 4, 2), 16 * (26 + 2 * 4), 0.1);
  filling(make_schneiders_pyramid(), 4 * 4 + 36 + 4 * 4, 0.1);
}

/** No point sees all of it, and there is no mesher. */
static void no_way_inside(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  test_mesh m = make_torus(6, 8);
  hexcon_mesh *mesh = NULL;
  const hexcon_mesh_options options = {.method = HEXCON_METHOD_DICED};
  assert_int_equal(
      hexcon_mesh_surface(context, m.points, m.point_count, m.quads, m.quad_count, &options, &mesh),
      HEXCON_NOT_STAR_SHAPED);
  assert_message(context);
  assert_null(mesh);
  test_mesh_free(&m);
  hexcon_context_free(context);
}

/* ------------------------------------------------------------------- without memory or patience */

/** A mesher's result, kept by its caller. */
typedef struct star_mesher {
  double center[3];
  int32_t tetrahedra[4 * 64];
} star_mesher;

static bool make_star(void *user, const double *points, size_t point_count,
                      const int32_t *triangles, size_t triangle_count, hexcon_tetrahedra *out) {
  star_mesher *m = user;
  assert_true(triangle_count <= 64);
  memset(m->center, 0, sizeof m->center);
  for (size_t i = 0; i < 3 * point_count; i++)
    m->center[i % 3] += points[i] / (double)point_count;
  for (size_t t = 0; t < triangle_count; t++) {
    const int32_t *from = triangles + 3 * t;
    int32_t to[4] = {from[0], from[2], from[1], (int32_t)point_count};
    memcpy(m->tetrahedra + 4 * t, to, sizeof to);
  }
  *out = (hexcon_tetrahedra){1, m->center, triangle_count, m->tetrahedra};
  return true;
}

static hexcon_status mesh_pyramid(hexcon_context *context) {
  test_mesh m = make_schneiders_pyramid();
  hexcon_mesh *mesh = NULL;
  star_mesher mesher;
  const hexcon_mesh_options options = {.method = HEXCON_METHOD_DICED,
                                       .threads = 1,
                                       .tetrahedralise = make_star,
                                       .tetrahedralise_user = &mesher};
  hexcon_status status =
      hexcon_mesh_surface(context, m.points, m.point_count, m.quads, m.quad_count, &options, &mesh);
  assert_true((status == HEXCON_OK) == (mesh != NULL));
  hexcon_mesh_free(context, mesh);
  test_mesh_free(&m);
  return status;
}

/** Every one of the first, then a few: each costs all that comes before it. */
static void out_of_memory(void **state) {
  (void)state;
  test_memory all = {0};
  hexcon_context *context = hexcon_context_new_with(test_reallocate, &all);
  assert_int_equal(mesh_pyramid(context), HEXCON_OK);
  hexcon_context_free(context);
  size_t tried = 0;
  for (size_t k = 2; k < all.calls; k += k < 120 ? 1 : all.calls / 8, tried++) {
    test_memory memory = {.fail_at = k};
    context = hexcon_context_new_with(test_reallocate, &memory);
    assert_int_equal(mesh_pyramid(context), HEXCON_OUT_OF_MEMORY);
    assert_message(context);
    assert_int_equal(memory.live, 1);
    hexcon_context_free(context);
    assert_int_equal(memory.live, 0);
  }
  print_message("%zu of %zu allocations fail\n", tried, all.calls);
}

static void cancellation(void **state) {
  (void)state;
  for (size_t k = 1; k < 40; k += 6) {
    test_memory memory = {0};
    test_patience left = {.cancel_at = k};
    hexcon_context *context = hexcon_context_new_with(test_reallocate, &memory);
    hexcon_context_set_progress(context, lose_patience, &left);
    hexcon_status status = mesh_pyramid(context);
    assert_int_equal(status, left.calls >= k ? HEXCON_CANCELLED : HEXCON_OK);
    hexcon_context_free(context);
    assert_int_equal(memory.live, 0);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(subdivisions_are_read), cmocka_unit_test(ways_are_ranked),
      cmocka_unit_test(others_are_refused),    cmocka_unit_test(fronts_are_closed),
      cmocka_unit_test(small_ones_are_filled), cmocka_unit_test(no_way_inside),
      cmocka_unit_test(out_of_memory),         cmocka_unit_test(cancellation),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
