/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "facet_tree.h"

#include <math.h>
#include <string.h>

#include "base/vector.h"

enum { LEAF = 4, MOST_DEPTH = 64 };

static double middle_of(const facet_tree *t, int32_t facet, int axis) {
  const int32_t *corner = t->corners + 3 * (size_t)facet;
  double sum = 0;
  for (int k = 0; k < 3; k++)
    sum += t->points[3 * (size_t)corner[k] + (size_t)axis];
  return sum;
}

static void box_of(const facet_tree *t, size_t first, size_t end, double box[6]) {
  for (int k = 0; k < 3; k++) {
    box[k] = INFINITY;
    box[3 + k] = -INFINITY;
  }
  for (size_t i = first; i < end; i++) {
    const int32_t *corner = t->corners + 3 * (size_t)t->order[i];
    for (size_t c = 0; c < 9; c++) {
      double value = t->points[3 * (size_t)corner[c / 3] + c % 3];
      box[c % 3] = fmin(box[c % 3], value);
      box[3 + c % 3] = fmax(box[3 + c % 3], value);
    }
  }
}

static int longest_side(const double box[6]) {
  int longest = 0;
  for (int k = 1; k < 3; k++)
    if (box[3 + k] - box[k] > box[3 + longest] - box[longest])
      longest = k;
  return longest;
}

/** By its middle, then by its number, so that the order is one. */
static bool comes_before(const facet_tree *t, int axis, int32_t a, int32_t b) {
  double first = middle_of(t, a, axis), second = middle_of(t, b, axis);
  return first < second || (first == second && a < b);
}

/** The lower half before the upper: Hoare, Algorithm 65: Find (1961), the middle one of three as
 * its bound. */
static void halve(const facet_tree *t, size_t first, size_t end, int axis) {
  int32_t *order = t->order;
  size_t low = first, high = end - 1, half = first + (end - first) / 2;
  while (low < high) {
    int32_t a = order[low], b = order[low + (high - low) / 2], c = order[high];
    int32_t bound = comes_before(t, axis, a, b) ? (comes_before(t, axis, b, c)   ? b
                                                   : comes_before(t, axis, a, c) ? c
                                                                                 : a)
                                                : (comes_before(t, axis, a, c)   ? a
                                                   : comes_before(t, axis, b, c) ? c
                                                                                 : b);
    size_t i = low, j = high;
    while (i <= j) {
      while (comes_before(t, axis, order[i], bound))
        i++;
      while (comes_before(t, axis, bound, order[j]))
        j--;
      if (i <= j) {
        int32_t swapped = order[i];
        order[i++] = order[j];
        order[j] = swapped;
        if (j == 0)
          break;
        j--;
      }
    }
    if (half <= j)
      high = j;
    else if (half >= i)
      low = i;
    else
      break;
  }
}

/** A range of facets and where its node is. */
typedef struct stretch {
  size_t first, end, node;
} stretch;

/** So many nodes has a range: its halves are as even as can be. */
static size_t nodes_of(size_t count) {
  return 2 * count; /* no more, and easily told */
}

static stretch first_half(stretch s) {
  return (stretch){s.first, s.first + (s.end - s.first) / 2, s.node + 1};
}

static stretch second_half(stretch s) {
  size_t half = s.first + (s.end - s.first) / 2;
  return (stretch){half, s.end, s.node + nodes_of(half - s.first)};
}

hexcon_status facet_tree_new(hexcon_context *context, const double *points, const int32_t *corners,
                             const int32_t *facets, size_t count, facet_tree *out) {
  *out = (facet_tree){.points = points, .corners = corners, .count = count};
  out->order = context_allocate(context, count, sizeof *out->order);
  out->boxes = context_allocate(context, count, 12 * sizeof *out->boxes);
  if (!out->order || !out->boxes)
    return HEXCON_OUT_OF_MEMORY;
  memcpy(out->order, facets, count * sizeof *facets);
  stretch stack[MOST_DEPTH];
  size_t depth = 0;
  hexcon_status status = HEXCON_OK;
  stack[depth++] = (stretch){0, count, 0};
  while (!status && depth > 0) {
    stretch s = stack[--depth];
    double *box = out->boxes + 6 * s.node;
    box_of(out, s.first, s.end, box);
    if (s.end - s.first <= LEAF)
      continue;
    halve(out, s.first, s.end, longest_side(box));
    stack[depth++] = second_half(s);
    stack[depth++] = first_half(s);
    status = context_after(context, s.end - s.first);
  }
  return status;
}

