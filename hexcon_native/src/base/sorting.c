/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "sorting.h"

#include <stdlib.h>
#include <string.h>

/** Items that are sorted at once: some ten milliseconds. */
enum { BLOCK = 1 << 16 };

typedef int (*comparison)(const void *, const void *);

/** Merge two neighbouring runs, of which the first `half` bytes of `bytes` are one. */
static hexcon_status merge(hexcon_context *context, const char *from, size_t half, size_t bytes,
                           size_t size, comparison compare, char *to) {
  hexcon_status status = HEXCON_OK;
  size_t a = 0, b = half;
  for (size_t item = 0; !status && a + b - half < bytes; item++, to += size) {
    bool first = a < half && (b >= bytes || compare(from + a, from + b) <= 0);
    memcpy(to, from + (first ? a : b), size);
    a += first ? size : 0;
    b += first ? 0 : size;
    status = context_pass(context, item);
  }
  return status;
}

/** Sorted runs of `run` bytes become such of twice as many. */
static hexcon_status merge_runs(hexcon_context *context, const char *from, size_t bytes, size_t run,
                                size_t size, comparison compare, char *to) {
  hexcon_status status = HEXCON_OK;
  for (size_t start = 0; !status && start < bytes; start += 2 * run) {
    size_t most = bytes - start, half = run < most ? run : most;
    status = merge(context, from + start, half, 2 * run < most ? 2 * run : most, size, compare,
                   to + start);
  }
  return status;
}

static hexcon_status merge_all(hexcon_context *context, char *items, size_t bytes, size_t size,
                               comparison compare, char *scratch) {
  hexcon_status status = HEXCON_OK;
  char *from = items, *to = scratch;
  for (size_t run = BLOCK * size; !status && run < bytes; run *= 2) {
    status = merge_runs(context, from, bytes, run, size, compare, to);
    char *kept = from;
    from = status ? from : to; /* an unfinished round counts for nothing */
    to = kept;
  }
  if (from != items)
    memcpy(items, from, bytes);
  return status;
}

hexcon_status context_sort(hexcon_context *context, void *items, size_t count, size_t size,
                           int (*compare)(const void *, const void *)) {
  hexcon_status status = HEXCON_OK;
  for (size_t start = 0; !status && start < count; start += BLOCK) {
    size_t left = count - start;
    qsort((char *)items + start * size, left < BLOCK ? left : BLOCK, size, compare);
    status = context_after(context, left < BLOCK ? left : BLOCK);
  }
  if (status || count <= BLOCK)
    return status;
  char *scratch = context_allocate(context, count, size);
  if (!scratch)
    return HEXCON_OUT_OF_MEMORY;
  status = merge_all(context, items, count * size, size, compare, scratch);
  context_free(context, scratch);
  return status;
}
