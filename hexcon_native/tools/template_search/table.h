/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * A table of balls reached from one ball, or several, by flips that respect the marks: class of the
 * boundary, marks, and how it was reached. 24 bytes an entry; the ball itself is replayed when
 * needed.
 *
 * Of two balls of one class, one whose marks include the other's and that has no more hexes
 * dominates: whatever the other can be continued to, it can be too. Such others are left out,
 * except for `alternatives` - 1 of them with other meshes inside.
 */
#ifndef TEMPLATE_SEARCH_TABLE_H
#define TEMPLATE_SEARCH_TABLE_H

#include <stddef.h>

#include "ball.h"
#include "canonical.h"
#include "key_set.h"

typedef struct table_entry {
  uint64_t marks;       /**< along the walk from the first canonical start */
  uint32_t parent;      /**< entry, or NO_ENTRY at a root */
  uint32_t next;        /**< entry of the same class, or NO_ENTRY */
  uint32_t fingerprint; /**< of the mesh; only if there may be alternatives */
  flip last;            /**< makes it from its parent */
  uint8_t hex_count;
} table_entry;

#define NO_ENTRY UINT32_MAX
enum { MOST_ALTERNATIVES = 64 };

typedef struct table {
  size_t root_count;
  ball *roots; /**< of the first entries */
  int most_quads, alternatives;
  size_t count, capacity;
  table_entry *entries;
  key_set classes;
  size_t first_capacity;
  uint32_t *first; /**< entry of each class */
} table;

/** @param alternatives  1 .. MOST_ALTERNATIVES */
void table_begin(table *t, int most_quads, int alternatives);
/** Before all other entries. */
void table_add_root(table *t, const ball *root);
void table_free(table *t);

void table_replay(const table *t, uint32_t entry, ball *b);

typedef void (*child_visitor)(void *user, flip f, const ball *child);
/** All balls with one hex more, within the limit of quads, proper as far as they go. */
void table_children(const table *t, const ball *parent, child_visitor visit, void *user);

/** Add a child unless it is dominated. @return its entry or NO_ENTRY */
uint32_t table_add(table *t, uint32_t parent, flip f, const ball *child, const canonical *c);

/** Fewest hexes first, until the entries or the hexes reach a limit or there is nothing new. */
void table_grow(table *t, size_t most_entries, int most_hexes);

typedef void (*match_visitor)(void *user, uint32_t entry, walk_start start);
/**
 * Entries whose boundary is this one, marked at least where needed.
 * @param c       of the boundary; `start` is the walk that fits the entry's first one
 * @param needed  by dart
 */
void table_match(const table *t, const sphere *s, const canonical *c, const bool *needed,
                 match_visitor visit, void *user);

/** Where a mesh from the table is to go. */
typedef struct seat {
  const sphere *surface;
  const uint8_t *point; /**< of its vertices */
  walk_start start;
  bool inside_out; /**< its quads face into the ball to be filled */
  int point_count; /**< ids given out; grows */
} seat;

/** Copy an entry's hexes to a place. @return their number, or 0 if ids or `room` run out */
int table_transplant(const table *t, uint32_t entry, seat *where, uint8_t (*hexes)[8], int room);

#endif
