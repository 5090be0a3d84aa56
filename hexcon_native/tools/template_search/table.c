/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "table.h"

#include <stdlib.h>
#include <string.h>

#include "hexes.h"
#include "support.h"

static uint32_t append(table *t, const table_entry *entry, uint64_t key) {
  const size_t classes_before = t->classes.count;
  const uint32_t class = key_set_add(&t->classes, key), index = (uint32_t)t->count;
  if (t->count == t->capacity) {
    t->capacity = grown(t->capacity, 1024);
    t->entries = resized(t->entries, t->capacity, sizeof *t->entries);
  }
  if (class == t->first_capacity) {
    t->first_capacity = grown(t->first_capacity, 1024);
    t->first = resized(t->first, t->first_capacity, sizeof *t->first);
  }
  if (class == classes_before)
    t->first[class] = NO_ENTRY;
  t->entries[t->count++] = *entry;
  t->entries[index].next = t->first[class];
  t->first[class] = index;
  return index;
}

static uint64_t marks_along(const ball *b, walk_start start) {
  walk w;
  walk_from(&b->surface, start, &w);
  return walk_marks(&b->surface, &w, b->marked);
}

/** Vertices on the boundary are told apart by their degrees only. */
static uint32_t fingerprint_of(const ball *b) {
  uint64_t colours[256] = {0};
  for (int v = 0; v < b->surface.vertex_count; v++)
    colours[b->point[v]] = b->surface.degree[v];
  return (uint32_t)hexes_fingerprint(b->hexes, b->hex_count, colours, 2);
}

void table_begin(table *t, int most_quads, int alternatives) {
  *t = (table){.most_quads = most_quads, .alternatives = alternatives};
}

void table_add_root(table *t, const ball *root) {
  canonical c;
  canonical_find(&root->surface, &c);
  const table_entry entry = {.marks = marks_along(root, c.starts[0]),
                             .parent = NO_ENTRY,
                             .fingerprint = t->alternatives > 1 ? fingerprint_of(root) : 0,
                             .hex_count = (uint8_t)root->hex_count};
  t->roots = resized(t->roots, t->root_count + 1, sizeof *t->roots);
  t->roots[t->root_count++] = *root;
  (void)append(t, &entry, c.key);
}

void table_free(table *t) {
  free(t->roots);
  free(t->entries);
  free(t->first);
  key_set_free(&t->classes);
}

void table_replay(const table *t, uint32_t entry, ball *b) {
  flip history[MOST_HEXES];
  int steps = 0;
  uint32_t e = entry;
  for (; t->entries[e].parent != NO_ENTRY; e = t->entries[e].parent)
    history[steps++] = t->entries[e].last;
  ball other, *here = b, *after = &other;
  *here = t->roots[e];
  while (steps > 0) {
    const flip f = history[--steps];
    flip_disc disc;
    if (!flip_find(&here->surface, f, &disc) || !ball_glue(here, f, &disc, after))
      stop("a history cannot be replayed");
    ball *const swap = here;
    here = after;
    after = swap;
  }
  if (here != b)
    *b = *here;
}

void table_children(const table *t, const ball *parent, child_visitor visit, void *user) {
  ball child;
  flip_disc disc;
  for (int root = 0; root < 4 * parent->surface.quad_count; root++)
    for (int sort = 0; sort < FLIP_SORTS; sort++) {
      const flip f = {(uint8_t)root, (uint8_t)sort};
      if (!flip_respects_marks(parent, f) || !flip_find(&parent->surface, f, &disc))
        continue;
      const int growth = flip_growth(&disc);
      if (growth > 0 && parent->surface.quad_count + growth > t->most_quads)
        continue;
      if (ball_glue(parent, f, &disc, &child) && ball_last_hex_proper(&child))
        visit(user, f, &child);
    }
}

/** The entries that dominate a ball, at most `alternatives` of them. */
typedef struct dominators {
  int count;
  uint32_t entries[MOST_ALTERNATIVES];
} dominators;

static void find_dominators(const table *t, const ball *b, const canonical *c, dominators *d) {
  uint64_t images[2 * MOST_DARTS];
  const uint32_t class = key_set_find(&t->classes, c->key);
  d->count = 0;
  if (class == NO_NUMBER)
    return;
  for (int i = 0; i < c->start_count; i++)
    images[i] = marks_along(b, c->starts[i]);
  for (uint32_t e = t->first[class]; e != NO_ENTRY && d->count < t->alternatives;
       e = t->entries[e].next)
    for (int i = 0; i < c->start_count; i++)
      if (t->entries[e].hex_count <= b->hex_count && (images[i] & ~t->entries[e].marks) == 0) {
        d->entries[d->count++] = e;
        break;
      }
}

