/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "closed_forms.h"

#include <math.h>
#include <string.h>

#include "base/vector.h"
#include "ellipse.h"

static const double right_angle = 1.5707963267948966;

const hexcon_carrier_facts *hexcon_carrier_info(int kind) {
  static const hexcon_carrier_facts rows[] = {
#define FACTS(name, words, freedom, fields) {words, freedom, fields},
      HEXCON_CARRIERS(FACTS)
#undef FACTS
  };
  return kind >= 0 && kind < HEXCON_CARRIER_COUNT ? &rows[kind] : NULL;
}

bool carrier_is_closed(int kind) {
  return kind != HEXCON_CARRIER_CURVE && kind != HEXCON_CARRIER_SURFACE;
}

/** Which fields a kind needs. */
typedef struct carrier_needs {
  bool axis, across;
  int sizes, ends; /* sizes above 0; of the next, so many may be 0: no end */
} carrier_needs;

static const carrier_needs needs_of[HEXCON_CARRIER_COUNT] = {
    [HEXCON_CARRIER_LINE] = {true, false, 0, 1},     [HEXCON_CARRIER_CIRCLE] = {true, false, 1, 1},
    [HEXCON_CARRIER_ELLIPSE] = {true, true, 2, 0},   [HEXCON_CARRIER_PLANE] = {true, false, 0, 0},
    [HEXCON_CARRIER_CYLINDER] = {true, false, 1, 0}, [HEXCON_CARRIER_CONE] = {true, false, 1, 0},
    [HEXCON_CARRIER_SPHERE] = {false, false, 1, 0},  [HEXCON_CARRIER_TORUS] = {true, false, 2, 0},
};

/** Whether `across` counts: of ellipses, and of circles that are arcs. */
static bool needs_across(const hexcon_carrier *c) {
  return needs_of[c->kind].across || (c->kind == HEXCON_CARRIER_CIRCLE && c->sizes[1] > 0);
}

static const double farthest = 1e100;

bool carrier_is_place(const double x[3]) {
  return fabs(x[0]) <= farthest && fabs(x[1]) <= farthest && fabs(x[2]) <= farthest;
}

bool carrier_is_direction(const double v[3]) {
  double length = vector_length(v);
  return isfinite(length) && length > 1e-150;
}

/** The part of `v` across a unit axis. */
static void reject(const double v[3], const double axis[3], double out[3]) {
  memcpy(out, v, 3 * sizeof *v);
  vector_add_scaled(out, -vector_dot(v, axis), axis);
}

/** Some unit vector across a unit axis. */
static void any_across(const double axis[3], double out[3]) {
  int least = 0;
  for (int k = 1; k < 3; k++)
    if (fabs(axis[k]) < fabs(axis[least]))
      least = k;
  double unit[3] = {least == 0, least == 1, least == 2};
  reject(unit, axis, out);
  double length = vector_length(out);
  for (int k = 0; k < 3; k++)
    out[k] /= length;
}

static void scale_to(double length, double v[3]) {
  double factor = length / vector_length(v);
  for (int k = 0; k < 3; k++)
    v[k] *= factor;
}

const char *carrier_fault(const hexcon_carrier *carrier) {
  if (!hexcon_carrier_info(carrier->kind))
    return "its kind does not exist";
  if (!carrier_is_closed(carrier->kind) || carrier->kind == HEXCON_CARRIER_FACETS)
    return NULL;
  const carrier_needs *needs = &needs_of[carrier->kind];
  if (!carrier_is_place(carrier->origin))
    return "its origin is not finite, or beyond 1e100";
  if (needs->axis && !carrier_is_direction(carrier->axis))
    return "its axis has no length, or is not finite";
  for (int i = 0; i < needs->sizes; i++)
    if (!(carrier->sizes[i] > 0 && carrier->sizes[i] <= farthest))
      return "a size of it is not positive, or beyond 1e100";
  for (int i = needs->sizes; i < needs->sizes + needs->ends; i++)
    if (!(carrier->sizes[i] >= 0 && carrier->sizes[i] <= farthest))
      return "its length, or angle, is negative, or beyond 1e100";
  if (carrier->kind == HEXCON_CARRIER_CONE && !(carrier->sizes[0] < right_angle))
    return "its half angle is not below pi / 2";
  if (carrier->kind == HEXCON_CARRIER_TORUS && carrier->sizes[1] > carrier->sizes[0])
    return "its tube is thicker than its ring, so that it crosses itself";
  if (needs_across(carrier)) {
    hexcon_carrier unit = *carrier;
    scale_to(1, unit.axis);
    reject(carrier->across, unit.axis, unit.across);
    if (!carrier_is_direction(unit.across) ||
        vector_length(unit.across) < 1e-9 * vector_length(carrier->across))
      return "its direction across has no length, or goes along its axis";
  }
  return NULL;
}

