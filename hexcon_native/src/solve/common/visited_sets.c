/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "visited_sets.h"

#include <string.h>

uint64_t visited_key(int32_t member) {
  uint64_t bits = ((uint64_t)(uint32_t)member + 1) * 0x9e3779b97f4a7c15U; /* splitmix64 */
  bits = (bits ^ bits >> 30) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ bits >> 27) * 0x94d049bb133111ebU;
  return bits ^ bits >> 31;
}

/** Where a key is, or may be put; `room` is a power of two and not full. */
static size_t find(const uint64_t *keys, size_t room, uint64_t key) {
  size_t slot = (size_t)key & (room - 1);
  while (keys[slot] && keys[slot] != key)
    slot = (slot + 1) & (room - 1);
  return slot;
}

bool visited_has(const visited_sets *sets, uint64_t key) {
  return sets->room && sets->keys[find(sets->keys, sets->room, key)] == key;
}

static hexcon_status grow(hexcon_context *context, visited_sets *sets) {
  size_t room = sets->room ? 2 * sets->room : 64;
  uint64_t *keys = context_allocate_zeroed(context, room, sizeof *keys);
  if (!keys)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t i = 0; i < sets->room; i++)
    if (sets->keys[i])
      keys[find(keys, room, sets->keys[i])] = sets->keys[i];
  context_free(context, sets->keys);
  sets->keys = keys;
  sets->room = room;
  return HEXCON_OK;
}

hexcon_status visited_add(hexcon_context *context, visited_sets *sets, uint64_t key) {
  hexcon_status status = 2 * sets->count >= sets->room ? grow(context, sets) : HEXCON_OK;
  if (status)
    return status;
  size_t slot = find(sets->keys, sets->room, key);
  sets->count += sets->keys[slot] != key;
  sets->keys[slot] = key;
  return HEXCON_OK;
}

void visited_free(hexcon_context *context, visited_sets *sets) {
  context_free(context, sets->keys);
  memset(sets, 0, sizeof *sets);
}
