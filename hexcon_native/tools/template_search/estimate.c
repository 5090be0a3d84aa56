/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "estimate.h"

/** One, quads, edges with two hexes behind, vertices of degree three, spread of the degrees. */
static void features_of(const sphere *s, const bool *marked, double x[FEATURES]) {
  int marks = 0, threes = 0, spread = 0;
  for (int d = 0; d < 4 * s->quad_count; d++)
    marks += marked[d];
  for (int v = 0; v < s->vertex_count; v++) {
    threes += s->degree[v] == 3;
    spread += (s->degree[v] - 4) * (s->degree[v] - 4);
  }
  x[0] = 1;
  x[1] = s->quad_count;
  x[2] = marks / 2.0;
  x[3] = threes;
  x[4] = spread;
}

/** Gauss-Jordan elimination of a small positive definite system, right side in the last column. */
static void solve(double rows[FEATURES][FEATURES + 1]) {
  for (int p = 0; p < FEATURES; p++)
    for (int r = 0; r < FEATURES; r++) {
      if (r == p)
        continue;
      const double factor = rows[r][p] / rows[p][p];
      for (int c = p; c <= FEATURES; c++)
        rows[r][c] -= factor * rows[p][c];
    }
}

void estimate_learn(const table *t, estimate *e) {
  enum { SAMPLES = 20000 };
  const double ridge = 1e-6;
  double rows[FEATURES][FEATURES + 1] = {{0}}, x[FEATURES];
  const size_t step = t->count / SAMPLES + 1;
  ball b;
  for (size_t i = 0; i < t->count; i += step) {
    table_replay(t, (uint32_t)i, &b);
    features_of(&b.surface, b.marked, x);
    for (int r = 0; r < FEATURES; r++) {
      for (int c = 0; c < FEATURES; c++)
        rows[r][c] += x[r] * x[c];
      rows[r][FEATURES] += x[r] * b.hex_count;
    }
  }
  for (int r = 0; r < FEATURES; r++)
    rows[r][r] += ridge;
  solve(rows);
  for (int r = 0; r < FEATURES; r++)
    e->weights[r] = rows[r][FEATURES] / rows[r][r];
}

double estimate_hexes(const estimate *e, const sphere *s, const bool *needed) {
  double x[FEATURES], sum = 0;
  features_of(s, needed, x);
  for (int r = 0; r < FEATURES; r++)
    sum += e->weights[r] * x[r];
  return sum;
}
