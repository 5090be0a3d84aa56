/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "manifold.h"

#include <string.h>

hexcon_status manifold_new(hexcon_context *context, const point_star *star, manifold *out) {
  memset(out, 0, sizeof *out);
  out->links_are_discs = true;
  out->hex_parent = context_allocate(context, star->most, sizeof *out->hex_parent);
  out->edge_parent = context_allocate(context, 3 * star->most, sizeof *out->edge_parent);
  out->edge_seen = context_allocate(context, 7 * star->most, sizeof *out->edge_seen);
  return out->hex_parent && out->edge_parent && out->edge_seen ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

void manifold_free(hexcon_context *context, manifold *facts) {
  context_free(context, facts->hex_parent);
  context_free(context, facts->edge_parent);
  context_free(context, facts->edge_seen);
  memset(facts, 0, sizeof *facts);
}

static int32_t find(int32_t *parent, int32_t i) {
  while (parent[i] != i) {
    parent[i] = parent[parent[i]];
    i = parent[i];
  }
  return i;
}

/** True if they were apart. */
static bool unite(int32_t *parent, int32_t a, int32_t b) {
  a = find(parent, a);
  b = find(parent, b);
  if (a < b)
    parent[b] = a;
  else
    parent[a] = b;
  return a != b;
}

/** What is at the point, sides that match counted once. */
typedef struct link_counts {
  int64_t pieces, sides, fans;
  int64_t fans_above; /* around edges to points with a higher id */
  bool open;          /* some side is on the boundary */
} link_counts;

/** Join what two hexes share in a face: themselves, and two edges, which run the other way round.
 */
static void join_across(manifold *facts, const point_star *star, int32_t side, int32_t opposite,
                        link_counts *counts) {
  int32_t here = side / 3, there = opposite / 3, n = side % 3, m = opposite % 3;
  counts->pieces -= unite(facts->hex_parent, here, there);
  for (int end = 0; end < 2; end++) {
    int32_t mine = (n + end) % 3, theirs = (m + 1 - end) % 3;
    bool apart = unite(facts->edge_parent, 3 * here + mine, 3 * there + theirs);
    counts->fans -= apart;
    counts->fans_above -= apart && star->firsts[here][mine] >= 0;
  }
}

static link_counts count_link(manifold *facts, const point_star *star) {
  int32_t count = (int32_t)star->count;
  link_counts counts = {.pieces = count, .fans = 3 * (int64_t)count};
  for (int32_t i = 0; i < count; i++)
    facts->hex_parent[i] = i;
  for (int32_t i = 0; i < 3 * count; i++) {
    facts->edge_parent[i] = i;
    counts.fans_above += star->firsts[i / 3][i % 3] >= 0;
  }
  for (int32_t side = 0; side < 3 * count; side++) {
    int32_t opposite = star->opposite[side];
    counts.open |= opposite < 0;
    counts.sides += opposite < side;
    if (opposite > side)
      join_across(facts, star, side, opposite, &counts);
  }
  return counts;
}

/** Different edges to points with a higher id. */
static int64_t count_edges_above(manifold *facts, const point_star *star) {
  int64_t edges = 0;
  memset(facts->edge_seen, 0, 7 * star->count);
  for (size_t i = 0; i < star->count; i++)
    for (int n = 0; n < 3; n++) {
      int32_t first = star->firsts[i][n];
      if (first < 0 || facts->edge_seen[first])
        continue;
      facts->edge_seen[first] = 1;
      edges++;
    }
  return edges;
}

/** The link of a point, whose vertices are fans, edges are sides and triangles are hexes, must be
 * connected, with Euler characteristic 2 inside and 1 outside. */
void manifold_enter(manifold *facts, const point_star *star) {
  if (star->count == 0)
    return;
  int64_t edges = count_edges_above(facts, star);
  link_counts link = count_link(facts, star);
  facts->used_point_count++;
  facts->edge_count += (size_t)edges;
  facts->links_are_discs &= link.pieces == 1 && link.fans_above == edges &&
                            link.fans - link.sides + (int64_t)star->count == (link.open ? 1 : 2);
}
