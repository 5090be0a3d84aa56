/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "harmonic.h"

#include <math.h>
#include <string.h>

#include "conjugate_gradients.h"

/** Far below what is visible: so the result depends on the order of the points by rounding only. */
static const double relative_residual = 1e-10;

hexcon_status harmonic_new(hexcon_context *context, const int32_t *quads, size_t quad_count,
                           const uint8_t *fixed, size_t point_count, harmonic *out) {
  *out = (harmonic){
      .point_count = point_count, .quad_count = quad_count, .quads = quads, .fixed = fixed};
  out->degree = context_allocate_zeroed(context, point_count, sizeof *out->degree);
  bool complete = out->degree != NULL;
  for (int i = 0; i < 7; i++) {
    out->work[i] = context_allocate_zeroed(context, point_count, sizeof *out->work[i]);
    complete &= out->work[i] != NULL;
  }
  if (!complete)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t i = 0; i < 4 * quad_count; i++)
    out->degree[quads[i]] += 2;
  return HEXCON_OK;
}

void harmonic_free(hexcon_context *context, harmonic *h) {
  context_free(context, h->degree);
  for (int i = 0; i < 7; i++)
    context_free(context, h->work[i]);
  for (size_t i = 0; i < h->basis_count; i++)
    context_free(context, h->basis[i]);
  memset(h, 0, sizeof *h);
}

/** out = Laplacian of in, zero on the rim. */
static void apply(void *user, const double *in, double *out) {
  const harmonic *h = user;
  memset(out, 0, h->point_count * sizeof *out);
  for (size_t q = 0; q < h->quad_count; q++)
    for (size_t side = 0; side < 4; side++) {
      size_t a = (size_t)h->quads[4 * q + side], b = (size_t)h->quads[4 * q + ((side + 1) & 3)];
      double difference = in[a] - in[b];
      out[a] += difference;
      out[b] -= difference;
    }
  for (size_t v = 0; v < h->point_count; v++)
    if (h->fixed[v])
      out[v] = 0;
}

static double dot_on_rim(const harmonic *h, const double *a, const double *b) {
  double sum = 0;
  for (size_t v = 0; v < h->point_count; v++)
    if (h->fixed[v])
      sum += a[v] * b[v];
  return sum;
}

static void precondition(void *user, const double *in, double *out) {
  const harmonic *h = user;
  for (size_t v = 0; v < h->point_count; v++)
    out[v] = h->fixed[v] ? 0 : in[v] / h->degree[v];
}

/** The inner rows, from those on the rim. */
static hexcon_status solve(hexcon_context *context, harmonic *h, double *values) {
  double *pull = h->work[4], *inner = h->work[5];
  for (size_t v = 0; v < h->point_count; v++)
    if (!h->fixed[v])
      values[v] = 0;
  apply(h, values, pull);
  for (size_t v = 0; v < h->point_count; v++) {
    pull[v] = -pull[v];
    inner[v] = 0;
  }
  linear_system system = {
      h->point_count, apply, precondition, h, {h->work[0], h->work[1], h->work[2], h->work[3]}};
  size_t limit = 100 + 20 * (size_t)sqrt((double)h->point_count);
  hexcon_status status =
      conjugate_gradients(context, &system, pull, relative_residual, limit, inner);
  for (size_t v = 0; v < h->point_count; v++)
    if (!h->fixed[v])
      values[v] = inner[v];
  return status;
}

/** Take from the leftover its part along a basis function, and add that part inside. */
static void project(const harmonic *h, const double *function, double *leftover, double *values) {
  double factor = dot_on_rim(h, leftover, function);
  for (size_t v = 0; v < h->point_count; v++)
    if (h->fixed[v])
      leftover[v] -= factor * function[v];
    else
      values[v] += factor * function[v];
}

static double largest_on_rim(const harmonic *h, const double *values) {
  double largest = 0;
  for (size_t v = 0; v < h->point_count; v++)
    if (h->fixed[v])
      largest = fmax(largest, fabs(values[v]));
  return largest;
}

/** Keep a solved function, scaled to norm 1 on the rim, while there is room. */
static hexcon_status keep(hexcon_context *context, harmonic *h, const double *solved) {
  double norm = sqrt(dot_on_rim(h, solved, solved));
  if (h->basis_count == HARMONIC_MAX_BASIS || norm <= 0)
    return HEXCON_OK;
  double *function = context_allocate(context, h->point_count, sizeof *function);
  if (!function)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t v = 0; v < h->point_count; v++)
    function[v] = solved[v] / norm;
  h->basis[h->basis_count++] = function;
  return HEXCON_OK;
}

hexcon_status harmonic_extend(hexcon_context *context, harmonic *h, double tolerance,
                              double *values) {
  double *leftover = h->work[6];
  memcpy(leftover, values, h->point_count * sizeof *values);
  for (size_t v = 0; v < h->point_count; v++)
    if (!h->fixed[v])
      values[v] = 0;
  for (size_t i = 0; i < h->basis_count; i++)
    project(h, h->basis[i], leftover, values);
  if (largest_on_rim(h, leftover) <= tolerance)
    return HEXCON_OK;
  hexcon_status status = solve(context, h, leftover);
  if (status)
    return status;
  for (size_t v = 0; v < h->point_count; v++)
    if (!h->fixed[v])
      values[v] += leftover[v];
  return keep(context, h, leftover);
}
