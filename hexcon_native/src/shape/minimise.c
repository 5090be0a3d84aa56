/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "minimise.h"

#include <lbfgs.h>
#include <string.h>

#include "base/vector.h"
#include "corner_energy.h"
#include "verify/hex_tables.h"

typedef struct problem {
  hexcon_context *context;
  const region_mesh *mesh;
  const region *r;
  double *positions;  /* the mesh's; rows of the region follow the unknowns */
  double (*sizes)[3]; /* [r->hex_count] target edge lengths by axis */
  double epsilon;
  int power;
  double smallest; /* determinant seen in the last evaluation */
  hexcon_status status;
} problem;

/** Axis of the edge between two corners of a hex. */
static int edge_axis(int a, int b) {
  int bit = hex_corner_bits[a] ^ hex_corner_bits[b];
  return bit == 1 ? 0 : bit == 2 ? 1 : 2;
}

/** Target lengths: the mean edge along each axis, of the hexes as they are now. */
static void choose_sizes(problem *p) {
  for (size_t i = 0; i < p->r->hex_count; i++) {
    const int32_t *hex = p->mesh->hexes + 8 * (size_t)p->r->hexes[i];
    double *size = p->sizes[i], sum = 0;
    size[0] = size[1] = size[2] = 0;
    for (int e = 0; e < 12; e++) {
      double edge[3];
      vector_subtract(p->positions + 3 * (size_t)hex[hex_edges[e][0]],
                      p->positions + 3 * (size_t)hex[hex_edges[e][1]], edge);
      size[edge_axis(hex_edges[e][0], hex_edges[e][1])] += vector_length(edge) / 4;
    }
    for (int axis = 0; axis < 3; axis++)
      sum += size[axis];
    for (int axis = 0; axis < 3; axis++)
      size[axis] = sum > 0 ? fmax(size[axis], 1e-3 * sum) : 1;
  }
}

static void add_gradient(const problem *p, lbfgsfloatval_t *gradient, int32_t v, double factor,
                         const double *g) {
  int32_t slot = p->mesh->slot_of_point[v];
  if (slot >= 0)
    vector_add_scaled(gradient + 3 * slot, factor, g);
}

/** Energy of one corner to the given power, added to value and gradient. */
static double add_corner(problem *p, size_t i, int corner, lbfgsfloatval_t *gradient) {
  const int32_t *hex = p->mesh->hexes + 8 * (size_t)p->r->hexes[i];
  double frame[3][3], slope[3][3], determinant, scale[3];
  for (int e = 0; e < 3; e++) {
    int other = hex_corner_neighbours[corner][e];
    vector_subtract(p->positions + 3 * (size_t)hex[other], p->positions + 3 * (size_t)hex[corner],
                    frame[e]);
    scale[e] = 1 / p->sizes[i][edge_axis(corner, other)];
    for (int k = 0; k < 3; k++)
      frame[e][k] *= scale[e];
  }
  double energy = corner_energy(frame, p->epsilon, slope, &determinant);
  p->smallest = fmin(p->smallest, determinant);
  double outer = p->power;
  for (int k = 1; k < p->power; k++)
    outer *= energy;
  for (int e = 0; e < 3; e++) {
    add_gradient(p, gradient, hex[hex_corner_neighbours[corner][e]], outer * scale[e], slope[e]);
    add_gradient(p, gradient, hex[corner], -outer * scale[e], slope[e]);
  }
  return outer / p->power * energy;
}

static lbfgsfloatval_t evaluate(void *user, const lbfgsfloatval_t *x, lbfgsfloatval_t *gradient,
                                const int n, const lbfgsfloatval_t step) {
  (void)step;
  problem *p = user;
  for (size_t i = 0; i < p->r->point_count; i++)
    memcpy(p->positions + 3 * (size_t)p->r->points[i], x + 3 * i, 3 * sizeof *x);
  memset(gradient, 0, (size_t)n * sizeof *gradient);
  p->smallest = 1;
  double sum = 0;
  for (size_t i = 0; i < p->r->hex_count; i++)
    for (int corner = 0; corner < 8; corner++)
      sum += add_corner(p, i, corner, gradient);
  return sum;
}

