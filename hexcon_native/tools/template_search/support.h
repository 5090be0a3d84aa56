/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** What every part of the tool needs: memory or the end, random numbers, the clock. */
#ifndef TEMPLATE_SEARCH_SUPPORT_H
#define TEMPLATE_SEARCH_SUPPORT_H

#include <stddef.h>
#include <stdint.h>

/** Say why on standard error and end the program. */
_Noreturn void stop(const char *why);

/** realloc(3) for count items of a size, or stop. */
void *resized(void *memory, size_t count, size_t size);

/** Capacity for at least `count` items: at least half as many again as before. */
size_t grown(size_t capacity, size_t count);

/** Read a number and go on behind it, or stop: no number, or out of its range. */
int whole_number(const char **text, int least, int most);
double real_number(const char **text);

/** A random number generator: any seed is good. */
typedef struct dice {
  uint64_t state;
} dice;

/** In 0 .. below - 1. */
int dice_below(dice *d, int below);
/** In [0, 1). */
double dice_unit(dice *d);

/** Seconds since some moment. */
double now(void);

#endif