hexcon_carrier carrier_normalised(const hexcon_carrier *carrier) {
  hexcon_carrier unit = *carrier;
  const carrier_needs *needs = &needs_of[carrier->kind];
  if (needs->axis)
    scale_to(1, unit.axis);
  if (needs_across(carrier)) {
    reject(carrier->across, unit.axis, unit.across);
    scale_to(1, unit.across);
  }
  return unit;
}

/** A point relative to the axis: how far along, how far out, and which way out. */
typedef struct axial {
  double along, out, outward[3];
} axial;

static axial see_from_axis(const hexcon_carrier *c, const double point[3]) {
  axial seen;
  double d[3];
  vector_subtract(point, c->origin, d);
  seen.along = vector_dot(d, c->axis);
  reject(d, c->axis, seen.outward);
  seen.out = vector_length(seen.outward);
  if (seen.out > 1e-14 * fabs(seen.along) && seen.out > 1e-200) {
    /* once more: what is left along the axis is rounding, which counts where it is far away */
    scale_to(1, seen.outward);
    reject(seen.outward, c->axis, seen.outward);
    scale_to(1, seen.outward);
  } else {
    any_across(c->axis, seen.outward);
  }
  return seen;
}

/** origin + along axis + out outward. */
static void place(const hexcon_carrier *c, const axial *seen, double along, double out,
                  double nearest[3]) {
  memcpy(nearest, c->origin, 3 * sizeof *nearest);
  vector_add_scaled(nearest, along, c->axis);
  vector_add_scaled(nearest, out, seen->outward);
}

/** Towards the nearer end of an arc, where a direction misses it. */
static void turn_into_arc(const hexcon_carrier *c, double outward[3]) {
  double second[3];
  vector_cross(c->axis, c->across, second);
  double angle = atan2(vector_dot(outward, second), vector_dot(outward, c->across));
  angle += angle < 0 ? 4 * right_angle : 0;
  if (angle <= c->sizes[1])
    return;
  double end = angle - c->sizes[1] < 4 * right_angle - angle ? c->sizes[1] : 0;
  for (int k = 0; k < 3; k++)
    outward[k] = cos(end) * c->across[k] + sin(end) * second[k];
}

static void project_circle(const hexcon_carrier *c, const double point[3], double nearest[3],
                           double tangent[3]) {
  axial seen = see_from_axis(c, point);
  if (c->sizes[1] > 0)
    turn_into_arc(c, seen.outward);
  place(c, &seen, 0, c->sizes[0], nearest);
  vector_cross(c->axis, seen.outward, tangent);
}

static void project_ellipse(const hexcon_carrier *c, const double point[3], double nearest[3],
                            double tangent[3]) {
  double d[3], second[3], angle[2];
  vector_subtract(point, c->origin, d);
  vector_cross(c->axis, c->across, second);
  const double in_plane[2] = {vector_dot(d, c->across), vector_dot(d, second)};
  ellipse_nearest(c->sizes, in_plane, angle);
  memcpy(nearest, c->origin, 3 * sizeof *nearest);
  vector_add_scaled(nearest, c->sizes[0] * angle[0], c->across);
  vector_add_scaled(nearest, c->sizes[1] * angle[1], second);
  memset(tangent, 0, 3 * sizeof *tangent);
  vector_add_scaled(tangent, -c->sizes[0] * angle[1], c->across);
  vector_add_scaled(tangent, c->sizes[1] * angle[0], second);
  scale_to(1, tangent);
}

