/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Hashing of point ids. */
#ifndef HEXCON_HEXMESH_ID_HASH_H
#define HEXCON_HEXMESH_ID_HASH_H

#include <stdint.h>

/** splitmix64's finaliser. Sums of it hash sets of ids. */
static inline uint64_t hash_id(int32_t id) {
  uint64_t x = (uint64_t)(uint32_t)id + 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

#endif
