/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Facets tell where each piece of a carrier counts: against all triangles measured one by one, and
 * on a plate with a rounded edge. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "support.h"

/* ------------------------------------------------------------------------------- many triangles */

enum { ROWS = 9, POINTS = (ROWS + 1) * (ROWS + 1), FACETS = 2 * ROWS * ROWS };

/** A height over a square, as triangles with normals at their corners. */
typedef struct terrain {
  double points[POINTS][3], normals[FACETS][3][3];
  int32_t facets[FACETS][3], piece_of_facet[FACETS], starts[2], of_point;
  hexcon_carrier piece;
} terrain;

typedef void (*terrain_shape)(double x, double y, double *height, double normal[3]);

static void flat(double x, double y, double *height, double normal[3]) {
  *height = 0.3 * x - 0.2 * y;
  normal[0] = -0.3;
  normal[1] = 0.2;
  normal[2] = 1;
}

static void wave(double x, double y, double *height, double normal[3]) {
  *height = 0.2 * sin(2 * x) * cos(y);
  normal[0] = -0.4 * cos(2 * x) * cos(y);
  normal[1] = 0.2 * sin(2 * x) * sin(y);
  normal[2] = 1;
}

static void make_terrain(terrain *t, terrain_shape shape) {
  *t = (terrain){.starts = {0, 1}, .piece = {.kind = HEXCON_CARRIER_FACETS}};
  double normals[POINTS][3];
  for (int i = 0; i <= ROWS; i++)
    for (int j = 0; j <= ROWS; j++) {
      int v = i * (ROWS + 1) + j;
      t->points[v][0] = 2.0 * i / ROWS;
      t->points[v][1] = 2.0 * j / ROWS;
      shape(t->points[v][0], t->points[v][1], &t->points[v][2], normals[v]);
      for (int k = 0; k < 3; k++)
        normals[v][k] *= v % 2 ? 1 : 3; /* any length */
    }
  for (int i = 0; i < ROWS; i++)
    for (int j = 0; j < ROWS; j++) {
      int32_t v = i * (ROWS + 1) + j, f = 2 * (i * ROWS + j);
      const int32_t two[2][3] = {{v, v + ROWS + 1, v + 1}, {v + 1, v + ROWS + 1, v + ROWS + 2}};
      memcpy(t->facets[f], two, sizeof two);
    }
  for (int f = 0; f < FACETS; f++)
    for (int k = 0; k < 3; k++)
      memcpy(t->normals[f][k], normals[t->facets[f][k]], sizeof normals[0]);
}

static hexcon_sliding sliding_on(const terrain *t) {
  return (hexcon_sliding){.carrier_of_point = &t->of_point,
                          .carrier_count = 1,
                          .starts = t->starts,
                          .pieces = &t->piece,
                          .facet_point_count = POINTS,
                          .facet_count = FACETS,
                          .facet_points = &t->points[0][0],
                          .facets = &t->facets[0][0],
                          .piece_of_facet = t->piece_of_facet,
                          .facet_normals = &t->normals[0][0][0]};
}

/** The square of the distance to a triangle: the least of many places of it, drawn ever closer. */
static double square_to(const terrain *t, int facet, const double p[3]) {
  double u = 1.0 / 3, v = 1.0 / 3, best = INFINITY;
  for (double step = 0.5; step > 1e-9; step /= 2)
    for (int round = 0; round < 4; round++) {
      double at_u = u, at_v = v;
      for (int way = 0; way < 9; way++) {
        double a = fmin(fmax(u + step * (way % 3 - 1), 0), 1);
        double b = fmin(fmax(v + step * (way / 3 - 1), 0), 1 - a), square = 0;
        for (int k = 0; k < 3; k++) {
          double x = (1 - a - b) * t->points[t->facets[facet][0]][k] +
                     a * t->points[t->facets[facet][1]][k] + b * t->points[t->facets[facet][2]][k];
          square += (x - p[k]) * (x - p[k]);
        }
        if (square < best) {
          best = square;
          at_u = a;
          at_v = b;
        }
      }
      u = at_u;
      v = at_v;
    }
  return best;
}

