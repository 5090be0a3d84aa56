/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * Reflections of a surface.
 *
 * A swept surface has one: it exchanges the caps and turns every column of sides upside down. It
 * is fixed by what it does to a single quad, so a strip's middle is enough to try it.
 */
#ifndef HEXCON_CONSTRUCT_REFLECTION_H
#define HEXCON_CONSTRUCT_REFLECTION_H

#include "strips.h"

/**
 * Where a strip is reflected, in half rings from its left end: 2 r is the edge cycle on the left
 * of ring r, 2 r + 1 the middle of ring r.
 */
typedef struct mirror {
  int32_t strip;
  size_t middle;
} mirror;

typedef struct reflection {
  int32_t *images; /**< [quad_count] 4 * q + o: side s goes to side (o - s) mod 4 of quad q */
  int32_t *queue;  /**< [quad_count] the quads reached, in order */
  size_t reached;  /**< length of queue */
  mirror *mirrors; /**< [mirror_count] every curve that stays in place */
  size_t mirror_count, mirror_capacity;
  int32_t *mirror_of_strip; /**< [strip count] its (last) mirror, -1 if none */
  size_t max_rings;         /**< most rings that all mirrors' strips have about them */
  int32_t clash[2];    /**< where it failed: a quad and the one it cannot go to; -1 if unknown */
  const char *failure; /**< NULL if the reflection exists */
} reflection;

/** Allocate; images are unset. @param out free with reflection_free */
hexcon_status reflection_new(hexcon_context *context, const surface *s, const strip_table *strips,
                             reflection *out);
void reflection_free(hexcon_context *context, reflection *r);

/**
 * Try the reflection about a mirror. Linear in r->reached, which ends at the first clash.
 * On return r->failure tells whether it exists; if so, images, mirrors and max_rings hold.
 */
hexcon_status reflection_try(hexcon_context *context, const surface *s, const surface_loops *loops,
                             const strip_table *strips, mirror seed, reflection *r);

/** Image of a half-edge; it runs the other way. */
static inline int32_t reflection_image(const reflection *r, int32_t half_edge) {
  int32_t image = r->images[half_edge >> 2];
  return (image & ~3) | ((image - half_edge) & 3);
}

#endif
