/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "curved_boundary.h"

#include <string.h>

#include "bodies.h"
#include "embedding/embedding.h"
#include "hexmesh/id_hash.h"
#include "middle_nodes.h"
#include "surface/build.h"

/** Edges of the boundary by their ends. */
typedef struct edge_table {
  int32_t (*edges)[3]; /* [mask + 1] lower end (-1: free), higher end, middle node */
  size_t mask;
} edge_table;

static int32_t *find_edge(const edge_table *table, int32_t p, int32_t q) {
  const int32_t low = p < q ? p : q, high = p < q ? q : p;
  size_t slot = (size_t)hash_id(low) * 3 + (size_t)hash_id(high);
  for (slot &= table->mask; table->edges[slot][0] >= 0; slot = (slot + 1) & table->mask)
    if (table->edges[slot][0] == low && table->edges[slot][1] == high)
      break;
  return table->edges[slot];
}

static hexcon_status edge_table_new(hexcon_context *context, const int32_t *quads,
                                    size_t quad_count, edge_table *table) {
  size_t capacity = 16;
  while (capacity < 4 * quad_count) /* two edges a quad */
    capacity *= 2;
  table->mask = capacity - 1;
  table->edges = context_allocate(context, capacity, sizeof *table->edges);
  if (!table->edges)
    return HEXCON_OUT_OF_MEMORY;
  memset(table->edges, -1, capacity * sizeof *table->edges);
  for (size_t i = 0; i < 4 * quad_count; i++) {
    int32_t p = quads[i], q = quads[i / 4 * 4 + (i + 1) % 4];
    int32_t *edge = find_edge(table, p, q);
    edge[0] = p < q ? p : q;
    edge[1] = p < q ? q : p;
  }
  return HEXCON_OK;
}

/** Quads with the middle nodes that their sides have in the hexes. */
static hexcon_status add_middles(hexcon_context *context, const int32_t *hexes, size_t hex_count,
                                 const int32_t *quads, size_t quad_count, int32_t *curved) {
  edge_table table;
  hexcon_status status = edge_table_new(context, quads, quad_count, &table);
  for (size_t h = 0; !status && h < hex_count; h++) {
    const int32_t *nodes = hexes + 20 * h;
    for (int e = 0; e < 12; e++) {
      int32_t *edge =
          find_edge(&table, nodes[middle_node_ends[e][0]], nodes[middle_node_ends[e][1]]);
      if (edge[0] >= 0)
        edge[2] = nodes[8 + e];
    }
    status = context_pass(context, h);
  }
  for (size_t i = 0; !status && i < 4 * quad_count; i++) {
    const size_t quad = i / 4, side = i % 4;
    curved[8 * quad + side] = quads[i];
    curved[8 * quad + 4 + side] = find_edge(&table, quads[i], quads[4 * quad + (side + 1) % 4])[2];
  }
  context_free(context, table.edges);
  return status;
}

hexcon_status curved_boundary_check(hexcon_context *context, const double *points,
                                    size_t point_count, const int32_t *hexes, size_t hex_count,
                                    const int32_t *quads, size_t quad_count,
                                    hexcon_embedding *embedding) {
  surface shells = {0};
  int32_t *curved = context_allocate(context, quad_count, 8 * sizeof *curved);
  hexcon_status status = curved ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  if (!status)
    status = add_middles(context, hexes, hex_count, quads, quad_count, curved);
  if (!status)
    status = surface_build(context, NULL, point_count, quads, quad_count, &shells);
  /* a single shell bounds hexes of positive volume: there nothing lies in anything */
  const bool several = !status && shells.component_count > 1;
  if (several)
    status = bodies_prove(context, points, point_count, quads, quad_count, embedding);
  if (!status && (!several || embedding->embedded == HEXCON_EMBEDDED_YES))
    status =
        embedding_prove_curved(context, points, point_count, curved,
                               several ? shells.component_of_quad : NULL, quad_count, embedding);
  surface_free(context, &shells);
  context_free(context, curved);
  return status;
}
