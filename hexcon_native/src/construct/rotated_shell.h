/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * Shells of hexes in which edges rotate: under each quad a hex, under each hexagon of a rotation a
 * template of 38 hexes whose upper end is split one way and whose lower end another way. Its six
 * sides are plain quads, so it fits beside hexes and its like.
 *
 * With that, any surface can be turned by and by into one whose dual loops can be taken away.
 */
#ifndef HEXCON_CONSTRUCT_ROTATED_SHELL_H
#define HEXCON_CONSTRUCT_ROTATED_SHELL_H

#include "growing_mesh.h"
#include "hex_template.h"
#include "surface/edge_rotation.h"

/** Rotations in the order in which they follow from each other. */
typedef struct rotation_plan {
  size_t count, shell_count;
  edge_rotation *rotations; /**< [count] half-edges as numbered when their turn comes */
  uint8_t *shells;          /**< [count] 0 .. shell_count - 1 from outside; those of a shell have no
                                 quad in common */
} rotation_plan;

/** Hexes of all shells. Point v of the surface is v + level * point_count on each level 0 ..
 * shell_count; those inside the cells follow. */
typedef struct rotated_shell {
  growing_mesh mesh;
  surface inner; /**< the surface under the last shell, in its numbers 0 .. point_count - 1; its
                      points are not known here */
  const hex_template *cell;
  size_t cell_count;
  int32_t *cell_points; /**< [cell_count][cell->point_count] */
  bool *mirrored;       /**< [cell_count] its hexagon is passed clockwise */
} rotated_shell;

/**
 * Build the shells of a plan.
 * @param fits  receives false where the surface between two shells is not proper: the rotations
 * were found in another order
 * @param out  free with rotated_shell_free, also after an error
 * Errors: OUT_OF_MEMORY, TOO_LARGE, BAD_ARGUMENT (a damaged template). Cost: linear in the hexes.
 */
hexcon_status rotated_shell_build(hexcon_context *context, const surface *s,
                                  const rotation_plan *plan, rotated_shell *out, bool *fits);
void rotated_shell_free(hexcon_context *context, rotated_shell *shell);

#endif
