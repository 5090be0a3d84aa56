/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** A patch whose points slide on what the mesh's points lie on. */
#ifndef HEXCON_SHAPE_IMPROVE_SLIDING_PATCH_H
#define HEXCON_SHAPE_IMPROVE_SLIDING_PATCH_H

#include "shape/slide/sliding_points.h"
#include "tangent_spaces.h"

typedef struct sliding_patch {
  const sliding_points *sliding;
  int32_t *ids; /**< [free_count] of the patch's free points, as `sliding` numbers them */
  tangent_spaces spaces;
} sliding_patch;

/**
 * Put a patch's free points onto what they lie on, and have them stay there: p->spaces is set.
 * @param point_ids  of the mesh's points, as `sliding` numbers them
 * @param out        stays where it is; free with sliding_patch_free, also after an error
 */
hexcon_status sliding_patch_new(hexcon_context *context, const sliding_points *sliding,
                                const int32_t *point_ids, patch *p, sliding_patch *out);
void sliding_patch_free(hexcon_context *context, sliding_patch *sliding);

#endif
