/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "stages.h"

#define FACTS(constant, name, words) {name, words},
static const hexcon_stage_facts progress_stages[] = {PROGRESS_STAGES(FACTS)};
static const hexcon_stage_facts hex_stages[] = {HEX_STAGES(FACTS)};
#undef FACTS

const hexcon_stage_facts *hexcon_progress_stage(size_t row) {
  return row < PROGRESS_STAGE_COUNT ? &progress_stages[row] : NULL;
}

const hexcon_stage_facts *hexcon_hex_stage(size_t row) {
  return row < HEX_STAGE_COUNT ? &hex_stages[row] : NULL;
}
