/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "support.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "hexes.h"

void stop(const char *why) {
  (void)fprintf(stderr, "hexcon_template_search: %s\n", why);
  exit(1);
}

void *resized(void *memory, size_t count, size_t size) {
  void *bigger = count <= SIZE_MAX / size ? realloc(memory, count * size) : NULL;
  if (!bigger)
    stop("out of memory");
  return bigger;
}

size_t grown(size_t capacity, size_t count) {
  const size_t more = capacity + capacity / 2;
  return more > count ? more : count;
}

int whole_number(const char **text, int least, int most) {
  char *end = NULL;
  const long value = strtol(*text, &end, 10);
  if (end == *text || value < least || value > most)
    stop("a whole number is missing or out of its range");
  *text = end;
  return (int)value;
}

double real_number(const char **text) {
  char *end = NULL;
  const double value = strtod(*text, &end);
  if (end == *text || !isfinite(value))
    stop("a number is missing");
  *text = end;
  return value;
}

static uint64_t roll(dice *d) {
  d->state += UINT64_C(0x9e3779b97f4a7c15);
  return mixed(d->state);
}

int dice_below(dice *d, int below) {
  return (int)(roll(d) % (uint64_t)below);
}

double dice_unit(dice *d) {
  return (double)(roll(d) >> 11) * 0x1p-53;
}

double now(void) {
  struct timespec t;
  (void)timespec_get(&t, TIME_UTC);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}