uint32_t table_add(table *t, uint32_t parent, flip f, const ball *child, const canonical *c) {
  dominators d;
  find_dominators(t, child, c, &d);
  if (t->count >= NO_ENTRY || d.count >= t->alternatives)
    return NO_ENTRY;
  const uint32_t fingerprint = t->alternatives > 1 ? fingerprint_of(child) : 0;
  for (int i = 0; i < d.count; i++)
    if (t->entries[d.entries[i]].fingerprint == fingerprint)
      return NO_ENTRY;
  const table_entry entry = {.marks = marks_along(child, c->starts[0]),
                             .parent = parent,
                             .fingerprint = fingerprint,
                             .last = f,
                             .hex_count = (uint8_t)child->hex_count};
  return append(t, &entry, c->key);
}

typedef struct growth {
  table *t;
  uint32_t parent;
} growth;

static void add_child(void *user, flip f, const ball *child) {
  const growth *g = user;
  canonical c;
  canonical_find(&child->surface, &c);
  (void)table_add(g->t, g->parent, f, child, &c);
}

/** Add what the entries with so many hexes lead to. */
static void grow_level(table *t, int hex_count, size_t most_entries) {
  ball b;
  const size_t count = t->count;
  for (size_t i = 0; i < count && t->count < most_entries; i++) {
    if (t->entries[i].hex_count != hex_count)
      continue;
    growth g = {t, (uint32_t)i};
    table_replay(t, (uint32_t)i, &b);
    table_children(t, &b, add_child, &g);
  }
}

void table_grow(table *t, size_t most_entries, int most_hexes) {
  for (int hexes = 1; hexes < most_hexes && t->count < most_entries; hexes++)
    grow_level(t, hexes, most_entries);
}

void table_match(const table *t, const sphere *s, const canonical *c, const bool *needed,
                 match_visitor visit, void *user) {
  const uint32_t class = key_set_find(&t->classes, c->key);
  if (class == NO_NUMBER)
    return;
  for (int i = 0; i < c->start_count; i++) {
    walk w;
    walk_from(s, c->starts[i], &w);
    const uint64_t need = walk_marks(s, &w, needed);
    for (uint32_t e = t->first[class]; e != NO_ENTRY; e = t->entries[e].next)
      if ((need & ~t->entries[e].marks) == 0)
        visit(user, e, c->starts[i]);
  }
}

/** Points of the entry's mesh that lie on its boundary get those of the seat. */
static void seat_boundary(const ball *b, walk_start first, const seat *where, uint8_t names[256]) {
  walk there, here;
  uint8_t by_number[MOST_VERTICES] = {0};
  walk_from(where->surface, where->start, &there);
  walk_from(&b->surface, first, &here);
  for (int v = 0; v < where->surface->vertex_count; v++)
    by_number[there.number[v]] = where->point[v];
  memset(names, NONE, 256);
  for (int v = 0; v < b->surface.vertex_count; v++)
    names[b->point[v]] = by_number[here.number[v]];
}

int table_transplant(const table *t, uint32_t entry, seat *where, uint8_t (*hexes)[8], int room) {
  ball b;
  canonical c;
  uint8_t names[256];
  table_replay(t, entry, &b);
  canonical_find(&b.surface, &c);
  seat_boundary(&b, c.starts[0], where, names);
  /* Senses of the walks differ: one surface is the mirror image of the other. */
  const bool mirrored = (((c.starts[0] ^ where->start) & 1) != 0) != where->inside_out;
  if (b.hex_count > room)
    return 0;
  for (int h = 0; h < b.hex_count; h++) {
    for (int i = 0; i < 8; i++) {
      uint8_t *name = &names[b.hexes[h][i]];
      if (*name == NONE && where->point_count == MOST_POINTS)
        return 0;
      if (*name == NONE)
        *name = (uint8_t)where->point_count++;
      hexes[h][i] = *name;
    }
    if (mirrored)
      hex_mirror(hexes[h]);
  }
  return b.hex_count;
}