static double gap_between(const double a[3], const double b[3]) {
  double square = 0;
  for (int k = 0; k < 3; k++)
    square += (a[k] - b[k]) * (a[k] - b[k]);
  return sqrt(square);
}

static double gap_to_terrain(const terrain *t, const double p[3]) {
  double least = INFINITY;
  for (int f = 0; f < FACETS; f++)
    least = fmin(least, square_to(t, f, p));
  return sqrt(least);
}

static void the_nearest_facet_is_found(void **state) {
  (void)state;
  uint64_t random = 51;
  static terrain t;
  make_terrain(&t, flat);
  hexcon_context *context = hexcon_context_new();
  hexcon_sliding sliding = sliding_on(&t);
  for (int round = 0; round < 60; round++) {
    double p[3], at[3], way[3];
    for (int k = 0; k < 3; k++)
      p[k] = random_between(&random, -1, 3);
    assert_int_equal(hexcon_project_points(context, p, 1, &sliding, at, way), HEXCON_OK);
    assert_close(gap_between(at, p), gap_to_terrain(&t, p), 1e-6);
    assert_close(way[0] * way[0] + way[1] * way[1] + way[2] * way[2], 1, 1e-12);
    assert_close(way[0] / way[2], -0.3, 1e-12);
  }
  hexcon_context_free(context);
}

/** Curved facets are much nearer to what they stand for than flat ones, and places on them stay. */
static void curved_facets_follow(void **state) {
  (void)state;
  uint64_t random = 52;
  static terrain t;
  make_terrain(&t, wave);
  hexcon_context *context = hexcon_context_new();
  hexcon_sliding sliding = sliding_on(&t);
  double flat_error = 0, curved_error = 0;
  for (int round = 0; round < 500; round++) {
    double x = random_between(&random, 0.1, 1.9), y = random_between(&random, 0.1, 1.9), height,
           normal[3], at[3], again[3], way[3];
    wave(x, y, &height, normal);
    const double p[3] = {x, y, height};
    assert_int_equal(hexcon_project_points(context, p, 1, &sliding, at, way), HEXCON_OK);
    assert_int_equal(hexcon_project_points(context, at, 1, &sliding, again, NULL), HEXCON_OK);
    flat_error = fmax(flat_error, round < 50 ? gap_to_terrain(&t, p) : 0);
    curved_error = fmax(curved_error, gap_between(at, p));
    assert_true(gap_between(at, again) < 1e-3);
  }
  assert_true(curved_error < 0.25 * flat_error);
  hexcon_context_free(context);
}

/* ------------------------------------------------------------------------- a plate with a fillet
 */

/** A floor z = 0, x < 0, a wall x = 1, z > 1, and a quarter of a cylinder between, as closed forms:
 * both planes go on beyond it. */
typedef struct bend {
  double points[12][3];
  int32_t facets[10][3], piece_of_facet[10], starts[2], of_point;
  hexcon_carrier pieces[3];
} bend;

static bend make_bend(void) {
  static const double profile[6][2] = {
      {-2, 0}, {0, 0}, {0.5, 0.1339745962155614}, {0.8660254037844386, 0.5}, {1, 1}, {1, 3}};
  static const int32_t pieces[5] = {0, 1, 1, 1, 2};
  bend b = {
      .starts = {0, 3},
      .pieces = {
          {.kind = HEXCON_CARRIER_PLANE, .axis = {0, 0, 1}},
          {.kind = HEXCON_CARRIER_CYLINDER, .origin = {0, 0, 1}, .axis = {0, 1, 0}, .sizes = {1}},
          {.kind = HEXCON_CARRIER_PLANE, .origin = {1, 0, 0}, .axis = {1, 0, 0}}}};
  for (int i = 0; i < 12; i++) {
    b.points[i][0] = profile[i / 2][0];
    b.points[i][1] = 4 * (i % 2);
    b.points[i][2] = profile[i / 2][1];
  }
  for (int f = 0; f < 10; f++) {
    const int32_t first = f / 2 * 2,
                  three[2][3] = {{first, first + 1, first + 2}, {first + 1, first + 2, first + 3}};
    memcpy(b.facets[f], three[f % 2], sizeof three[0]);
    b.piece_of_facet[f] = pieces[f / 2];
  }
  return b;
}

