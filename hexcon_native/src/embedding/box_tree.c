/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "box_tree.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

enum {
  LEAF = 4,      /* boxes in a leaf, at most */
  KEY_BITS = 21, /* of each coordinate on the curve */
  DIGIT_BITS = 11,
  DIGITS = 1 << DIGIT_BITS,
  MAX_WAITING = 4 * 64 /* a path of the tree leaves a few pairs at each level */
};

typedef struct item {
  uint64_t key; /* place on the curve */
  int32_t id;
} item;

/** Node 1 is the root, 2 i and 2 i + 1 are the halves of i; the leaves are those of the last level.
 */
typedef struct tree {
  const box *boxes;
  item *items;
  box *nodes;
  size_t count, first_leaf; /* of boxes; of nodes in a level of leaves: a power of two */
} tree;

/* --------------------------------------------------------------------------------------- the curve
 */

static uint64_t spread_bits(uint64_t x) {
  x = (x | x << 32) & 0x1f00000000ffffu;
  x = (x | x << 16) & 0x1f0000ff0000ffu;
  x = (x | x << 8) & 0x100f00f00f00f00fu;
  x = (x | x << 4) & 0x10c30c30c30c30c3u;
  return (x | x << 2) & 0x1249249249249249u;
}

static void box_around(box *all, const box *more) {
  for (int k = 0; k < 3; k++) {
    all->low[k] = fmin(all->low[k], more->low[k]);
    all->high[k] = fmax(all->high[k], more->high[k]);
  }
}

