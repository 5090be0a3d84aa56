/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "colouring.h"

#include <string.h>

enum { UNSEEN = 2 };

typedef struct search {
  const surface *s;
  const uint8_t *crossed; /* [4 quad_count] edges that change the colour; NULL: all */
  uint8_t *colours;
  int32_t *corner_of_point; /* [point_count] one half-edge that starts there, -1 if unused */
  int32_t *parents;         /* [point_count] breadth-first tree, -1 at roots */
  int32_t *queue;           /* [point_count] */
} search;

/** List the cycle that edge (a, b) closes in the tree: up from a to the fork, down to b. */
static hexcon_status report_odd_cycle(hexcon_context *context, const search *f, int32_t a,
                                      int32_t b) {
  size_t length_a = 0, length_b = 0;
  for (int32_t v = a; v >= 0; v = f->parents[v])
    length_a++;
  for (int32_t v = b; v >= 0; v = f->parents[v])
    length_b++;
  int32_t x = a, y = b;
  for (; length_a > length_b; length_a--)
    x = f->parents[x];
  for (; length_b > length_a; length_b--)
    y = f->parents[y];
  while (x != y) {
    x = f->parents[x];
    y = f->parents[y];
  }
  size_t length = 1, down = 0;
  for (int32_t v = a; v != x; v = f->parents[v], length++)
    context_add_element(context, v);
  context_add_element(context, x);
  for (int32_t v = b; v != x; v = f->parents[v])
    f->queue[down++] = v; /* the search is over: its queue serves to turn the path round */
  length += down;
  while (down)
    context_add_element(context, f->queue[--down]);
  if (f->crossed)
    return context_fail(context, HEXCON_NO_SIDES,
                        "dual loops that are to be split together have no two sides: a closed path "
                        "of edges crosses them an odd number of times (its points listed)");
  return context_fail(context, HEXCON_NOT_BIPARTITE,
                      "the points cannot be coloured black and white along edges: a cycle of %zu "
                      "edges is odd (its points listed)",
                      length);
}

static hexcon_status colour_component(hexcon_context *context, search *f, int32_t root) {
  size_t head = 0, tail = 0;
  f->colours[root] = 0;
  f->parents[root] = -1;
  f->queue[tail++] = root;
  while (head < tail) {
    int32_t v = f->queue[head++], start = f->corner_of_point[v], h = start;
    hexcon_status status = context_pass(context, head);
    if (status)
      return status;
    do {
      int32_t other = half_edge_end(f->s, h);
      uint8_t colour = f->colours[v] ^ (!f->crossed || f->crossed[h]);
      if (f->colours[other] == UNSEEN) {
        f->colours[other] = colour;
        f->parents[other] = v;
        f->queue[tail++] = other;
      } else if (f->colours[other] != colour) {
        return report_odd_cycle(context, f, v, other);
      }
      h = f->s->twins[half_edge_turn(h, -1)];
    } while (h != start);
  }
  return HEXCON_OK;
}

static hexcon_status colour_all(hexcon_context *context, search *f) {
  memset(f->corner_of_point, -1, f->s->point_count * sizeof *f->corner_of_point);
  for (size_t h = 0; h < 4 * f->s->quad_count; h++)
    f->corner_of_point[f->s->quads[h]] = (int32_t)h;
  memset(f->colours, UNSEEN, f->s->point_count);
  for (size_t v = 0; v < f->s->point_count; v++) {
    if (f->colours[v] != UNSEEN)
      continue;
    if (f->corner_of_point[v] < 0) {
      f->colours[v] = 0;
      continue;
    }
    hexcon_status status = colour_component(context, f, (int32_t)v);
    if (status)
      return status;
  }
  return HEXCON_OK;
}

static hexcon_status colour(hexcon_context *context, const surface *s, const uint8_t *crossed,
                            uint8_t *colours) {
  search f = {s,
              crossed,
              colours,
              context_allocate(context, s->point_count, sizeof *f.corner_of_point),
              context_allocate(context, s->point_count, sizeof *f.parents),
              context_allocate(context, s->point_count, sizeof *f.queue)};
  hexcon_status status =
      f.corner_of_point && f.parents && f.queue ? colour_all(context, &f) : HEXCON_OUT_OF_MEMORY;
  context_free(context, f.corner_of_point);
  context_free(context, f.parents);
  context_free(context, f.queue);
  return status;
}

hexcon_status surface_colour(hexcon_context *context, const surface *s, uint8_t *colours) {
  return colour(context, s, NULL, colours);
}

hexcon_status surface_sides(hexcon_context *context, const surface *s, const uint8_t *crossed,
                            uint8_t *sides) {
  return colour(context, s, crossed, sides);
}
