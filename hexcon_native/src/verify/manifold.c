/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "manifold.h"

#include <string.h>

#include "hex_tables.h"

/** Disjoint sets of hex corners (8 a hex) and hex edges (12 a hex), joined across shared faces. */
typedef struct link_sets {
  int32_t *corner_parent, *edge_parent;
  int8_t edge_of_corners[8][8]; /* local edge between two local corners, -1 if none */
} link_sets;

static int32_t find(int32_t *parent, int32_t i) {
  while (parent[i] != i) {
    parent[i] = parent[parent[i]];
    i = parent[i];
  }
  return i;
}

static void unite(int32_t *parent, int32_t a, int32_t b) {
  a = find(parent, a);
  b = find(parent, b);
  if (a < b)
    parent[b] = a;
  else
    parent[a] = b;
}

static void index_edges(link_sets *sets) {
  memset(sets->edge_of_corners, -1, sizeof sets->edge_of_corners);
  for (int e = 0; e < 12; e++) {
    sets->edge_of_corners[hex_edges[e][0]][hex_edges[e][1]] = (int8_t)e;
    sets->edge_of_corners[hex_edges[e][1]][hex_edges[e][0]] = (int8_t)e;
  }
}

/** Join what two hexes share in a face: 4 corners, 4 edges. */
static void join_across(link_sets *sets, const int32_t *hexes, int32_t side, int32_t opposite) {
  int32_t here = side / 6, there = opposite / 6;
  unsigned char mine[4], theirs[4] = {0};
  for (int i = 0; i < 4; i++) {
    mine[i] = hex_faces[side % 6][i];
    for (int j = 0; j < 4; j++)
      if (hexes[8 * (size_t)there + hex_faces[opposite % 6][j]] ==
          hexes[8 * (size_t)here + mine[i]])
        theirs[i] = hex_faces[opposite % 6][j];
  }
  for (int i = 0; i < 4; i++) {
    int next = (i + 1) & 3;
    unite(sets->corner_parent, 8 * here + mine[i], 8 * there + theirs[i]);
    unite(sets->edge_parent, 12 * here + sets->edge_of_corners[mine[i]][mine[next]],
          12 * there + sets->edge_of_corners[theirs[i]][theirs[next]]);
  }
}

typedef struct stamps {
  int32_t *point; /* [point_count] the point at which this one was last seen as a neighbour */
  int32_t *fan;   /* [point_count] with which fan of the edge between them */
} stamps;

/** Count the edges at a point; false if one of them has several fans of hexes. */
static bool count_edges_at(link_sets *sets, const int32_t *hexes, const corner_table *corners,
                           int32_t v, stamps *seen, int64_t *edges) {
  bool single = true;
  *edges = 0;
  for (size_t i = corners->starts[v]; i < corners->starts[v + 1]; i++) {
    int32_t hex = corners->corners[i] / 8, local = corners->corners[i] % 8;
    for (int n = 0; n < 3; n++) {
      int neighbour = hex_corner_neighbours[local][n];
      int32_t other = hexes[8 * (size_t)hex + (size_t)neighbour];
      int32_t fan = find(sets->edge_parent, 12 * hex + sets->edge_of_corners[local][neighbour]);
      if (seen->point[other] != v) {
        seen->point[other] = v;
        seen->fan[other] = fan;
        ++*edges;
      } else {
        single &= seen->fan[other] == fan;
      }
    }
  }
  return single;
}

/** Faces at a point, inner ones counted once; `open` tells whether one is on the boundary. */
static int64_t count_faces_at(const face_table *faces, const corner_table *corners, int32_t v,
                              bool *open) {
  int64_t halves = 0;
  *open = false;
  for (size_t i = corners->starts[v]; i < corners->starts[v + 1]; i++) {
    int32_t hex = corners->corners[i] / 8, local = corners->corners[i] % 8;
    for (int f = 0; f < 6; f++) {
      if (!memchr(hex_faces[f], local, 4))
        continue;
      bool boundary = faces->opposite[6 * hex + f] < 0;
      halves += boundary ? 2 : 1;
      *open |= boundary;
    }
  }
  return halves / 2;
}

/** The link of a point must be connected, with Euler characteristic 2 inside and 1 outside. */
static bool link_is_disc(link_sets *sets, const int32_t *hexes, const face_table *faces,
                         const corner_table *corners, int32_t v, stamps *seen,
                         manifold_facts *facts) {
  size_t first = corners->starts[v], last = corners->starts[v + 1];
  int64_t edges;
  bool open, fans_single = count_edges_at(sets, hexes, corners, v, seen, &edges);
  facts->edge_count += (size_t)edges;
  int32_t root = find(sets->corner_parent, corners->corners[first]);
  for (size_t i = first; i < last; i++)
    if (find(sets->corner_parent, corners->corners[i]) != root)
      return false;
  int64_t face_count = count_faces_at(faces, corners, v, &open);
  return fans_single && edges - face_count + (int64_t)(last - first) == (open ? 1 : 2);
}

static void check_all(link_sets *sets, const int32_t *hexes, size_t hex_count, size_t point_count,
                      const face_table *faces, const corner_table *corners, stamps *seen,
                      manifold_facts *facts) {
  for (size_t i = 0; i < 8 * hex_count; i++)
    sets->corner_parent[i] = (int32_t)i;
  for (size_t i = 0; i < 12 * hex_count; i++)
    sets->edge_parent[i] = (int32_t)i;
  for (size_t side = 0; side < 6 * hex_count; side++)
    if (faces->opposite[side] > (int32_t)side)
      join_across(sets, hexes, (int32_t)side, faces->opposite[side]);
  memset(seen->point, -1, point_count * sizeof *seen->point);
  facts->links_are_discs = true;
  for (size_t v = 0; v < point_count; v++) {
    if (corners->starts[v] == corners->starts[v + 1])
      continue;
    facts->used_point_count++;
    facts->links_are_discs &= link_is_disc(sets, hexes, faces, corners, (int32_t)v, seen, facts);
  }
  facts->edge_count /= 2;
}

hexcon_status manifold_check(hexcon_context *context, const int32_t *hexes, size_t hex_count,
                             size_t point_count, const face_table *faces,
                             const corner_table *corners, manifold_facts *facts) {
  memset(facts, 0, sizeof *facts);
  link_sets sets = {context_allocate(context, 8 * hex_count, sizeof(int32_t)),
                    context_allocate(context, 12 * hex_count, sizeof(int32_t)),
                    {{0}}};
  stamps seen = {context_allocate(context, point_count, sizeof(int32_t)),
                 context_allocate(context, point_count, sizeof(int32_t))};
  bool complete = sets.corner_parent && sets.edge_parent && seen.point && seen.fan;
  if (complete) {
    index_edges(&sets);
    check_all(&sets, hexes, hex_count, point_count, faces, corners, &seen, facts);
  }
  context_free(context, sets.corner_parent);
  context_free(context, sets.edge_parent);
  context_free(context, seen.point);
  context_free(context, seen.fan);
  return complete ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}
