/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Points of a patch that slide: each moves in a linear space of its own, and is put back onto what
 * it slides on after every step. */
#ifndef HEXCON_SHAPE_IMPROVE_TANGENT_SPACES_H
#define HEXCON_SHAPE_IMPROVE_TANGENT_SPACES_H

#include "block_matrix.h"

/** Spaces of the free points of a patch. */
typedef struct tangent_spaces {
  size_t count;       /**< free points */
  uint8_t *freedom;   /**< [count] 1: along a tangent, 2: in a tangent plane, 3: anywhere */
  double *directions; /**< [count][3] unit tangent or normal at the patch's points; of no
                           meaning where the freedom is 3 */
  double *trial;      /**< [count][3] those at the points that were put back last */
  /** Put points back onto what they slide on, and tell the directions there. Not NULL.
   * @param x           [count][3] in place
   * @param directions  [count][3] those of points of freedom 3 are left as they are */
  hexcon_status (*retract)(void *user, hexcon_context *context, double *x, double *directions);
  void *user;
} tangent_spaces;

/** Room for so many points, all of freedom 3. @param out free with tangent_spaces_free, also after
 * an error */
hexcon_status tangent_spaces_new(hexcon_context *context, size_t count, tangent_spaces *out);
void tangent_spaces_free(hexcon_context *context, tangent_spaces *spaces);

/** Put a patch's points onto what they slide on, and take the directions there; nothing where they
 * do not slide. */
hexcon_status patch_put_on(hexcon_context *context, patch *p);

/** Take every point's part of a vector [count][3] that lies in its space. */
void tangent_spaces_restrict(const tangent_spaces *spaces, double *vector);

/** The matrix seen from the spaces, P M P, and a multiple of the identity across them, so that it
 * stays positive definite. */
void tangent_spaces_restrict_matrix(const tangent_spaces *spaces, block_matrix *m);

/** Put trial points back; their directions are kept aside until they are accepted. */
hexcon_status tangent_spaces_retract(hexcon_context *context, tangent_spaces *spaces, double *x);

/** The points put back last are the patch's from now on. */
void tangent_spaces_accept(tangent_spaces *spaces);

#endif
