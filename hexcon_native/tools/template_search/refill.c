/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "refill.h"

#include <string.h>

#include "hexes.h"
#include "hexmesh/hex_tables.h"

enum { MOST_CHOICES = 64 };

/** A part of a filling, and its neighbours. */
typedef struct part {
  const target *goal;
  const filling *whole;
  int16_t beyond[MOST_HEXES][6]; /**< hex across each face, or -1 */
  bool inside[MOST_HEXES];
  int hex_count;
  sphere surface;
  uint8_t point[MOST_VERTICES];
  bool needed[MOST_DARTS];
} part;

/** Does `hex` have all corners of a face of another hex? */
static int face_shared(const uint8_t hex[8], const uint8_t other[8]) {
  for (int f = 0; f < 6; f++) {
    int common = 0;
    for (int k = 0; k < 4; k++)
      common += memchr(other, hex[hex_faces[f][k]], 8) != NULL;
    if (common == 4)
      return f;
  }
  return -1;
}

static void find_neighbours(part *p) {
  const filling *w = p->whole;
  memset(p->beyond, -1, sizeof p->beyond);
  for (int i = 0; i < w->hex_count; i++)
    for (int j = 0; j < w->hex_count; j++) {
      const int face = i == j ? -1 : face_shared(w->hexes[i], w->hexes[j]);
      if (face >= 0)
        p->beyond[i][face] = (int16_t)j;
    }
}

/** Faces that a hex shares with the part. */
static int faces_towards(const part *p, int hex) {
  int count = 0;
  for (int f = 0; f < 6; f++)
    count += p->beyond[hex][f] >= 0 && p->inside[p->beyond[hex][f]];
  return count;
}

/** Take one hex more, rather one with many faces towards the part. @return false if none is left */
static bool take_one(part *p, dice *random) {
  int weights[MOST_HEXES], total = 0;
  for (int h = 0; h < p->whole->hex_count; h++) {
    const int faces = p->inside[h] ? 0 : faces_towards(p, h);
    weights[h] = faces * faces * faces;
    total += weights[h];
  }
  if (total == 0)
    return false;
  int chosen = 0;
  for (int left = dice_below(random, total); left >= weights[chosen]; chosen++)
    left -= weights[chosen];
  p->inside[chosen] = true;
  p->hex_count++;
  return true;
}

/** The part's boundary. @return false unless it is a three-connected sphere of few quads */
static bool find_surface(part *p, int most_quads) {
  uint8_t vertex_of[256];
  sphere *s = &p->surface;
  memset(vertex_of, NONE, sizeof vertex_of);
  s->quad_count = s->vertex_count = 0;
  for (int h = 0; h < p->whole->hex_count; h++)
    for (int f = 0; p->inside[h] && f < 6; f++) {
      if (p->beyond[h][f] >= 0 && p->inside[p->beyond[h][f]])
        continue;
      if (s->quad_count == most_quads)
        return false;
      for (int k = 0; k < 4; k++) {
        uint8_t *vertex = &vertex_of[p->whole->hexes[h][hex_faces[f][k]]];
        if (*vertex == NONE && s->vertex_count == most_quads + 2)
          return false;
        if (*vertex == NONE) {
          p->point[s->vertex_count] = p->whole->hexes[h][hex_faces[f][k]];
          *vertex = (uint8_t)s->vertex_count++;
        }
        s->corner[4 * s->quad_count + k] = *vertex;
      }
      s->quad_count++;
    }
  return s->vertex_count == s->quad_count + 2 && sphere_link(s) && sphere_is_sphere(s) &&
         sphere_three_connected(s);
}

/** Hexes outside the part that have an edge. */
static int hexes_outside(const part *p, uint8_t a, uint8_t b) {
  int count = 0;
  for (int h = 0; h < p->whole->hex_count; h++)
    count += !p->inside[h] && memchr(p->whole->hexes[h], a, 8) != NULL &&
             memchr(p->whole->hexes[h], b, 8) != NULL;
  return count;
}

