/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "linking_numbers.h"

#include <string.h>

#include "base/vector.h"

/** Edges whose box is compared as one. */
enum { PIECE = 32 };

/** Boxes and edges compared between two questions whether to go on: some milliseconds. */
enum { WORK_PATIENCE = 1 << 20 };

/** Rounding of coordinates, of the largest one. */
static const double rounding = 1e-14;

/** Along these it is looked, until in one of them no two curves meet: no model lies so. */
static const double directions[][3] = {{0.3128, -0.5417, 0.7802},
                                       {-0.7139, 0.2683, 0.6468},
                                       {0.5381, 0.7693, 0.3446},
                                       {0.1372, 0.8954, -0.4237}};
enum { DIRECTIONS = sizeof directions / sizeof *directions };

typedef struct box {
  double low[2], high[2];
} box;

/** Closed polygons: polygon i has points first[i] .. first[i + 1] - 1; edge k starts at point k. */
typedef struct polygons {
  size_t count;
  size_t *first;
  double *points; /* [.][3] as seen: the last coordinate is the height */
  box *boxes;     /* of pieces; those of polygon i start at first_box[i] */
  size_t *first_box;
} polygons;

/** A direction to look along, and how to bring the surface to size 1. */
typedef struct view {
  double axes[3][3], origin[3], scale;
  double noise; /* of coordinates as seen */
} view;

typedef struct sight {
  const surface *s;
  const handle_cycles *cycles;
  view view;
  polygons along, across;
  bool blurred; /* two curves meet, as far as rounding can tell */
  size_t work;  /* boxes and edges compared since it was asked whether to go on */
} sight;

static void polygons_free(hexcon_context *context, polygons *p) {
  context_free(context, p->first);
  context_free(context, p->points);
  context_free(context, p->boxes);
  context_free(context, p->first_box);
}

static void sight_free(hexcon_context *context, sight *w) {
  polygons_free(context, &w->along);
  polygons_free(context, &w->across);
}

/** Polygons of so many points for each half-edge of each cycle. */
static hexcon_status polygons_new(hexcon_context *context, const size_t *first, size_t count,
                                  size_t points, polygons *out) {
  size_t boxes = 0;
  out->count = count;
  out->first = context_allocate(context, count + 1, sizeof *out->first);
  out->first_box = context_allocate(context, count + 1, sizeof *out->first_box);
  out->points = context_allocate(context, points * first[count], 3 * sizeof *out->points);
  if (!out->first || !out->first_box || !out->points)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t i = 0; i < count; i++) {
    out->first[i] = points * first[i];
    out->first_box[i] = boxes;
    boxes += (points * (first[i + 1] - first[i]) + PIECE - 1) / PIECE;
  }
  out->first[count] = points * first[count];
  out->first_box[count] = boxes;
  out->boxes = context_allocate(context, boxes, sizeof *out->boxes);
  return out->boxes ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

/* ---------------------------------------------------------------------------------------- view */

/** A right-handed frame whose last axis is the direction. */
static void make_axes(const double direction[3], double axes[3][3]) {
  static const double helper[3] = {0.8017, 0.5345, 0.2673};
  double length = vector_length(direction);
  for (int i = 0; i < 3; i++)
    axes[2][i] = direction[i] / length;
  vector_cross(helper, axes[2], axes[0]);
  length = vector_length(axes[0]);
  for (int i = 0; i < 3; i++)
    axes[0][i] /= length;
  vector_cross(axes[2], axes[0], axes[1]);
}

static void make_view(const surface *s, const double direction[3], view *out) {
  double extent = 0, largest = 0;
  make_axes(direction, out->axes);
  memcpy(out->origin, s->points + 3 * (size_t)s->quads[0], sizeof out->origin);
  for (size_t h = 0; h < 4 * s->quad_count; h++)
    for (size_t i = 0; i < 3; i++) {
      double x = s->points[3 * (size_t)s->quads[h] + i];
      extent = fmax(extent, fabs(x - out->origin[i]));
      largest = fmax(largest, fabs(x));
    }
  out->scale = extent > 0 ? extent : 1;
  out->noise = rounding * (1 + largest / out->scale);
}