void facet_tree_free(hexcon_context *context, facet_tree *tree) {
  context_free(context, tree->order);
  context_free(context, tree->boxes);
  memset(tree, 0, sizeof *tree);
}

static double square_to_box(const double point[3], const double box[6]) {
  double sum = 0;
  for (int k = 0; k < 3; k++) {
    double gap = fmax(0, fmax(box[k] - point[k], point[k] - box[3 + k]));
    sum += gap * gap;
  }
  return sum;
}

/** Weights of the nearest place of a triangle: the regions of Ericson, Real-Time Collision
 * Detection (2005), section 5.1.5. */
static void weigh(const double *const corner[3], const double point[3], double weights[3]) {
  double ab[3], ac[3], ap[3], bp[3], cp[3];
  vector_subtract(corner[1], corner[0], ab);
  vector_subtract(corner[2], corner[0], ac);
  vector_subtract(point, corner[0], ap);
  vector_subtract(point, corner[1], bp);
  vector_subtract(point, corner[2], cp);
  double d1 = vector_dot(ab, ap), d2 = vector_dot(ac, ap), d3 = vector_dot(ab, bp),
         d4 = vector_dot(ac, bp), d5 = vector_dot(ab, cp), d6 = vector_dot(ac, cp);
  double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  double v = 0, w = 0;
  if (d1 <= 0 && d2 <= 0) {
    v = w = 0;
  } else if (d3 >= 0 && d4 <= d3) {
    v = 1;
  } else if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    v = d1 - d3 > 0 ? d1 / (d1 - d3) : 0;
  } else if (d6 >= 0 && d5 <= d6) {
    w = 1;
  } else if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    w = d2 - d6 > 0 ? d2 / (d2 - d6) : 0;
  } else if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    double sum = (d4 - d3) + (d5 - d6);
    w = sum > 0 ? (d4 - d3) / sum : 0;
    v = 1 - w;
  } else if (va + vb + vc > 0) {
    v = vb / (va + vb + vc);
    w = vc / (va + vb + vc);
  }
  weights[0] = 1 - v - w;
  weights[1] = v;
  weights[2] = w;
}

static void look_at(const facet_tree *t, stretch leaf, const double point[3], double *least,
                    facet_place *best) {
  for (size_t i = leaf.first; i < leaf.end; i++) {
    const int32_t *ids = t->corners + 3 * (size_t)t->order[i];
    const double *corner[3];
    double weights[3], foot[3] = {0, 0, 0}, gap[3];
    for (int k = 0; k < 3; k++)
      corner[k] = t->points + 3 * (size_t)ids[k];
    weigh(corner, point, weights);
    for (int k = 0; k < 3; k++)
      vector_add_scaled(foot, weights[k], corner[k]);
    vector_subtract(point, foot, gap);
    double square = vector_dot(gap, gap);
    if (!(square < *least))
      continue;
    *least = square;
    best->facet = t->order[i];
    memcpy(best->weights, weights, sizeof weights);
    memcpy(best->foot, foot, sizeof foot);
  }
}

facet_place facet_tree_nearest(const facet_tree *t, const double point[3]) {
  facet_place best = {.facet = t->order[0], .weights = {1, 0, 0}};
  double least = INFINITY;
  stretch stack[MOST_DEPTH];
  size_t depth = 0;
  stack[depth++] = (stretch){0, t->count, 0};
  while (depth > 0) {
    stretch s = stack[--depth];
    if (!(square_to_box(point, t->boxes + 6 * s.node) < least))
      continue;
    if (s.end - s.first <= LEAF) {
      look_at(t, s, point, &least, &best);
      continue;
    }
    stretch near = first_half(s), far = second_half(s);
    if (square_to_box(point, t->boxes + 6 * far.node) <
        square_to_box(point, t->boxes + 6 * near.node)) {
      stretch other = near;
      near = far;
      far = other;
    }
    stack[depth++] = far;
    stack[depth++] = near;
  }
  return best;
}
