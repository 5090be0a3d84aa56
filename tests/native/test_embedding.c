/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Patches that cross, touch or keep apart, and the steps that tell: each against something
 * simpler. */
#include <math.h>
#include <string.h>

#include "embedding/box_tree.h"
#include "embedding/coincident_points.h"
#include "embedding/flat_quads.h"
#include "embedding/orientation.h"
#include "embedding/patch_pair.h"
#include "embedding/separation.h"
#include "support.h"

/* ------------------------------------------------------------------------------------ predicates
 */

static void orientation_of_near_planes(void **state) {
  (void)state;
  const double a[3] = {0, 0, 0}, b[3] = {1, 0, 0}, c[3] = {0, 1, 0};
  const double heights[] = {0, 0x1p-1000, -0x1p-1000, 1e-30, -1};
  const int signs[] = {0, 1, -1, 1, -1};
  for (int i = 0; i < 5; i++) {
    const double d[3] = {0.3, 0.1, heights[i]};
    assert_int_equal(orientation_in_space(a, b, c, d), signs[i]);
  }
  /* 0.1, 0.2, 0.3 are not on a line as doubles: 0.1 + 0.2 is above 0.3 */
  const double p[3] = {0.1, 0.1, 0}, q[3] = {0.2, 0.2, 0}, r[3] = {0.3, 0.3, 0},
               s[3] = {0.1 + 0.2, 0.3, 0};
  assert_int_equal(orientation_along(2, p, q, r), 0);
  assert_int_equal(orientation_along(2, p, q, s), -1);
}

static void separation_finds_directions(void **state) {
  (void)state;
  uint64_t random = 7;
  for (int round = 0; round < 300; round++) {
    double vectors[8][3], hidden[3], found[3];
    for (int k = 0; k < 3; k++)
      hidden[k] = random_between(&random, -1, 1);
    for (int i = 0; i < 8; i++) {
      double along = 0, square = 0;
      for (int k = 0; k < 3; k++) {
        vectors[i][k] = random_between(&random, -1, 1);
        along += vectors[i][k] * hidden[k];
        square += hidden[k] * hidden[k];
      }
      for (int k = 0; k < 3; k++) /* all forward along the hidden direction, by at least 1e-3 */
        vectors[i][k] += hidden[k] * (fabs(along) - along + 1e-3) / square;
    }
    assert_true(separation_direction((const double(*)[3])vectors, 8, found));
    for (int i = 0; i < 8; i++)
      assert_true(vectors[i][0] * found[0] + vectors[i][1] * found[1] + vectors[i][2] * found[2] >
                  0);
  }
  const double around[4][3] = {{1, 0, 0}, {-1, 1, 0}, {-1, -1, 1}, {0, 0, -1}};
  double found[3];
  assert_false(separation_direction(around, 4, found));
}

/* ------------------------------------------------------------------------------------------ boxes
 */

enum { BOXES = 700 };

typedef struct seen_pairs {
  uint8_t seen[BOXES][BOXES];
  size_t visits;
} seen_pairs;

static hexcon_status note_pair(void *user, hexcon_context *context, int32_t a, int32_t b) {
  seen_pairs *pairs = user;
  (void)context;
  pairs->seen[a][b]++;
  pairs->seen[b][a]++;
  pairs->visits++;
  return HEXCON_OK;
}

/** Every pair once, whatever the sizes: as all are compared with all. */
static void box_tree_finds_all_pairs(void **state) {
  (void)state;
  static box boxes[BOXES];
  static seen_pairs pairs;
  hexcon_context *context = hexcon_context_new();
  assert_non_null(context);
  for (size_t count = 1; count <= BOXES; count = 3 * count + 1) {
    uint64_t random = count;
    for (size_t i = 0; i < count; i++)
      for (int k = 0; k < 3; k++) {
        double size = pow(10, random_between(&random, -4, 0));
        boxes[i].low[k] = i % 5 == 0 ? 0.5 : random_between(&random, -1, 1);
        boxes[i].high[k] = boxes[i].low[k] + (i % 7 == 0 ? 0 : size);
      }
    memset(&pairs, 0, sizeof pairs);
    assert_int_equal(
        box_tree_visit_pairs(context, boxes, count, STAGE_EMBEDDING, note_pair, &pairs), HEXCON_OK);
    for (size_t i = 0; i < count; i++)
      for (size_t j = 0; j < count; j++) {
        bool meet = i != j;
        for (int k = 0; k < 3; k++)
          meet &= boxes[i].low[k] <= boxes[j].high[k] && boxes[j].low[k] <= boxes[i].high[k];
        assert_int_equal(pairs.seen[i][j], meet);
      }
  }
  hexcon_context_free(context);
}

