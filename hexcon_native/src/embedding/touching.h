/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Quads that touch exactly: a corner or a side of one on the other. */
#ifndef HEXCON_EMBEDDING_TOUCHING_H
#define HEXCON_EMBEDDING_TOUCHING_H

#include <stdbool.h>

#include "flat_quads.h"

/**
 * Proved: a side of one meets a side of the other, or the polygon that it is, or a corner of one
 * lies on the other's patch, where they do not share it. For pairs that no plane and no halving
 * parts: false leaves the question open.
 */
bool quads_touch(const flat_quad *a, const flat_quad *b);

#endif
