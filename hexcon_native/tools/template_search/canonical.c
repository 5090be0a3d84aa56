/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "canonical.h"

#include <string.h>

#include "hexes.h"

enum { CODE_LENGTH = MOST_DARTS + MOST_VERTICES };

/** What is near a dart, for one sense; walks begin where this is greatest. */
static uint64_t surroundings(const sphere *s, int dart, bool mirrored) {
  const int twin = s->twin[dart];
  const uint64_t near = s->degree[s->corner[dart]], far = s->degree[s->corner[twin]];
  uint64_t left_far = s->degree[s->corner[dart_turned(dart, 2)]];
  uint64_t left_near = s->degree[s->corner[dart_turned(dart, 3)]];
  uint64_t right_near = s->degree[s->corner[dart_turned(twin, 2)]];
  uint64_t right_far = s->degree[s->corner[dart_turned(twin, 3)]];
  if (mirrored) {
    const uint64_t swap[2] = {left_near, left_far};
    left_near = right_near, left_far = right_far;
    right_near = swap[0], right_far = swap[1];
  }
  return near << 40 | far << 32 | left_far << 24 | left_near << 16 | right_near << 8 | right_far;
}

static int likely_starts(const sphere *s, walk_start starts[2 * MOST_DARTS]) {
  uint64_t greatest = 0;
  int count = 0;
  for (int d = 0; d < 4 * s->quad_count; d++)
    for (int mirrored = 0; mirrored < 2; mirrored++) {
      const uint64_t here = surroundings(s, d, mirrored);
      if (here > greatest) {
        greatest = here;
        count = 0;
      }
      if (here == greatest)
        starts[count++] = (walk_start)(2 * d + mirrored);
    }
  return count;
}

/**
 * Write the code of a walk unless it gets greater than the least one so far.
 * @param least  NULL: there is none yet
 * @return the length, or 0 if greater
 */
static int write_code(const sphere *s, walk_start start, const uint8_t *least, uint8_t *code) {
  uint8_t number[MOST_VERTICES], first[MOST_VERTICES];
  const bool mirrored = start & 1;
  int count = 1, length = 0;
  memset(number, NONE, sizeof number);
  first[0] = (uint8_t)(start >> 1);
  number[s->corner[first[0]]] = 0;
  for (int v = 0; v < count; v++) {
    const int begin = length;
    int dart = first[v];
    do {
      const int twin = s->twin[dart], to = s->corner[twin];
      if (number[to] == NONE) {
        first[count] = (uint8_t)twin;
        number[to] = (uint8_t)count++;
      }
      code[length++] = number[to];
      dart = dart_rotated(s, dart, mirrored);
    } while (dart != first[v]);
    code[length++] = NONE;
    const int order = least ? memcmp(code + begin, least + begin, (size_t)(length - begin)) : -1;
    if (order > 0)
      return 0;
    if (order < 0)
      least = NULL;
  }
  return length;
}

static uint64_t hash(const uint8_t *code, int length) {
  uint64_t key = (uint64_t)length;
  for (int i = 0; i < length; i += 8) {
    uint64_t word = 0;
    memcpy(&word, code + i, (size_t)(length - i < 8 ? length - i : 8));
    key = mixed(key ^ word) + (uint64_t)i;
  }
  return key ? key : 1;
}

void canonical_find(const sphere *s, canonical *c) {
  walk_start starts[2 * MOST_DARTS];
  uint8_t codes[2][CODE_LENGTH], *least = NULL, *code = codes[0];
  const int count = likely_starts(s, starts);
  int length = 0;
  c->start_count = 0;
  for (int i = 0; i < count; i++) {
    const int written = write_code(s, starts[i], least, code);
    if (!written)
      continue;
    if (!least || memcmp(code, least, (size_t)written) != 0) {
      least = code;
      code = codes[least == codes[0]];
      length = written;
      c->start_count = 0;
    }
    c->starts[c->start_count++] = starts[i];
  }
  c->key = hash(least, length);
}

void walk_from(const sphere *s, walk_start start, walk *w) {
  uint8_t first[MOST_VERTICES];
  const bool mirrored = start & 1;
  int count = 1, edges = 0;
  memset(w->number, NONE, sizeof w->number);
  first[0] = (uint8_t)(start >> 1);
  w->number[s->corner[first[0]]] = 0;
  for (int v = 0; v < count; v++) {
    int dart = first[v];
    do {
      const int twin = s->twin[dart], to = s->corner[twin];
      if (w->number[to] == NONE) {
        first[count] = (uint8_t)twin;
        w->number[to] = (uint8_t)count++;
      }
      if (w->number[to] > v)
        w->edges[edges++] = (uint8_t)dart;
      dart = dart_rotated(s, dart, mirrored);
    } while (dart != first[v]);
  }
}

uint64_t walk_marks(const sphere *s, const walk *w, const bool marked[MOST_DARTS]) {
  uint64_t marks = 0;
  for (int e = 0; e < 2 * s->quad_count; e++)
    marks |= (uint64_t)marked[w->edges[e]] << e;
  return marks;
}
