/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Which sets of things a search has been at, by hash. */
#ifndef HEXCON_SOLVE_COMMON_VISITED_SETS_H
#define HEXCON_SOLVE_COMMON_VISITED_SETS_H

#include "base/context.h"

/** Sets are told apart by 64 bits: two that are taken for one cost a search one of its ways. */
typedef struct visited_sets {
  size_t count, room;
  uint64_t *keys; /**< [room] 0: free */
} visited_sets;

/** What a member adds to its set's key, by exclusive or. */
uint64_t visited_key(int32_t member);

bool visited_has(const visited_sets *sets, uint64_t key);

/** Add a set. Amortised: constant. */
hexcon_status visited_add(hexcon_context *context, visited_sets *sets, uint64_t key);
void visited_free(hexcon_context *context, visited_sets *sets);

#endif
