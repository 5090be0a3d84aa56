/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Pairs that remove self-crossings: on the transitioned surface, quads and all, none is left. */
#include <stdlib.h>
#include <string.h>

#include "pairing/pair_crossings.h"
#include "pairing/pair_rewiring.h"
#include "support.h"
#include "surface/build.h"
#include "surface/loops.h"

/* --------------------------------------------------------------------------- the transition */

static size_t add_quad(int32_t *quads, size_t count, int32_t a, int32_t b, int32_t c, int32_t d) {
  int32_t *quad = quads + 4 * count;
  quad[0] = a;
  quad[1] = b;
  quad[2] = c;
  quad[3] = d;
  return count + 1;
}

/** The six quads of the pair at a half-edge; new points from `fresh` on. */
static size_t add_six(const surface *s, int32_t half_edge, int32_t fresh, int32_t *quads,
                      size_t count) {
  int32_t twin = s->twins[half_edge];
  int32_t v2 = half_edge_start(s, half_edge), v5 = half_edge_end(s, half_edge);
  int32_t v4 = half_edge_start(s, half_edge_turn(half_edge, 2));
  int32_t v1 = half_edge_end(s, half_edge_turn(half_edge, 2));
  int32_t v3 = half_edge_start(s, half_edge_turn(twin, 2));
  int32_t v6 = half_edge_end(s, half_edge_turn(twin, 2));
  int32_t v7 = fresh, v8 = fresh + 1, v9 = fresh + 2, v10 = fresh + 3;
  count = add_quad(quads, count, v1, v2, v7, v8);
  count = add_quad(quads, count, v7, v2, v3, v8);
  count = add_quad(quads, count, v1, v8, v9, v4);
  count = add_quad(quads, count, v8, v3, v6, v9);
  count = add_quad(quads, count, v4, v9, v10, v5);
  return add_quad(quads, count, v9, v6, v5, v10);
}

static size_t self_crossings_of(const int32_t *quads, size_t count) {
  hexcon_context *context = hexcon_context_new();
  hexcon_loops loops;
  size_t crossings = 0;
  hexcon_status status = hexcon_surface_loops(context, quads, count, &loops);
  assert_string_equal(hexcon_context_message(context), "");
  assert_int_equal(status, HEXCON_OK);
  for (size_t i = 0; i < loops.count; i++)
    crossings += loops.self_crossings[i];
  hexcon_loops_free(context, &loops);
  hexcon_context_free(context);
  return crossings;
}

/** Self-crossings after the transition of some pairs, found on its quads. */
static size_t crossings_after(const surface *s, const int32_t *half_edges) {
  int32_t *quads = calloc(4 * 4 * s->quad_count, sizeof *quads);
  assert_non_null(quads);
  int32_t fresh = (int32_t)s->point_count;
  size_t count = 0;
  for (size_t q = 0; q < s->quad_count; q++) {
    const int32_t *old = s->quads + 4 * q;
    if (half_edges[q] < 0) {
      count = add_quad(quads, count, old[0], old[1], old[2], old[3]);
      continue;
    }
    int32_t twin = s->twins[half_edges[q]];
    assert_int_equal(half_edge_quad(half_edges[q]), q);
    assert_int_equal(half_edges[half_edge_quad(twin)], twin);
    if (half_edges[q] < twin) {
      count = add_six(s, half_edges[q], fresh, quads, count);
      fresh += 4;
    }
  }
  size_t crossings = self_crossings_of(quads, count);
  free(quads);
  return crossings;
}

static size_t count_pairs(const surface *s, const int32_t *half_edges) {
  size_t count = 0;
  for (size_t q = 0; q < s->quad_count; q++)
    count += half_edges[q] >= 0;
  assert_int_equal(count % 2, 0);
  return count / 2;
}

/* ------------------------------------------------------------------------------------- tests */

/** Pairs of a surface, checked; frees the mesh. */
static size_t pairs_of(test_mesh mesh) {
  hexcon_context *context = hexcon_context_new();
  surface s;
  size_t pair_count;
  int32_t *half_edges = calloc(mesh.quad_count, sizeof *half_edges);
  assert_non_null(half_edges);
  assert_int_equal(surface_build(context, mesh.points, mesh.surface_point_count, mesh.quads,
                                 mesh.quad_count, &s),
                   HEXCON_OK);
  assert_int_equal(surface_pair_crossings(context, &s, half_edges, &pair_count), HEXCON_OK);
  assert_int_equal(count_pairs(&s, half_edges), pair_count);
  assert_int_equal(crossings_after(&s, half_edges), 0);
  surface_free(context, &s);
  hexcon_context_free(context);
  free(half_edges);
  test_mesh_free(&mesh);
  return pair_count;
}

