/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** One way to fill a subdivided surface: blocks on coarse quads, diced tetrahedra inside. */
#ifndef HEXCON_SOLVE_DICED_DICED_FILLING_H
#define HEXCON_SOLVE_DICED_DICED_FILLING_H

#include "construct/coarse_front.h"
#include "solve/common/filled_mesh.h"

typedef enum diced_closure {
  DICED_ONE,       /**< the front is one tetrahedron */
  DICED_STAR,      /**< one from each of its triangles to the centre */
  DICED_TETRAHEDRA /**< the caller's mesher's */
} diced_closure;

/** What stands on coarse quads. */
typedef enum diced_block { DICED_PYRAMIDS, DICED_GEODES, DICED_BLOCKS } diced_block;

/** What all attempts at one reading of the surface share. */
typedef struct diced_problem {
  const surface *s;
  const hexcon_mesh_options *options;
  bool star_shaped; /* then .. */
  double center[3]; /* .. sees the surface */
  double bound;     /* of the worst scaled Jacobian, from the surface's own corners */
  coarse_surface coarse;
  coarse_front fronts[DICED_BLOCKS]; /* no points: not possible */
  surface quads;                     /* the coarse surface, if Geodes are possible, .. */
  double *corners;                   /* .. and its points */
} diced_problem;

typedef struct diced_filling {
  filled_mesh mesh; /* without points if there are no tetrahedra */
  diced_block block;
  diced_closure closure;
  double scale; /* of the blocks' heights */
  double bound; /* of the worst scaled Jacobian, by narrow corners */
  size_t tetrahedron_count, triangle_count, quad_count;
} diced_filling;

/** Whether a front can be closed so at all. */
bool diced_filling_is_possible(const diced_problem *p, diced_block block, diced_closure kind);

/**
 * Fill, not improved yet.
 * @param f  free with filled_mesh_free(.., &f->mesh); no points where no tetrahedra were found, or
 *           one of a star's would be turned inside out
 * Errors: OUT_OF_MEMORY, TOO_LARGE, CANCELLED. Linear, and what the mesher takes.
 */
hexcon_status diced_filling_build(hexcon_context *context, const diced_problem *p,
                                  diced_block block, diced_closure kind, double scale,
                                  diced_filling *f);

#endif
