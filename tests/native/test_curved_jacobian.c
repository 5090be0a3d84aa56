/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The sign of a 20-node hex's Jacobian, against cases by hand. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "support.h"
#include "verify/curved_jacobian.h"
#include "verify/curved_jacobian_exact.h"
#include "verify/curved_quality.h"
#include "verify/jacobian_sign.h"

static const double unit_cube[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                       {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
static const unsigned char ends[12][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                                          {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};

static void straight(const double corners[8][3], double nodes[20][3]) {
  memcpy(nodes, corners, 24 * sizeof(double));
  for (int e = 0; e < 12; e++)
    for (int c = 0; c < 3; c++)
      nodes[8 + e][c] = (corners[ends[e][0]][c] + corners[ends[e][1]][c]) / 2;
}

/** Filter and exact arithmetic agree as far as both decide; a witness lies in the hex. */
static jacobian_sign sign_of(double nodes[20][3], double witness[3]) {
  double other[3];
  void *room = malloc(curved_jacobian_room());
  assert_non_null(room);
  jacobian_sign sign = prove_curved_jacobian_sign(nodes, room, witness);
  jacobian_sign exact = prove_curved_jacobian_exactly(nodes, room, other);
  free(room);
  if (sign != JACOBIAN_UNDECIDED && exact != JACOBIAN_UNDECIDED)
    assert_int_equal(sign, exact);
  assert_witness(sign == JACOBIAN_NONPOSITIVE, witness);
  return sign;
}

static void cubes(void **state) {
  (void)state;
  double nodes[20][3], witness[3];
  straight(unit_cube, nodes);
  assert_int_equal(sign_of(nodes, witness), JACOBIAN_POSITIVE);
  for (int n = 0; n < 20; n++)
    nodes[n][2] = -nodes[n][2];
  assert_int_equal(sign_of(nodes, witness), JACOBIAN_NONPOSITIVE);
  for (int n = 0; n < 20; n++)
    nodes[n][2] = 0;
  assert_int_equal(sign_of(nodes, witness), JACOBIAN_NONPOSITIVE);
  for (int n = 0; n < 20; n++)
    nodes[n][2] = NAN;
  assert_int_equal(sign_of(nodes, witness), JACOBIAN_UNDECIDED);
}

/** Flat and far: units of each axis do not matter. */
static void scales(void **state) {
  (void)state;
  static const double by[4] = {1e-12, 1e12, 1e-140, 1e90};
  double nodes[20][3], witness[3];
  for (int i = 0; i < 4; i++) {
    straight(unit_cube, nodes);
    for (int n = 0; n < 20; n++)
      nodes[n][i % 3] *= by[i];
    assert_int_equal(sign_of(nodes, witness), JACOBIAN_POSITIVE);
    nodes[0][i % 3] = 2 * by[i];
    assert_int_equal(sign_of(nodes, witness), JACOBIAN_NONPOSITIVE);
  }
}

/** A middle node at a quarter of its edge: the derivative at the end is 4 m - 1 = 0. */
static void quarter_point(void **state) {
  (void)state;
  double nodes[20][3], witness[3];
  straight(unit_cube, nodes);
  nodes[8][0] = 0.25;
  assert_int_equal(sign_of(nodes, witness), JACOBIAN_NONPOSITIVE);
  assert_true(witness[0] == 0 && witness[1] == 0 && witness[2] == 0);
  nodes[8][0] = nextafter(0.25, 1);
  assert_int_equal(sign_of(nodes, witness), JACOBIAN_POSITIVE);
  nodes[8][0] = nextafter(0.25, 0);
  assert_int_equal(sign_of(nodes, witness), JACOBIAN_NONPOSITIVE);
  nodes[8][0] = nextafter(0.75, 1); /* now the other end */
  assert_int_equal(sign_of(nodes, witness), JACOBIAN_NONPOSITIVE);
  assert_true(witness[0] == 1 && witness[1] == 0 && witness[2] == 0);
}

/** Every axis and corner alike: moving one middle node of the cube along its own edge past the
 * quarter inverts that hex, and just before it does not. */
static void every_edge(void **state) {
  (void)state;
  double nodes[20][3], witness[3];
  for (int e = 0; e < 12; e++)
    for (int end = 0; end < 2; end++) {
      straight(unit_cube, nodes);
      const double *near = unit_cube[ends[e][end]], *far = unit_cube[ends[e][1 - end]];
      for (int c = 0; c < 3; c++)
        nodes[8 + e][c] = near[c] + 0.26 * (far[c] - near[c]);
      assert_int_equal(sign_of(nodes, witness), JACOBIAN_POSITIVE);
      for (int c = 0; c < 3; c++)
        nodes[8 + e][c] = near[c] + 0.24 * (far[c] - near[c]);
      assert_int_equal(sign_of(nodes, witness), JACOBIAN_NONPOSITIVE);
      for (int c = 0; c < 3; c++)
        assert_true(witness[c] == near[c]); /* the local coordinates are the cube's own */
    }
}

/** x = r, y = s, z = t (1 + a (4 r (1 - r) + 4 s (1 - s) - 1)) bends the top: det = 1 + a (...),
 * least at the corners of the (r, s) square for a > 0, in its middle for a < 0: 1 - |a|. */
static void bent_top(void **state) {
  (void)state;
  static const double strengths[6] = {0.99, 1, 1.01, -0.99, -1, -1.01};
  double nodes[20][3], witness[3];
  for (int i = 0; i < 6; i++) {
    straight(unit_cube, nodes);
    for (int n = 0; n < 20; n++) {
      double r = nodes[n][0], s = nodes[n][1];
      nodes[n][2] *= 1 + strengths[i] * (4 * r * (1 - r) + 4 * s * (1 - s) - 1);
    }
    assert_int_equal(sign_of(nodes, witness),
                     fabs(strengths[i]) < 1 ? JACOBIAN_POSITIVE : JACOBIAN_NONPOSITIVE);
    if (strengths[i] == -1)
      assert_true(witness[0] == 0.5 && witness[1] == 0.5);
  }
}

/** With middle nodes exactly in the middle the Jacobian is the 8-node hex's. */
static void as_with_eight_nodes(void **state) {
  (void)state;
  static const int32_t in_order[8] = {0, 1, 2, 3, 4, 5, 6, 7};
  uint64_t random = 7;
  int positive = 0;
  for (int round = 0; round < 2000; round++) {
    double corners[8][3], nodes[20][3], witness[3], other[3];
    int reach = round % 2 ? 9 : 2000;
    for (int i = 0; i < 8; i++)
      for (int c = 0; c < 3; c++)
        corners[i][c] =
            (double)(reach * (int)unit_cube[i][c]) + (double)random_below(&random, (uint64_t)reach);
    straight(corners, nodes);
    jacobian_sign sign = sign_of(nodes, witness);
    jacobian_sign eight = prove_jacobian_sign_at(&corners[0][0], in_order, other);
    if (sign != JACOBIAN_UNDECIDED && eight != JACOBIAN_UNDECIDED)
      assert_int_equal(sign, eight);
    positive += sign == JACOBIAN_POSITIVE;
  }
  assert_true(positive > 100 && positive < 1900);
}

/** A cube has 1 everywhere; a bent top 1 - |a| at some corner, or in the middle; units do not
 * matter, nor does turning; what is not positive has 0 at most. */
static void qualities(void **state) {
  (void)state;
  static const double strengths[4] = {0.5, -0.5, -1, 1.01}, sizes[3] = {1, 1e-90, 1e80};
  void *room = malloc(curved_jacobian_room());
  assert_non_null(room);
  double nodes[20][3];
  straight(unit_cube, nodes);
  assert_close(curved_scaled_jacobian(nodes, room), 1, 1e-9);
  for (int i = 0; i < 4; i++)
    for (int k = 0; k < 3; k++) {
      straight(unit_cube, nodes);
      for (int n = 0; n < 20; n++) {
        double r = nodes[n][0], s = nodes[n][1], top = 4 * r * (1 - r) + 4 * s * (1 - s) - 1;
        double place[3] = {r, s, nodes[n][2] * (1 + strengths[i] * top)};
        for (int c = 0; c < 3; c++)
          nodes[n][(c + i) % 3] = sizes[k] * place[c];
      }
      double found = curved_scaled_jacobian(nodes, room);
      if (fabs(strengths[i]) < 1)
        assert_true(found > 0.1 && found < 1);
      else
        assert_true(found <= 0);
    }
  free(room);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(cubes),         cmocka_unit_test(scales),
      cmocka_unit_test(quarter_point), cmocka_unit_test(every_edge),
      cmocka_unit_test(bent_top),      cmocka_unit_test(as_with_eight_nodes),
      cmocka_unit_test(qualities),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
