/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "shells.h"

#include <stdlib.h>
#include <string.h>

#include "base/vector.h"
#include "geometry.h"

typedef struct closed_shell {
  double low[3], high[3];
  double volume;
  size_t first_quad, end_quad; /* in nest.quads */
  size_t depth;                /* shells around it */
  int32_t component;
} closed_shell;

typedef struct nest {
  const surface *s;
  closed_shell *shells; /* by low[0] */
  int32_t *quads;       /* [quad_count] by component */
  size_t *around;       /* shells whose boxes reach as far in x as the present one */
  uint8_t *turned;      /* [component_count] faces into the solid */
} nest;

static void nest_free(hexcon_context *context, nest *n) {
  context_free(context, n->shells);
  context_free(context, n->quads);
  context_free(context, n->around);
  context_free(context, n->turned);
}

static hexcon_status nest_new(hexcon_context *context, const surface *s, nest *out) {
  *out =
      (nest){.s = s,
             .shells = context_allocate_zeroed(context, s->component_count, sizeof(closed_shell)),
             .quads = context_allocate(context, s->quad_count, sizeof *out->quads),
             .around = context_allocate(context, s->component_count, sizeof *out->around),
             .turned = context_allocate_zeroed(context, s->component_count, 1)};
  return out->shells && out->quads && out->around && out->turned ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

static const double *corner(const surface *s, int32_t half_edge) {
  return s->points + 3 * (size_t)s->quads[half_edge];
}

/* -------------------------------------------------------------------------------------- shells */

static void sort_quads(nest *n) {
  const surface *s = n->s;
  for (size_t q = 0; q < s->quad_count; q++)
    n->shells[s->component_of_quad[q]].end_quad++;
  size_t next = 0;
  for (size_t c = 0; c < s->component_count; c++) {
    size_t count = n->shells[c].end_quad;
    n->shells[c].first_quad = n->shells[c].end_quad = next;
    next += count;
  }
  for (size_t q = 0; q < s->quad_count; q++)
    n->quads[n->shells[s->component_of_quad[q]].end_quad++] = (int32_t)q;
}

static void measure(const nest *n, closed_shell *shell) {
  const surface *s = n->s;
  const double *origin = corner(s, 4 * n->quads[shell->first_quad]);
  memcpy(shell->low, origin, sizeof shell->low);
  memcpy(shell->high, origin, sizeof shell->high);
  for (size_t i = shell->first_quad; i < shell->end_quad; i++) {
    shell->volume += surface_quad_volume(s, n->quads[i], origin);
    for (int32_t h = 4 * n->quads[i]; h < 4 * n->quads[i] + 4; h++)
      for (size_t axis = 0; axis < 3; axis++) {
        shell->low[axis] = fmin(shell->low[axis], corner(s, h)[axis]);
        shell->high[axis] = fmax(shell->high[axis], corner(s, h)[axis]);
      }
  }
}

static int compare_lows(const void *a, const void *b) {
  const closed_shell *one = a, *other = b;
  if (one->low[0] != other->low[0])
    return one->low[0] < other->low[0] ? -1 : 1;
  return one->component < other->component ? -1 : 1;
}

static void find_shells(nest *n) {
  sort_quads(n);
  for (size_t c = 0; c < n->s->component_count; c++) {
    n->shells[c].component = (int32_t)c;
    measure(n, &n->shells[c]);
  }
  qsort(n->shells, n->s->component_count, sizeof *n->shells, compare_lows);
}

/* ------------------------------------------------------------------------------------- nesting */

/** Half the solid angle of a triangle seen from a point; 0 where the point is a corner. Source: Van
 * Oosterom and Strackee, The solid angle of a plane triangle (1983). */
static double half_solid_angle(const double from[3], const double *const corners[3]) {
  double arms[3][3];
  for (int i = 0; i < 3; i++) {
    vector_subtract(corners[i], from, arms[i]);
    double length = vector_length(arms[i]);
    if (!(length > 0))
      return 0;
    for (int axis = 0; axis < 3; axis++)
      arms[i][axis] /= length;
  }
  return atan2(vector_determinant(arms[0], arms[1], arms[2]), 1 + vector_dot(arms[0], arms[1]) +
                                                                  vector_dot(arms[1], arms[2]) +
                                                                  vector_dot(arms[2], arms[0]));
}

/** Two triangles are seen like the bilinear patch, but from between them: there it is cut in four.
 */
static bool lies_near(const double from[3], double corners[4][3]) {
  for (int axis = 0; axis < 3; axis++) {
    double low = INFINITY, high = -INFINITY;
    for (int c = 0; c < 4; c++) {
      low = fmin(low, corners[c][axis]);
      high = fmax(high, corners[c][axis]);
    }
    if (from[axis] < low || from[axis] > high)
      return false;
  }
  return true;
}

static double half_angle_of_triangles(const double from[3], double corners[4][3]) {
  const double *const first[3] = {corners[0], corners[1], corners[2]};
  const double *const second[3] = {corners[0], corners[2], corners[3]};
  return half_solid_angle(from, first) + half_solid_angle(from, second);
}

/** A quarter of a patch: from corner c, over the middles of its sides, to its centre. */
static void quarter(double corners[4][3], int c, double out[4][3]) {
  for (int axis = 0; axis < 3; axis++) {
    double here = corners[c][axis], next = corners[(c + 1) & 3][axis],
           opposite = corners[(c + 2) & 3][axis], last = corners[(c + 3) & 3][axis];
    out[0][axis] = here;
    out[1][axis] = (here + next) / 2;
    out[2][axis] = (here + next + opposite + last) / 4;
    out[3][axis] = (here + last) / 2;
  }
}

static double half_angle_of_patch(const double from[3], double corners[4][3], int depth) {
  if (depth == 0 || !lies_near(from, corners))
    return half_angle_of_triangles(from, corners);
  double sum = 0, part[4][3];
  for (int c = 0; c < 4; c++) {
    quarter(corners, c, part);
    sum += half_angle_of_patch(from, part, depth - 1);
  }
  return sum;
}

/** Whether a shell winds round a point, in either sense. */
static hexcon_status winds_round(hexcon_context *context, const nest *n, const closed_shell *shell,
                                 const double point[3], bool *winds) {
  const double half_turn = acos(-1); /* of half solid angles: a whole winding has 2 pi of them */
  double sum = 0, corners[4][3];
  hexcon_status status = HEXCON_OK;
  for (size_t i = shell->first_quad; !status && i < shell->end_quad; i++) {
    for (int k = 0; k < 4; k++)
      memcpy(corners[k], corner(n->s, 4 * n->quads[i] + k), sizeof corners[k]);
    sum += half_angle_of_patch(point, corners, 24);
    status = context_pass(context, i);
  }
  *winds = fabs(sum) > half_turn;
  return status;
}

/** Count a shell's depth up if another one is round it. */
static hexcon_status count_around(hexcon_context *context, const nest *n, closed_shell *inner,
                                  const closed_shell *outer) {
  bool winds = false;
  for (int axis = 0; axis < 3; axis++)
    if (inner->low[axis] < outer->low[axis] || inner->high[axis] > outer->high[axis])
      return HEXCON_OK;
  hexcon_status status =
      winds_round(context, n, outer, corner(n->s, 4 * n->quads[inner->first_quad]), &winds);
  inner->depth += winds;
  return status;
}

/** Along x, with those shells at hand that reach to the present one. */
static hexcon_status find_depths(hexcon_context *context, nest *n) {
  hexcon_status status = HEXCON_OK;
  size_t reach = 0, looked = 0;
  for (size_t i = 0; !status && i < n->s->component_count; i++) {
    closed_shell *shell = &n->shells[i];
    size_t kept = 0;
    for (size_t k = 0; !status && k < reach; k++) {
      closed_shell *other = &n->shells[n->around[k]];
      if (other->high[0] < shell->low[0])
        continue;
      n->around[kept++] = n->around[k];
      status = count_around(context, n, shell, other);
      if (!status)
        status = count_around(context, n, other, shell);
    }
    looked += reach;
    if (!status && looked >= CONTEXT_PATIENCE) {
      status = context_ask(context);
      looked = 0;
    }
    n->around[kept++] = i;
    reach = kept;
  }
  return status;
}

/* ------------------------------------------------------------------------------------- turning */

static void turn_quad(surface *s, size_t q) {
  half_edge_reverse(s->quads + 4 * q, s->twins + 4 * q);
  for (size_t h = 4 * q; h < 4 * q + 4; h++)
    s->twins[h] = (s->twins[h] & ~3) | (3 - (s->twins[h] & 3));
}

/** Reverse the quads of shells, keeping their first corners, and the adjacency with them. */
static void turn_shells(surface *s, const uint8_t *turned) {
  for (size_t q = 0; q < s->quad_count; q++)
    if (turned[s->component_of_quad[q]]) {
      turn_quad(s, q);
      s->turned = true;
    }
}

static void judge_shells(nest *n, surface *s) {
  for (size_t i = 0; i < s->component_count; i++) {
    const closed_shell *shell = &n->shells[i];
    bool cavity = shell->depth % 2 == 1;
    s->is_cavity[shell->component] = cavity;
    s->cavity_count += cavity;
    n->turned[shell->component] = cavity ? shell->volume > 0 : shell->volume < 0;
  }
}

hexcon_status surface_orient_shells(hexcon_context *context, surface *s) {
  nest n;
  s->is_cavity = context_allocate_zeroed(context, s->component_count, sizeof *s->is_cavity);
  hexcon_status status = s->is_cavity ? nest_new(context, s, &n) : HEXCON_OUT_OF_MEMORY;
  if (!s->is_cavity)
    return status;
  if (!status) {
    find_shells(&n);
    status = context_after(context, s->quad_count);
  }
  if (!status)
    status = find_depths(context, &n);
  if (!status) {
    judge_shells(&n, s);
    turn_shells(s, n.turned);
  }
  nest_free(context, &n);
  return status;
}
