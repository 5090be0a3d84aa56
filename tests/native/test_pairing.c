/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Pairings: perfect wherever there is one, heavy, on surfaces and on graphs no surface has. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "pairing/pair_weights.h"
#include "pairing/pairing.h"
#include "support.h"
#include "surface/build.h"

/* ------------------------------------------------------------------------- 4-regular graphs */

enum { MOST_QUADS = 64 };

/** A graph given by its edges; surface_pair reads nothing else of a surface. */
typedef struct graph {
  int32_t twins[4 * MOST_QUADS];
  int32_t pairing[MOST_QUADS];
  double weights[4 * MOST_QUADS];
  int degrees[MOST_QUADS];
  surface s;
} graph;

static void start_graph(graph *g, size_t quad_count) {
  memset(g, 0, sizeof *g);
  assert_true(quad_count <= MOST_QUADS);
  g->s = (surface){.quad_count = quad_count, .twins = g->twins};
}

static void connect(graph *g, int a, int b, double weight) {
  int h = 4 * a + g->degrees[a]++, twin = 4 * b + g->degrees[b]++;
  assert_true(g->degrees[a] <= 4 && g->degrees[b] <= 4);
  g->twins[h] = twin;
  g->twins[twin] = h;
  g->weights[h] = g->weights[twin] = weight;
}

static void assert_perfect(const surface *s, const int32_t *pairing) {
  for (size_t q = 0; q < s->quad_count; q++) {
    assert_int_equal(half_edge_quad(pairing[q]), q);
    int32_t twin = s->twins[pairing[q]];
    assert_int_not_equal(half_edge_quad(twin), q);
    assert_int_equal(pairing[half_edge_quad(twin)], twin);
  }
}

static double total_weight(const graph *g) {
  double sum = 0;
  for (size_t q = 0; q < g->s.quad_count; q++)
    sum += g->weights[g->pairing[q]] / 2;
  return sum;
}

static hexcon_status pair_graph(graph *g, bool weighted) {
  for (size_t q = 0; q < g->s.quad_count; q++)
    assert_int_equal(g->degrees[q], 4);
  hexcon_context *context = hexcon_context_new();
  hexcon_status status = surface_pair(context, &g->s, weighted ? g->weights : NULL, g->pairing);
  if (status)
    assert_message(context);
  else
    assert_perfect(&g->s, g->pairing);
  hexcon_context_free(context);
  return status;
}

/** Greatest number of pairs, and their greatest weight, among the quads not in `gone`. */
static int best_by_trying(const graph *g, uint64_t gone, double *weight) {
  int32_t q = 0;
  *weight = 0;
  while (q < (int32_t)g->s.quad_count && gone >> q & 1)
    q++;
  if (q == (int32_t)g->s.quad_count)
    return 0;
  int most = best_by_trying(g, gone | UINT64_C(1) << q, weight); /* q left over */
  for (int32_t h = 4 * q; h < 4 * q + 4; h++) {
    int32_t other = half_edge_quad(g->twins[h]);
    double rest;
    if (other == q || gone >> other & 1)
      continue;
    int count = 1 + best_by_trying(g, gone | UINT64_C(1) << q | UINT64_C(1) << other, &rest);
    rest += g->weights[h];
    if (count > most || (count == most && rest > *weight))
      *weight = rest;
    most = count > most ? count : most;
  }
  return most;
}

/** Half-edges joined at random: with loops, parallel edges and parts, all that may go wrong. */
static void make_random_graph(graph *g, size_t quad_count, uint64_t *random) {
  int32_t ends[4 * MOST_QUADS];
  start_graph(g, quad_count);
  for (size_t i = 0; i < 4 * quad_count; i++) {
    size_t j = random_below(random, i + 1);
    ends[i] = ends[j];
    ends[j] = (int32_t)(i / 4);
  }
  for (size_t i = 0; i < 4 * quad_count; i += 2)
    connect(g, ends[i], ends[i + 1], random_between(random, -1, 1));
}

