/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "edge_labels.h"

#include <string.h>

/** splitmix64's finalizer: as good as random words, and always the same. */
static uint64_t scramble(uint64_t x) {
  x = (x + 1) * 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

static uint64_t word_of(const handle_cycles *c, size_t ring) {
  return c->count <= 64 ? (uint64_t)1 << ring : scramble(ring);
}

static uint64_t label_of(const handle_cycles *c, const bit_matrix *linking, size_t ring) {
  if (!linking)
    return word_of(c, ring);
  uint64_t label = 0;
  for (size_t k = 0; k < c->count; k++)
    if (bit_matrix_get(linking, ring, k))
      label ^= word_of(c, k);
  return label;
}

void edge_labels_write(const surface *s, const handle_cycles *cycles, const bit_matrix *linking,
                       uint64_t *labels) {
  memset(labels, 0, 4 * s->quad_count * sizeof *labels);
  for (size_t j = 0; j < cycles->count; j++) {
    uint64_t label = label_of(cycles, linking, j);
    for (size_t k = cycles->first_across[j]; k < cycles->first_across[j + 1]; k++) {
      labels[cycles->across[k]] ^= label;
      labels[s->twins[cycles->across[k]]] ^= label;
    }
  }
}
