/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "cell_sharing.h"

#include <stdbool.h>

int shared_partner(int32_t id, const int32_t quad[4]) {
  for (int corner = 3; corner >= 0; corner--)
    if (quad[corner] == id)
      return corner;
  return -1;
}

static bool is_next(int corner, int other) {
  return ((corner + 1) & 3) == other || ((other + 1) & 3) == corner;
}

/** The place of b's grid that is the same as a place of a's, on a shared corner or side. */
static bool partner_place(const int partner[4], int32_t i, int32_t j, int32_t width,
                          int32_t out[2]) {
  for (int from = 0; from < 4; from++) {
    int to = (from + 1) & 3;
    const int32_t *start = cell_corner_steps[from], *end = cell_corner_steps[to];
    int axis = start[0] == end[0] ? 1 : 0;
    int32_t here[2] = {i, j};
    if (partner[from] < 0 || here[1 - axis] != width * start[1 - axis])
      continue;
    int32_t passed = start[axis] < end[axis] ? here[axis] : width - here[axis];
    bool side = partner[to] >= 0 && is_next(partner[from], partner[to]);
    if (passed != 0 && !side)
      continue;
    const int32_t *first = cell_corner_steps[partner[from]];
    const int32_t *second = passed ? cell_corner_steps[partner[to]] : first;
    for (int k = 0; k < 2; k++)
      out[k] = first[k] * (width - passed) + second[k] * passed;
    return true;
  }
  return false;
}

/** The corner of b at a place of its grid joins a's. */
static void add_shared(int corner, const int32_t place[2], const cell *b, shared *out) {
  for (int other = 0; other < 4; other++)
    if (place[0] == b->i + cell_corner_steps[other][0] &&
        place[1] == b->j + cell_corner_steps[other][1]) {
      out->a[out->count] = corner;
      out->b[out->count++] = other;
    }
}

void shared_find(const int partner[4], const cell *a, const cell *b, shared *out) {
  const int32_t width = (int32_t)1 << a->depth;
  out->count = 0;
  for (int corner = 0; corner < 4; corner++) {
    int32_t place[2];
    if (partner_place(partner, a->i + cell_corner_steps[corner][0],
                      a->j + cell_corner_steps[corner][1], width, place))
      add_shared(corner, place, b, out);
  }
}

void shared_find_within(const cell *a, const cell *b, shared *out) {
  out->count = 0;
  for (int corner = 0; corner < 4; corner++) {
    int32_t place[2] = {a->i + cell_corner_steps[corner][0], a->j + cell_corner_steps[corner][1]};
    add_shared(corner, place, b, out);
  }
}

int shared_middle(const shared *s) {
  for (int i = 0; i < 3; i++)
    if (is_next(s->a[i], s->a[(i + 1) % 3]) && is_next(s->a[i], s->a[(i + 2) % 3]))
      return i;
  return -1;
}

int cell_side_of(int corner, int other) {
  if (((corner + 1) & 3) == other)
    return corner;
  return ((other + 1) & 3) == corner ? other : -1;
}

cell cell_child(const cell *c, int index) {
  return (cell){2 * c->i + (index & 1), 2 * c->j + (index >> 1), c->depth + 1};
}
