/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "face_table.h"

#include <string.h>

#include "hex_tables.h"

void face_of_hex(const int32_t *hexes, int32_t side, int32_t corners[4]) {
  const int32_t *hex = hexes + 8 * (size_t)(side / 6);
  for (int i = 0; i < 4; i++)
    corners[i] = hex[hex_faces[side % 6][i]];
}

static uint64_t mix(uint64_t x) { /* splitmix64's finaliser */
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

uint64_t face_hash(const int32_t corners[4]) {
  uint64_t sum = 0;
  for (int i = 0; i < 4; i++)
    sum += mix((uint64_t)(uint32_t)corners[i] + 0x9e3779b97f4a7c15u);
  return sum;
}

bool face_same_cycle(const int32_t a[4], const int32_t b[4], bool against) {
  for (int shift = 0; shift < 4; shift++) {
    bool same = true;
    for (int i = 0; i < 4; i++)
      same &= a[i] == b[(against ? shift - i : shift + i) & 3];
    if (same)
      return true;
  }
  return false;
}

static bool same_corners(const int32_t a[4], const int32_t b[4]) {
  for (int i = 0; i < 4; i++)
    if (a[i] != b[0] && a[i] != b[1] && a[i] != b[2] && a[i] != b[3])
      return false;
  return true;
}

/** Enter one side: the first of its face opens a slot, the second is its opposite. */
static void enter(face_table *table, const int32_t *hexes, int32_t *slots, size_t mask,
                  int32_t side) {
  int32_t corners[4], known[4];
  face_of_hex(hexes, side, corners);
  size_t slot = (size_t)face_hash(corners) & mask;
  for (; slots[slot] >= 0; slot = (slot + 1) & mask) {
    face_of_hex(hexes, slots[slot], known);
    if (!same_corners(known, corners))
      continue;
    int32_t first = slots[slot];
    table->face_of_side[side] = first;
    if (table->opposite[first] >= 0 || !face_same_cycle(known, corners, true)) {
      table->crowded_count++;
      return;
    }
    table->opposite[first] = side;
    table->opposite[side] = first;
    table->boundary_count--;
    return;
  }
  slots[slot] = side;
  table->face_of_side[side] = side;
  table->face_count++;
  table->boundary_count++;
}

hexcon_status face_table_build(hexcon_context *context, const int32_t *hexes, size_t hex_count,
                               face_table *out) {
  memset(out, 0, sizeof *out);
  size_t sides = 6 * hex_count, capacity = 16;
  while (capacity < sides + sides / 2)
    capacity *= 2;
  out->opposite = context_allocate(context, sides, sizeof *out->opposite);
  out->face_of_side = context_allocate(context, sides, sizeof *out->face_of_side);
  int32_t *slots = context_allocate(context, capacity, sizeof *slots);
  bool complete = out->opposite && out->face_of_side && slots;
  if (complete) {
    memset(out->opposite, -1, sides * sizeof *out->opposite);
    memset(slots, -1, capacity * sizeof *slots);
    for (size_t side = 0; side < sides; side++)
      enter(out, hexes, slots, capacity - 1, (int32_t)side);
  }
  context_free(context, slots);
  return complete ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

void face_table_free(hexcon_context *context, face_table *table) {
  context_free(context, table->opposite);
  context_free(context, table->face_of_side);
  memset(table, 0, sizeof *table);
}
