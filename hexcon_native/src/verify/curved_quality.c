/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "curved_quality.h"

#include <math.h>
#include <string.h>

#include "base/vector.h"
#include "curved_box.h"
#include "curved_jacobian.h"
#include "hexmesh/hex_arrays.h"

enum {
  PLACES = CURVED_QUALITY_PLACES,
  PATIENCE = 1 << 9 /* hexes between two questions whether to go on */
};

/** Bernstein polynomials of degree 2 at 0, 1/4 .. 1, and half their derivatives. */
static const double values[PLACES][3] = {
    {1, 0, 0}, {0.5625, 0.375, 0.0625}, {0.25, 0.5, 0.25}, {0.0625, 0.375, 0.5625}, {0, 0, 1}};
static const double slopes[PLACES][3] = {
    {-1, 1, 0}, {-0.75, 0.5, 0.25}, {-0.5, 0, 0.5}, {-0.25, -0.5, 0.75}, {0, -1, 1}};

/** Half the derivative along an axis at all places, direction by direction: out[125][3]. */
static void derive(double at[27][3], int axis, double out[PLACES * PLACES * PLACES][3]) {
  const double(*weights[3])[3] = {axis == 0 ? slopes : values, axis == 1 ? slopes : values,
                                  axis == 2 ? slopes : values};
  double first[PLACES][9][3] = {{{0}}}, second[PLACES * PLACES][3][3] = {{{0}}};
  memset(out, 0, PLACES * PLACES * PLACES * sizeof *out);
  for (int i = 0; i < PLACES; i++)
    for (int control = 0; control < 27; control++)
      for (int c = 0; c < 3; c++)
        first[i][control % 9][c] += weights[0][i][control / 9] * at[control][c];
  for (int ij = 0; ij < PLACES * PLACES; ij++)
    for (int control = 0; control < 9; control++)
      for (int c = 0; c < 3; c++)
        second[ij][control % 3][c] +=
            weights[1][ij % PLACES][control / 3] * first[ij / PLACES][control][c];
  for (int ijk = 0; ijk < PLACES * PLACES * PLACES; ijk++)
    for (int control = 0; control < 3; control++)
      for (int c = 0; c < 3; c++)
        out[ijk][c] += weights[2][ijk % PLACES][control] * second[ijk / PLACES][control][c];
}

static double quotient(const double r[3], const double s[3], const double t[3]) {
  double product = vector_length(r) * vector_length(s) * vector_length(t);
  return product > 0 ? fmax(vector_determinant(r, s, t) / product, -1) : -1;
}

double curved_scaled_jacobian(double nodes[20][3], void *room) {
  double at[27][3], scale[3], witness[3], smallest = 1;
  double derivatives[3][PLACES * PLACES * PLACES][3];
  if (!curved_box_make(nodes, room, at, scale))
    return -1;
  double least = fmin(scale[0], fmin(scale[1], scale[2])); /* the hex as a whole is of any size */
  for (int control = 0; control < 27; control++)
    for (int c = 0; c < 3; c++)
      at[control][c] /= scale[c] / least;
  for (int axis = 0; axis < 3; axis++)
    derive(at, axis, derivatives[axis]);
  for (int place = 0; place < PLACES * PLACES * PLACES; place++)
    smallest = fmin(smallest,
                    quotient(derivatives[0][place], derivatives[1][place], derivatives[2][place]));
  if (smallest > 0 && prove_curved_jacobian_sign(nodes, room, witness) != JACOBIAN_POSITIVE)
    smallest = 0;
  return smallest;
}

hexcon_status curved_qualities(hexcon_context *context, const double *points, const int32_t *hexes,
                               size_t hex_count, double *qualities) {
  void *room = context_allocate(context, curved_jacobian_room(), 1);
  hexcon_status status = room ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  for (size_t h = 0; !status && h < hex_count; h++) {
    double nodes[20][3];
    for (size_t n = 0; n < 20; n++)
      memcpy(nodes[n], points + 3 * (size_t)hexes[20 * h + n], sizeof nodes[n]);
    qualities[h] = curved_scaled_jacobian(nodes, room);
    if ((h + 1) % PATIENCE == 0)
      status = context_ask(context);
  }
  context_free(context, room);
  return status;
}

hexcon_status hexcon_quality_second_order(hexcon_context *context, const double *points,
                                          size_t point_count, const int32_t *hexes,
                                          size_t hex_count, double *qualities) {
  context_clear(context);
  hexcon_status status = check_second_order_arrays(context, points, point_count, hexes, hex_count);
  return status ? status : curved_qualities(context, points, hexes, hex_count, qualities);
}