static hexcon_sliding sliding_round(const bend *b) {
  return (hexcon_sliding){.carrier_of_point = &b->of_point,
                          .carrier_count = 1,
                          .starts = b->starts,
                          .pieces = b->pieces,
                          .facet_point_count = 12,
                          .facet_count = 10,
                          .facet_points = &b->points[0][0],
                          .facets = &b->facets[0][0],
                          .piece_of_facet = b->piece_of_facet};
}

static void pieces_count_between_their_borders(void **state) {
  (void)state;
  uint64_t random = 53;
  bend b = make_bend();
  hexcon_sliding sliding = sliding_round(&b);
  hexcon_context *context = hexcon_context_new();
  for (int round = 0; round < 300; round++) {
    double angle = random_between(&random, 0, 1.57), out = random_between(&random, 0.8, 1.2);
    double round_part[3] = {out * sin(angle), random_between(&random, 0.5, 3.5),
                            1 - out * cos(angle)};
    double floor_part[3] = {random_between(&random, -1.9, -0.01), 1,
                            random_between(&random, -1, 0.5)};
    double wall_part[3] = {random_between(&random, 0.5, 2), 1, random_between(&random, 1.01, 2.9)};
    for (int part = 0; part < 3; part++) {
      double *p = part == 0 ? floor_part : part == 1 ? round_part : wall_part;
      assert_int_equal(hexcon_project_points(context, p, 1, &sliding, p, NULL), HEXCON_OK);
    }
    double *parts[3] = {floor_part, round_part, wall_part};
    for (int part = 0; part < 3; part++) {
      const double *p = parts[part]; /* on the face that is there */
      double off = p[0] < 0 ? p[2] : p[2] > 1 ? p[0] - 1 : hypot(p[0], 1 - p[2]) - 1;
      assert_close(off, 0, 1e-14);
    }
    assert_close(hypot(round_part[0], 1 - round_part[2]), 1, 1e-14);
  }
  /* far beyond the fillet a plane's nearest place is not on the patch: its facet's is */
  double beyond[3] = {0.9, 1, -3};
  assert_int_equal(hexcon_project_points(context, beyond, 1, &sliding, beyond, NULL), HEXCON_OK);
  assert_true(beyond[0] > -1e-12 && beyond[2] > -1e-12 && beyond[2] < 0.2);
  hexcon_context_free(context);
}

/* ---------------------------------------------------------------------------------- what is wrong
 */

static bool never_asked(void *user, size_t count, const double *points, const int32_t *tags,
                        double *projected, double *directions) {
  (void)user, (void)count, (void)points, (void)tags, (void)projected, (void)directions;
  fail_msg("asked for a place");
  return false;
}

static void faults_are_named(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  const double p[3] = {0, 0, 0};
  double at[3];
  const int32_t none = 0;
  for (int fault = 0; fault < 9; fault++) {
    bend b = make_bend();
    hexcon_sliding sliding = sliding_round(&b);
    hexcon_status expected = fault < 5 ? HEXCON_INDEX_OUT_OF_RANGE : HEXCON_BAD_ARGUMENT;
    int32_t facet = 3;
    double normals[90];
    for (int k = 0; k < 90; k++)
      normals[k] = k == 27 && fault == 4 ? NAN : 1;
    switch (fault) {
    case 0:
      b.facets[3][1] = 12;
      break;
    case 1:
      b.facets[3][2] = -1;
      break;
    case 2:
      b.piece_of_facet[3] = 3;
      break;
    case 3:
      b.points[0][1] = INFINITY; /* a corner of the first */
      facet = 0;
      break;
    case 4:
      sliding.facet_normals = normals;
      break;
    case 5:
      b.pieces[1].kind = HEXCON_CARRIER_FACETS; /* without normals */
      break;
    case 6:
      for (int f = 0; f < 10; f++)
        b.piece_of_facet[f] = 0; /* none on the others */
      break;
    case 7:
      b.pieces[1].kind = HEXCON_CARRIER_SURFACE;
      sliding.project = never_asked;
      break;
    default:
      sliding.facet_count = 0;
      for (int i = 0; i < 3; i++)
        b.pieces[i].kind = HEXCON_CARRIER_FACETS;
    }
    assert_int_equal(hexcon_project_points(context, p, 1, &sliding, at, NULL), expected);
    assert_elements(context, expected == HEXCON_INDEX_OUT_OF_RANGE ? &facet : &none, 1);
  }
  hexcon_context_free(context);
}

