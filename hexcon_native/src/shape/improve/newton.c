/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "newton.h"

#include <math.h>
#include <string.h>

hexcon_status newton_new(hexcon_context *context, const patch *p, newton *out) {
  memset(out, 0, sizeof *out);
  out->context = context;
  hexcon_status status = block_matrix_new(context, p, &out->hessian);
  out->gradient = context_allocate(context, p->free_count, 3 * sizeof *out->gradient);
  out->step = context_allocate(context, p->free_count, 3 * sizeof *out->step);
  out->trial = context_allocate(context, p->point_count, 3 * sizeof *out->trial);
  return !status && out->gradient && out->step && out->trial ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

void newton_free(hexcon_context *context, newton *n) {
  block_matrix_free(context, &n->hessian);
  context_free(context, n->gradient);
  context_free(context, n->step);
  context_free(context, n->trial);
  memset(n, 0, sizeof *n);
}

double newton_step(newton *n, patch *p, const frame_energy_options *options) {
  const double enough = 1e-4, tolerance = 0.05;
  const size_t most_products = 60;
  const int most_halvings = 30;
  size_t count = 3 * p->free_count;
  double before = patch_energy(p, p->x, options, n->gradient, &n->hessian).energy;
  if (!isfinite(before))
    return 0;
  for (size_t i = 0; i < count; i++)
    n->gradient[i] = -n->gradient[i];
  n->status = context_after(n->context, count);
  if (p->spaces) {
    tangent_spaces_restrict(p->spaces, n->gradient);
    tangent_spaces_restrict_matrix(p->spaces, &n->hessian);
  }
  if (!n->status)
    n->status =
        block_matrix_solve(n->context, &n->hessian, n->gradient, tolerance, most_products, n->step);
  if (n->status)
    return 0;
  if (p->spaces)
    tangent_spaces_restrict(p->spaces, n->step);
  double descent = 0, length = 1;
  for (size_t i = 0; i < count; i++)
    descent += n->gradient[i] * n->step[i];
  memcpy(n->trial, p->x, 3 * p->point_count * sizeof *n->trial);
  for (int halving = 0; !n->status && halving < most_halvings; halving++) {
    for (size_t i = 0; i < count; i++)
      n->trial[i] = p->x[i] + length * n->step[i];
    if (p->spaces)
      n->status = tangent_spaces_retract(n->context, p->spaces, n->trial);
    if (n->status)
      return 0;
    double after = patch_energy(p, n->trial, options, NULL, NULL).energy;
    if (after <= before - enough * length * descent && after < before) {
      memcpy(p->x, n->trial, count * sizeof *n->trial);
      if (p->spaces)
        tangent_spaces_accept(p->spaces);
      return (before - after) / fmax(fabs(before), 1e-300);
    }
    length /= 2;
    n->status = context_after(n->context, count);
  }
  return 0;
}

hexcon_status newton_go_back(newton *n, patch *p, const double *state) {
  size_t bytes = 3 * p->free_count * sizeof *state;
  memcpy(p->x, state, bytes);
  hexcon_status status = patch_put_on(n->context, p);
  memcpy(p->x, state, bytes); /* without what rounding has moved */
  return status;
}

double newton_descend(newton *n, patch *p, const frame_energy_options *options,
                      double smallest_decrease, int most) {
  double left = 1;
  for (int i = 0; !n->status && i < most; i++) {
    double decrease = newton_step(n, p, options);
    left *= 1 - decrease;
    if (decrease < smallest_decrease)
      break;
  }
  return left;
}
