/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The proof that a quad surface crosses and touches itself nowhere. */
#ifndef HEXCON_EMBEDDING_EMBEDDING_H
#define HEXCON_EMBEDDING_EMBEDDING_H

#include "base/context.h"

/** As hexcon_surface_embedding, for checked arrays and without forgetting the last error; points
 * that no quad uses are allowed. */
hexcon_status embedding_prove(hexcon_context *context, const double *points, size_t point_count,
                              const int32_t *quads, size_t quad_count, hexcon_embedding *out);

/**
 * The same of curved quads, each the serendipity patch on its 8 nodes.
 * @param quads   [quad_count][8] corners, then the middles of the sides; quads that share the ends
 * of a side share its middle
 * @param shells  [quad_count] or NULL. YES says then besides that quads of different shells do not
 *                meet while all become straight together, so that shells lie within one another as
 *                the bilinear patches on their corners do
 */
hexcon_status embedding_prove_curved(hexcon_context *context, const double *points,
                                     size_t point_count, const int32_t *quads,
                                     const int32_t *shells, size_t quad_count,
                                     hexcon_embedding *out);

#endif
