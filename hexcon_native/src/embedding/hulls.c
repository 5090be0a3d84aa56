/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "hulls.h"

#include "base/vector.h"
#include "separation.h"

enum { MAX_DIFFERENCES = HULL_PAIRS * HULL_MOST * HULL_MOST };

bool boxes_part(const hull_pair *hulls) {
  for (int k = 0; k < 3; k++) {
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int c = 0; c < hulls->count_a; c++) {
      low[0] = fmin(low[0], ball_low(hulls->a[c][k]));
      high[0] = fmax(high[0], ball_high(hulls->a[c][k]));
    }
    for (int c = 0; c < hulls->count_b; c++) {
      low[1] = fmin(low[1], ball_low(hulls->b[c][k]));
      high[1] = fmax(high[1], ball_high(hulls->b[c][k]));
    }
    if (high[0] < low[1] || high[1] < low[0])
      return true;
  }
  return false;
}

static bool parts_along(const double normal[3], const hull_pair *hulls) {
  double most = -INFINITY, least = INFINITY;
  for (int c = 0; c < hulls->count_a; c++)
    most = fmax(most, ball_high(ball_dot_exact(normal, hulls->a[c])));
  for (int c = 0; c < hulls->count_b; c++)
    least = fmin(least, ball_low(ball_dot_exact(normal, hulls->b[c])));
  return most < least;
}

bool plane_parts(const hull_pair *pairs, int pair_count) {
  double vectors[MAX_DIFFERENCES][3], normal[3];
  int count = 0;
  for (int p = 0; p < pair_count; p++)
    for (int i = 0; i < pairs[p].count_a; i++)
      for (int j = 0; j < pairs[p].count_b; j++, count++)
        for (int k = 0; k < 3; k++)
          vectors[count][k] = pairs[p].b[j][k].mid - pairs[p].a[i][k].mid;
  if (!separation_direction((const double(*)[3])vectors, count, normal))
    return false;
  for (int p = 0; p < pair_count; p++)
    if (!parts_along(normal, &pairs[p]))
      return false;
  return true;
}

bool all_forward(ball (*vectors)[3], int count) {
  double places[FORWARD_MOST][3], normal[3];
  for (int i = 0; i < count; i++) {
    double length = 0;
    for (int k = 0; k < 3; k++) {
      places[i][k] = vectors[i][k].mid;
      length += places[i][k] * places[i][k];
    }
    length = sqrt(length);
    for (int k = 0; k < 3; k++)
      places[i][k] = length > 0 ? places[i][k] / length : 0;
  }
  if (!separation_direction((const double(*)[3])places, count, normal))
    return false;
  for (int i = 0; i < count; i++)
    if (ball_sign(ball_dot_exact(normal, vectors[i])) <= 0)
      return false;
  return true;
}