static void surfaces(void **state) {
  (void)state;
  assert_int_equal(pairs_of(make_box(3, 4, 5)), 0);
  assert_int_equal(pairs_of(make_tube(6, 2)), 0);
  assert_int_equal(pairs_of(make_torus(5, 6)), 0);
  assert_int_equal(pairs_of(make_torus(3, 5)), 0); /* odd, but nothing is to be paired */
  assert_int_equal(pairs_of(make_trapezohedron()), 4);
  assert_int_equal(pairs_of(make_schneiders_pyramid()), 4);
}

/** Whatever is tried, taken or not, the loops kept up are those of the transitioned surface. */
static void changes(void **state) {
  (void)state;
  uint64_t random = 8;
  for (int round = 0; round < 2; round++) {
    test_mesh mesh = round ? make_schneiders_pyramid() : make_tube(3, 1);
    hexcon_context *context = hexcon_context_new();
    surface s;
    pair_rewiring r;
    assert_int_equal(surface_build(context, mesh.points, mesh.surface_point_count, mesh.quads,
                                   mesh.quad_count, &s),
                     HEXCON_OK);
    assert_int_equal(pair_rewiring_create(context, &s, &r), HEXCON_OK);
    pair_rewiring_set(&r, NULL);
    for (int i = 0; i < 2000; i++) {
      pair_change change;
      size_t crossings = r.crossing_count, pairs = r.pair_count;
      pair_rewiring_try(&r, (int32_t)random_below(&random, 4 * s.quad_count), &change);
      assert_int_equal(count_pairs(&s, r.half_edges), r.pair_count);
      assert_int_equal((int)r.pair_count - (int)pairs, change.more_pairs);
      assert_int_equal(crossings_after(&s, r.half_edges), (int)crossings + change.more_crossings);
      if (random_below(&random, 3) > 0)
        pair_rewiring_accept(&r, &change);
      else
        pair_rewiring_reject(&r, &change);
      assert_int_equal(crossings_after(&s, r.half_edges), r.crossing_count);
      int32_t quad = pair_rewiring_crossed_quad(&r, random_bits(&random));
      assert_int_equal(quad == PAIR_FREE, r.crossing_count == 0);
      assert_true(quad == PAIR_FREE || r.half_edges[quad] == PAIR_FREE);
    }
    pair_rewiring_free(&r);
    surface_free(context, &s);
    hexcon_context_free(context);
    test_mesh_free(&mesh);
  }
}

static bool refuse(void *user, const char *stage, double fraction) {
  size_t *left = user;
  assert_string_equal(stage, "pairing");
  assert_true(fraction >= 0 && fraction <= 1);
  return (*left)-- > 1;
}

static void public_call(void **state) {
  (void)state;
  test_mesh pyramid = make_schneiders_pyramid();
  hexcon_context *context = hexcon_context_new();
  int32_t pairs[16], again[16];
  size_t count, count_again, left = 1;
  for (int i = 0; i < 2; i++)
    assert_int_equal(hexcon_surface_pairing_of_crossings(
                         context, pyramid.point_count, pyramid.quads, pyramid.quad_count,
                         i ? again : pairs, i ? &count_again : &count),
                     HEXCON_OK);
  assert_int_equal(count, count_again);
  assert_memory_equal(pairs, again, 2 * count * sizeof *pairs);
  for (size_t i = 0; i < count; i++) {
    assert_true(pairs[2 * i] < pairs[2 * i + 1]);
    assert_true(i == 0 || pairs[2 * i - 2] < pairs[2 * i]);
  }
  hexcon_context_set_progress(context, refuse, &left);
  assert_int_equal(hexcon_surface_pairing_of_crossings(context, pyramid.point_count, pyramid.quads,
                                                       pyramid.quad_count, pairs, &count),
                   HEXCON_CANCELLED);
  assert_int_equal(count, 0);
  assert_message(context);
  hexcon_context_free(context);
  test_mesh_free(&pyramid);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(surfaces),
      cmocka_unit_test(changes),
      cmocka_unit_test(public_call),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
