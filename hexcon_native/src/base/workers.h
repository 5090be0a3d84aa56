/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Independent pieces of work shared out to threads. */
#ifndef HEXCON_BASE_WORKERS_H
#define HEXCON_BASE_WORKERS_H

#include "context.h"

/** More threads than this are not started. */
enum { WORKERS_MAX = 64 };

/**
 * Do piece number `item`. May allocate and fail through `context`, which is the worker's own, and
 * report progress: that asks the user, from the calling thread only, whether to go on.
 * @param worker  below the number of threads: which buffers of the caller's to use
 */
typedef hexcon_status (*work_function)(void *user, hexcon_context *context, int worker,
                                       size_t item);

/** The threads to use when `wanted` are asked for; 0 means one per processor. */
int workers_count(int wanted);

/**
 * Do the items 0 .. count - 1, in any order, the calling thread among the workers. What the items
 * compute must not depend on each other; then the result is the same for any number of threads.
 * @param stage  what the user is told; the fraction is that of the items begun
 * @return the first fault found, whose words are then in `context`; no item is begun after one.
 */
hexcon_status workers_run(hexcon_context *context, int threads, size_t count, progress_stage stage,
                          work_function work, void *user);

#endif
