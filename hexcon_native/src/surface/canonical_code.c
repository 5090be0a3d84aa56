/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "canonical_code.h"

#include <string.h>

static int32_t next_around(const surface *s, int32_t h, bool mirrored) {
  return mirrored ? half_edge_turn(s->twins[h], 1) : s->twins[half_edge_turn(h, -1)];
}

void surface_walk(const surface *s, int32_t half_edge, bool mirrored, canonical_code *walk) {
  int32_t numbers[CODE_MOST_POINTS], entries[CODE_MOST_POINTS], count = 1;
  char *text = walk->text;
  memset(numbers, -1, sizeof numbers);
  numbers[half_edge_start(s, half_edge)] = 0;
  walk->order[0] = half_edge_start(s, half_edge);
  walk->mirrored = mirrored;
  entries[0] = half_edge;
  for (int32_t v = 0; v < count; v++) {
    int32_t h = entries[v];
    do {
      const int32_t to = half_edge_end(s, h);
      if (numbers[to] < 0) {
        walk->order[count] = to;
        entries[count] = s->twins[h];
        numbers[to] = count++;
      }
      *text++ = (char)('a' + numbers[to]);
      h = next_around(s, h, mirrored);
    } while (h != entries[v]);
    *text++ = '.';
  }
  *text = '\0';
}

size_t surface_canonical_walks(const surface *s, walk_start starts[CODE_MOST_WALKS]) {
  canonical_code walk = {0}, least = {0};
  size_t count = 0;
  for (int mirrored = 0; mirrored < 2; mirrored++)
    for (int32_t h = 0; h < (int32_t)(4 * s->quad_count); h++) {
      surface_walk(s, h, mirrored, &walk);
      const int order = count == 0 ? -1 : strcmp(walk.text, least.text);
      if (order < 0) {
        least = walk;
        count = 0;
      }
      if (order <= 0)
        starts[count++] = (walk_start){h, mirrored};
    }
  return count;
}
