/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** As many pairs as there can be: augmenting paths, through blossoms. */
#ifndef HEXCON_PAIRING_PAIR_AUGMENT_H
#define HEXCON_PAIRING_PAIR_AUGMENT_H

#include "pair_state.h"

/**
 * Pair the quads that are free, as long as there are augmenting paths: the quads still free
 * afterwards are as few as can be. Each search costs what it visits: near its start, while free
 * quads are many.
 * Sources: Edmonds, Paths, trees, and flowers (1965); Gabow, An efficient implementation of
 * Edmonds' algorithm for maximum matching on graphs (1976).
 * @return OUT_OF_MEMORY, CANCELLED
 */
hexcon_status pair_augment(pair_state *p);

#endif