static void see(const view *v, const double point[3], double out[3]) {
  double arm[3];
  vector_subtract(point, v->origin, arm);
  for (int i = 0; i < 3; i++)
    arm[i] /= v->scale;
  for (int i = 0; i < 3; i++)
    out[i] = vector_dot(v->axes[i], arm);
}

static void see_mean(const sight *w, const int32_t *ids, const int *rows, int count,
                     double out[3]) {
  double mean[3] = {0};
  for (int i = 0; i < count; i++)
    vector_add_scaled(mean, 1.0 / count, w->s->points + 3 * (size_t)ids[rows[i]]);
  see(&w->view, mean, out);
}

static void see_quad(const sight *w, int32_t quad, double out[3]) {
  static const int all[4] = {0, 1, 2, 3};
  see_mean(w, w->s->quads + 4 * (size_t)quad, all, 4, out);
}

static void see_middle(const sight *w, int32_t half_edge, double out[3]) {
  const int ends[2] = {half_edge & 3, (half_edge + 1) & 3};
  see_mean(w, w->s->quads + (half_edge & ~3), ends, 2, out);
}

static void box_pieces(polygons *p) {
  for (size_t i = 0; i < p->count; i++)
    for (size_t k = p->first[i]; k < p->first[i + 1]; k++) {
      box *b = &p->boxes[p->first_box[i] + (k - p->first[i]) / PIECE];
      const size_t next = k + 1 < p->first[i + 1] ? k + 1 : p->first[i];
      const double *ends[2] = {p->points + 3 * k, p->points + 3 * next};
      if ((k - p->first[i]) % PIECE == 0)
        *b = (box){{ends[0][0], ends[0][1]}, {ends[0][0], ends[0][1]}};
      for (int end = 0; end < 2; end++)
        for (int axis = 0; axis < 2; axis++) {
          b->low[axis] = fmin(b->low[axis], ends[end][axis]);
          b->high[axis] = fmax(b->high[axis], ends[end][axis]);
        }
    }
}

static void look_along(sight *w, const double direction[3]) {
  const handle_cycles *c = w->cycles;
  make_view(w->s, direction, &w->view);
  w->blurred = false;
  for (size_t k = 0; k < c->first_along[c->count]; k++)
    see(&w->view, w->s->points + 3 * (size_t)w->s->quads[c->along[k]], w->along.points + 3 * k);
  for (size_t k = 0; k < c->first_across[c->count]; k++) {
    see_middle(w, c->across[k], w->across.points + 6 * k);
    see_quad(w, half_edge_quad(w->s->twins[c->across[k]]), w->across.points + 6 * k + 3);
  }
  box_pieces(&w->along);
  box_pieces(&w->across);
}

/* ----------------------------------------------------------------------------------- crossings */

static double size_of(const double v[3]) {
  return fabs(v[0]) + fabs(v[1]) + fabs(v[2]);
}

/** 1 if c is seen to the left of the line from a to b, -1 to its right, 0 if rounding hides it. */
static int side_of(const double a[3], const double b[3], const double c[3], double noise) {
  double line[3], arm[3];
  vector_subtract(b, a, line);
  vector_subtract(c, a, arm);
  double area = line[0] * arm[1] - line[1] * arm[0];
  double bound = 4 * noise * (size_of(line) + size_of(arm));
  return area > bound ? 1 : area < -bound ? -1 : 0;
}

