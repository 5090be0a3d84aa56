/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "sweep_placement.h"

#include "affine_fit.h"
#include "base/vector.h"
#include "harmonic.h"

/** What is left at the rim may be neglected below this part of the mean rim edge. */
static const double negligible = 1e-4;

typedef struct placement {
  const sweep_levels *levels;
  double *points;
  int32_t *rim, *edges; /* cap points on the rim, and the rim's directed edges */
  size_t rim_count, edge_count;
  double *fractions;    /* [rings + 1] 0 at the first cap, 1 at the second */
  double *residuals[3]; /* [cap_point_count] by coordinate */
  harmonic spread;
  rim_pose first, last;
} placement;

static const int32_t *level_ids(const sweep_levels *levels, size_t level) {
  return levels->ids + level * levels->cap_point_count;
}

/** Rim points, and all directed edges from rim to rim: those inside the cap appear in both
 * directions and cancel in the vector area. */
static void collect_rim(placement *p) {
  const sweep_levels *levels = p->levels;
  for (size_t v = 0; v < levels->cap_point_count; v++)
    if (levels->on_rim[v])
      p->rim[p->rim_count++] = (int32_t)v;
  for (size_t i = 0; i < 4 * levels->cap_quad_count; i++) {
    int32_t a = levels->cap_quads[i];
    int32_t b = levels->cap_quads[(i & ~(size_t)3) | ((i + 1) & 3)];
    if (!levels->on_rim[a] || !levels->on_rim[b])
      continue;
    p->edges[2 * p->edge_count] = a;
    p->edges[2 * p->edge_count++ + 1] = b;
  }
}

/** Fractions along the sides by mean length, so that graded rings blend where they are. */
static void measure_fractions(placement *p) {
  size_t rings = p->levels->rings;
  p->fractions[0] = 0;
  for (size_t level = 1; level <= rings; level++) {
    const int32_t *here = level_ids(p->levels, level), *before = level_ids(p->levels, level - 1);
    double sum = 0;
    for (size_t i = 0; i < p->rim_count; i++) {
      double step[3];
      vector_subtract(p->points + 3 * (size_t)here[p->rim[i]],
                      p->points + 3 * (size_t)before[p->rim[i]], step);
      sum += vector_length(step);
    }
    p->fractions[level] = p->fractions[level - 1] + sum;
  }
  double total = p->fractions[rings];
  for (size_t level = 1; level <= rings; level++)
    p->fractions[level] = total > 0 ? p->fractions[level] / total : (double)level / (double)rings;
}

/** The blend of both caps at a level, for one cap point. */
static void blend(const placement *p, const affine_map *up, const affine_map *down, double fraction,
                  size_t v, double out[3]) {
  double from_first[3], from_last[3];
  affine_apply(up, p->points + 3 * (size_t)level_ids(p->levels, 0)[v], from_first);
  affine_apply(down, p->points + 3 * (size_t)level_ids(p->levels, p->levels->rings)[v], from_last);
  for (int i = 0; i < 3; i++)
    out[i] = (1 - fraction) * from_first[i] + fraction * from_last[i];
}

/** What the blend misses at the rim; returns the largest. */
static double measure_residuals(placement *p, const int32_t *ids, const affine_map *up,
                                const affine_map *down, double fraction) {
  double largest = 0;
  for (size_t i = 0; i < p->rim_count; i++) {
    size_t v = (size_t)p->rim[i];
    double blended[3], miss[3];
    blend(p, up, down, fraction, v, blended);
    vector_subtract(p->points + 3 * (size_t)ids[v], blended, miss);
    for (int axis = 0; axis < 3; axis++) {
      p->residuals[axis][v] = miss[axis];
      largest = fmax(largest, fabs(miss[axis]));
    }
  }
  return largest;
}

static double mean_rim_edge(const placement *p, const int32_t *ids) {
  double sum = 0;
  for (size_t e = 0; e < p->edge_count; e++) {
    double edge[3];
    vector_subtract(p->points + 3 * (size_t)ids[p->edges[2 * e]],
                    p->points + 3 * (size_t)ids[p->edges[2 * e + 1]], edge);
    sum += vector_length(edge);
  }
  return p->edge_count ? sum / (double)p->edge_count : 0;
}

