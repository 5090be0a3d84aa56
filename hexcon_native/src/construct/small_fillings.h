/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * Proper hex meshes of quadrangulations of the sphere with few quads: a table, made by search.
 * resources/fillings tells how it is written.
 */
#ifndef HEXCON_CONSTRUCT_SMALL_FILLINGS_H
#define HEXCON_CONSTRUCT_SMALL_FILLINGS_H

#include "surface/canonical_code.h"

/** One class of quadrangulations, as the table has it. */
typedef struct small_filling_record {
  const char *code;   /**< canonical_code.h; boundary points are numbered as it says */
  int certified;      /**< the hexes are positive where `places` puts them */
  const char *hexes;  /**< eight ids a hex, VTK order, two digits each */
  const char *places; /**< three coordinates a point, three digits each */
} small_filling_record;

typedef struct small_filling_table {
  size_t count;
  const small_filling_record *records; /**< [count] by code, ascending */
} small_filling_table;

/** Made from resources/fillings/smallest.txt by the build. */
extern const small_filling_table small_fillings_smallest;

/** A filling of a surface: its points first, then new ones. */
typedef struct small_filling {
  size_t point_count, hex_count;
  int32_t *hexes; /**< [hex_count][8] VTK order */
  double *places; /**< [point_count][3] of a mesh with these hexes in a convex polyhedron */
  bool certified; /**< whether that mesh is */
} small_filling;

/** A surface's class and the ways in which its filling fits the surface: its symmetries. */
typedef struct small_class {
  const small_filling_record *record;
  size_t walk_count; /**< at least 1 */
  walk_start walks[CODE_MOST_WALKS];
} small_class;

/**
 * Look a surface up; the mirror image of a class is the class.
 * @param s  a sphere's surface whose points are all used
 * @return NOT_A_BALL; NO_SMALL_FILLING: too many quads, two quads that meet in opposite corners
 *         (elements; no proper mesh has them), or a class that the table lacks. Cost: quadratic in
 *         the quads.
 */
hexcon_status small_class_find(hexcon_context *context, const surface *s,
                               const small_filling_table *table, small_class *out);

/**
 * Write the class's filling with the surface's own points.
 * @param walk  below walk_count: which points of the surface are which of the class
 * @param out   free with small_filling_free, also after an error
 * @return BAD_ARGUMENT for a damaged record, OUT_OF_MEMORY. Cost: n log n in the hexes.
 */
hexcon_status small_filling_read(hexcon_context *context, const surface *s,
                                 const small_class *found, size_t walk, small_filling *out);
void small_filling_free(hexcon_context *context, small_filling *filling);

/**
 * Check a record: ids in range, every face in two hexes or on the boundary, and that is of the
 * class.
 * @return BAD_ARGUMENT with the fault, OUT_OF_MEMORY. Cost: n log n in the hexes.
 */
hexcon_status small_filling_check(hexcon_context *context, const small_filling_record *record);

#endif
