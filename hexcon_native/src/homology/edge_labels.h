/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Labels of edges whose sum over a closed path tells the path's homology class. */
#ifndef HEXCON_HOMOLOGY_EDGE_LABELS_H
#define HEXCON_HOMOLOGY_EDGE_LABELS_H

#include "bit_matrix.h"
#include "handle_cycles.h"

/**
 * Write a word for every half-edge, alike on twins; words are added by exclusive or.
 *
 * A path's class is what it crosses of the rings, modulo 2. Without a matrix the sum is 0 if and
 * only if the path is a sum of bounds on the surface: a simple one parts it then. With that of the
 * linking numbers the sum of the matrix's rows for the rings crossed is taken, which is 0 if and
 * only if the path bounds inside. Classes become words by a linear map, one to one for up to 64
 * rings, else at random: a sum is 0 by chance with a probability of 2^-64.
 * @param linking  as linking_numbers_find gives it; NULL: classes on the surface
 * @param labels   [4 quad_count]
 * Cost: linear in the rings' half-edges, quadratic in the rings.
 */
void edge_labels_write(const surface *s, const handle_cycles *cycles, const bit_matrix *linking,
                       uint64_t *labels);

#endif