static hexcon_status place_level(hexcon_context *context, placement *p, size_t level) {
  const sweep_levels *levels = p->levels;
  const int32_t *ids = level_ids(levels, level);
  rim_pose pose = rim_measure(p->points, ids, p->rim, p->rim_count, p->edges, p->edge_count);
  affine_map up =
      affine_fit(p->points, level_ids(levels, 0), &p->first, ids, &pose, p->rim, p->rim_count);
  affine_map down = affine_fit(p->points, level_ids(levels, levels->rings), &p->last, ids, &pose,
                               p->rim, p->rim_count);
  double fraction = p->fractions[level], tolerance = negligible * mean_rim_edge(p, ids);
  bool bent = measure_residuals(p, ids, &up, &down, fraction) > tolerance;
  for (int axis = 0; bent && axis < 3; axis++) {
    hexcon_status status = harmonic_extend(context, &p->spread, tolerance, p->residuals[axis]);
    if (status)
      return status;
  }
  for (size_t v = 0; v < levels->cap_point_count; v++) {
    if (levels->on_rim[v])
      continue;
    double *point = p->points + 3 * (size_t)ids[v];
    blend(p, &up, &down, fraction, v, point);
    for (int axis = 0; bent && axis < 3; axis++)
      point[axis] += p->residuals[axis][v];
  }
  return HEXCON_OK;
}

/** Levels share extensions, so their order matters within the tolerance: it is taken from where
 * the caps lie, not from how they are numbered. The direction is any that no part is built along.
 */
static bool runs_backwards(const placement *p) {
  static const double direction[3] = {1, 0.6180339887, 0.3819660113};
  double way[3];
  vector_subtract(p->last.center, p->first.center, way);
  return vector_dot(way, direction) < 0;
}

static hexcon_status place_levels(hexcon_context *context, placement *p) {
  const sweep_levels *levels = p->levels;
  collect_rim(p);
  measure_fractions(p);
  p->first =
      rim_measure(p->points, level_ids(levels, 0), p->rim, p->rim_count, p->edges, p->edge_count);
  p->last = rim_measure(p->points, level_ids(levels, levels->rings), p->rim, p->rim_count, p->edges,
                        p->edge_count);
  bool backwards = runs_backwards(p);
  for (size_t step = 1; step < levels->rings; step++) {
    hexcon_status status =
        context_progress(context, STAGE_PLACEMENT, (double)step / (double)levels->rings);
    if (!status)
      status = place_level(context, p, backwards ? levels->rings - step : step);
    if (status)
      return status;
  }
  return HEXCON_OK;
}

hexcon_status sweep_place(hexcon_context *context, const sweep_levels *levels, double *points) {
  placement p = {.levels = levels, .points = points};
  p.rim = context_allocate(context, levels->cap_point_count, sizeof *p.rim);
  p.edges = context_allocate(context, 8 * levels->cap_quad_count, sizeof *p.edges);
  p.fractions = context_allocate(context, levels->rings + 1, sizeof *p.fractions);
  bool complete = p.rim && p.edges && p.fractions;
  for (int axis = 0; axis < 3; axis++) {
    p.residuals[axis] = context_allocate_zeroed(context, levels->cap_point_count, sizeof(double));
    complete &= p.residuals[axis] != NULL;
  }
  hexcon_status status = complete ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  if (!status)
    status = harmonic_new(context, levels->cap_quads, levels->cap_quad_count, levels->on_rim,
                          levels->cap_point_count, &p.spread);
  if (!status)
    status = place_levels(context, &p);
  harmonic_free(context, &p.spread);
  context_free(context, p.rim);
  context_free(context, p.edges);
  context_free(context, p.fractions);
  for (int axis = 0; axis < 3; axis++)
    context_free(context, p.residuals[axis]);
  return status;
}
