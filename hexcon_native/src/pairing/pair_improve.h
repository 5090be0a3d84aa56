/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** A heavier pairing: alternating cycles of positive gain. */
#ifndef HEXCON_PAIRING_PAIR_IMPROVE_H
#define HEXCON_PAIRING_PAIR_IMPROVE_H

#include "pair_state.h"

/**
 * Exchange pairs along alternating cycles that gain weight, until a bounded search finds no more.
 * All quads are paired before and after.
 * @return OUT_OF_MEMORY, CANCELLED (the pairing is then a pairing all the same)
 */
hexcon_status pair_improve(pair_state *p);

#endif
