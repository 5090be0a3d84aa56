/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "reference_placement.h"

#include <math.h>
#include <string.h>

#include "base/vector.h"
#include "shape/place/conjugate_gradients.h"

typedef struct springs {
  const patch *p;
  double (*pulls)[3]; /* [hex_count] of the edges along each axis */
  double *degree;     /* [free_count] */
  double *all;        /* [3 point_count] a vector with rows for the fixed points, which are zero */
} springs;

static void choose_pulls(springs *s) {
  const patch *p = s->p;
  for (size_t h = 0; h < p->hex_count; h++) {
    double length[3] = {0, 0, 0};
    for (int e = 0; e < PATCH_EDGES; e++)
      length[e / 4] += 0.25 / p->stretch[PATCH_EDGES * h + (size_t)e];
    double volume = length[0] * length[1] * length[2];
    for (int axis = 0; axis < 3; axis++) {
      s->pulls[h][axis] = volume / (length[axis] * length[axis]);
      for (size_t c = 0; c < 8; c++)
        if ((size_t)p->corners[8 * h + c] < p->free_count)
          s->degree[p->corners[8 * h + c]] += s->pulls[h][axis];
    }
  }
}

/** Forces on the free points; `x` has rows for all points. */
static void apply(const springs *s, const double *x, double *out) {
  const patch *p = s->p;
  memset(out, 0, 3 * p->free_count * sizeof *out);
  for (size_t h = 0; h < p->hex_count; h++) {
    const int32_t *corners = p->corners + 8 * h;
    for (int e = 0; e < PATCH_EDGES; e++) {
      int start = patch_edge_start(e);
      size_t a = (size_t)corners[start], b = (size_t)corners[start | 1 << e / 4];
      double along[3];
      vector_subtract(x + 3 * b, x + 3 * a, along);
      if (a < p->free_count)
        vector_add_scaled(out + 3 * a, -s->pulls[h][e / 4], along);
      if (b < p->free_count)
        vector_add_scaled(out + 3 * b, s->pulls[h][e / 4], along);
    }
  }
}

static void multiply(void *user, const double *in, double *out) {
  springs *s = user;
  memcpy(s->all, in, 3 * s->p->free_count * sizeof *in);
  apply(s, s->all, out);
}

static void precondition(void *user, const double *in, double *out) {
  const springs *s = user;
  for (size_t i = 0; i < 3 * s->p->free_count; i++)
    out[i] = in[i] / s->degree[i / 3];
}

hexcon_status reference_placement(hexcon_context *context, patch *p) {
  size_t count = 3 * p->free_count;
  springs s = {.p = p};
  double *work[6] = {NULL};
  s.pulls = context_allocate(context, p->hex_count, sizeof *s.pulls);
  s.degree = context_allocate_zeroed(context, p->free_count, sizeof *s.degree);
  s.all = context_allocate_zeroed(context, p->point_count, 3 * sizeof *s.all);
  hexcon_status status = HEXCON_OK;
  bool ready = s.pulls && s.degree && s.all;
  for (int i = 0; i < 6; i++) {
    work[i] = context_allocate_zeroed(context, count, sizeof *work[i]);
    ready = ready && work[i];
  }
  if (ready) {
    choose_pulls(&s);
    linear_system system = {
        count, multiply, precondition, &s, {work[0], work[1], work[2], work[3]}};
    apply(&s, p->x, work[4]);
    for (size_t i = 0; i < count; i++)
      work[4][i] = -work[4][i];
    status = conjugate_gradients(context, &system, work[4], 1e-5, 2000, work[5]);
    for (size_t i = 0; i < count; i++)
      p->x[i] += work[5][i];
  }
  for (int i = 0; i < 6; i++)
    context_free(context, work[i]);
  context_free(context, s.pulls);
  context_free(context, s.degree);
  context_free(context, s.all);
  return ready ? status : HEXCON_OUT_OF_MEMORY;
}
