/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "corner_table.h"

#include <string.h>

hexcon_status corner_table_build(hexcon_context *context, const int32_t *hexes, size_t hex_count,
                                 size_t point_count, corner_table *out) {
  out->starts = context_allocate_zeroed(context, point_count + 2, sizeof *out->starts);
  out->corners = context_allocate(context, 8 * hex_count, sizeof *out->corners);
  if (!out->starts || !out->corners)
    return HEXCON_OUT_OF_MEMORY;
  /* Counted two places ahead, so that filling moves starts[v + 1] to where it belongs. */
  hexcon_status status = HEXCON_OK;
  for (size_t c = 0; !status && c < 8 * hex_count; c++) {
    out->starts[hexes[c] + 2]++;
    status = context_pass(context, c);
  }
  for (size_t v = 1; v <= point_count; v++)
    out->starts[v + 1] += out->starts[v];
  for (size_t c = 0; !status && c < 8 * hex_count; c++) {
    out->corners[out->starts[hexes[c] + 1]++] = (int32_t)c;
    status = context_pass(context, c);
  }
  return status;
}

void corner_table_free(hexcon_context *context, corner_table *table) {
  context_free(context, table->starts);
  context_free(context, table->corners);
  memset(table, 0, sizeof *table);
}
