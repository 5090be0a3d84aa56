/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "proper.h"

#include <string.h>

#include "hex_tables.h"

hexcon_status id_list_append(hexcon_context *context, id_list *list, int32_t id) {
  if (list->count == list->capacity) {
    size_t capacity = list->capacity ? 2 * list->capacity : 16;
    int32_t *ids = context_grow(context, list->ids, capacity, sizeof *ids);
    if (!ids)
      return HEXCON_OUT_OF_MEMORY;
    list->ids = ids;
    list->capacity = capacity;
  }
  list->ids[list->count++] = id;
  return HEXCON_OK;
}

/** How two corners of a hex lie to each other: an edge, or the diagonal of a face, or of space. */
enum { RELATION_EDGE = -1, RELATION_SPACE = -2 }; /* a face diagonal is its local face, 0 .. 5 */

static void tabulate_relations(int32_t relation[8][8]) {
  for (int i = 0; i < 64; i++)
    relation[i / 8][i % 8] = RELATION_SPACE;
  for (int e = 0; e < 12; e++) {
    relation[hex_edges[e][0]][hex_edges[e][1]] = RELATION_EDGE;
    relation[hex_edges[e][1]][hex_edges[e][0]] = RELATION_EDGE;
  }
  for (int f = 0; f < 6; f++)
    for (int i = 0; i < 4; i++)
      relation[hex_faces[f][i]][hex_faces[f][(i + 2) & 3]] = f;
}

typedef struct pair_stamps {
  int32_t *point;    /* [point_count] the point with which this one was last paired */
  int32_t *relation; /* [point_count] the face of the diagonal between them, or RELATION_... */
} pair_stamps;

static hexcon_status check_pairs_at(hexcon_context *context, const int32_t *hexes,
                                    const face_table *faces, const corner_table *corners,
                                    int32_t relation[8][8], int32_t v, pair_stamps *seen,
                                    id_list *improper) {
  for (size_t i = corners->starts[v]; i < corners->starts[v + 1]; i++) {
    int32_t hex = corners->corners[i] / 8, local = corners->corners[i] % 8;
    for (int c = 0; c < 8; c++) {
      int32_t other = hexes[8 * (size_t)hex + (size_t)c];
      if (other <= v)
        continue; /* every pair once, at its lower point */
      int32_t here = relation[local][c];
      if (here >= 0)
        here = faces->face_of_side[6 * hex + here];
      if (seen->point[other] != v) {
        seen->point[other] = v;
        seen->relation[other] = here;
      } else if (here == RELATION_SPACE || seen->relation[other] != here) {
        hexcon_status status = id_list_append(context, improper, hex);
        if (status)
          return status;
      }
    }
  }
  return HEXCON_OK;
}

hexcon_status proper_check(hexcon_context *context, const int32_t *hexes, size_t point_count,
                           const face_table *faces, const corner_table *corners,
                           id_list *improper) {
  int32_t relation[8][8];
  tabulate_relations(relation);
  pair_stamps seen = {context_allocate(context, point_count, sizeof *seen.point),
                      context_allocate(context, point_count, sizeof *seen.relation)};
  hexcon_status status = seen.point && seen.relation ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  if (!status)
    memset(seen.point, -1, point_count * sizeof *seen.point);
  for (size_t v = 0; !status && v < point_count; v++)
    status = check_pairs_at(context, hexes, faces, corners, relation, (int32_t)v, &seen, improper);
  context_free(context, seen.point);
  context_free(context, seen.relation);
  return status;
}

hexcon_status proper_find_doublets(hexcon_context *context, size_t hex_count,
                                   const face_table *faces, id_list *pairs) {
  for (size_t hex = 0; hex < hex_count; hex++)
    for (size_t f = 0; f < 6; f++) {
      int32_t opposite = faces->opposite[6 * hex + f];
      if (opposite < 0 || opposite / 6 <= (int32_t)hex)
        continue;
      int shared = 0, before = 0;
      for (size_t g = 0; g < 6; g++) {
        int32_t side = faces->opposite[6 * hex + g];
        bool same = side >= 0 && side / 6 == opposite / 6;
        shared += same;
        before += same && g < f;
      }
      if (shared < 2 || before)
        continue;
      hexcon_status status = id_list_append(context, pairs, (int32_t)hex);
      if (!status)
        status = id_list_append(context, pairs, opposite / 6);
      if (status)
        return status;
    }
  return HEXCON_OK;
}
