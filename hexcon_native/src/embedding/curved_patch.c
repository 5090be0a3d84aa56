/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "curved_patch.h"

#include <string.h>

/** Where the nodes are among control points: corners, then the middles of sides. */
static const int places[8] = {0, 6, 8, 2, 3, 7, 5, 1};

int curved_corner_place(int corner) {
  return places[corner];
}

/** An edge's control point is 2 m - (p + q) / 2; the middle one is the sum of the middle nodes less
 * three quarters of the sum of the corners: see verify/serendipity.h. */
void curved_patch_set(curved_patch *p, const double *const nodes[8], const double origin[3]) {
  for (int k = 0; k < 3; k++) {
    ball at[8], corners = ball_exact(0), middles = ball_exact(0);
    for (int n = 0; n < 8; n++)
      at[n] = ball_difference(nodes[n][k], origin[k]);
    for (int i = 0; i < 4; i++) {
      ball ends = ball_scaled(ball_add(at[i], at[(i + 1) & 3]), 0.5);
      p->controls[places[i]][k] = at[i];
      p->controls[places[4 + i]][k] = ball_subtract(ball_scaled(at[4 + i], 2), ends);
      corners = ball_add(corners, at[i]);
      middles = ball_add(middles, at[4 + i]);
    }
    p->controls[4][k] = ball_subtract(middles, ball_scaled(corners, 0.75));
  }
}

/** Weights of three control points in those of the part from s to t: its polar form at (s, s),
 * (s, t) and (t, t). Of dyadic s and t of few bits they are exact. */
static void polar_weights(int32_t place, int depth, double weights[3][3]) {
  const double s = ldexp(place, -depth), t = ldexp(place + 1, -depth);
  const double at[3][2] = {{s, s}, {s, t}, {t, t}};
  for (int i = 0; i < 3; i++) {
    weights[i][0] = (1 - at[i][0]) * (1 - at[i][1]);
    weights[i][1] = (1 - at[i][0]) * at[i][1] + at[i][0] * (1 - at[i][1]);
    weights[i][2] = at[i][0] * at[i][1];
  }
}

static ball weighted(ball a, ball b, ball c, const double weights[3]) {
  ball sum = ball_add(ball_scaled(a, weights[0]), ball_scaled(b, weights[1]));
  return ball_add(sum, ball_scaled(c, weights[2]));
}

void curved_cell_controls(const curved_patch *p, const cell *c, ball controls[CURVED_CONTROLS][3]) {
  if (c->depth == 0) {
    memcpy(controls, p->controls, sizeof p->controls);
    return;
  }
  double along[3][3], across[3][3];
  polar_weights(c->i, c->depth, along);
  polar_weights(c->j, c->depth, across);
  for (int k = 0; k < 3; k++) {
    ball rows[3][3];
    for (int i = 0; i < 3; i++)
      for (int j = 0; j < 3; j++)
        rows[i][j] =
            weighted(p->controls[j][k], p->controls[3 + j][k], p->controls[6 + j][k], along[i]);
    for (int i = 0; i < 3; i++)
      for (int j = 0; j < 3; j++)
        controls[3 * i + j][k] = weighted(rows[i][0], rows[i][1], rows[i][2], across[j]);
  }
}

void curved_controls_from(ball controls[CURVED_CONTROLS][3], int corner, int next,
                          ball out[CURVED_CONTROLS][3]) {
  const int start = places[corner], along = (places[next] - start) / 2;
  const int beside = next == ((corner + 1) & 3) ? (corner + 3) & 3 : (corner + 1) & 3;
  const int inwards = (places[beside] - start) / 2;
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      memcpy(out[3 * i + j], controls[start + i * along + j * inwards], sizeof *out);
}
