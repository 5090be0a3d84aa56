/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "touching.h"

#include "base/expansion.h"
#include "orientation.h"
#include "patch_cell.h"

/* ---------------------------------------------------------------------------------- side and side
 */

/** From a common end the two go the same way. */
static bool run_together(const double *from, const double *one, const double *other) {
  for (int axis = 0; axis < 3; axis++)
    if (orientation_along(axis, from, one, other) != 0)
      return false;
  for (int k = 0; k < 3; k++)
    if ((one[k] > from[k] && other[k] > from[k]) || (one[k] < from[k] && other[k] < from[k]))
      return true;
  return false;
}

/** Segments of a plane that is not seen from its edge meet if they seem to; so they do if they seem
 * to along all three axes. */
static bool sides_touch(const flat_quad *a, int side_a, const flat_quad *b, int side_b) {
  const int ends_a[2] = {side_a, (side_a + 1) & 3}, ends_b[2] = {side_b, (side_b + 1) & 3};
  int common = 0, free_a = 0, free_b = 0;
  for (int i = 0; i < 2; i++)
    for (int j = 0; j < 2; j++)
      if (a->ids[ends_a[i]] == b->ids[ends_b[j]]) {
        common++;
        free_a = 1 - i;
        free_b = 1 - j;
      }
  const double *const one[2] = {a->corners[ends_a[0]], a->corners[ends_a[1]]};
  const double *const other[2] = {b->corners[ends_b[0]], b->corners[ends_b[1]]};
  if (common == 2)
    return false;
  if (common == 1)
    return run_together(a->corners[ends_a[1 - free_a]], a->corners[ends_a[free_a]],
                        b->corners[ends_b[free_b]]);
  bool meet = orientation_in_space(one[0], one[1], other[0], other[1]) == 0;
  for (int axis = 0; axis < 3; axis++)
    meet = meet && segments_meet_along(axis, one, other) == MEETING_PROVED;
  return meet;
}

/* ------------------------------------------------------------------------------ corner and patch
 */

static void differences(const double *a, const double *b, expansion out[3]) {
  for (int k = 0; k < 3; k++)
    out[k] = expansion_difference(a[k], b[k]);
}

static expansion determinant(const expansion a[3], const expansion b[3], const expansion c[3]) {
  expansion sum = {0};
  for (int k = 0; k < 3; k++) {
    int i = (k + 1) % 3, j = (k + 2) % 3;
    expansion plus = expansion_product(&b[i], &c[j]), minus = expansion_product(&b[j], &c[i]);
    minus = expansion_scaled(&minus, -1);
    plus = expansion_sum(&plus, &minus);
    plus = expansion_product(&a[k], &plus);
    sum = expansion_sum(&sum, &plus);
  }
  return sum;
}

static double approximate(const expansion *value) {
  return value->count ? value->terms[value->count - 1] : 0;
}

/** The equation U W = V Z of patch_quadric.h, exactly, and u = U / V, v = W / V clearly inside: at
 * the sides it is a question of sides. */
static bool corner_touches(const double *place, const flat_quad *quad) {
  expansion e[3], f[3], opposite[3], twist[3], from[3];
  differences(quad->corners[1], quad->corners[0], e);
  differences(quad->corners[3], quad->corners[0], f);
  differences(quad->corners[2], quad->corners[1], opposite);
  differences(place, quad->corners[0], from);
  for (int k = 0; k < 3; k++) {
    expansion minus = expansion_scaled(&f[k], -1);
    twist[k] = expansion_sum(&opposite[k], &minus);
  }
  expansion volume = determinant(e, f, twist), u = determinant(from, f, twist),
            w = determinant(e, from, twist), z = determinant(e, f, from);
  expansion plus = expansion_product(&u, &w), minus = expansion_product(&volume, &z);
  minus = expansion_scaled(&minus, -1);
  expansion value = expansion_sum(&plus, &minus);
  double at[2] = {approximate(&u) / approximate(&volume), approximate(&w) / approximate(&volume)};
  const double margin = 1e-9;
  return !value.lost && expansion_sign(&value) == 0 && expansion_sign(&volume) != 0 &&
         at[0] > margin && at[0] < 1 - margin && at[1] > margin && at[1] < 1 - margin;
}

static bool shares_id(const flat_quad *quad, int32_t id) {
  return quad->ids[0] == id || quad->ids[1] == id || quad->ids[2] == id || quad->ids[3] == id;
}

/** What is of `a` touches `b`. */
static bool parts_touch(const flat_quad *a, const flat_quad *b) {
  for (int i = 0; i < 4; i++) {
    if (b->form == QUAD_CONVEX && side_meets_flat_quad(a, i, b) == MEETING_PROVED)
      return true;
    if (b->form == QUAD_WARPED && !shares_id(b, a->ids[i]) && corner_touches(a->corners[i], b))
      return true;
    for (int j = 0; j < 4; j++)
      if (sides_touch(a, i, b, j))
        return true;
  }
  return false;
}

bool quads_touch(const flat_quad *a, const flat_quad *b) {
  return parts_touch(a, b) || parts_touch(b, a);
}
