/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The result of meshing, and the report that grows with it. */
#ifndef HEXCON_SOLVE_COMMON_MESH_RESULT_H
#define HEXCON_SOLVE_COMMON_MESH_RESULT_H

#include "base/context.h"

enum { MAX_FIGURES = 32, MAX_LOG = 4096 };

struct hexcon_mesh {
  size_t point_count, hex_count, quad_count;
  int order;
  double *points;
  int32_t *hexes; /* [hex_count][8] or [hex_count][20] */
  int32_t *quads;
  double *quality;
  const char *method;
  bool topological, checked;
  double bound; /* of the worst scaled Jacobian that this topology can have on this surface */
  hexcon_certificate certificate;
  size_t figure_count;
  hexcon_figure figures[MAX_FIGURES];
  size_t log_length;
  char log[MAX_LOG];
};

/** Free what a mesh holds; it is empty then. */
void mesh_clear(hexcon_context *context, hexcon_mesh *mesh);

/** Set a figure, or add it; those beyond MAX_FIGURES are dropped. */
void mesh_note(hexcon_mesh *mesh, const char *name, double value);

/** Value of a figure; 0: there is none of that name. */
double mesh_figure(const hexcon_mesh *mesh, const char *name);

/** Add a line to the log; what is beyond MAX_LOG is cut off. */
void mesh_log(hexcon_mesh *mesh, const char *line);

/**
 * If the time ran out and there is a mesh all the same, that is the method's: then log it, and let
 * it be finished.
 * @return HEXCON_OK then, else `status`
 */
hexcon_status mesh_settle(hexcon_context *context, hexcon_status status, bool found,
                          hexcon_mesh *mesh);

/** After an improvement that kept what it had: whether that can be measured, in time or because the
 * time has just run out, which then is used for it. */
bool mesh_stop(hexcon_context *context, hexcon_status status);

/** Seconds since an arbitrary start, for the report only. */
double mesh_clock(void);

/** Note "seconds <stage>" since `start`. */
void mesh_note_seconds(hexcon_mesh *mesh, const char *stage, double start);

/** Note "hexes of <stage>". */
void mesh_note_hexes(hexcon_mesh *mesh, hex_stage stage, size_t hexes);

/** Note "hexes of <stage>" of hexes that lie outside of all others, and come first; what is under
 * them gets a stage of its own where the method has none. */
void mesh_note_outer_hexes(hexcon_mesh *mesh, hex_stage stage, size_t hexes);

/** Note "hexes of <stage> <number>": one of several stages of a kind. */
void mesh_note_hexes_of_one(hexcon_mesh *mesh, hex_stage stage, size_t number, size_t hexes);

/** Append mid-edge points and turn the hexes into those of order 2. Linear. */
hexcon_status mesh_raise_order(hexcon_context *context, hexcon_mesh *mesh);

#endif
