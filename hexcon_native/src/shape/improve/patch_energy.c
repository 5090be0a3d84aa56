/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "patch_energy.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "base/vector.h"

/** A frame as a linear map of a hex's corners: frame[axis] = sum over i of weights[i][axis] x. */
typedef struct sample {
  int count;
  int corners[8];
  double weights[8][3];
} sample;

static void corner_sample(int corner, const double *stretch, sample *s) {
  s->count = 4;
  s->corners[3] = corner;
  memset(s->weights, 0, 4 * sizeof s->weights[0]);
  for (int axis = 0; axis < 3; axis++) {
    int bit = 1 << axis, low = corner & ~bit;
    int edge = 4 * axis + (axis == 0 ? low >> 1 : axis == 1 ? (low & 1) | (low >> 1 & 2) : low & 3);
    double weight = corner & bit ? -stretch[edge] : stretch[edge];
    s->corners[axis] = corner ^ bit;
    s->weights[axis][axis] = weight;
    s->weights[3][axis] = -weight;
  }
}

/** The trilinear map's derivative at place[axis] / parts, with the mean target of the edges that
 * take part. */
static void inner_sample(const int place[3], int parts, const double *stretch, sample *s) {
  s->count = 8;
  memset(s->weights, 0, sizeof s->weights);
  for (int i = 0; i < 8; i++)
    s->corners[i] = i;
  for (int axis = 0; axis < 3; axis++) {
    double length = 0, shares[4];
    for (int m = 0; m < 4; m++) {
      int start = patch_edge_start(4 * axis + m), product = 1;
      for (int other = 0; other < 3; other++)
        if (other != axis)
          product *= start >> other & 1 ? place[other] : parts - place[other];
      shares[m] = (double)product / (parts * parts);
      length += shares[m] / stretch[4 * axis + m];
    }
    for (int m = 0; m < 4; m++) {
      int start = patch_edge_start(4 * axis + m);
      s->weights[start][axis] -= shares[m] / length;
      s->weights[start | 1 << axis][axis] += shares[m] / length;
    }
  }
}

/** Parts into which a watched hex is cut along each axis: frames are looked at on this grid. */
static int parts_of(const patch *p, size_t hex) {
  return 1 << p->watched[hex];
}

/** The corners, then the places of the grid. */
static int samples_of(const patch *p, size_t hex) {
  int places = parts_of(p, hex) + 1;
  return p->watched[hex] ? 8 + places * places * places : 8;
}

/** Frames inside a hex only guard its positivity: their energy counts a part of a corner's. */
static const double inner_share = 0.25;

static frame_energy_options options_of(const frame_energy_options *options, int number) {
  frame_energy_options own = *options;
  if (number >= 8)
    own.ceiling = own.inner_ceiling > 0 ? own.inner_ceiling : own.ceiling / inner_share;
  return own;
}

/** Sample number `number` of a hex; false if no corner of it is free, or it has been one before. */
static bool find_sample(const patch *p, size_t hex, int number, sample *s) {
  const double *stretch = p->stretch + PATCH_EDGES * hex;
  if (number < 8) {
    corner_sample(number, stretch, s);
  } else {
    int parts = parts_of(p, hex), k = number - 8, outer = 0, place[3];
    for (int axis = 0; axis < 3; axis++, k /= parts + 1) {
      place[axis] = k % (parts + 1);
      outer += place[axis] % parts == 0;
    }
    if (outer == 3)
      return false;
    inner_sample(place, parts, stretch, s);
  }
  for (int i = 0; i < s->count; i++)
    if ((size_t)p->corners[8 * hex + (size_t)s->corners[i]] < p->free_count)
      return true;
  return false;
}

/** The frame of a sample, where find_sample finds one. */
static bool find_frame(const patch *p, const double *x, size_t hex, int number, sample *s,
                       double frame[3][3]) {
  if (!find_sample(p, hex, number, s))
    return false;
  memset(frame, 0, 9 * sizeof(double));
  for (int i = 0; i < s->count; i++) {
    const double *at = x + 3 * (size_t)p->corners[8 * hex + (size_t)s->corners[i]];
    for (int axis = 0; axis < 3; axis++)
      vector_add_scaled(frame[axis], s->weights[i][axis], at);
  }
  return true;
}

/** sum over axes of weights[axis] rows[axis]. */
static void combine(const double weights[3], double rows[3][3], double out[3]) {
  for (int k = 0; k < 3; k++)
    out[k] = weights[0] * rows[0][k] + weights[1] * rows[1][k] + weights[2] * rows[2][k];
}

/** What a frame's derivatives are at the corners: f and k the frame and its cofactors seen from a
 * corner, p and q what they meet in the second derivative. */
typedef struct corner_parts {
  double f[3], k[3], p[3], q[3];
} corner_parts;

