/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "classes.h"

#include <stdlib.h>
#include <string.h>

#include "ball.h"
#include "canonical.h"
#include "key_set.h"
#include "support.h"

/** The quads of one of each class, in the order found; a queue. */
typedef struct class_list {
  key_set keys;
  size_t capacity, *ends; /**< ends[i]: behind the corners of class i */
  size_t corner_capacity;
  uint8_t *corners;
} class_list;

static size_t begin_of(const class_list *list, size_t i) {
  return i ? list->ends[i - 1] : 0;
}

static void append(class_list *list, const sphere *s) {
  const size_t i = list->keys.count - 1, size = 4 * (size_t)s->quad_count;
  if (i == list->capacity) {
    list->capacity = grown(list->capacity, 1024);
    list->ends = resized(list->ends, list->capacity, sizeof *list->ends);
  }
  const size_t begin = begin_of(list, i);
  if (begin + size > list->corner_capacity) {
    list->corner_capacity = grown(list->corner_capacity, begin + (1 << 16));
    list->corners = resized(list->corners, list->corner_capacity, 1);
  }
  memcpy(list->corners + begin, s->corner, size);
  list->ends[i] = begin + size;
}

static void load(const class_list *list, size_t i, ball *b) {
  const size_t begin = begin_of(list, i), size = list->ends[i] - begin;
  memcpy(b->surface.corner, list->corners + begin, size);
  b->surface.quad_count = (int)(size / 4);
  b->surface.vertex_count = b->surface.quad_count + 2;
  b->hex_count = b->point_count = 0;
  (void)sphere_link(&b->surface);
}

static void add_if_new(class_list *list, const sphere *s) {
  canonical c;
  canonical_find(s, &c);
  const size_t before = list->keys.count;
  if (key_set_add(&list->keys, c.key) == before)
    append(list, s);
}

static void add_flipped(class_list *list, const ball *b, int most_quads) {
  ball after;
  flip_disc disc;
  for (int root = 0; root < 4 * b->surface.quad_count; root++)
    for (int sort = 0; sort < FLIP_SORTS; sort++) {
      const flip f = {(uint8_t)root, (uint8_t)sort};
      if (flip_find(&b->surface, f, &disc) &&
          b->surface.quad_count + flip_growth(&disc) <= most_quads &&
          ball_glue(b, f, &disc, &after))
        add_if_new(list, &after.surface);
    }
}

void count_classes(int most_quads, size_t counts[MOST_QUADS + 1], int hexes[MOST_QUADS + 1]) {
  class_list list = {0};
  ball b = {0};
  sphere cube;
  size_t round_end = 1; /* behind the classes of as many hexes as the present one */
  int hex_count = 1;
  memset(counts, 0, (MOST_QUADS + 1) * sizeof *counts);
  memset(hexes, 0, (MOST_QUADS + 1) * sizeof *hexes);
  sphere_cube(&cube);
  add_if_new(&list, &cube);
  for (size_t i = 0; i < list.keys.count; i++) {
    if (i == round_end) {
      round_end = list.keys.count;
      hex_count++;
    }
    load(&list, i, &b);
    counts[b.surface.quad_count]++;
    hexes[b.surface.quad_count] = hex_count;
    add_flipped(&list, &b, most_quads);
  }
  free(list.ends);
  free(list.corners);
  key_set_free(&list.keys);
}
