/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The proof that a quad surface crosses and touches itself nowhere. */
#ifndef HEXCON_EMBEDDING_EMBEDDING_H
#define HEXCON_EMBEDDING_EMBEDDING_H

#include "base/context.h"

/** As hexcon_surface_embedding, for checked arrays and without forgetting the last error; points
 * that no quad uses are allowed. */
hexcon_status embedding_prove(hexcon_context *context, const double *points, size_t point_count,
                              const int32_t *quads, size_t quad_count, hexcon_embedding *out);

#endif
