/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "proper.h"

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

/** Do two corners of the star have the same point on an edge of both, or across one face of both?
 * @param a, b  its places, as 7 * i + k */
static bool pairs_alike(const point_star *star, int32_t a, int32_t b) {
  int32_t kind = a % 7, other_kind = b % 7;
  if (kind < 3 || other_kind < 3)
    return kind < 3 && other_kind < 3;
  if (kind == 6 || other_kind == 6)
    return false;
  int32_t here[3], there[3];
  point_star_side(star, (size_t)(3 * (a / 7) + kind - 3), here);
  point_star_side(star, (size_t)(3 * (b / 7) + other_kind - 3), there);
  return (here[0] == there[0] && here[2] == there[2]) ||
         (here[0] == there[2] && here[2] == there[0]);
}

hexcon_status proper_check(hexcon_context *context, const point_star *star, id_list *improper) {
  hexcon_status status = HEXCON_OK;
  for (int32_t place = 0; !status && place < 7 * (int32_t)star->count; place++) {
    int32_t first = star->firsts[place / 7][place % 7];
    if (first >= 0 && first != place && !pairs_alike(star, first, place))
      status = id_list_append(context, improper, star->corners[place / 7] / 8);
  }
  return status;
}

hexcon_status proper_find_doublets(hexcon_context *context, size_t hex_count,
                                   const face_table *faces, id_list *pairs) {
  for (size_t hex = 0; hex < hex_count; hex++) {
    hexcon_status asked = context_pass(context, hex);
    if (asked)
      return asked;
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
  }
  return HEXCON_OK;
}