static void random_graphs(void **state) {
  (void)state;
  uint64_t random = 5;
  int imperfect = 0;
  double gap = 0;
  for (int round = 0; round < 3000; round++) {
    graph g;
    double best;
    make_random_graph(&g, 2 + 2 * random_below(&random, 5), &random);
    bool perfect = 2 * best_by_trying(&g, 0, &best) == (int)g.s.quad_count;
    assert_int_equal(pair_graph(&g, false), perfect ? HEXCON_OK : HEXCON_NO_PAIRING);
    assert_int_equal(pair_graph(&g, true), perfect ? HEXCON_OK : HEXCON_NO_PAIRING);
    imperfect += !perfect;
    if (perfect) {
      assert_true(total_weight(&g) <= best + 1e-12);
      gap += best - total_weight(&g);
    }
  }
  assert_true(imperfect > 20); /* the error is tried, too */
  assert_true(gap / 3000 < 0.02);
}

/** Five quads, all joined to each other but the first two: what is left of a cut of two edges. */
static void add_knot(graph *g, int first) {
  for (int a = 0; a < 5; a++)
    for (int b = 0; b < a; b++)
      if (a != 1 || b != 0)
        connect(g, first + a, first + b, 0);
}

/** Four odd knots hang on two quads: two of them must stay incomplete, though all is connected. */
static void no_pairing_of_one_part(void **state) {
  (void)state;
  graph g;
  start_graph(&g, 22);
  for (int i = 0; i < 4; i++) {
    add_knot(&g, 2 + 5 * i);
    connect(&g, i / 2, 2 + 5 * i, 0);
    connect(&g, i % 2, 3 + 5 * i, 0);
  }
  assert_int_equal(pair_graph(&g, false), HEXCON_NO_PAIRING);
}

/** A ring of knots: each is odd, so blossoms have to be passed through on the way to the next. */
static void blossoms_in_a_ring(void **state) {
  (void)state;
  for (int count = 2; count <= 12; count += 2) {
    graph g;
    start_graph(&g, (size_t)(5 * count));
    for (int i = 0; i < count; i++)
      add_knot(&g, 5 * i);
    for (int i = 0; i < count; i++)
      connect(&g, 5 * i, (5 * i + 6) % (5 * count), i % 2 ? 1 : 0.5);
    assert_int_equal(pair_graph(&g, false), HEXCON_OK);
    assert_int_equal(pair_graph(&g, true), HEXCON_OK);
    assert_close(total_weight(&g), count / 2, 1e-12); /* every other link, the heavy ones */
  }
}

/** Two quads that share all their edges, and the heaviest is meant. */
static void parallel_edges(void **state) {
  (void)state;
  graph g;
  start_graph(&g, 2);
  for (int i = 0; i < 4; i++)
    connect(&g, 0, 1, i == 2);
  assert_int_equal(pair_graph(&g, true), HEXCON_OK);
  assert_int_equal(g.pairing[0], 2);
  start_graph(&g, 2);
  connect(&g, 0, 0, 9); /* a quad is no neighbour of its own */
  connect(&g, 0, 1, 0);
  connect(&g, 0, 1, 1);
  connect(&g, 1, 1, 9);
  assert_int_equal(pair_graph(&g, true), HEXCON_OK);
  assert_close(total_weight(&g), 1, 0);
}

/** Every second link of a ring is slightly heavier: a start from greedy choices has to turn it. */
static void long_cycle(void **state) {
  (void)state;
  graph g;
  start_graph(&g, 40);
  for (int q = 0; q < 40; q++) {
    connect(&g, q, (q + 1) % 40, q == 6 ? 1.5 : q % 2 ? 1 : 0.99);
    connect(&g, q, (q + 7) % 40, -100); /* of no use */
  }
  assert_int_equal(pair_graph(&g, true), HEXCON_OK);
  assert_close(total_weight(&g), 19 * 0.99 + 1.5, 1e-12);
}

/* --------------------------------------------------------------------------------- surfaces */

