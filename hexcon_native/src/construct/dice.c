/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "dice.h"

#include <string.h>

#include "tuple_table.h"

/** Corner i of a tetrahedron, then the others so that orientation is kept: a hex at each. */
static const unsigned char turns[4][4] = {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}};

typedef struct dicing {
  tuple_table table;
  diced_complex *out;
  size_t first_point;
} dicing;

/** Id of the mean of up to four corners, c and d may be -1. */
static int32_t mean_point(dicing *d, int32_t a, int32_t b, int32_t c) {
  int32_t fresh = (int32_t)(d->first_point + d->out->point_count);
  int32_t id = tuple_table_number(&d->table, a, b, c, fresh);
  if (id == fresh) {
    int32_t corners[4] = {a, b, c, -1};
    memcpy(d->out->means + 4 * d->out->point_count++, corners, sizeof corners);
  }
  return id;
}

static void dice_one(dicing *d, const int32_t t[4], int32_t *hex) {
  int32_t body = (int32_t)(d->first_point + d->out->point_count);
  memcpy(d->out->means + 4 * d->out->point_count++, t, 4 * sizeof *t);
  for (size_t turn = 0; turn < 4; turn++, hex += 8) {
    int32_t i = t[turns[turn][0]], j = t[turns[turn][1]], k = t[turns[turn][2]],
            m = t[turns[turn][3]];
    hex[0] = i;
    hex[1] = mean_point(d, i, j, -1);
    hex[2] = mean_point(d, i, j, k);
    hex[3] = mean_point(d, i, k, -1);
    hex[4] = mean_point(d, i, m, -1);
    hex[5] = mean_point(d, i, j, m);
    hex[6] = body;
    hex[7] = mean_point(d, i, k, m);
  }
}

static void enter_known(dicing *d, const diced_triangles *known) {
  for (size_t t = 0; t < known->count; t++) {
    const int32_t *c = known->corners + 3 * t, *middles = known->side_middles + 3 * t;
    (void)tuple_table_number(&d->table, c[0], c[1], c[2], known->means[t]);
    for (size_t i = 0; i < 3; i++)
      (void)tuple_table_number(&d->table, c[i], c[(i + 1) % 3], -1, middles[i]);
  }
}

hexcon_status dice(hexcon_context *context, const int32_t *tetrahedra, size_t count,
                   const diced_triangles *known, size_t first_point, diced_complex *out) {
  memset(out, 0, sizeof *out);
  /* New points: a body, and no more than four faces and six edges each. */
  if (count > CONTEXT_MAX_COUNT / 32 || first_point > CONTEXT_MAX_COUNT - 11 * count)
    return context_fail(context, HEXCON_TOO_LARGE,
                        "%zu tetrahedra make more points than 32-bit ids hold", count);
  dicing d = {.out = out, .first_point = first_point};
  out->hex_count = 4 * count;
  out->hexes = context_allocate(context, 32 * count, sizeof *out->hexes);
  out->means = context_allocate(context, 44 * count, sizeof *out->means);
  hexcon_status status = tuple_table_new(context, 10 * count + 4 * known->count, &d.table);
  if (!out->hexes || !out->means)
    status = HEXCON_OUT_OF_MEMORY;
  if (!status) {
    enter_known(&d, known);
    status = context_after(context, known->count);
    for (size_t t = 0; !status && t < count; t++) {
      dice_one(&d, tetrahedra + 4 * t, out->hexes + 32 * t);
      status = context_pass(context, t);
    }
  }
  tuple_table_free(context, &d.table);
  return status;
}

void dice_free(hexcon_context *context, diced_complex *d) {
  context_free(context, d->hexes);
  context_free(context, d->means);
  memset(d, 0, sizeof *d);
}