static void add_hessian(const int32_t *corners, size_t free_count, const sample *s,
                        const corner_parts *parts, double identity, block_matrix *hessian) {
  for (int a = 0; a < s->count; a++) {
    int32_t row = corners[s->corners[a]];
    if ((size_t)row >= free_count)
      continue;
    for (int b = 0; b < s->count; b++) {
      int32_t column = corners[s->corners[b]];
      if ((size_t)column >= free_count || column < row)
        continue;
      double *block = block_matrix_at(hessian, row, column);
      double diagonal = identity * vector_dot(s->weights[a], s->weights[b]);
      for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
          block[3 * i + j] += parts[a].f[i] * parts[b].p[j] + parts[a].k[i] * parts[b].q[j];
        block[4 * i] += diagonal;
      }
    }
  }
}

static void add_derivatives(const patch *p, size_t hex, const sample *s, double frame[3][3],
                            frame_derivatives *d, double *gradient, block_matrix *hessian) {
  const int32_t *corners = p->corners + 8 * hex;
  corner_parts parts[8];
  for (int i = 0; i < s->count; i++) {
    combine(s->weights[i], frame, parts[i].f);
    combine(s->weights[i], d->cofactors, parts[i].k);
    for (int k = 0; k < 3; k++) {
      parts[i].p[k] = d->ff * parts[i].f[k] + d->fk * parts[i].k[k];
      parts[i].q[k] = d->fk * parts[i].f[k] + d->kk * parts[i].k[k];
    }
    int32_t v = corners[s->corners[i]];
    if ((size_t)v >= p->free_count)
      continue;
    vector_add_scaled(gradient + 3 * (size_t)v, d->f, parts[i].f);
    vector_add_scaled(gradient + 3 * (size_t)v, d->k, parts[i].k);
  }
  if (hessian)
    add_hessian(corners, p->free_count, s, parts, d->identity, hessian);
}

/** Count a frame's energy by its share. */
static void scale_derivatives(frame_derivatives *d, double share) {
  double *all[] = {&d->value, &d->f, &d->k, &d->identity, &d->ff, &d->fk, &d->kk};
  for (size_t i = 0; i < sizeof all / sizeof *all; i++)
    *all[i] *= share;
}

patch_state patch_energy(const patch *p, const double *x, const frame_energy_options *options,
                         double *gradient, block_matrix *hessian) {
  patch_state state = {0, 0, DBL_MAX};
  if (gradient)
    memset(gradient, 0, 3 * p->free_count * sizeof *gradient);
  if (hessian)
    block_matrix_clear(hessian);
  for (size_t h = 0; h < p->hex_count; h++)
    for (int number = 0; number < samples_of(p, h); number++) {
      sample s;
      double frame[3][3];
      frame_derivatives d;
      if (!find_frame(p, x, h, number, &s, frame))
        continue;
      frame_energy_options own = options_of(options, number);
      bool finite = frame_energy(frame, &own, gradient != NULL, &d);
      state.determinant = fmin(state.determinant, d.determinant);
      if (p->shares)
        scale_derivatives(&d, number < 8 ? p->shares[8 * h + (size_t)number] : inner_share);
      state.energy += finite ? d.value : INFINITY;
      if (!finite && !gradient)
        return state;
      if (finite && gradient)
        add_derivatives(p, h, &s, frame, &d, gradient, hessian);
    }
  return state;
}

patch_state patch_worst_frame(const patch *p, const double *x,
                              const frame_energy_options *options) {
  patch_state state = {0, 0, DBL_MAX};
  frame_energy_options open = *options;
  open.ceiling = 0;
  for (size_t h = 0; h < p->hex_count; h++)
    for (int number = 0; number < samples_of(p, h); number++) {
      sample s;
      double frame[3][3];
      frame_derivatives d;
      if (!find_frame(p, x, h, number, &s, frame))
        continue;
      bool finite = frame_energy(frame, &open, false, &d);
      state.determinant = fmin(state.determinant, d.determinant);
      double energy = finite ? d.value : INFINITY;
      if (number >= 8)
        state.inner_energy = fmax(state.inner_energy, energy);
      state.energy = fmax(state.energy, number < 8 ? energy : 0);
    }
  return state;
}

double patch_guarded_worst(const patch *p) {
  const frame_energy_options options = {0};
  patch_state state = patch_worst_frame(p, p->x, &options);
  return fmax(state.energy, inner_share * state.inner_energy);
}

void patch_watch_thin(patch *p) {
  const frame_energy_options options = {0};
  for (size_t h = 0; h < p->hex_count; h++) {
    double at_corners = 0, inside = 0;
    uint8_t watched = p->watched[h];
    p->watched[h] = watched > 0 ? watched : 1;
    for (int number = 0; number < samples_of(p, h); number++) {
      sample s;
      double frame[3][3];
      frame_derivatives d;
      if (!find_frame(p, p->x, h, number, &s, frame))
        continue;
      double energy = frame_energy(frame, &options, false, &d) ? d.value : INFINITY;
      double *largest = number < 8 ? &at_corners : &inside;
      *largest = fmax(*largest, energy);
    }
    if (inside * inner_share <= at_corners)
      p->watched[h] = watched;
  }
}