/** Edges at which the new part must have two hexes or more. */
static void find_needed(part *p) {
  const uint8_t size = (uint8_t)p->goal->point_count;
  for (int d = 0; d < 4 * p->surface.quad_count; d++) {
    const uint8_t a = p->point[p->surface.corner[d]];
    const uint8_t b = p->point[p->surface.corner[p->surface.twin[d]]];
    const int outside = hexes_outside(p, a, b);
    const int sort = a < size && b < size ? p->goal->edges[a][b] : NO_EDGE;
    p->needed[d] = sort == NO_EDGE ? outside == 1 : sort == FLAT_EDGE && outside == 0;
  }
}

/** Some of the table's entries that fit, chosen evenly. */
typedef struct choice {
  const table *t;
  dice *random;
  int most_hexes, offered, count;
  uint32_t entries[MOST_CHOICES];
  walk_start starts[MOST_CHOICES];
} choice;

static void offer(void *user, uint32_t entry, walk_start start) {
  choice *c = user;
  if (c->t->entries[entry].hex_count > c->most_hexes)
    return;
  c->offered++;
  int at = c->count;
  if (c->count < MOST_CHOICES)
    c->count++;
  else
    at = dice_below(c->random, c->offered);
  if (at < MOST_CHOICES) {
    c->entries[at] = entry;
    c->starts[at] = start;
  }
}

static bool swap_part(const part *p, const choice *c, int chosen, int point_count, filling *after) {
  seat where = {&p->surface, p->point, c->starts[chosen], false, point_count};
  after->hex_count = 0;
  for (int h = 0; h < p->whole->hex_count; h++)
    if (!p->inside[h])
      memcpy(after->hexes[after->hex_count++], p->whole->hexes[h], 8);
  const int kept = after->hex_count;
  const int more =
      table_transplant(c->t, c->entries[chosen], &where, after->hexes + kept, MOST_HEXES - kept);
  after->hex_count += more;
  if (more == 0 || !target_filled(p->goal, (const uint8_t(*)[8])after->hexes, after->hex_count))
    return false;
  for (int h = kept; h < after->hex_count; h++)
    if (!target_allows(p->goal, after->hexes[h]))
      return false;
  return true;
}

static bool fill_part(part *p, const table *t, int point_count, const refill_options *o,
                      dice *random, filling *after) {
  enum { TRIES = 4 };
  const int room = o->most_hexes - p->whole->hex_count + p->hex_count;
  const int most = p->hex_count + o->slack < room ? p->hex_count + o->slack : room;
  choice c = {.t = t, .random = random, .most_hexes = most};
  canonical code;
  find_needed(p);
  canonical_find(&p->surface, &code);
  table_match(t, &p->surface, &code, p->needed, offer, &c);
  for (int i = 0; i < TRIES && c.count > 0; i++)
    if (swap_part(p, &c, dice_below(random, c.count), point_count, after))
      return true;
  return false;
}

/** One part that begins at a hex. @return false if no other filling was found */
static bool grow_part(part *p, const table *t, int begin, int point_count, const refill_options *o,
                      dice *random, filling *after) {
  enum { LEAST = 4 };
  const int count = p->whole->hex_count, most = o->most_part < count ? o->most_part : count;
  const int stop_at = LEAST + dice_below(random, most > LEAST ? most - LEAST : 1);
  memset(p->inside, 0, sizeof p->inside);
  p->inside[begin] = true;
  p->hex_count = 1;
  while (p->hex_count < stop_at && take_one(p, random)) {
    if (p->hex_count < LEAST || dice_unit(random) < 0.5 || !find_surface(p, t->most_quads))
      continue;
    if (fill_part(p, t, point_count, o, random, after))
      return true;
  }
  return false;
}

bool refill(const table *t, const target *goal, const filling *before, int point_count,
            const refill_options *options, dice *random, filling *after) {
  const uint64_t old = filling_name(goal, before);
  part p = {.goal = goal, .whole = before};
  find_neighbours(&p);
  for (int i = 0; i < options->tries; i++) {
    const int begin = options->focus >= 0 ? options->focus : dice_below(random, before->hex_count);
    if (grow_part(&p, t, begin, point_count, options, random, after) &&
        filling_name(goal, after) != old)
      return true;
  }
  return false;
}
