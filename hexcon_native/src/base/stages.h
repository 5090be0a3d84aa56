/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The tables of stages: what long work calls itself while it runs, and what put hexes in. */
#ifndef HEXCON_BASE_STAGES_H
#define HEXCON_BASE_STAGES_H

#include "hexcon.h"

/** Stages that progress tells of: constant, name, and the words that people see. */
#define PROGRESS_STAGES(ROW)                                                                       \
  ROW(STAGE_CHECKS, "checks", "Surface: checking")                                                 \
  ROW(STAGE_LINKING_NUMBERS, "linking numbers", "Surface: which closed paths bound inside")        \
  ROW(STAGE_PAIRING, "pairing", "Hexes: pairing quads")                                            \
  ROW(STAGE_SWEEP_RECOGNITION, "sweep recognition", "Hexes: looking for sweeps")                   \
  ROW(STAGE_PLACEMENT, "placement", "Hexes: placing points")                                       \
  ROW(STAGE_CUTS, "cutting handles", "Hexes: cutting handles")                                     \
  ROW(STAGE_LOOPS, "taking loops away", "Hexes: taking dual loops away")                           \
  ROW(STAGE_ROTATIONS, "rotating edges", "Hexes: looking for edges to rotate")                     \
  ROW(STAGE_SPLIT_LAYERS, "split layers", "Hexes: laying split layers")                            \
  ROW(STAGE_CLOSURE, "closure", "Hexes: closing the inside")                                       \
  ROW(STAGE_TETRAHEDRA, "tetrahedra", "Hexes: cutting tetrahedra")                                 \
  ROW(STAGE_TETRAHEDRA_INSIDE, "tetrahedra inside", "Hexes: tetrahedra inside")                    \
  ROW(STAGE_MEASURING, "measuring", "Hexes: measuring")                                            \
  ROW(STAGE_UNTANGLING, "untangling", "Hexes: untangling")                                         \
  ROW(STAGE_OPTIMISATION, "optimisation", "Hexes: improving the worst")                            \
  ROW(STAGE_HOMOTOPY, "homotopy", "Hexes: moving to another boundary")                             \
  ROW(STAGE_LINKS, "certificate: links", "Certificate: neighbourhoods")                            \
  ROW(STAGE_PAIRS, "certificate: pairs", "Certificate: pairs of hexes")                            \
  ROW(STAGE_JACOBIANS, "certificate: Jacobians", "Certificate: Jacobians")                         \
  ROW(STAGE_EMBEDDING, "embedding", "Does the surface cross itself?")

/** Stages that put hexes in, which a mesh's report counts as "hexes of <name>". */
#define HEX_STAGES(ROW)                                                                            \
  ROW(HEXES_OF_LAYERS, "layers", "boundary layers")                                                \
  ROW(HEXES_OF_CELLS, "cells", "cells")                                                            \
  ROW(HEXES_OF_STAR, "star", "star inside")                                                        \
  ROW(HEXES_OF_TETRAHEDRA, "tetrahedra", "tetrahedra inside")                                      \
  ROW(HEXES_OF_CORE, "core", "core")                                                               \
  ROW(HEXES_OF_GEODES, "geodes", "Geodes on coarse quads")                                         \
  ROW(HEXES_OF_PYRAMIDS, "pyramids", "pyramids on coarse quads")                                   \
  ROW(HEXES_OF_SHELLS, "shells", "shells of rotated edges")                                        \
  ROW(HEXES_OF_SHEETS_INSIDE, "sheets inside", "sheets inside")                                    \
  ROW(HEXES_OF_PAIRED_TRANSITION, "paired transition", "paired transition")                        \
  ROW(HEXES_OF_SPLIT_LAYER, "split layer", "split layer")                                          \
  ROW(HEXES_OF_FURTHER_LAYERS, "further split layers", "further split layers")                     \
  ROW(HEXES_OF_CLOSURE, "closure", "closure")                                                      \
  ROW(HEXES_OF_PILLOWS, "pillows", "pillows")                                                      \
  ROW(HEXES_OF_INSIDE, "inside", "inside of the pillows")

#define STAGE_CONSTANT(constant, name, words) constant,
typedef enum progress_stage { PROGRESS_STAGES(STAGE_CONSTANT) PROGRESS_STAGE_COUNT } progress_stage;
typedef enum hex_stage { HEX_STAGES(STAGE_CONSTANT) HEX_STAGE_COUNT } hex_stage;
#undef STAGE_CONSTANT

#endif
