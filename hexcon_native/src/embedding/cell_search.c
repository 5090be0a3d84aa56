/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "cell_search.h"

#include "cell_sharing.h"

enum { CHILDREN = 16, MAX_WAITING = CHILDREN * (CELL_MAX_DEPTH + 1) };

bool cells_are_same(const cells *c) {
  return c->a.i == c->b.i && c->a.j == c->b.j;
}

/** @return how many pairs wait then */
static int push_children(const cells *now, bool itself, cells *waiting, int count) {
  const bool same = itself && cells_are_same(now);
  for (int child = 0; child < CHILDREN; child++)
    if (!same || (child & 3) <= child >> 2)
      waiting[count++] = (cells){cell_child(&now->a, child & 3), cell_child(&now->b, child >> 2)};
  return count;
}

meeting cell_search(cell_judge judge, void *patches, bool itself, int patience) {
  cells waiting[MAX_WAITING];
  int count = 1;
  waiting[0] = (cells){{0, 0, 0}, {0, 0, 0}};
  meeting found = MEETING_NONE;
  for (int looked_at = 1; count > 0; looked_at++) {
    cells now = waiting[--count];
    meeting here = judge(patches, &now);
    if (here == MEETING_PROVED)
      return here;
    if (here == MEETING_NONE)
      continue;
    if (looked_at >= patience)
      return MEETING_OPEN;
    if (now.a.depth == CELL_MAX_DEPTH)
      found = MEETING_OPEN;
    else
      count = push_children(&now, itself, waiting, count);
  }
  return found;
}
