/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "coarse_ways.h"

#include <string.h>

#include "surface/shell_copy.h"

/** What one way is worth. */
typedef struct way_rank {
  uint8_t way;
  bool has_quads;
  double departure;
} way_rank;

static bool comes_before(const way_rank *a, const way_rank *b) {
  return a->has_quads != b->has_quads ? b->has_quads : a->departure < b->departure;
}

static void insert(way_rank *ranks, size_t count, way_rank fresh) {
  size_t place = count;
  for (; place > 0 && comes_before(&fresh, &ranks[place - 1]); place--)
    ranks[place] = ranks[place - 1];
  ranks[place] = fresh;
}

/** The ways to read one shell, ranked. */
static hexcon_status rank_ways(hexcon_context *context, const surface *shell,
                               uint8_t ways[COARSE_WAYS], size_t *count) {
  way_rank ranks[COARSE_WAYS] = {{0}};
  size_t fewest = SIZE_MAX;
  uint8_t nearest = 0;
  *count = 0;
  for (int k = 0; k < COARSE_WAYS; k++) {
    const uint8_t way = (uint8_t)k;
    coarse_surface c;
    size_t faults = 0;
    hexcon_status status = coarse_surface_read(context, shell, &way, &c, &faults);
    way_rank rank = {way, c.quad_count > 0, c.departure};
    coarse_surface_free(context, &c);
    if (status && status != HEXCON_NOT_DICED)
      return status;
    if (!status)
      insert(ranks, (*count)++, rank);
    else if (faults < fewest)
      nearest = way;
    fewest = faults < fewest ? faults : fewest;
    context_clear(context);
  }
  for (size_t i = 0; i < *count; i++)
    ways[i] = ranks[i].way;
  coarse_surface none;
  if (*count > 0)
    return HEXCON_OK;
  hexcon_status status = coarse_surface_read(context, shell, &nearest, &none, NULL);
  coarse_surface_free(context, &none);
  return status;
}

/** Ways and their number of every shell. */
static hexcon_status rank_shells(hexcon_context *context, const surface *s,
                                 uint8_t (*ways)[COARSE_WAYS], size_t *counts) {
  shell_copies copies;
  hexcon_status status = shell_copies_new(context, s, &copies);
  for (size_t c = 0; !status && c < s->component_count; c++) {
    surface shell;
    status = shell_copies_take(context, &copies, c, &shell);
    if (!status)
      status = rank_ways(context, &shell, ways[c], &counts[c]);
    if (status == HEXCON_NOT_DICED)
      for (size_t i = 0; i < context->element_count; i++)
        context->elements[i] = shell_copies_quad(&copies, c, context->elements[i]);
    shell_copy_free(context, &shell);
  }
  shell_copies_free(context, &copies);
  return status;
}

static hexcon_status write_ways(hexcon_context *context, const surface *s,
                                uint8_t (*ways)[COARSE_WAYS], const size_t *counts,
                                coarse_ways *out) {
  for (size_t c = 0; c < s->component_count; c++)
    out->count = counts[c] > out->count ? counts[c] : out->count;
  out->of_shells =
      context_allocate(context, out->count * s->component_count, sizeof *out->of_shells);
  if (!out->of_shells)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t k = 0; k < out->count; k++)
    for (size_t c = 0; c < s->component_count; c++)
      out->of_shells[k * s->component_count + c] = ways[c][k < counts[c] ? k : counts[c] - 1];
  return HEXCON_OK;
}

hexcon_status coarse_ways_find(hexcon_context *context, const surface *s, coarse_ways *out) {
  *out = (coarse_ways){0};
  uint8_t(*ways)[COARSE_WAYS] = context_allocate(context, s->component_count, sizeof *ways);
  size_t *counts = context_allocate_zeroed(context, s->component_count, sizeof *counts);
  hexcon_status status = ways && counts ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  if (!status)
    status = s->component_count == 1 ? rank_ways(context, s, ways[0], counts)
                                     : rank_shells(context, s, ways, counts);
  if (!status)
    status = write_ways(context, s, ways, counts, out);
  context_free(context, ways);
  context_free(context, counts);
  return status;
}

void coarse_ways_free(hexcon_context *context, coarse_ways *ways) {
  context_free(context, ways->of_shells);
  *ways = (coarse_ways){0};
}
