/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "repair.h"

#include <string.h>

#include "edge_lengths.h"
#include "hexmesh/hex_tables.h"
#include "hexmesh/scaled_jacobian.h"
#include "reference_placement.h"
#include "verify/jacobian_sign.h"

size_t patch_count_bad(patch *p, size_t *watched) {
  size_t bad = 0;
  for (size_t h = 0; h < p->hex_count; h++) {
    int32_t hex[8];
    for (size_t c = 0; c < 8; c++)
      hex[c] = p->corners[8 * h + hex_corner_bits[c]];
    if (prove_jacobian_sign(p->x, hex) == JACOBIAN_POSITIVE)
      continue;
    bad++;
    if (watched && p->watched[h] < PATCH_WATCH_MOST && scaled_jacobian(p->x, hex) > 0) {
      p->watched[h]++;
      ++*watched;
    }
  }
  return bad;
}

hexcon_status untangle_watching(hexcon_context *context, newton *n, patch *p, bool patient,
                                size_t *bad) {
  const int most_passes = 1 + PATCH_WATCH_MOST;
  hexcon_status status = HEXCON_OK;
  memset(p->watched, 0, p->hex_count * sizeof *p->watched);
  for (int pass = 0; !status && pass < most_passes; pass++) {
    bool done;
    size_t watched = 0;
    status = untangle_patch(context, n, p, patient, &done);
    *bad = patch_count_bad(p, &watched);
    if (*bad == 0 || watched == 0)
      break;
  }
  return status;
}

/** States of a patch's points, [3 point_count] each. */
typedef struct repair_states {
  double *given, *placed, *best;
} repair_states;

static bool placement_is_better(const patch *p, const repair_states *states) {
  const frame_energy_options options = {.epsilon = 1, .theta = 0.125};
  return patch_energy(p, states->placed, &options, NULL, NULL).energy <
         patch_energy(p, states->given, &options, NULL, NULL).energy;
}

/** Untangle from both starts, the better one first. */
static hexcon_status try_starts(hexcon_context *context, patch *p, repair_states *states,
                                bool patient, size_t *bad) {
  size_t bytes = 3 * p->point_count * sizeof *p->x;
  bool first_placed = placement_is_better(p, states);
  newton n;
  hexcon_status status = newton_new(context, p, &n);
  for (int attempt = 0; !status && attempt < 2 && *bad > 0; attempt++) {
    size_t now = *bad;
    memcpy(p->x, (attempt == 0) == first_placed ? states->placed : states->given, bytes);
    status = patch_put_on(context, p);
    if (!status)
      status = untangle_watching(context, &n, p, patient, &now);
    if (now < *bad) {
      *bad = now;
      memcpy(states->best, p->x, bytes);
    }
  }
  memcpy(p->x, states->best, bytes);
  newton_free(context, &n);
  return status;
}

/** Place by the targets alone; the state to beat is the better of that and the given one.
 * @return whether it is good enough: nothing bad is left, or, in a large patch, so little that it
 * is better repaired piece by piece */
static bool try_placement(patch *p, repair_states *states, size_t *bad) {
  const size_t large = 10000, much_fewer = 10;
  size_t bytes = 3 * p->point_count * sizeof *p->x, left = patch_count_bad(p, NULL);
  memcpy(states->placed, p->x, bytes);
  memcpy(states->best, left < *bad ? states->placed : states->given, bytes);
  bool enough = left == 0 || (p->free_count > large && left * much_fewer < *bad);
  *bad = left < *bad ? left : *bad;
  memcpy(p->x, states->best, bytes);
  return enough;
}

hexcon_status repair_patch(hexcon_context *context, patch *p, const uint8_t *healthy, bool patient,
                           size_t *bad) {
  size_t size = 3 * sizeof *p->x;
  repair_states states = {context_allocate(context, p->point_count, size),
                          context_allocate(context, p->point_count, size),
                          context_allocate(context, p->point_count, size)};
  hexcon_status status =
      states.given && states.placed && states.best ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  *bad = patch_count_bad(p, NULL);
  if (!status) {
    memcpy(states.given, p->x, size * p->point_count);
    status = edge_lengths_spread(context, p, healthy);
  }
  if (!status)
    status = reference_placement(context, p);
  if (!status)
    status = patch_put_on(context, p);
  if (!status && !try_placement(p, &states, bad))
    status = try_starts(context, p, &states, patient, bad);
  context_free(context, states.given);
  context_free(context, states.placed);
  context_free(context, states.best);
  return status;
}
