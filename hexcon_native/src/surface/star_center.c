/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "star_center.h"

#include <float.h>
#include <string.h>

#include "base/vector.h"
#include "geometry.h"

enum { DIMENSIONS = 4, ROW = DIMENSIONS + 1 };

/** Unknowns are scaled so that the surface lies in [-1, 1]^3: the solution cannot leave this box.
 */
static const double box = 4;
static const double tolerance = 1e-12;

/** A linear programme: maximise objective . x where row . (x, -1) <= 0 and |x_i| <= box. */
typedef struct programme {
  int dimension;
  size_t count;
  double (*rows)[ROW]; /* [count] coefficients, then the right side at index `dimension` */
  double objective[DIMENSIONS];
  hexcon_context *context;
  hexcon_status *status; /* of all that comes of one programme */
} programme;

/** The best point of the box [-box, box] alone, or of an interval in one dimension. */
static bool solve_line(const programme *p, double solution[DIMENSIONS]) {
  double low = -box, high = box;
  for (size_t i = 0; i < p->count; i++) {
    double slope = p->rows[i][0], bound = p->rows[i][1];
    if (slope > tolerance)
      high = fmin(high, bound / slope);
    else if (slope < -tolerance)
      low = fmax(low, bound / slope);
    else if (bound < -tolerance)
      return false;
  }
  solution[0] = p->objective[0] >= 0 ? high : low;
  return low <= high + tolerance;
}

static bool violates(const programme *p, size_t i, const double x[DIMENSIONS]) {
  double sum = -p->rows[i][p->dimension];
  for (int d = 0; d < p->dimension; d++)
    sum += p->rows[i][d] * x[d];
  return sum > tolerance;
}

/** Express a row on the plane of `pivot_row` by eliminating variable `pivot`. */
static void eliminate(int dimension, const double *row, const double *pivot_row, int pivot,
                      double *out) {
  double factor = row[pivot] / pivot_row[pivot];
  int column = 0;
  for (int d = 0; d < dimension; d++)
    if (d != pivot)
      out[column++] = row[d] - factor * pivot_row[d];
  out[column] = row[dimension] - factor * pivot_row[dimension];
}

static bool solve(const programme *p, double (*scratch[DIMENSIONS])[ROW],
                  double solution[DIMENSIONS]);

/** The optimum on the plane of constraint `tight`, subject to the constraints before it. */
static bool solve_on_plane(const programme *p, size_t tight, double (*scratch[DIMENSIONS])[ROW],
                           double solution[DIMENSIONS]) {
  const double *plane = p->rows[tight];
  if (!*p->status)
    *p->status = context_after(p->context, tight);
  if (*p->status)
    return false;
  int pivot = 0, n = p->dimension;
  for (int d = 1; d < n; d++)
    if (fabs(plane[d]) > fabs(plane[pivot]))
      pivot = d;
  if (fabs(plane[pivot]) < tolerance)
    return false;
  programme lower = {n - 1, 0, scratch[n - 1], {0}, p->context, p->status};
  for (size_t i = 0; i < tight; i++)
    eliminate(n, p->rows[i], plane, pivot, lower.rows[lower.count++]);
  for (int sign = -1; sign <= 1; sign += 2) { /* the box of the eliminated variable */
    double side[ROW] = {0};
    side[pivot] = sign;
    side[n] = box;
    eliminate(n, side, plane, pivot, lower.rows[lower.count++]);
  }
  double objective[ROW] = {0}, reduced[ROW] = {0};
  memcpy(objective, p->objective, sizeof p->objective);
  objective[n] = 0;
  eliminate(n, objective, plane, pivot, reduced);
  for (int d = 0; d < n - 1; d++)
    lower.objective[d] = reduced[d];
  double partial[DIMENSIONS];
  if (!solve(&lower, scratch, partial))
    return false;
  double rest = plane[n];
  for (int d = 0, column = 0; d < n; d++)
    if (d != pivot) {
      solution[d] = partial[column++];
      rest -= plane[d] * solution[d];
    }
  solution[pivot] = rest / plane[pivot];
  return true;
}

static bool solve(const programme *p, double (*scratch[DIMENSIONS])[ROW],
                  double solution[DIMENSIONS]) {
  if (p->dimension == 1)
    return solve_line(p, solution);
  for (int d = 0; d < p->dimension; d++)
    solution[d] = p->objective[d] >= 0 ? box : -box;
  for (size_t i = 0; i < p->count; i++)
    if (violates(p, i, solution) && !solve_on_plane(p, i, scratch, solution))
      return false;
  return true;
}

