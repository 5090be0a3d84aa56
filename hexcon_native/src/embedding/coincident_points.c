/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "coincident_points.h"

#include <stdbool.h>
#include <string.h>

/** Whatever the sign of a zero. */
static uint64_t hash_place(const double *place) {
  uint64_t hash = 0;
  for (int k = 0; k < 3; k++) {
    double value = place[k] + 0.0;
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 29;
  }
  return hash ^ hash >> 32;
}

static bool same_place(const double *a, const double *b) {
  return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

hexcon_status coincident_points_find(hexcon_context *context, const double *points, size_t count,
                                     int32_t *first, size_t *found) {
  size_t capacity = 16;
  while (capacity < 2 * count)
    capacity *= 2;
  int32_t *slots = context_allocate(context, capacity, sizeof *slots);
  *found = 0;
  if (!slots)
    return HEXCON_OUT_OF_MEMORY;
  memset(slots, -1, capacity * sizeof *slots);
  for (size_t v = 0; v < count; v++) {
    size_t slot = (size_t)hash_place(points + 3 * v) & (capacity - 1);
    while (slots[slot] >= 0 && !same_place(points + 3 * (size_t)slots[slot], points + 3 * v))
      slot = (slot + 1) & (capacity - 1);
    if (slots[slot] < 0)
      slots[slot] = (int32_t)v;
    first[v] = slots[slot];
    *found += first[v] != (int32_t)v;
  }
  context_free(context, slots);
  return HEXCON_OK;
}
