/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "point_star.h"

#include <string.h>

#include "hex_tables.h"
#include "id_hash.h"

enum { AHEAD = 16 }; /* corners whose hexes are fetched before their turn: two stars of a grid */

/** Of a hash table for so many entries: a power of two, at most half full. */
static size_t slot_count(size_t entries) {
  size_t slots = 16;
  while (slots < 2 * entries)
    slots *= 2;
  return slots;
}

hexcon_status point_star_new(hexcon_context *context, const corner_table *table, size_t point_count,
                             point_star *out) {
  memset(out, 0, sizeof *out);
  out->point_count = point_count;
  for (size_t v = 0; v < point_count; v++)
    if (table->starts[v + 1] - table->starts[v] > out->most)
      out->most = table->starts[v + 1] - table->starts[v];
  out->others = context_allocate(context, out->most, sizeof *out->others);
  out->firsts = context_allocate(context, out->most, sizeof *out->firsts);
  out->opposite = context_allocate(context, 3 * out->most, sizeof *out->opposite);
  out->slots = context_allocate(context, slot_count(7 * out->most), sizeof *out->slots);
  return out->others && out->firsts && out->opposite && out->slots ? HEXCON_OK
                                                                   : HEXCON_OUT_OF_MEMORY;
}

void point_star_free(hexcon_context *context, point_star *star) {
  context_free(context, star->others);
  context_free(context, star->firsts);
  context_free(context, star->opposite);
  context_free(context, star->slots);
  memset(star, 0, sizeof *star);
}

static size_t clear_slots(point_star *star, size_t entries) {
  size_t slots = slot_count(entries);
  memset(star->slots, -1, slots * sizeof *star->slots);
  return slots - 1;
}

/** Each pair of points is looked at from the lower one only. */
static void find_firsts(point_star *star) {
  size_t mask = clear_slots(star, 7 * star->count);
  const int32_t *ids = star->others[0];
  int32_t *firsts = star->firsts[0];
  for (size_t i = 0; i < 7 * star->count; i++) {
    firsts[i] = -1;
    if (ids[i] < star->point)
      continue;
    size_t slot = (size_t)hash_id(ids[i]) & mask;
    while (star->slots[slot] >= 0 && ids[star->slots[slot]] != ids[i])
      slot = (slot + 1) & mask;
    if (star->slots[slot] < 0)
      star->slots[slot] = (int32_t)i;
    firsts[i] = star->slots[slot];
  }
}

void point_star_side(const point_star *star, size_t side, int32_t ids[3]) {
  const int32_t *others = star->others[side / 3];
  size_t n = side % 3;
  ids[0] = others[n == 2 ? 0 : n + 1];
  ids[1] = others[3 + n];
  ids[2] = others[n];
}

static bool same_ids(const int32_t a[3], const int32_t b[3]) {
  for (int i = 0; i < 3; i++)
    if (a[i] != b[0] && a[i] != b[1] && a[i] != b[2])
      return false;
  return true;
}

/** The first side of each face opens a slot, the second one matches it. */
static void match_sides(point_star *star) {
  size_t mask = clear_slots(star, 3 * star->count);
  for (size_t side = 0; side < 3 * star->count; side++) {
    int32_t ids[3], known[3], first;
    point_star_side(star, side, ids);
    star->opposite[side] = STAR_BOUNDARY;
    size_t slot = (size_t)(hash_id(ids[0]) + hash_id(ids[1]) + hash_id(ids[2])) & mask;
    for (; (first = star->slots[slot]) >= 0; slot = (slot + 1) & mask) {
      point_star_side(star, (size_t)first, known);
      if (same_ids(known, ids))
        break;
    }
    if (first < 0) {
      star->slots[slot] = (int32_t)side;
    } else if (star->opposite[first] >= 0 || known[1] != ids[1] || known[0] != ids[2]) {
      star->opposite[side] = STAR_CROWDED;
    } else {
      star->opposite[first] = (int32_t)side;
      star->opposite[side] = first;
    }
  }
}

void point_star_gather(point_star *star, const int32_t *hexes, const corner_table *table,
                       int32_t point) {
  const int32_t *end = table->corners + table->starts[star->point_count];
  star->point = point;
  star->corners = table->corners + table->starts[point];
  star->count = table->starts[point + 1] - table->starts[point];
  for (size_t i = 0; i < star->count; i++) {
    const int32_t *hex = hexes + 8 * (size_t)(star->corners[i] / 8);
    if (end - star->corners > (ptrdiff_t)i + AHEAD)
      __builtin_prefetch(hexes + 8 * (size_t)(star->corners[i + AHEAD] / 8));
    const unsigned char *others = hex_corner_others[star->corners[i] % 8];
    for (int k = 0; k < 7; k++)
      star->others[i][k] = hex[others[k]];
  }
  find_firsts(star);
  match_sides(star);
}