static void points_at_one_place(void **state) {
  (void)state;
  const double points[6][3] = {{0, 0, 0}, {1, 2, 3}, {-0.0, 0, -0.0},
                               {1, 2, 3}, {1, 2, 4}, {0, 0, 0}};
  int32_t first[6];
  size_t found;
  hexcon_context *context = hexcon_context_new();
  assert_non_null(context);
  assert_int_equal(coincident_points_find(context, points[0], 6, first, &found), HEXCON_OK);
  const int32_t expected[6] = {0, 1, 0, 1, 4, 0};
  assert_memory_equal(first, expected, sizeof first);
  assert_int_equal(found, 3);
  hexcon_context_free(context);
}

/* ---------------------------------------------------------------------------------------- patches
 */

static const int32_t one[4] = {0, 1, 2, 3};

/** A saddle over the unit square, and another quad. */
static meeting with_saddle(const double other[4][3], const int32_t ids[4], int patience) {
  double points[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}};
  memcpy(points[4], other, 4 * sizeof *other);
  return patches_meet(points[0], one, ids, patience);
}

static void a_copy_of_a_patch(void **state) {
  (void)state;
  const int32_t ids[4] = {4, 5, 6, 7};
  for (double gap = 1; gap > 1e-13; gap /= 10) {
    const double above[4][3] = {{0, 0, gap}, {1, 0, gap}, {1, 1, 1 + gap}, {0, 1, gap}};
    assert_int_equal(with_saddle(above, ids, 1), MEETING_NONE); /* at once: by the quadric */
    const double through[4][3] = {{0, 0, -gap}, {1, 0, 2 * gap}, {1, 1, 1 - gap}, {0, 1, 3 * gap}};
    meeting crossing = with_saddle(through, ids, 4096);
    assert_int_not_equal(crossing, MEETING_NONE);
    if (gap > 1e-4)
      assert_int_equal(crossing, MEETING_PROVED);
  }
}

static void quads_that_share(void **state) {
  (void)state;
  /* an edge: going on, and folded back over or under the saddle */
  const double flat[4][3] = {{0, -1, 0}, {1, -1, 0}};
  const int32_t edge[4] = {1, 0, 4, 5};
  assert_int_equal(with_saddle(flat, edge, 1), MEETING_NONE);
  for (double lift = 1; lift > 1e-9; lift /= 10) {
    const double over[4][3] = {{0, 1, lift}, {1, 1, 1 + lift}},
                 under[4][3] = {{0, 1, -lift}, {1, 1, 1 - lift}};
    assert_int_equal(with_saddle(over, edge, 100), MEETING_NONE);
    assert_int_equal(with_saddle(under, edge, 100), MEETING_NONE);
    const double across[4][3] = {{0, 1, lift}, {1, 1, 1 - lift}};
    assert_int_not_equal(with_saddle(across, edge, 1000), MEETING_NONE);
  }
  /* a corner */
  const double apart[4][3] = {{-1, 0, 0}, {-1, -1, 3}, {0, -1, 0}},
               through[4][3] = {{0, 0.5, -1}, {1, 1, 0}, {1, 0.5, 1}};
  const int32_t corner[4] = {0, 4, 5, 6};
  assert_int_equal(with_saddle(apart, corner, 1), MEETING_NONE);
  assert_int_equal(with_saddle(through, corner, 1000), MEETING_PROVED);
  /* two edges, at a point of two quads only: the fourth corners on either side, or the same */
  const int32_t edges[4] = {0, 3, 4, 1};
  const double below[4][3] = {{1, 1, -0.5}}, above[4][3] = {{1, 1, 1.5}}, same[4][3] = {{1, 1, 1}};
  assert_int_equal(with_saddle(below, edges, 1), MEETING_NONE);
  assert_int_equal(with_saddle(above, edges, 1), MEETING_NONE);
  assert_int_not_equal(with_saddle(same, edges, 100), MEETING_NONE);
}

