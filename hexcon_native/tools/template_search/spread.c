/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "spread.h"

#include <stdlib.h>
#include <string.h>

#include "hexes.h"
#include "hexmesh/hex_tables.h"
#include "support.h"

static bool has_all(const uint8_t hex[8], const uint8_t *ids, int count) {
  for (int i = 0; i < count; i++)
    if (!memchr(hex, ids[i], 8))
      return false;
  return true;
}

static int hexes_with(const filling *f, const uint8_t *ids, int count) {
  int found = 0;
  for (int h = 0; h < f->hex_count; h++)
    found += has_all(f->hexes[h], ids, count);
  return found;
}

/** Append a quad of points, numbering those that are new on the surface. */
static bool add_quad(ball *b, const uint8_t ids[4], uint8_t vertex_of[256]) {
  sphere *s = &b->surface;
  if (s->quad_count == MOST_QUADS)
    return false;
  for (int k = 0; k < 4; k++) {
    uint8_t *vertex = &vertex_of[ids[k]];
    if (*vertex == NONE && s->vertex_count == MOST_VERTICES)
      return false;
    if (*vertex == NONE) {
      b->point[s->vertex_count] = ids[k];
      *vertex = (uint8_t)s->vertex_count++;
    }
    s->corner[4 * s->quad_count + k] = *vertex;
  }
  s->quad_count++;
  return true;
}

static void mark_edges(const filling *f, ball *b) {
  const sphere *s = &b->surface;
  for (int d = 0; d < 4 * s->quad_count; d++) {
    const uint8_t ends[2] = {b->point[s->corner[d]], b->point[s->corner[s->twin[d]]]};
    b->marked[d] = hexes_with(f, ends, 2) > 1;
  }
}

/** Ids without gaps: there is more room for new ones then. */
static void copy_hexes(const filling *f, ball *b) {
  uint8_t number[256];
  memset(number, NONE, sizeof number);
  for (int h = 0; h < f->hex_count; h++)
    for (int i = 0; i < 8; i++) {
      uint8_t *id = &number[f->hexes[h][i]];
      if (*id == NONE)
        *id = (uint8_t)b->point_count++;
      b->hexes[h][i] = *id;
    }
  for (int v = 0; v < b->surface.vertex_count; v++)
    b->point[v] = number[b->point[v]];
}

bool ball_of_filling(const filling *f, ball *b) {
  uint8_t vertex_of[256];
  memset(vertex_of, NONE, sizeof vertex_of);
  *b = (ball){.hex_count = f->hex_count};
  for (int h = 0; h < f->hex_count; h++)
    for (int face = 0; face < 6; face++) {
      uint8_t ids[4];
      for (int k = 0; k < 4; k++)
        ids[k] = f->hexes[h][hex_faces[face][k]];
      if (hexes_with(f, ids, 4) == 1 && !add_quad(b, ids, vertex_of))
        return false;
    }
  sphere *s = &b->surface;
  if (s->vertex_count != s->quad_count + 2 || !sphere_link(s) || !sphere_is_sphere(s) ||
      !sphere_three_connected(s))
    return false;
  mark_edges(f, b);
  copy_hexes(f, b);
  return true;
}

/** Entries of a class, fewest hexes first, at most `room`. @return how many */
static int smallest_of_class(const table *t, uint32_t class, uint32_t *entries, int room) {
  int count = 0;
  for (uint32_t e = t->first[class]; e != NO_ENTRY; e = t->entries[e].next) {
    const int hexes = t->entries[e].hex_count;
    int at = count < room ? count++ : room;
    for (; at > 0 && t->entries[entries[at - 1]].hex_count > hexes; at--)
      if (at < room)
        entries[at] = entries[at - 1];
    if (at < room)
      entries[at] = e;
  }
  return count;
}

void visit_smallest(const table *t, int most_quads, int keep, filling_visitor visit, void *user) {
  uint32_t *entries = resized(NULL, (size_t)keep, sizeof *entries);
  ball b;
  for (uint32_t class = 0; class < t->classes.count; class ++) {
    const int count = smallest_of_class(t, class, entries, keep);
    for (int i = 0; i < count; i++) {
      table_replay(t, entries[i], &b);
      if (b.surface.quad_count > most_quads)
        break;
      filling f = {.hex_count = b.hex_count};
      memcpy(f.hexes, b.hexes, sizeof f.hexes);
      visit(user, &f);
    }
  }
  free(entries);
}
