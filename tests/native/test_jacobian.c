/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Scaled Jacobian and the sign of the Jacobian, against hand values and exact integers. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "support.h"
#include "verify/jacobian_exact.h"
#include "verify/jacobian_sign.h"

static const int32_t in_order[8] = {0, 1, 2, 3, 4, 5, 6, 7};
static const double unit_cube[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                       {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

/** VTK's corners as bits. */
static const int corner_bits[8] = {0, 1, 3, 2, 4, 5, 7, 6};

/** A witness lies in the hex; there is one exactly if the hex is proved not positive. */
static jacobian_sign sign_at(const double points[8][3], double witness[3]) {
  jacobian_sign sign = prove_jacobian_sign_at(&points[0][0], in_order, witness);
  assert_witness(sign == JACOBIAN_NONPOSITIVE, witness);
  return sign;
}

static jacobian_sign sign_of(const double points[8][3]) {
  double witness[3];
  jacobian_sign sign = sign_at(points, witness);
  assert_int_equal(prove_jacobian_sign(&points[0][0], in_order), sign);
  return sign;
}

static double quality_of(const double points[8][3]) {
  hexcon_context *context = hexcon_context_new();
  double value = 9;
  assert_int_equal(hexcon_quality(context, &points[0][0], 8, in_order, 1, &value), HEXCON_OK);
  hexcon_context_free(context);
  return value;
}

/** unit cube, then x -> scale * (matrix x) + offset */
static void map_cube(double matrix[3][3], double scale, double offset, double out[8][3]) {
  for (int v = 0; v < 8; v++)
    for (int i = 0; i < 3; i++) {
      out[v][i] = offset;
      for (int j = 0; j < 3; j++)
        out[v][i] += scale * matrix[i][j] * unit_cube[v][j];
    }
}

/* ------------------------------------------------------------------------- scaled Jacobian */

static void scaled_jacobian_by_hand(void **state) {
  (void)state;
  double points[8][3];
  assert_close(quality_of(unit_cube), 1, 1e-15);
  map_cube((double[3][3]){{3, 0, 0}, {0, 0.1, 0}, {0, 0, 7}}, 1, 0, points);
  assert_close(quality_of((const double(*)[3])points), 1, 1e-15); /* a box */
  map_cube((double[3][3]){{1, 1, 0}, {0, 1, 0}, {0, 0, 1}}, 1, 0, points);
  assert_close(quality_of((const double(*)[3])points), sqrt(0.5), 1e-15); /* sheared */
  map_cube((double[3][3]){{1, 1, 1}, {0, 1, 1}, {0, 0, 1}}, 1, 0, points);
  assert_close(quality_of((const double(*)[3])points), 1 / sqrt(6), 1e-15);
  map_cube((double[3][3]){{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 1, 0, points);
  assert_close(quality_of((const double(*)[3])points), -1, 1e-15); /* mirrored */
  memcpy(points, unit_cube, sizeof points);
  points[6][0] = points[6][1] = points[6][2] = 2; /* worst there: determinant 4, edges sqrt 6 */
  assert_close(quality_of((const double(*)[3])points), 4 / pow(6, 1.5), 1e-15);
  memcpy(points, unit_cube, sizeof points);
  memcpy(points[6], points[5], sizeof points[6]); /* an edge of length 0 */
  assert_close(quality_of((const double(*)[3])points), -1, 0);
}

static void scaled_jacobian_of_one_corner(void **state) {
  (void)state;
  double points[8][3];
  memcpy(points, unit_cube, sizeof points);
  points[0][2] = 0.5; /* there: edges (1, 0, -.5), (0, 1, -.5), (0, 0, .5), determinant 1/2 */
  const double at_0 = 0.5 / (0.5 * 1.25), at_1 = 1 / sqrt(1.25);
  assert_close(quality_of((const double(*)[3])points), fmin(at_0, at_1), 1e-15);
}

/** Quality does not depend on the unit. */
static void scaled_jacobian_at_any_scale(void **state) {
  (void)state;
  double points[8][3], matrix[3][3] = {{1, 0.5, 0.1}, {0, 1, 0.2}, {0.1, 0, 1}};
  map_cube(matrix, 1, 0, points);
  double expected = quality_of((const double(*)[3])points);
  for (int exponent = -500; exponent <= 500; exponent += 50) {
    map_cube(matrix, ldexp(1, exponent), 0, points);
    assert_close(quality_of((const double(*)[3])points), expected, 1e-12);
  }
}

static void quality_faults(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  test_mesh box = make_box(2, 1, 1);
  double values[2];
  assert_int_equal(hexcon_quality(context, box.points, 12, box.hexes, 0, values), HEXCON_EMPTY);
  assert_message(context);
  assert_int_equal(hexcon_quality(context, box.points, 12, box.hexes, (size_t)INT32_MAX, values),
                   HEXCON_TOO_LARGE);
  assert_int_equal(hexcon_quality(context, box.points, 11, box.hexes, 2, values),
                   HEXCON_INDEX_OUT_OF_RANGE);
  const int32_t *ids;
  assert_true(hexcon_context_elements(context, &ids) >= 1);
  box.points[30] = NAN;
  assert_int_equal(hexcon_quality(context, box.points, 12, box.hexes, 2, values),
                   HEXCON_NOT_FINITE);
  assert_elements(context, (int32_t[]){10}, 1);
  test_mesh_free(&box);
  hexcon_context_free(context);
}

/* ----------------------------------------------------------------------- exact integer proof */

typedef __int128 wide;

/** 8 times each Bernstein coefficient of the Jacobian, exactly, from integer corners in order of
 * their bits. Written from the definition: all triples of edges. */
static void exact_coefficients(int corners[8][3], wide value[27]) {
  static const int strides[3] = {9, 3, 1}, binomial[3] = {1, 2, 1};
  memset(value, 0, 27 * sizeof *value);
  for (int m = 0; m < 64; m++) {
    long edge[3][3];
    int power[3] = {0, 0, 0};
    for (int axis = 0; axis < 3; axis++) {
      int first = (axis + 1) % 3, second = (axis + 2) % 3, bits = m >> (2 * axis);
      int start = (bits & 1) << first | (bits >> 1 & 1) << second;
      power[first] += bits & 1;
      power[second] += bits >> 1 & 1;
      for (int k = 0; k < 3; k++)
        edge[axis][k] = corners[start | 1 << axis][k] - corners[start][k];
    }
    wide determinant = 0;
    for (int k = 0; k < 3; k++)
      determinant += (wide)edge[0][k] * (edge[1][(k + 1) % 3] * edge[2][(k + 2) % 3] -
                                         edge[1][(k + 2) % 3] * edge[2][(k + 1) % 3]);
    int at = power[0] * strides[0] + power[1] * strides[1] + power[2] * strides[2];
    value[at] += determinant * (8 / (binomial[power[0]] * binomial[power[1]] * binomial[power[2]]));
  }
}

/** Halve along an axis, everything times 4. */
static void halve(const wide v[27], int stride, wide low[27], wide high[27]) {
  for (int i = 0; i < 27; i++) {
    if (i / stride % 3 != 0)
      continue;
    wide a = v[i], b = v[i + stride], c = v[i + 2 * stride];
    low[i] = 4 * a;
    low[i + stride] = 2 * (a + b);
    low[i + 2 * stride] = high[i] = a + 2 * b + c;
    high[i + stride] = 2 * (b + c);
    high[i + 2 * stride] = 4 * c;
  }
}

/** Exact: 1 positive everywhere, -1 negative or zero somewhere, 0 not known at this depth. */
static int exact_sign(const wide v[27], int depth, bool *zero) {
  static const int strides[3] = {9, 3, 1};
  bool all = true;
  for (int i = 0; i < 27; i++)
    all &= v[i] > 0;
  if (all)
    return 1;
  for (int corner = 0; corner < 8; corner++) {
    wide value = v[(corner & 1) * 18 + (corner >> 1 & 1) * 6 + (corner >> 2) * 2];
    if (value <= 0) {
      *zero = value == 0;
      return -1;
    }
  }
  if (depth == 0)
    return 0;
  wide low[27], high[27];
  halve(v, strides[depth % 3], low, high);
  int first = exact_sign(low, depth - 1, zero);
  if (first < 0)
    return -1;
  int second = exact_sign(high, depth - 1, zero);
  return second < 0 ? -1 : first & second;
}

static int exact_sign_of(int points[8][3], bool *zero) {
  int corners[8][3];
  wide value[27];
  for (int i = 0; i < 8; i++)
    memcpy(corners[corner_bits[i]], points[i], sizeof corners[0]);
  exact_coefficients(corners, value);
  *zero = false;
  return exact_sign(value, 15, zero);
}

/** The Jacobian of integer corners at a point whose coordinates have 12 bits, exactly up to a
 * positive factor. Written from the definition of the trilinear map. */
static wide exact_jacobian(int points[8][3], const double at[3]) {
  wide d[3][3] = {{0}}, sum = 0;
  for (int v = 0; v < 8; v++)
    for (int axis = 0; axis < 3; axis++) {
      wide weight = corner_bits[v] >> axis & 1 ? 1 : -1;
      for (int other = 0; other < 3; other++) {
        double u = corner_bits[v] >> other & 1 ? at[other] : 1 - at[other];
        assert_true(0x1p12 * u == floor(0x1p12 * u));
        if (other != axis)
          weight *= (int)(0x1p12 * u);
      }
      for (int k = 0; k < 3; k++)
        d[axis][k] += weight * points[v][k];
    }
  for (int k = 0; k < 3; k++)
    sum +=
        d[0][k] * (d[1][(k + 1) % 3] * d[2][(k + 2) % 3] - d[1][(k + 2) % 3] * d[2][(k + 1) % 3]);
  return sum;
}

static void random_hex(uint64_t *random, int size, int spread, int points[8][3]) {
  for (int v = 0; v < 8; v++)
    for (int k = 0; k < 3; k++)
      points[v][k] = size * (int)unit_cube[v][k] +
                     (int)random_below(random, (size_t)(2 * spread + 1)) - spread;
}

static void scale_points(int points[8][3], double scale, double out[8][3]) {
  for (int v = 0; v < 8; v++)
    for (int k = 0; k < 3; k++)
      out[v][k] = scale * points[v][k];
}

/** What the exact proof says, the proof in doubles says, in any power of two of the unit. */
static void random_integer_hexes(void **state) {
  (void)state;
  uint64_t random = 1;
  int counts[3] = {0};
  for (int round = 0; round < 6000; round++) {
    int hex[8][3];
    bool zero;
    double points[8][3];
    random_hex(&random, 8, 2 + round % 5, hex);
    int exact = exact_sign_of(hex, &zero);
    counts[exact + 1]++;
    for (int exponent = -498; exponent <= 498; exponent += 249) {
      double witness[3];
      scale_points(hex, ldexp(1, exponent), points);
      jacobian_sign sign = sign_at((const double(*)[3])points, witness);
      if (sign == JACOBIAN_NONPOSITIVE)
        assert_true(exact_jacobian(hex, witness) <= 0);
      if (exact == 1)
        assert_int_equal(sign, JACOBIAN_POSITIVE);
      else if (exact == -1)
        assert_int_not_equal(sign, JACOBIAN_POSITIVE);
      if (exact == -1 && !zero)
        assert_int_equal(sign, JACOBIAN_NONPOSITIVE);
    }
  }
  assert_true(counts[0] > 500 && counts[2] > 500);
}

/** A hex that is positive at its corners and on all its edges may be negative inside. */
static void positive_corners_are_no_proof(void **state) {
  (void)state;
  uint64_t random = 5;
  int found = 0;
  for (int round = 0; round < 200000 && found < 20; round++) {
    int hex[8][3], corners[8][3];
    bool zero, positive = true;
    wide value[27];
    double points[8][3];
    random_hex(&random, 8, 6, hex);
    for (int i = 0; i < 8; i++)
      memcpy(corners[corner_bits[i]], hex[i], sizeof corners[0]);
    exact_coefficients(corners, value);
    for (int corner = 0; corner < 8; corner++)
      positive &= value[(corner & 1) * 18 + (corner >> 1 & 1) * 6 + (corner >> 2) * 2] > 0;
    if (!positive || exact_sign_of(hex, &zero) != -1 || zero)
      continue;
    found++;
    double witness[3];
    scale_points(hex, 1, points);
    assert_true(quality_of((const double(*)[3])points) > 0);
    assert_int_equal(sign_at((const double(*)[3])points, witness), JACOBIAN_NONPOSITIVE);
    assert_true(exact_jacobian(hex, witness) <= 0);
  }
  assert_true(found >= 5);
}

/** A cube with one corner pressed into the plane of its neighbours, or a little beyond. */
static void witness_at_a_corner(void **state) {
  (void)state;
  for (int v = 0; v < 8; v++)
    for (int beyond = 0; beyond < 2; beyond++) {
      double points[8][3], witness[3], in[3] = {0.25, 0.25, 0.5 + beyond / 16.0};
      memcpy(points, unit_cube, sizeof points);
      for (int k = 0; k < 3; k++)
        points[v][k] = fabs(unit_cube[v][k] - in[k]);
      assert_int_equal(sign_at((const double(*)[3])points, witness), JACOBIAN_NONPOSITIVE);
      assert_memory_equal(witness, unit_cube[v], sizeof witness);
    }
}

/* ---------------------------------------------------------------------------- special hexes */

static void plain_hexes(void **state) {
  (void)state;
  double points[8][3];
  assert_int_equal(sign_of(unit_cube), JACOBIAN_POSITIVE);
  map_cube((double[3][3]){{1, 1000, 0}, {0, 1, 0}, {0, 1e-3, 1}}, 1, 0, points);
  assert_int_equal(sign_of((const double(*)[3])points), JACOBIAN_POSITIVE);
  map_cube((double[3][3]){{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, 1, 0, points);
  assert_int_equal(sign_of((const double(*)[3])points), JACOBIAN_NONPOSITIVE);
}

/** Scales, offsets and flat boxes that have an exact answer. */
static void extreme_coordinates(void **state) {
  (void)state;
  double identity[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, points[8][3];
  static const double scales[] = {1e-300, 1e-150, 1e-30, 1, 1e30, 1e150, 1e300};
  for (int i = 0; i < 7; i++) {
    map_cube(identity, scales[i], 0, points);
    assert_int_equal(sign_of((const double(*)[3])points), JACOBIAN_POSITIVE);
    for (int v = 0; v < 8; v++)
      points[v][0] = -points[v][0];
    assert_int_equal(sign_of((const double(*)[3])points), JACOBIAN_NONPOSITIVE);
  }
  map_cube(identity, 1, 1e8, points);
  assert_int_equal(sign_of((const double(*)[3])points), JACOBIAN_POSITIVE);
  map_cube((double[3][3]){{1, 0, 0}, {0, 1, 0}, {0, 0, 1e-9}}, 1, 0, points);
  assert_int_equal(sign_of((const double(*)[3])points), JACOBIAN_POSITIVE);
  map_cube(identity, 1.7e308, 0, points); /* the largest numbers */
  assert_int_equal(sign_of((const double(*)[3])points), JACOBIAN_POSITIVE);
  map_cube(identity, 0x1p-1074, 0, points); /* the smallest */
  assert_int_equal(sign_of((const double(*)[3])points), JACOBIAN_POSITIVE);
  map_cube((double[3][3]){{1e300, 0, 0}, {0, 1e-300, 0}, {0, 0, 1e-300}}, 1, 0, points);
  assert_int_equal(sign_of((const double(*)[3])points), JACOBIAN_POSITIVE);
  for (int turned = 0; turned < 2; turned++) { /* edges that overflow */
    for (int v = 0; v < 8; v++)
      for (int k = 0; k < 3; k++)
        points[v][k] = 1.7e308 * (2 * unit_cube[v][k] - 1) * (turned ? -1 : 1);
    assert_int_equal(sign_of((const double(*)[3])points),
                     turned ? JACOBIAN_NONPOSITIVE : JACOBIAN_POSITIVE);
  }
}

/** No hex with a coordinate that is no number is positive. */
static void not_a_number(void **state) {
  (void)state;
  for (int entry = 0; entry < 24; entry++) {
    double points[8][3];
    memcpy(points, unit_cube, sizeof points);
    points[entry / 3][entry % 3] = NAN;
    assert_int_not_equal(sign_of((const double(*)[3])points), JACOBIAN_POSITIVE);
    points[entry / 3][entry % 3] = INFINITY;
    assert_int_not_equal(sign_of((const double(*)[3])points), JACOBIAN_POSITIVE);
  }
}

/** The filter in doubles and exact arithmetic never contradict each other, and exact arithmetic
 * decides every hex of small integers that has no zero inside. */
static void filter_and_exact_agree(void **state) {
  (void)state;
  uint64_t random = 21;
  for (int round = 0; round < 3000; round++) {
    int hex[8][3];
    bool zero;
    double points[8][3];
    random_hex(&random, 8, 2 + round % 5, hex);
    scale_points(hex, 0x1p-40, points);
    int truth = exact_sign_of(hex, &zero);
    double witness[3];
    jacobian_sign sign = prove_jacobian_sign_exactly(&points[0][0], in_order, witness);
    if (sign == JACOBIAN_NONPOSITIVE)
      assert_true(exact_jacobian(hex, witness) <= 0);
    if (truth > 0)
      assert_int_equal(sign, JACOBIAN_POSITIVE);
    if (truth < 0)
      assert_int_equal(sign, JACOBIAN_NONPOSITIVE);
    if (sign != JACOBIAN_UNDECIDED)
      assert_int_equal(sign_of((const double(*)[3])points), sign);
  }
}

/** Jacobian 0 at a corner, on an edge, on a face, everywhere: never positive, and soon decided. */
static void zero_jacobians(void **state) {
  (void)state;
  double points[8][3];
  memcpy(points, unit_cube, sizeof points);
  points[0][0] = points[0][1] = 0.25; /* in one plane with its neighbours */
  points[0][2] = 0.5;
  assert_int_equal(sign_of((const double(*)[3])points), JACOBIAN_NONPOSITIVE);
  /* the doubles next to a third lie on either side of that plane: only exact arithmetic tells */
  points[0][0] = points[0][1] = points[0][2] = 1.0 / 3;
  assert_int_equal(sign_of((const double(*)[3])points), JACOBIAN_POSITIVE);
  points[0][0] = points[0][1] = points[0][2] = nextafter(1.0 / 3, 1);
  assert_int_equal(sign_of((const double(*)[3])points), JACOBIAN_NONPOSITIVE);
  memcpy(points, unit_cube, sizeof points);
  memcpy(points[1], points[0], sizeof points[1]); /* an edge of length 0 */
  assert_int_equal(sign_of((const double(*)[3])points), JACOBIAN_NONPOSITIVE);
  memcpy(points, unit_cube, sizeof points);
  for (int v = 4; v < 8; v++)
    memcpy(points[v], points[4], sizeof points[v]); /* a pyramid */
  assert_int_equal(sign_of((const double(*)[3])points), JACOBIAN_NONPOSITIVE);
  for (int round = 0; round < 200; round++) { /* flat, all of it */
    map_cube((double[3][3]){{1, 0.1 * round, 0}, {0.3, 1, 0}, {0, 0, 0}}, 1, 0, points);
    assert_int_equal(sign_of((const double(*)[3])points), JACOBIAN_NONPOSITIVE);
  }
  memset(points, 0, sizeof points);
  assert_int_equal(sign_of((const double(*)[3])points), JACOBIAN_NONPOSITIVE);
}

/** Few hexes are undecided: the Jacobian of those is 0 at a third, a fifth .. of an edge, and
 * positive elsewhere. */
static void undecided_hexes(void **state) {
  (void)state;
  /* 0 at (2/3, 0, 1) */
  const double third[8][3] = {{-1, -1, -1}, {2, 1, 0}, {3, 3, 0}, {-1, 3, -1},
                              {1, 1, 3},    {1, 0, 1}, {2, 1, 2}, {-1, 3, 3}};
  assert_int_equal(sign_of(third), JACOBIAN_UNDECIDED);
  uint64_t random = 11;
  int undecided = 0;
  for (int round = 0; round < 20000; round++) {
    int hex[8][3];
    double points[8][3];
    random_hex(&random, 2 + round % 3, 1 + round % 2, hex);
    scale_points(hex, 1, points);
    undecided += sign_of((const double(*)[3])points) == JACOBIAN_UNDECIDED;
  }
  assert_true(undecided <= 20000 / 2000);
}

/** On the way from a hex that is positive to one that is not, every one is decided, down to
 * neighbouring doubles. */
static void touching_zero(void **state) {
  (void)state;
  uint64_t random = 31;
  for (int round = 0; round < 30; round++) {
    double good[8][3], bad[8][3], points[8][3], low = 0, high = 1;
    for (int v = 0; v < 8; v++)
      for (int k = 0; k < 3; k++) {
        good[v][k] = unit_cube[v][k] + random_between(&random, -0.05, 0.05);
        bad[v][k] = unit_cube[v][k] + random_between(&random, -0.6, 0.6);
      }
    if (sign_of((const double(*)[3])bad) != JACOBIAN_NONPOSITIVE)
      continue;
    for (double middle = 0.5; middle > low && middle < high; middle = (low + high) / 2) {
      for (int i = 0; i < 24; i++)
        points[i / 3][i % 3] =
            good[i / 3][i % 3] + middle * (bad[i / 3][i % 3] - good[i / 3][i % 3]);
      jacobian_sign sign = sign_of((const double(*)[3])points);
      assert_int_not_equal(sign, JACOBIAN_UNDECIDED);
      *(sign == JACOBIAN_POSITIVE ? &low : &high) = middle;
    }
  }
}

/** The Jacobian in long double at a point of the unit cube. */
static long double jacobian_at(const double points[8][3], const long double u[3]) {
  long double d[3][3] = {{0}};
  for (int v = 0; v < 8; v++)
    for (int axis = 0; axis < 3; axis++) {
      long double weight = corner_bits[v] >> axis & 1 ? 1 : -1;
      for (int other = 0; other < 3; other++)
        if (other != axis)
          weight *= corner_bits[v] >> other & 1 ? u[other] : 1 - u[other];
      for (int k = 0; k < 3; k++)
        d[axis][k] += weight * points[v][k];
    }
  long double sum = 0;
  for (int k = 0; k < 3; k++)
    sum +=
        d[0][k] * (d[1][(k + 1) % 3] * d[2][(k + 2) % 3] - d[1][(k + 2) % 3] * d[2][(k + 1) % 3]);
  return sum;
}

static long double smallest_sample(const double points[8][3], long double *largest) {
  long double smallest = 1e300L;
  *largest = 0;
  for (int i = 0; i < 512; i++) {
    long double u[3] = {(long double)(i % 8) / 7, (long double)(i / 8 % 8) / 7,
                        (long double)(i / 64) / 7};
    long double value = jacobian_at(points, u);
    smallest = fminl(smallest, value);
    *largest = fmaxl(*largest, fabsl(value));
  }
  return smallest;
}

/** Sampling refutes: a hex with a clearly negative sample is not positive, one with clearly
 * positive samples mostly is; some lie far from the origin, some are very thin. */
static void random_real_hexes(void **state) {
  (void)state;
  uint64_t random = 77;
  int agreed = 0, disagreed = 0;
  for (int round = 0; round < 3000; round++) {
    double points[8][3], spread = random_between(&random, 0.1, 0.6);
    double thin = pow(10, -random_between(&random, 0, 6)), far = round % 3 ? 0 : 1e5;
    for (int v = 0; v < 8; v++)
      for (int k = 0; k < 3; k++)
        points[v][k] = far + (unit_cube[v][k] + random_between(&random, -spread, spread)) *
                                 (k == 2 ? thin : 1);
    long double largest, smallest = smallest_sample((const double(*)[3])points, &largest);
    jacobian_sign sign = sign_of((const double(*)[3])points);
    if (smallest < -1e-12L * largest)
      assert_int_not_equal(sign, JACOBIAN_POSITIVE);
    if (smallest > 0.1L * largest)
      *(sign == JACOBIAN_POSITIVE ? &agreed : &disagreed) += 1;
    if (sign == JACOBIAN_NONPOSITIVE)
      assert_true(smallest < 0.1L * largest);
  }
  assert_true(agreed > 300 && disagreed == 0);
}

/** The 24 ways to number a hex from another corner have the same sign; mirrored ones have not. */
static void numbering_does_not_matter(void **state) {
  (void)state;
  static const int turn_z[8] = {1, 2, 3, 0, 5, 6, 7, 4}, turn_x[8] = {3, 2, 6, 7, 0, 1, 5, 4};
  static const int mirror[8] = {4, 5, 6, 7, 0, 1, 2, 3};
  uint64_t random = 9;
  for (int round = 0; round < 300; round++) {
    int hex[8][3], turned[8][3];
    bool zero;
    double points[8][3];
    random_hex(&random, 8, 3, hex);
    int exact = exact_sign_of(hex, &zero);
    for (int turns = 0; turns < 24; turns++) {
      const int *order = random_below(&random, 2) ? turn_z : turn_x;
      for (int v = 0; v < 8; v++)
        memcpy(turned[v], hex[order[v]], sizeof turned[v]);
      memcpy(hex, turned, sizeof hex);
      scale_points(hex, 1, points);
      jacobian_sign sign = sign_of((const double(*)[3])points);
      assert_true(exact == 0 || (sign == JACOBIAN_POSITIVE) == (exact == 1));
    }
    for (int v = 0; v < 8; v++)
      memcpy(turned[v], hex[mirror[v]], sizeof turned[v]);
    scale_points(turned, 1, points);
    assert_true(exact != 1 || sign_of((const double(*)[3])points) == JACOBIAN_NONPOSITIVE);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(scaled_jacobian_by_hand),
      cmocka_unit_test(scaled_jacobian_of_one_corner),
      cmocka_unit_test(scaled_jacobian_at_any_scale),
      cmocka_unit_test(quality_faults),
      cmocka_unit_test(random_integer_hexes),
      cmocka_unit_test(positive_corners_are_no_proof),
      cmocka_unit_test(witness_at_a_corner),
      cmocka_unit_test(plain_hexes),
      cmocka_unit_test(extreme_coordinates),
      cmocka_unit_test(not_a_number),
      cmocka_unit_test(zero_jacobians),
      cmocka_unit_test(undecided_hexes),
      cmocka_unit_test(touching_zero),
      cmocka_unit_test(filter_and_exact_agree),
      cmocka_unit_test(random_real_hexes),
      cmocka_unit_test(numbering_does_not_matter),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