/** Whether the line c d passes over a b, which it is seen to cross; 0 if rounding hides it. */
static int height_over(const double a[3], const double b[3], const double c[3], const double d[3],
                       double noise) {
  double u[3], v[3], arm[3], normal[3];
  vector_subtract(b, a, u);
  vector_subtract(d, c, v);
  vector_subtract(c, a, arm);
  vector_cross(u, v, normal);
  double volume = vector_dot(arm, normal);
  double bound =
      8 * noise * (size_of(u) * size_of(v) + size_of(arm) * size_of(u) + size_of(arm) * size_of(v));
  if (fabs(volume) <= bound)
    return 0;
  return (volume > 0) == (normal[2] > 0) ? 1 : -1;
}

/** Whether edge c d passes over edge a b. */
static bool passes_over(sight *w, const double a[3], const double b[3], const double c[3],
                        const double d[3]) {
  for (int axis = 0; axis < 2; axis++)
    if (fmax(a[axis], b[axis]) < fmin(c[axis], d[axis]) ||
        fmax(c[axis], d[axis]) < fmin(a[axis], b[axis]))
      return false;
  const double noise = w->view.noise;
  const int sides[4] = {side_of(a, b, c, noise), side_of(a, b, d, noise), side_of(c, d, a, noise),
                        side_of(c, d, b, noise)};
  if (sides[0] * sides[1] > 0 || sides[2] * sides[3] > 0)
    return false;
  const int height = height_over(a, b, c, d, noise);
  w->blurred |= sides[0] * sides[1] * sides[2] * sides[3] == 0 || height == 0;
  return height > 0;
}

/**
 * Where a ring meets its cycle, in the middle of an edge, pushed out it passes over the edge if the
 * surface there faces up. Where the surface folds there, it is pushed past the edge as seen: over a
 * ridge it goes round the edge, once above; in a groove it turns back before it.
 */
static bool passes_over_edge(sight *w, int32_t half_edge) {
  const surface *s = w->s;
  double a[3], b[3], left[3], right[3], line[3], arms[2][3];
  see(&w->view, s->points + 3 * (size_t)half_edge_start(s, half_edge), a);
  see(&w->view, s->points + 3 * (size_t)half_edge_end(s, half_edge), b);
  see_quad(w, half_edge_quad(half_edge), left);
  see_quad(w, half_edge_quad(s->twins[half_edge]), right);
  const int up_left = side_of(a, b, left, w->view.noise);
  const int up_right = side_of(b, a, right, w->view.noise);
  if (up_left == up_right) {
    w->blurred |= up_left == 0;
    return up_left > 0;
  }
  vector_subtract(b, a, line);
  vector_subtract(left, a, arms[0]);
  vector_subtract(right, a, arms[1]);
  const double rise = vector_determinant(line, arms[0], arms[1]);
  w->blurred |= up_left * up_right == 0 || fabs(rise) <= 8 * w->view.noise * size_of(line) *
                                                             (size_of(arms[0]) + size_of(arms[1]));
  return rise < 0;
}

static bool overlap(const box *a, const box *b) {
  return a->low[0] <= b->high[0] && b->low[0] <= a->high[0] && a->low[1] <= b->high[1] &&
         b->low[1] <= a->high[1];
}

static const double *polygon_point(const polygons *p, size_t polygon, size_t row) {
  return p->points + 3 * (row < p->first[polygon + 1] ? row : p->first[polygon]);
}

/** Crossings of a piece of cycle i with one of ring j, modulo 2. */
static bool cross_pieces(sight *w, size_t i, size_t piece, size_t j, size_t other) {
  const polygons *p = &w->along, *r = &w->across;
  const size_t start = p->first[i] + PIECE * piece, begin = r->first[j] + PIECE * other;
  bool odd = false;
  w->work += (size_t)PIECE * PIECE;
  for (size_t k = start; k < start + PIECE && k < p->first[i + 1]; k++)
    for (size_t l = begin; l < begin + PIECE && l < r->first[j + 1]; l++) {
      bool meet = i == j && k == p->first[i] && (l == r->first[j] || l + 1 == r->first[j + 1]);
      if (!meet)
        odd ^= passes_over(w, polygon_point(p, i, k), polygon_point(p, i, k + 1),
                           polygon_point(r, j, l), polygon_point(r, j, l + 1));
    }
  return odd;
}

