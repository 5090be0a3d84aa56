/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "repair.h"

#include <string.h>

#include "edge_lengths.h"
#include "reference_placement.h"
#include "verify/hex_tables.h"
#include "verify/jacobian_sign.h"
#include "verify/scaled_jacobian.h"

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

/** The better start first. Returns the energies' verdict: whether the placement is better. */
static bool placement_is_better(const patch *p, const double *given, const double *placed) {
  const frame_energy_options options = {.epsilon = 1, .theta = 0.125};
  return patch_energy(p, placed, &options, NULL, NULL).energy <
         patch_energy(p, given, &options, NULL, NULL).energy;
}

static hexcon_status try_starts(hexcon_context *context, newton *n, patch *p, double *given,
                                double *placed, double *best, size_t *bad) {
  size_t bytes = 3 * p->point_count * sizeof *p->x;
  hexcon_status status = reference_placement(context, p);
  memcpy(placed, p->x, bytes);
  memcpy(best, given, bytes);
  bool first_placed = placement_is_better(p, given, placed);
  for (int attempt = 0; !status && attempt < 4 && *bad > 0; attempt++) {
    size_t now = *bad;
    memcpy(p->x, (attempt % 2 == 0) == first_placed ? placed : given, bytes);
    status = untangle_watching(context, n, p, attempt >= 2, &now);
    if (now < *bad) {
      *bad = now;
      memcpy(best, p->x, bytes);
    }
  }
  memcpy(p->x, best, bytes);
  return status;
}

hexcon_status repair_patch(hexcon_context *context, patch *p, const uint8_t *healthy, size_t *bad) {
  size_t size = 3 * sizeof *p->x;
  newton n = {0};
  double *given = context_allocate(context, p->point_count, size);
  double *placed = context_allocate(context, p->point_count, size);
  double *best = context_allocate(context, p->point_count, size);
  hexcon_status status = given && placed && best ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  *bad = patch_count_bad(p, NULL);
  if (!status)
    status = newton_new(context, p, &n);
  if (!status) {
    memcpy(given, p->x, size * p->point_count);
    status = edge_lengths_spread(context, p, healthy);
  }
  if (!status)
    status = try_starts(context, &n, p, given, placed, best, bad);
  newton_free(context, &n);
  context_free(context, given);
  context_free(context, placed);
  context_free(context, best);
  return status;
}
