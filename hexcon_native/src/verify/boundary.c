/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "boundary.h"

#include <string.h>

#include "hexmesh/id_hash.h"

/** Whatever its first corner and direction. */
static uint64_t hash_quad(const int32_t corners[4]) {
  return hash_id(corners[0]) + hash_id(corners[1]) + hash_id(corners[2]) + hash_id(corners[3]);
}

/** True if one is the other, turned. */
static bool same_quad(const int32_t a[4], const int32_t b[4]) {
  for (int turn = 0; turn < 4; turn++)
    if (a[0] == b[turn] && a[1] == b[(turn + 1) & 3] && a[2] == b[(turn + 2) & 3] &&
        a[3] == b[(turn + 3) & 3])
      return true;
  return false;
}

/** Find the quad that is this side and take it out; false if there is none. */
static bool take_quad(const int32_t *quads, int32_t *slots, size_t mask, uint8_t *taken,
                      const int32_t side[4]) {
  for (size_t slot = (size_t)hash_quad(side) & mask; slots[slot] >= 0; slot = (slot + 1) & mask) {
    int32_t quad = slots[slot];
    if (!taken[quad] && same_quad(quads + 4 * (size_t)quad, side)) {
      taken[quad] = 1;
      return true;
    }
  }
  return false;
}

hexcon_status boundary_check(hexcon_context *context, const int32_t *hexes, size_t hex_count,
                             const face_table *faces, const int32_t *quads, size_t quad_count,
                             bool *exact) {
  *exact = faces->boundary_count == quad_count;
  if (!*exact)
    return HEXCON_OK;
  size_t capacity = 16;
  while (capacity < 2 * quad_count)
    capacity *= 2;
  int32_t *slots = context_allocate(context, capacity, sizeof *slots);
  uint8_t *taken = context_allocate_zeroed(context, quad_count, sizeof *taken);
  bool complete = slots && taken;
  hexcon_status status = complete ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  if (complete) {
    memset(slots, -1, capacity * sizeof *slots);
    for (size_t q = 0; q < quad_count; q++) {
      size_t slot = (size_t)hash_quad(quads + 4 * q) & (capacity - 1);
      while (slots[slot] >= 0)
        slot = (slot + 1) & (capacity - 1);
      slots[slot] = (int32_t)q;
    }
    for (size_t side = 0; !status && *exact && side < 6 * hex_count; side++) {
      status = context_pass(context, side);
      if (faces->opposite[side] >= 0)
        continue;
      int32_t corners[4];
      face_of_hex(hexes, (int32_t)side, corners);
      *exact = take_quad(quads, slots, capacity - 1, taken, corners);
    }
  }
  context_free(context, slots);
  context_free(context, taken);
  return status;
}