/** Ask whether to go on once enough has been compared. */
static hexcon_status count_work(hexcon_context *context, sight *w, size_t work) {
  w->work += work;
  if (w->work < WORK_PATIENCE)
    return HEXCON_OK;
  w->work = 0;
  return context_ask(context);
}

/** @param odd  receives the linking number of cycle i and ring j, modulo 2 */
static hexcon_status link(hexcon_context *context, sight *w, size_t i, size_t j, bool *odd) {
  const polygons *p = &w->along, *r = &w->across;
  const size_t boxes = r->first_box[j + 1] - r->first_box[j];
  hexcon_status status = HEXCON_OK;
  *odd = i == j && passes_over_edge(w, w->cycles->along[w->cycles->first_along[i]]);
  for (size_t k = p->first_box[i]; !status && k < p->first_box[i + 1]; k++) {
    for (size_t l = r->first_box[j]; l < r->first_box[j + 1]; l++)
      if (overlap(&p->boxes[k], &r->boxes[l]))
        *odd ^= cross_pieces(w, i, k - p->first_box[i], j, l - r->first_box[j]);
    status = count_work(context, w, boxes);
  }
  return status;
}

/* -------------------------------------------------------------------------------------- matrix */

static hexcon_status fill_matrix(hexcon_context *context, sight *w, bit_matrix *out) {
  hexcon_status status = HEXCON_OK;
  memset(out->rows, 0, out->count * out->words * sizeof *out->rows);
  for (size_t i = 0; i < out->count && !w->blurred && !status; i++) {
    status = context_progress(context, STAGE_LINKING_NUMBERS, (double)i / (double)out->count);
    for (size_t j = 0; !status && j < out->count && !w->blurred; j++) {
      bool odd;
      status = link(context, w, i, j, &odd);
      bit_matrix_add(out, i, j, odd);
    }
  }
  return status;
}

static hexcon_status look(hexcon_context *context, sight *w, bit_matrix *out, bool *known) {
  hexcon_status status = fill_matrix(context, w, out);
  size_t rank = 0;
  *known = false;
  if (status || w->blurred)
    return status;
  status = bit_matrix_is_projection(context, out, known);
  if (!status && *known)
    status = bit_matrix_rank(context, out, &rank);
  *known = *known && 2 * rank == out->count;
  return status;
}

static bool is_too_much(const polygons *along, const polygons *across) {
  return (double)along->first_box[along->count] * (double)across->first_box[across->count] >
         LINKING_MOST_BOXES;
}

hexcon_status linking_numbers_find(hexcon_context *context, const surface *s,
                                   const handle_cycles *cycles, bit_matrix *out, bool *known) {
  sight w = {.s = s, .cycles = cycles};
  *known = false;
  *out = (bit_matrix){0};
  if (cycles->count > LINKING_MOST_CYCLES)
    return HEXCON_OK;
  hexcon_status status = polygons_new(context, cycles->first_along, cycles->count, 1, &w.along);
  if (!status)
    status = polygons_new(context, cycles->first_across, cycles->count, 2, &w.across);
  if (!status && !is_too_much(&w.along, &w.across))
    status = bit_matrix_new(context, cycles->count, out);
  for (size_t i = 0; !status && out->rows && i < DIRECTIONS && !*known; i++) {
    look_along(&w, directions[i]);
    status = context_after(context, s->quad_count);
    if (!status)
      status = look(context, &w, out, known);
  }
  sight_free(context, &w);
  return status;
}

hexcon_status linked_cycles_find(hexcon_context *context, const surface *s, handle_cycles *cycles,
                                 bit_matrix *linking, bool *known) {
  *linking = (bit_matrix){0};
  hexcon_status status = handle_cycles_find(context, s, cycles, known);
  if (!status && *known)
    status = linking_numbers_find(context, s, cycles, linking, known);
  return status;
}