static void flat_quads_decide_touching(void **state) {
  (void)state;
  static const struct {
    double other[4][3];
    meeting expected;
  } cases[] = {
      {{{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}}, MEETING_PROVED},           /* along a side */
      {{{1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}}, MEETING_PROVED},           /* in a corner */
      {{{1 + 1e-16, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1.5, 2, 0}}, MEETING_PROVED}, /* rounded to it */
      {{{1 + 1e-15, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1.5, 1, 0}}, MEETING_NONE},
      {{{.2, .2, 0}, {.8, .2, 0}, {.8, .8, 0}, {.2, .8, 0}}, MEETING_PROVED}, /* in it */
      {{{.5, .5, 0}, {.5, .6, 1}, {.5, .5, 2}, {.5, .4, 1}}, MEETING_PROVED}, /* on a corner */
      {{{.5, .5, 1e-30}, {.5, .6, 1}, {.5, .5, 2}, {.5, .4, 1}}, MEETING_NONE},
      {{{-1, .5, -1}, {2, .5, -1}, {2, .5, 1}, {-1, .5, 1}}, MEETING_PROVED}, /* through it */
      {{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}, MEETING_NONE},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    double points[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    memcpy(points[4], cases[i].other, sizeof cases[i].other);
    const int32_t ids[4] = {4, 5, 6, 7};
    flat_quad a, b;
    flat_quad_set(&a, points[0], one);
    flat_quad_set(&b, points[0], ids);
    assert_int_equal(a.form, QUAD_CONVEX);
    assert_int_equal(b.form, QUAD_CONVEX);
    assert_int_equal(flat_quads_meet(&a, &b), cases[i].expected);
    assert_int_equal(flat_quads_meet(&b, &a), cases[i].expected);
  }
}

static void forms_of_quads(void **state) {
  (void)state;
  static const struct {
    double corners[4][3];
    quad_form expected;
  } cases[] = {
      {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, QUAD_CONVEX},
      {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}, QUAD_CONVEX}, /* a flat corner */
      {{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}, QUAD_FOLDED}, /* a dart */
      {{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}, QUAD_FOLDED}, /* a bow tie */
      {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, QUAD_FOLDED},
      {{{0, 0, 0}, {4, 0, 0}, {1, 1, 1e-300}, {0, 4, 0}}, QUAD_WARPED},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    flat_quad quad;
    flat_quad_set(&quad, cases[i].corners[0], one);
    assert_int_equal(quad.form, cases[i].expected);
  }
}

/* ---------------------------------------------------------------------------------------- surfaces
 */

static void faults_of_arrays(void **state) {
  (void)state;
  test_mesh box_mesh = make_box(1, 1, 1);
  hexcon_context *context = hexcon_context_new();
  hexcon_embedding found;
  assert_non_null(context);
  assert_int_equal(hexcon_surface_embedding(context, box_mesh.points, box_mesh.point_count,
                                            box_mesh.quads, 0, &found),
                   HEXCON_EMPTY);
  assert_int_equal(hexcon_surface_embedding(context, box_mesh.points, box_mesh.point_count,
                                            box_mesh.quads, box_mesh.quad_count, &found),
                   HEXCON_OK);
  assert_int_equal(found.embedded, HEXCON_EMBEDDED_YES);
  assert_int_equal(found.pair_count, 0);
  hexcon_embedding_free(context, &found);
  box_mesh.points[0] = NAN;
  assert_int_equal(hexcon_surface_embedding(context, box_mesh.points, box_mesh.point_count,
                                            box_mesh.quads, box_mesh.quad_count, &found),
                   HEXCON_NOT_FINITE);
  hexcon_context_free(context);
  test_mesh_free(&box_mesh);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(orientation_of_near_planes), cmocka_unit_test(separation_finds_directions),
      cmocka_unit_test(box_tree_finds_all_pairs),   cmocka_unit_test(points_at_one_place),
      cmocka_unit_test(a_copy_of_a_patch),          cmocka_unit_test(quads_that_share),
      cmocka_unit_test(flat_quads_decide_touching), cmocka_unit_test(forms_of_quads),
      cmocka_unit_test(faults_of_arrays),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