/** liblbfgs calls this after every iteration; a value other than 0 stops it. */
static int watch(void *user, const lbfgsfloatval_t *x, const lbfgsfloatval_t *g,
                 const lbfgsfloatval_t fx, const lbfgsfloatval_t xnorm, const lbfgsfloatval_t gnorm,
                 const lbfgsfloatval_t step, int n, int k, int evaluations) {
  (void)x, (void)g, (void)fx, (void)xnorm, (void)gnorm, (void)step, (void)n, (void)evaluations;
  problem *p = user;
  p->status = context_progress(p->context, "optimisation", k % 100 / 100.0);
  return p->status != HEXCON_OK;
}

/** One run of L-BFGS at the present epsilon. Stalled line searches are no fault: x then holds the
 * best point so far. */
static hexcon_status descend(problem *p, double *x, int iterations, double *energy) {
  lbfgs_parameter_t parameters;
  lbfgs_parameter_init(&parameters);
  parameters.max_iterations = iterations;
  parameters.epsilon = 1e-7;
  parameters.past = 5;
  parameters.delta = 1e-5;
  int code = lbfgs((int)(3 * p->r->point_count), x, energy, evaluate, watch, p, &parameters);
  if (p->status)
    return p->status;
  if (code == LBFGSERR_OUTOFMEMORY)
    return context_fail(p->context, HEXCON_OUT_OF_MEMORY, "out of memory in L-BFGS on %zu points",
                        p->r->point_count);
  return HEXCON_OK;
}

/** The rule of Garanzha et al., section 3.2: sharpen as far as the descent has earned. */
static double next_epsilon(double epsilon, double smallest, double energy, double before) {
  double sigma = fmax(1 - energy / before, 0.1);
  double root = sqrt(smallest * smallest + epsilon * epsilon);
  return smallest >= 0 ? epsilon * (1 - sigma)
                       : epsilon * (1 - sigma * root / (fabs(smallest) + root));
}

static hexcon_status untangle(problem *p, double *x, double *gradient, int iterations) {
  const int rounds = 40;
  p->epsilon = 1;
  hexcon_status status = HEXCON_OK;
  for (int round = 0; !status && round < rounds; round++) {
    int n = (int)(3 * p->r->point_count);
    double before = evaluate(p, x, gradient, n, 0), energy = before;
    status = descend(p, x, iterations, &energy);
    double after = evaluate(p, x, gradient, n, 0);
    if (p->smallest > 1e-3 && p->epsilon < 0.1)
      break;
    p->epsilon = next_epsilon(p->epsilon, p->smallest, after, before);
  }
  return status;
}

static hexcon_status minimise(problem *p, const minimise_options *options, double *x,
                              double *gradient) {
  choose_sizes(p);
  for (size_t i = 0; i < p->r->point_count; i++)
    memcpy(x + 3 * i, p->positions + 3 * (size_t)p->r->points[i], 3 * sizeof *x);
  hexcon_status status = HEXCON_OK;
  if (options->untangle) {
    status = untangle(p, x, gradient, options->iterations);
  } else {
    double energy;
    p->epsilon = 1e-3; /* all but a barrier, and no line search fails on it */
    status = descend(p, x, options->iterations, &energy);
  }
  (void)evaluate(p, x, gradient, (int)(3 * p->r->point_count), 0); /* writes the positions */
  return status;
}

hexcon_status region_minimise(hexcon_context *context, const region_mesh *mesh, const region *r,
                              const minimise_options *options, double *positions) {
  problem p = {
      .context = context, .mesh = mesh, .r = r, .positions = positions, .power = options->power};
  if (r->point_count == 0)
    return HEXCON_OK;
  if (r->point_count > CONTEXT_MAX_COUNT / 3)
    return context_fail(context, HEXCON_TOO_LARGE, "%zu free points are too many for L-BFGS",
                        r->point_count);
  p.sizes = context_allocate(context, r->hex_count, sizeof *p.sizes);
  double *gradient = context_allocate(context, 3 * r->point_count, sizeof *gradient);
  double *x = lbfgs_malloc((int)(3 * r->point_count));
  hexcon_status status = HEXCON_OUT_OF_MEMORY;
  if (p.sizes && gradient && x)
    status = minimise(&p, options, x, gradient);
  else if (p.sizes && gradient)
    status = context_fail(context, HEXCON_OUT_OF_MEMORY, "out of memory in L-BFGS on %zu points",
                          r->point_count);
  context_free(context, p.sizes);
  context_free(context, gradient);
  lbfgs_free(x);
  return status;
}
