/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Keys, none of them zero, numbered 0, 1, 2 ... as they come: open addressing, doubling. */
#ifndef TEMPLATE_SEARCH_KEY_SET_H
#define TEMPLATE_SEARCH_KEY_SET_H

#include <stddef.h>
#include <stdint.h>

typedef struct key_set {
  size_t count, slot_count; /**< slots: a power of two */
  uint64_t *keys;           /**< [slot_count], 0: free */
  uint32_t *numbers;        /**< [slot_count] */
} key_set;

/** The number of a key that is not there. */
#define NO_NUMBER UINT32_MAX

uint32_t key_set_find(const key_set *set, uint64_t key);
/** Its number, new or old: it is new if that equals the count before. */
uint32_t key_set_add(key_set *set, uint64_t key);
void key_set_free(key_set *set);

#endif