/** Pairs of a surface's public call; frees the mesh. Returns its status. */
static hexcon_status pair_surface(test_mesh mesh, bool with_points) {
  hexcon_context *context = hexcon_context_new();
  int32_t *pairs = calloc(mesh.quad_count, sizeof *pairs);
  uint8_t *seen = calloc(mesh.quad_count, 1);
  assert_true(pairs && seen);
  hexcon_status status =
      hexcon_surface_pairing(context, with_points ? mesh.points : NULL, mesh.surface_point_count,
                             mesh.quads, mesh.quad_count, pairs);
  for (size_t i = 0; !status && i < mesh.quad_count; i++)
    assert_int_equal(seen[pairs[i]]++, 0);
  for (size_t i = 0; !status && i < mesh.quad_count; i += 2) {
    assert_true(pairs[i] < pairs[i + 1]);
    assert_true(i == 0 || pairs[i - 2] < pairs[i]);
    int shared = 0;
    for (int a = 0; a < 4; a++)
      for (int b = 0; b < 4; b++)
        shared += mesh.quads[4 * pairs[i] + a] == mesh.quads[4 * pairs[i + 1] + b];
    assert_true(shared >= 2);
  }
  if (status)
    assert_message(context);
  hexcon_context_free(context);
  free(pairs);
  free(seen);
  test_mesh_free(&mesh);
  return status;
}

static void surfaces(void **state) {
  (void)state;
  for (int with_points = 0; with_points < 2; with_points++) {
    for (int n = 1; n < 8; n++) {
      assert_int_equal(pair_surface(make_box(1, n, 2 * n - 1), with_points), HEXCON_OK);
      assert_int_equal(pair_surface(make_box(n, n, n), with_points), HEXCON_OK);
      assert_int_equal(pair_surface(make_tube(n + 2, 1), with_points), HEXCON_OK);
    }
    assert_int_equal(pair_surface(make_torus(5, 6), with_points), HEXCON_OK);
    assert_int_equal(pair_surface(make_trapezohedron(), with_points), HEXCON_OK);
    assert_int_equal(pair_surface(make_schneiders_pyramid(), with_points), HEXCON_OK);
    assert_int_equal(pair_surface(make_cells(3, 1, 1, "#.#"), with_points), HEXCON_OK);
    assert_int_equal(pair_surface(make_torus(3, 5), with_points), HEXCON_ODD);
  }
}

/** Two tori of 9 quads each: even in all, but not one by one. */
static void odd_parts(void **state) {
  (void)state;
  test_mesh torus = make_torus(3, 3);
  double points[18][3];
  int32_t quads[18][4];
  for (int i = 0; i < 18; i++)
    for (int k = 0; k < 4; k++) {
      quads[i][k] = torus.quads[4 * (i % 9) + k] + (i < 9 ? 0 : 9);
      if (k < 3)
        points[i][k] = torus.points[3 * (i % 9) + k] + (i < 9 ? 0 : 20);
    }
  test_mesh_free(&torus);
  hexcon_context *context = hexcon_context_new();
  int32_t pairs[18];
  const int32_t *left;
  assert_int_equal(hexcon_surface_pairing(context, NULL, 18, quads[0], 18, pairs),
                   HEXCON_NO_PAIRING);
  assert_message(context);
  assert_int_equal(hexcon_context_elements(context, &left), 2);
  assert_true(left[0] < 9 && left[1] >= 9);
  hexcon_context_free(context);
  assert_int_equal(
      pair_surface(make_surface((const double(*)[3])points, 18, (const int32_t(*)[4])quads, 18),
                   true),
      HEXCON_NO_PAIRING);
}

/** Folds that a box's pairs cannot do without: its six sides are odd. */
static void fewest_folds(void **state) {
  (void)state;
  test_mesh box = make_box(5, 5, 5);
  hexcon_context *context = hexcon_context_new();
  int32_t pairs[150];
  int folds = 0;
  assert_int_equal(hexcon_surface_pairing(context, box.points, box.surface_point_count, box.quads,
                                          box.quad_count, pairs),
                   HEXCON_OK);
  surface s;
  assert_int_equal(
      surface_build(context, box.points, box.surface_point_count, box.quads, box.quad_count, &s),
      HEXCON_OK);
  double weights[600];
  surface_pair_weights(&s, weights);
  for (int i = 0; i < 75; i++)
    for (int32_t h = 4 * pairs[2 * i]; h < 4 * pairs[2 * i] + 4; h++)
      if (half_edge_quad(s.twins[h]) == pairs[2 * i + 1])
        folds += weights[h] < -1;
  assert_int_equal(folds, 3);
  surface_free(context, &s);
  hexcon_context_free(context);
  test_mesh_free(&box);
}

