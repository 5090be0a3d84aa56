/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "key_set.h"

#include <stdlib.h>
#include <string.h>

#include "support.h"

static size_t slot_of(const key_set *set, uint64_t key) {
  size_t slot = (size_t)(key * UINT64_C(0x9e3779b97f4a7c15) >> 20) & (set->slot_count - 1);
  while (set->keys[slot] && set->keys[slot] != key)
    slot = (slot + 1) & (set->slot_count - 1);
  return slot;
}

static void double_slots(key_set *set) {
  const key_set old = *set;
  set->slot_count = old.slot_count ? 2 * old.slot_count : 1024;
  set->keys = resized(NULL, set->slot_count, sizeof *set->keys);
  set->numbers = resized(NULL, set->slot_count, sizeof *set->numbers);
  memset(set->keys, 0, set->slot_count * sizeof *set->keys);
  for (size_t i = 0; i < old.slot_count; i++)
    if (old.keys[i]) {
      const size_t slot = slot_of(set, old.keys[i]);
      set->keys[slot] = old.keys[i];
      set->numbers[slot] = old.numbers[i];
    }
  free(old.keys);
  free(old.numbers);
}

uint32_t key_set_find(const key_set *set, uint64_t key) {
  if (set->slot_count == 0)
    return NO_NUMBER;
  const size_t slot = slot_of(set, key);
  return set->keys[slot] ? set->numbers[slot] : NO_NUMBER;
}

uint32_t key_set_add(key_set *set, uint64_t key) {
  if (3 * (set->count + 1) > 2 * set->slot_count)
    double_slots(set);
  const size_t slot = slot_of(set, key);
  if (!set->keys[slot]) {
    set->keys[slot] = key;
    set->numbers[slot] = (uint32_t)set->count++;
  }
  return set->numbers[slot];
}

void key_set_free(key_set *set) {
  free(set->keys);
  free(set->numbers);
  *set = (key_set){0};
}