/** Unit normal and offset of the triangle at a corner of a quad; false if it has no area. */
static bool corner_plane(const surface *s, int32_t corner, double normal[3], double *offset) {
  const double *here = s->points + 3 * (size_t)s->quads[corner];
  double next[3], previous[3];
  vector_subtract(s->points + 3 * (size_t)s->quads[half_edge_turn(corner, 1)], here, next);
  vector_subtract(s->points + 3 * (size_t)s->quads[half_edge_turn(corner, -1)], here, previous);
  vector_cross(next, previous, normal);
  double length = vector_length(normal);
  for (int i = 0; i < 3; i++)
    normal[i] /= length > 0 ? length : 1;
  *offset = vector_dot(normal, here);
  return length > 0;
}

/** Unit normal of a quad and the offset of its mean plane; false if it has no area. */
static bool mean_plane(const surface *s, int32_t quad, double normal[3], double *offset) {
  surface_quad_normal(s, quad, normal);
  double length = vector_length(normal), middle[3] = {0};
  for (int i = 0; i < 3; i++)
    normal[i] /= length > 0 ? length : 1;
  for (int corner = 0; corner < 4; corner++)
    vector_add_scaled(middle, 0.25, s->points + 3 * (size_t)s->quads[4 * quad + corner]);
  *offset = vector_dot(normal, middle);
  return length > 0;
}

/** One of the planes that the centre shall be behind: of corners, or of whole quads. */
typedef bool (*plane_function)(const surface *s, int32_t number, double normal[3], double *offset);

/** Distance of a point to the nearest plane, negative where it is outside. */
static double smallest_distance(const surface *s, plane_function plane, size_t count,
                                const double point[3]) {
  double smallest = DBL_MAX, normal[3], offset;
  for (size_t i = 0; i < count; i++)
    smallest = fmin(smallest,
                    plane(s, (int32_t)i, normal, &offset) ? offset - vector_dot(normal, point) : 0);
  return smallest;
}

/** Centre and half extent of the bounding box. */
static double bounding_cube(const surface *s, double middle[3]) {
  double half = 0;
  for (int axis = 0; axis < 3; axis++) {
    double low = s->points[axis], high = low;
    for (size_t v = 1; v < s->point_count; v++) {
      low = fmin(low, s->points[3 * v + (size_t)axis]);
      high = fmax(high, s->points[3 * v + (size_t)axis]);
    }
    middle[axis] = low / 2 + high / 2;
    half = fmax(half, high / 2 - low / 2);
  }
  return half > 0 ? half : 1;
}

/** Random order makes the expected cost linear; a fixed seed makes the result repeatable. */
static void shuffle(double (*rows)[ROW], size_t count) {
  uint64_t state = 0x9e3779b97f4a7c15u;
  for (size_t i = count; i > 1; i--) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    size_t j = (size_t)((state >> 33) % i);
    double row[ROW];
    memcpy(row, rows[i - 1], sizeof row);
    memcpy(rows[i - 1], rows[j], sizeof row);
    memcpy(rows[j], row, sizeof row);
  }
}

static bool deepest_point(const surface *s, plane_function plane, size_t count, programme *p,
                          double (*scratch[DIMENSIONS])[ROW], double center[3]) {
  double middle[3], half = bounding_cube(s, middle);
  for (size_t i = 0; i < count; i++) {
    double offset, *row = p->rows[p->count];
    if (!plane(s, (int32_t)i, row, &offset))
      continue;
    row[3] = 1;
    row[4] = (offset - vector_dot(row, middle)) / half;
    p->count++;
  }
  shuffle(p->rows, p->count);
  double solution[DIMENSIONS];
  if (!solve(p, scratch, solution))
    return false;
  for (int i = 0; i < 3; i++)
    center[i] = middle[i] + half * solution[i];
  return true;
}

static hexcon_status deepest_behind(hexcon_context *context, const surface *s, plane_function plane,
                                    size_t planes, double center[3], double *margin) {
  double(*scratch[DIMENSIONS])[ROW] = {NULL};
  hexcon_status status = HEXCON_OK;
  programme p = {DIMENSIONS,   0,       context_allocate(context, planes, sizeof *p.rows),
                 {0, 0, 0, 1}, context, &status};
  bool complete = p.rows != NULL;
  for (int d = 1; d < DIMENSIONS; d++) {
    scratch[d] = context_allocate(context, planes + 2 * DIMENSIONS, sizeof *scratch[d]);
    complete &= scratch[d] != NULL;
  }
  if (complete) {
    if (!deepest_point(s, plane, planes, &p, scratch, center))
      (void)bounding_cube(s, center);
    *margin = smallest_distance(s, plane, planes, center);
  }
  context_free(context, p.rows);
  for (int d = 1; d < DIMENSIONS; d++)
    context_free(context, scratch[d]);
  return complete ? status : HEXCON_OUT_OF_MEMORY;
}

hexcon_status surface_star_center(hexcon_context *context, const surface *s, double center[3],
                                  double *margin) {
  return deepest_behind(context, s, corner_plane, 4 * s->quad_count, center, margin);
}

hexcon_status surface_mean_center(hexcon_context *context, const surface *s, double center[3],
                                  double *margin) {
  return deepest_behind(context, s, mean_plane, s->quad_count, center, margin);
}