static void shape_weights(void **state) {
  (void)state;
  test_mesh box = make_box(2, 2, 2);
  for (size_t v = 0; v < box.surface_point_count; v++)
    box.points[3 * v] *= 4; /* quads four times as long as wide */
  hexcon_context *context = hexcon_context_new();
  surface s;
  double weights[4 * 24];
  assert_int_equal(
      surface_build(context, box.points, box.surface_point_count, box.quads, box.quad_count, &s),
      HEXCON_OK);
  surface_pair_weights(&s, weights);
  for (int32_t h = 0; h < 96; h++) {
    double lowest = weights[h] <= 0 ? weights[h] : NAN;
    assert_close(lowest, weights[s.twins[h]], 0);
    const double *a = s.points + 3 * half_edge_start(&s, h);
    const double *b = s.points + 3 * half_edge_end(&s, h);
    bool is_long = fabs(a[0] - b[0]) > 1;
    const double *n = s.points + 3 * half_edge_end(&s, half_edge_turn(h, 1));
    if (fabs(n[0] - b[0]) > 1) /* across the short edge of a long quad: 1 to 8 */
      assert_true(lowest <= -9.0 / 8 + 1e-12);
    else if (is_long && lowest > -0.9) /* flat, across the long one: 4 to 2 */
      assert_close(lowest, -1.0 / 8, 1e-12);
  }
  memset(box.points, 0, 3 * box.surface_point_count * sizeof *box.points);
  surface_pair_weights(&s, weights); /* all points in one: finite all the same */
  for (int h = 0; h < 96; h++)
    assert_true(isfinite(weights[h]));
  surface_free(context, &s);
  hexcon_context_free(context);
  test_mesh_free(&box);
}

typedef struct patience {
  const char *stage; /* whose reports are counted */
  size_t left;
} patience;

static bool refuse(void *user, const char *stage, double fraction) {
  patience *p = user;
  assert_true(!strcmp(stage, "checks") || !strcmp(stage, "pairing"));
  assert_true(fraction >= 0 && fraction <= 1);
  return strcmp(stage, p->stage) != 0 || p->left-- > 1;
}

/** Progress is told in all stages of a surface large enough to wait for, the checks before them
 * too. */
static void cancelled(void **state) {
  (void)state;
  const int32_t rings = 300, sectors = 300;
  test_mesh torus = make_torus(rings, sectors);
  uint64_t random = 3;
  for (size_t i = 0; i < 3 * torus.point_count; i++)
    torus.points[i] += random_between(&random, -0.02, 0.02);
  int32_t *pairs = calloc(torus.quad_count, sizeof *pairs);
  assert_non_null(pairs);
  hexcon_context *context = hexcon_context_new();
  for (size_t count = 0; count < 5; count++) {
    patience p = {count ? "pairing" : "checks", count ? count : 1};
    hexcon_context_set_progress(context, refuse, &p);
    assert_int_equal(hexcon_surface_pairing(context, torus.points, torus.point_count, torus.quads,
                                            torus.quad_count, pairs),
                     HEXCON_CANCELLED);
    assert_int_equal(p.left, 0);
  }
  hexcon_context_free(context);
  free(pairs);
  test_mesh_free(&torus);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(random_graphs),      cmocka_unit_test(no_pairing_of_one_part),
      cmocka_unit_test(blossoms_in_a_ring), cmocka_unit_test(parallel_edges),
      cmocka_unit_test(long_cycle),         cmocka_unit_test(surfaces),
      cmocka_unit_test(odd_parts),          cmocka_unit_test(fewest_folds),
      cmocka_unit_test(shape_weights),      cmocka_unit_test(cancelled),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
