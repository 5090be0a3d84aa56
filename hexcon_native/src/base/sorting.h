/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Sorting of what may be many, which can be stopped. */
#ifndef HEXCON_BASE_SORTING_H
#define HEXCON_BASE_SORTING_H

#include "context.h"

/**
 * As qsort, and asks now and then whether to go on. Equal items may end in any order.
 * @param size  of an item, bytes
 * @return OUT_OF_MEMORY, CANCELLED, OUT_OF_TIME; the items are then in no order, but all there
 */
hexcon_status context_sort(hexcon_context *context, void *items, size_t count, size_t size,
                           int (*compare)(const void *, const void *));

#endif
