/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Which layers leave a core that is worth filling? */
#ifndef HEXCON_SOLVE_SHEETS_SHEET_CORES_H
#define HEXCON_SOLVE_SHEETS_SHEET_CORES_H

#include "layered_core.h"

enum { CORES_KEPT = 4 };

typedef struct sheet_cores {
  size_t count, step_count;
  layered_core cores[CORES_KEPT]; /**< the fewest hexes expected first; of 0 quads: all is filled */
} sheet_cores;

/**
 * Look for layers that have room for good hexes: on the surface where it bends, or anywhere under a
 * layer that covers all of it, between whose hexes there is always room. Cores that keep nearly all
 * quads are dropped.
 * @param whole_only  drop all but those of 0 quads
 * @param limit       see sheet_search_run
 * @param out         free with sheet_cores_free, also after an error
 * Errors: those of sheet_search_run. Cost: that of six searches.
 */
hexcon_status sheet_cores_find(hexcon_context *context, const surface *s, bool whole_only,
                               size_t limit, sheet_cores *out);
void sheet_cores_free(hexcon_context *context, sheet_cores *cores);

#endif