static box empty_box(void) {
  return (box){{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
}

static void set_keys(tree *t) {
  box all = empty_box();
  for (size_t i = 0; i < t->count; i++)
    box_around(&all, &t->boxes[i]);
  double width = 0;
  for (int k = 0; k < 3; k++)
    width = fmax(width, all.high[k] - all.low[k]);
  double scale = width > 0 ? (double)((1 << KEY_BITS) - 1) / width : 0;
  for (size_t i = 0; i < t->count; i++) {
    uint64_t key = 0;
    for (int k = 0; k < 3; k++) {
      double middle = t->boxes[i].low[k] / 2 + t->boxes[i].high[k] / 2 - all.low[k];
      key |= spread_bits((uint64_t)fmax(0, middle * scale)) << k;
    }
    t->items[i] = (item){key, (int32_t)i};
  }
}

/** By radix, digit after digit. */
static hexcon_status sort_items(hexcon_context *context, tree *t) {
  item *other = context_allocate(context, t->count, sizeof *other);
  size_t *starts = context_allocate(context, DIGITS + 1, sizeof *starts);
  hexcon_status status = other && starts ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  for (int shift = 0; !status && shift < 3 * KEY_BITS; shift += DIGIT_BITS) {
    memset(starts, 0, (DIGITS + 1) * sizeof *starts);
    for (size_t i = 0; i < t->count; i++)
      starts[(t->items[i].key >> shift & (DIGITS - 1)) + 1]++;
    for (size_t d = 0; d < DIGITS; d++)
      starts[d + 1] += starts[d];
    for (size_t i = 0; i < t->count; i++)
      other[starts[t->items[i].key >> shift & (DIGITS - 1)]++] = t->items[i];
    item *kept = t->items;
    t->items = other;
    other = kept;
  }
  context_free(context, other);
  context_free(context, starts);
  return status;
}

/* ---------------------------------------------------------------------------------------- the tree
 */

/** The items of a leaf. */
static size_t leaf_start(const tree *t, size_t node) {
  size_t start = (node - t->first_leaf) * LEAF;
  return start < t->count ? start : t->count;
}

static void bound_nodes(tree *t) {
  for (size_t node = 2 * t->first_leaf - 1; node >= 1; node--) {
    t->nodes[node] = empty_box();
    if (node < t->first_leaf) {
      box_around(&t->nodes[node], &t->nodes[2 * node]);
      box_around(&t->nodes[node], &t->nodes[2 * node + 1]);
      continue;
    }
    for (size_t i = leaf_start(t, node); i < leaf_start(t, node + 1); i++)
      box_around(&t->nodes[node], &t->boxes[t->items[i].id]);
  }
}

static hexcon_status tree_new(hexcon_context *context, const box *boxes, size_t count, tree *t) {
  *t = (tree){.boxes = boxes, .count = count, .first_leaf = 1};
  while (t->first_leaf * LEAF < count)
    t->first_leaf *= 2;
  t->items = context_allocate(context, count, sizeof *t->items);
  t->nodes = context_allocate(context, 2 * t->first_leaf, sizeof *t->nodes);
  if (!t->items || !t->nodes)
    return HEXCON_OUT_OF_MEMORY;
  set_keys(t);
  hexcon_status status = sort_items(context, t);
  if (!status)
    bound_nodes(t);
  return status;
}

static bool boxes_meet(const box *a, const box *b) {
  bool meet = true;
  for (int k = 0; k < 3; k++)
    meet &= a->low[k] <= b->high[k] && b->low[k] <= a->high[k];
  return meet;
}

/* ---------------------------------------------------------------------------------------- the
 * visit */

typedef struct node_pair {
  size_t a, b;
} node_pair;

typedef struct visitor {
  const tree *tree;
  progress_stage stage;
  box_pair_visit visit;
  void *user;
  size_t leaves_done;
} visitor;

static hexcon_status visit_leaves(const visitor *v, hexcon_context *context, node_pair now) {
  const tree *t = v->tree;
  hexcon_status status = HEXCON_OK;
  size_t end_a = leaf_start(t, now.a + 1), end_b = leaf_start(t, now.b + 1);
  for (size_t i = leaf_start(t, now.a); i < end_a; i++) {
    size_t first = now.a == now.b ? i + 1 : leaf_start(t, now.b);
    for (size_t j = first; !status && j < end_b; j++) {
      int32_t a = t->items[i].id, b = t->items[j].id;
      if (boxes_meet(&t->boxes[a], &t->boxes[b]))
        status = v->visit(v->user, context, a, b);
    }
  }
  return status;
}

/** The halves of a pair of nodes; a node with itself has three. */
static int halve(const tree *t, node_pair now, node_pair out[4]) {
  if (now.a == now.b) {
    out[0] = (node_pair){2 * now.a, 2 * now.a + 1};
    out[1] = (node_pair){2 * now.a + 1, 2 * now.a + 1};
    out[2] = (node_pair){2 * now.a, 2 * now.a};
    return 3;
  }
  int count = 0;
  for (size_t half = 0; half < 4; half++) {
    node_pair next = {2 * now.a + half / 2, 2 * now.b + half % 2};
    if (boxes_meet(&t->nodes[next.a], &t->nodes[next.b]))
      out[count++] = next;
  }
  return count;
}

static hexcon_status tell(visitor *v, hexcon_context *context) {
  double fraction = (double)v->leaves_done / (double)v->tree->first_leaf;
  if (v->leaves_done++ % 4096)
    return HEXCON_OK;
  return context_progress(context, v->stage, fraction);
}

static hexcon_status visit_tree(visitor *v, hexcon_context *context) {
  node_pair waiting[MAX_WAITING];
  int count = 1;
  waiting[0] = (node_pair){1, 1};
  hexcon_status status = HEXCON_OK;
  while (!status && count > 0) {
    node_pair now = waiting[--count];
    if (now.a >= v->tree->first_leaf) {
      if (now.a == now.b)
        status = tell(v, context);
      if (!status)
        status = visit_leaves(v, context, now);
    } else {
      count += halve(v->tree, now, waiting + count);
    }
  }
  return status;
}

hexcon_status box_tree_visit_pairs(hexcon_context *context, const box *boxes, size_t count,
                                   progress_stage stage, box_pair_visit visit, void *user) {
  tree t;
  hexcon_status status = tree_new(context, boxes, count, &t);
  visitor v = {&t, stage, visit, user, 0};
  if (!status)
    status = visit_tree(&v, context);
  context_free(context, t.items);
  context_free(context, t.nodes);
  return status;
}
