/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "separation.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "base/vector.h"

enum { MAX_STEPS = 32 };

/** The nearest vectors found so far: their hull holds the nearest point. */
typedef struct simplex {
  double corners[4][3];
  int count;
} simplex;

/** Weights of the point of the plane through the chosen corners that is nearest to the origin, by
 * the corners' edges from the first one; false if they are degenerate. */
static bool weigh(const simplex *s, const int *chosen, int count, double weights[4]) {
  double edges[3][3], gram[3][4] = {{0}};
  int size = count - 1;
  for (int i = 0; i < size; i++)
    vector_subtract(s->corners[chosen[i + 1]], s->corners[chosen[0]], edges[i]);
  for (int i = 0; i < size; i++) {
    for (int j = 0; j < size; j++)
      gram[i][j] = vector_dot(edges[i], edges[j]);
    gram[i][3] = -vector_dot(edges[i], s->corners[chosen[0]]);
  }
  for (int i = 0; i < size; i++) {
    if (!(gram[i][i] > 0))
      return false;
    for (int r = 0; r < size; r++)
      for (int k = 3; r != i && k >= i; k--)
        gram[r][k] -= gram[r][i] / gram[i][i] * gram[i][k];
  }
  weights[0] = 1;
  for (int i = 0; i < size; i++) {
    weights[i + 1] = gram[i][3] / gram[i][i];
    weights[0] -= weights[i + 1];
  }
  return true;
}

static bool none_negative(const double *weights, int count) {
  for (int i = 0; i < count; i++)
    if (!(weights[i] >= 0))
      return false;
  return true;
}

/** The nearest point of the simplex; keeps only the corners that it needs. */
static void reduce(simplex *s, double nearest[3]) {
  double best = INFINITY;
  simplex kept = *s;
  for (int subset = 1; subset < 1 << s->count; subset++) {
    int chosen[4], count = 0;
    double weights[4], place[3] = {0, 0, 0};
    for (int i = 0; i < s->count; i++)
      if (subset >> i & 1)
        chosen[count++] = i;
    if (!weigh(s, chosen, count, weights) || !none_negative(weights, count))
      continue;
    for (int i = 0; i < count; i++)
      vector_add_scaled(place, weights[i], s->corners[chosen[i]]);
    if (vector_dot(place, place) >= best)
      continue;
    best = vector_dot(place, place);
    memcpy(nearest, place, sizeof place);
    kept.count = count;
    for (int i = 0; i < count; i++)
      memcpy(kept.corners[i], s->corners[chosen[i]], sizeof place);
  }
  *s = kept;
}

static int least_along(const double (*vectors)[3], int count, const double direction[3]) {
  int least = 0;
  for (int i = 1; i < count; i++)
    if (vector_dot(vectors[i], direction) < vector_dot(vectors[least], direction))
      least = i;
  return least;
}

static double longest_of(const double (*vectors)[3], int count) {
  double longest = 0;
  for (int i = 0; i < count; i++)
    longest = fmax(longest, vector_dot(vectors[i], vectors[i]));
  return longest;
}

static void start_at_mean(const double (*vectors)[3], int count, double direction[3]) {
  memset(direction, 0, 3 * sizeof *direction);
  for (int i = 0; i < count; i++)
    vector_add_scaled(direction, 1.0 / count, vectors[i]);
}

bool separation_direction(const double (*vectors)[3], int count, double direction[3]) {
  const double nothing = longest_of(vectors, count) * (16 * DBL_EPSILON * DBL_EPSILON);
  simplex s = {.count = 1};
  start_at_mean(vectors, count, direction);
  int least = least_along(vectors, count, direction);
  if (vector_dot(vectors[least], direction) > 0.1 * vector_dot(direction, direction))
    return true; /* plain cases, of which most are */
  memcpy(s.corners[0], vectors[least], sizeof s.corners[0]);
  memcpy(direction, vectors[least], sizeof s.corners[0]);
  for (int steps = 0; steps < MAX_STEPS; steps++) {
    double square = vector_dot(direction, direction);
    if (!(square > nothing))
      return false;
    least = least_along(vectors, count, direction);
    if (vector_dot(vectors[least], direction) > 0.5 * square)
      return true;
    if (s.count == 4)
      return false;
    memcpy(s.corners[s.count++], vectors[least], sizeof s.corners[0]);
    reduce(&s, direction);
  }
  return false;
}