/** All equal facets, and all in one place: still halved, still found. */
static void facets_that_coincide(void **state) {
  (void)state;
  static terrain t;
  make_terrain(&t, flat);
  for (int f = 0; f < FACETS; f++)
    memcpy(t.facets[f], f % 2 ? t.facets[0] : (int32_t[3]){5, 5, 5}, sizeof t.facets[f]);
  hexcon_context *context = hexcon_context_new();
  hexcon_sliding sliding = sliding_on(&t);
  double p[3] = {1, 1, 1};
  assert_int_equal(hexcon_project_points(context, p, 1, &sliding, p, NULL), HEXCON_OK);
  assert_true(isfinite(p[0] + p[1] + p[2]));
  hexcon_context_free(context);
}

static void every_allocation_fails_once(void **state) {
  (void)state;
  bend b = make_bend();
  hexcon_sliding sliding = sliding_round(&b);
  const double p[3] = {0, 1, 0};
  for (size_t fail_at = 2;; fail_at++) {
    test_memory memory = {.fail_at = fail_at};
    hexcon_context *context = hexcon_context_new_with(test_reallocate, &memory);
    double at[3];
    hexcon_status status = hexcon_project_points(context, p, 1, &sliding, at, NULL);
    bool failed = memory.calls >= fail_at;
    assert_int_equal(status, failed ? HEXCON_OUT_OF_MEMORY : HEXCON_OK);
    hexcon_context_free(context);
    assert_int_equal(memory.live, 0);
    if (!failed) {
      assert_true(fail_at > 8);
      break;
    }
  }
}

/** So many that is asked whether to go on: once while they are checked, once while they are halved,
 * once while they are measured. */
static void building_can_be_cancelled(void **state) {
  (void)state;
  enum { MANY = 10000, ASKED = 3 };
  static int32_t facets[MANY][3], piece_of_facet[MANY];
  bend b = make_bend();
  for (int f = 0; f < MANY; f++) {
    memcpy(facets[f], b.facets[f % 10], sizeof facets[f]);
    piece_of_facet[f] = b.piece_of_facet[f % 10];
  }
  hexcon_sliding sliding = sliding_round(&b);
  sliding.facet_count = MANY;
  sliding.facets = &facets[0][0];
  sliding.piece_of_facet = piece_of_facet;
  const double p[3] = {0, 1, 0};
  for (size_t k = 1; k <= ASKED + 1; k++) {
    test_memory memory = {0};
    test_patience left = {.cancel_at = k};
    hexcon_context *context = hexcon_context_new_with(test_reallocate, &memory);
    hexcon_context_set_progress(context, lose_patience, &left);
    double at[3];
    hexcon_status status = hexcon_project_points(context, p, 1, &sliding, at, NULL);
    assert_int_equal(status, k <= ASKED ? HEXCON_CANCELLED : HEXCON_OK);
    assert_int_equal(left.calls, k <= ASKED ? k : ASKED); /* not asked again */
    if (status)
      assert_message(context);
    hexcon_context_free(context);
    assert_int_equal(memory.live, 0);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(the_nearest_facet_is_found),
      cmocka_unit_test(curved_facets_follow),
      cmocka_unit_test(pieces_count_between_their_borders),
      cmocka_unit_test(faults_are_named),
      cmocka_unit_test(facets_that_coincide),
      cmocka_unit_test(every_allocation_fails_once),
      cmocka_unit_test(building_can_be_cancelled),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
