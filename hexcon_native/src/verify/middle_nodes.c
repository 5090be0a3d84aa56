/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "middle_nodes.h"

#include "base/sorting.h"

/** An edge of one hex, its lower end first. */
typedef struct hex_edge {
  int32_t low, high, middle, hex;
} hex_edge;

static int compare_ids(int32_t a, int32_t b) {
  return (a > b) - (a < b);
}

static int by_ends(const void *a, const void *b) {
  const hex_edge *p = a, *q = b;
  int order = compare_ids(p->low, q->low);
  order = order ? order : compare_ids(p->high, q->high);
  order = order ? order : compare_ids(p->middle, q->middle);
  return order ? order : compare_ids(p->hex, q->hex);
}

static int by_middle(const void *a, const void *b) {
  const hex_edge *p = a, *q = b;
  int order = compare_ids(p->middle, q->middle);
  return order ? order : by_ends(a, b);
}

static bool same_ends(const hex_edge *a, const hex_edge *b) {
  return a->low == b->low && a->high == b->high;
}

/** Both hexes of every two edges, one after the other, of which just one of ends and middle agrees.
 */
static hexcon_status add_mismatches(hexcon_context *context, const hex_edge *edges, size_t count,
                                    id_list *improper) {
  hexcon_status status = HEXCON_OK;
  for (size_t i = 1; !status && i < count; i++) {
    const hex_edge *a = &edges[i - 1], *b = &edges[i];
    if (same_ends(a, b) == (a->middle == b->middle))
      continue;
    status = id_list_append(context, improper, a->hex);
    if (!status)
      status = id_list_append(context, improper, b->hex);
  }
  return status;
}

static hexcon_status collect_edges(hexcon_context *context, const int32_t *hexes, size_t hex_count,
                                   size_t point_count, hex_edge *edges, id_list *improper) {
  uint8_t *is_corner = context_allocate_zeroed(context, point_count, sizeof *is_corner);
  if (!is_corner)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t h = 0; h < hex_count; h++)
    for (int i = 0; i < 8; i++)
      is_corner[hexes[20 * h + (size_t)i]] = 1;
  hexcon_status status = HEXCON_OK;
  for (size_t h = 0; !status && h < hex_count; h++) {
    const int32_t *nodes = hexes + 20 * h;
    bool collapsed = false;
    for (int e = 0; e < 12; e++) {
      int32_t a = nodes[middle_node_ends[e][0]], b = nodes[middle_node_ends[e][1]],
              middle = nodes[8 + e];
      edges[12 * h + (size_t)e] = (hex_edge){a < b ? a : b, a < b ? b : a, middle, (int32_t)h};
      collapsed |= is_corner[middle] != 0;
    }
    if (collapsed)
      status = id_list_append(context, improper, (int32_t)h);
    if (!status)
      status = context_pass(context, h);
  }
  context_free(context, is_corner);
  return status;
}

hexcon_status middle_nodes_check(hexcon_context *context, const int32_t *hexes, size_t hex_count,
                                 size_t point_count, id_list *improper) {
  hex_edge *edges = context_allocate(context, 12 * hex_count, sizeof *edges);
  if (!edges)
    return HEXCON_OUT_OF_MEMORY;
  hexcon_status status = collect_edges(context, hexes, hex_count, point_count, edges, improper);
  static int (*const orders[2])(const void *, const void *) = {by_ends, by_middle};
  for (int o = 0; !status && o < 2; o++) {
    status = context_sort(context, edges, 12 * hex_count, sizeof *edges, orders[o]);
    if (!status)
      status = add_mismatches(context, edges, 12 * hex_count, improper);
  }
  context_free(context, edges);
  return status;
}
