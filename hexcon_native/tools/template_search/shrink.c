/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "shrink.h"

#include <string.h>

#include "refill.h"

/** Close the gaps in the numbers of inner points. @return how many points there are */
static int renumber(const target *goal, filling *f) {
  uint8_t number[256];
  int count = goal->point_count;
  memset(number, NONE, sizeof number);
  for (int h = 0; h < f->hex_count; h++)
    for (int i = 0; i < 8; i++) {
      uint8_t *id = &f->hexes[h][i];
      if (*id < goal->point_count)
        continue;
      if (number[*id] == NONE)
        number[*id] = (uint8_t)count++;
      *id = number[*id];
    }
  return count;
}

void pool_offer(pool *p, const filling *f) {
  const uint64_t name = filling_name(p->goal, f);
  for (int i = 0; i < p->count; i++)
    if (p->names[i] == name)
      return;
  int at = p->count < p->room ? p->count++ : p->room - 1;
  if (at == p->room - 1 && p->names[at] != 0 && p->kept[at].hex_count < f->hex_count)
    return;
  for (; at > 0 && p->kept[at - 1].hex_count >= f->hex_count; at--) {
    p->kept[at] = p->kept[at - 1];
    p->names[at] = p->names[at - 1];
  }
  p->kept[at] = *f;
  p->names[at] = name;
}

void shrink(const table *t, pool *p, double seconds, dice *random) {
  static const int slacks[] = {0, 0, 0, 1, 2}, parts[] = {12, 20, 30};
  const double end = now() + seconds;
  filling before, after;
  while (p->count > 0 && now() < end) {
    const int first = dice_below(random, p->count), second = dice_below(random, p->count);
    before = p->kept[first < second ? first : second];
    const int points = renumber(p->goal, &before);
    const refill_options o = {.tries = 4,
                              .slack = slacks[dice_below(random, 5)],
                              .most_hexes = before.hex_count + 2,
                              .focus = -1,
                              .most_part = parts[dice_below(random, 3)]};
    if (refill(t, p->goal, &before, points, &o, random, &after))
      pool_offer(p, &after);
  }
}