static void project_cone(const hexcon_carrier *c, const double point[3], double nearest[3],
                         double normal[3]) {
  axial seen = see_from_axis(c, point);
  double sine = sin(c->sizes[0]), cosine = cos(c->sizes[0]);
  double length = fmax(seen.along * cosine + seen.out * sine, 0); /* 0: at the apex */
  place(c, &seen, length * cosine, length * sine, nearest);
  memset(normal, 0, 3 * sizeof *normal);
  vector_add_scaled(normal, cosine, seen.outward);
  vector_add_scaled(normal, -sine, c->axis);
}

static void project_sphere(const hexcon_carrier *c, const double point[3], double nearest[3],
                           double normal[3]) {
  vector_subtract(point, c->origin, normal);
  if (vector_length(normal) > 1e-200)
    scale_to(1, normal);
  else
    memcpy(normal, (double[3]){0, 0, 1}, 3 * sizeof *normal);
  memcpy(nearest, c->origin, 3 * sizeof *nearest);
  vector_add_scaled(nearest, c->sizes[0], normal);
}

static void project_torus(const hexcon_carrier *c, const double point[3], double nearest[3],
                          double normal[3]) {
  axial seen = see_from_axis(c, point);
  double out = seen.out - c->sizes[0], away = hypot(out, seen.along);
  double cosine = away > 0 ? out / away : 1, sine = away > 0 ? seen.along / away : 0;
  place(c, &seen, c->sizes[1] * sine, c->sizes[0] + c->sizes[1] * cosine, nearest);
  memset(normal, 0, 3 * sizeof *normal);
  vector_add_scaled(normal, cosine, seen.outward);
  vector_add_scaled(normal, sine, c->axis);
}

void carrier_project(const hexcon_carrier *c, const double point[3], double nearest[3],
                     double direction[3]) {
  double d[3], along;
  axial seen;
  switch (c->kind) {
  case HEXCON_CARRIER_LINE:
    vector_subtract(point, c->origin, d);
    along = vector_dot(d, c->axis);
    if (c->sizes[0] > 0)
      along = fmin(fmax(along, 0), c->sizes[0]);
    memcpy(nearest, c->origin, 3 * sizeof *nearest);
    vector_add_scaled(nearest, along, c->axis);
    memcpy(direction, c->axis, 3 * sizeof *direction);
    break;
  case HEXCON_CARRIER_PLANE:
    memcpy(nearest, point, 3 * sizeof *nearest);
    for (int pass = 0; pass < 2; pass++) { /* the second takes the first one's rounding away */
      vector_subtract(nearest, c->origin, d);
      vector_add_scaled(nearest, -vector_dot(d, c->axis), c->axis);
    }
    memcpy(direction, c->axis, 3 * sizeof *direction);
    break;
  case HEXCON_CARRIER_CYLINDER:
    seen = see_from_axis(c, point);
    place(c, &seen, seen.along, c->sizes[0], nearest);
    memcpy(direction, seen.outward, 3 * sizeof *direction);
    break;
  case HEXCON_CARRIER_CIRCLE:
    project_circle(c, point, nearest, direction);
    break;
  case HEXCON_CARRIER_ELLIPSE:
    project_ellipse(c, point, nearest, direction);
    break;
  case HEXCON_CARRIER_CONE:
    project_cone(c, point, nearest, direction);
    break;
  case HEXCON_CARRIER_SPHERE:
    project_sphere(c, point, nearest, direction);
    break;
  case HEXCON_CARRIER_TORUS:
    project_torus(c, point, nearest, direction);
    break;
  default:
    memcpy(nearest, c->origin, 3 * sizeof *nearest);
  }
}
