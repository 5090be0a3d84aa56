/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "methods.h"

#include <stdio.h>

#include "solve/cells/mesh_cells.h"
#include "solve/diced/mesh_diced.h"
#include "solve/paper/mesh_topological.h"
#include "solve/proposal/mesh_proposal.h"
#include "solve/sheets/mesh_sheets.h"
#include "solve/shelling/mesh_shelling.h"
#include "solve/smallest/mesh_smallest.h"
#include "solve/swept/mesh_swept.h"

/**
 * In the order in which users see them: those for solvers by their worth, then those of topology.
 * `auto` tries by turn, those of fewest hexes first: the fewer a method takes, the less its
 * successors can win, so the lower is what suffices.
 */
static const method_row rows[] = {
    {.facts = {.method = HEXCON_METHOD_AUTO,
               .name = "auto",
               .label = "automatic",
               .purpose =
                   "tries the methods for solvers, those of fewest hexes first, until one is "
                   "certified and good, and takes the best",
               .told = "automatic",
               .pillow = true,
               .layers = true,
               .tetrahedralise = true,
               .proposal = true,
               .holes = true,
               .cavities = true,
               .odd_colours = true}},
    {.facts = {.method = HEXCON_METHOD_PROPOSAL,
               .name = "proposal",
               .label = "as proposed",
               .purpose =
                   "takes hexes that come with the surface: places, improves and proves them",
               .told = "as proposed[, {pillows} pillow]",
               .pillow = true,
               .proposal = true,
               .holes = true,
               .cavities = true,
               .odd_colours = true,
               .tries = {{.turn = 1, .good_worst = 0.2}}},
     .fill = mesh_proposal},
    {.facts = {.method = HEXCON_METHOD_SWEPT,
               .name = "swept",
               .label = "swept",
               .purpose = "sweeps: as many hexes as a cap's quads times rings",
               .told = "swept, {cap quads} cap quads \u00d7 {rings} rings[, {pillows} pillow]",
               .pillow = true,
               .holes = true,
               .odd_colours = true,
               .tries = {{.turn = 2, .good_worst = 0.3}}},
     .fill = mesh_swept},
    {.facts = {.method = HEXCON_METHOD_SHEETS,
               .name = "sheets",
               .label = "sheets",
               .purpose =
                   "boxes, polyhedra and mixtures that are no sweep: layers of hexes cut all "
                   "handles and take one dual loop after the other away, down to a cube or a core",
               .told = "{sheets} sheets[, {cuts} of them cuts][, a core of {core quads} quads]"
                       "[, {pillows} pillow]",
               .pillow = true,
               .core = true,
               .tetrahedralise = true,
               .holes = true,
               .odd_colours = true,
               .tries = {{.turn = 3, .good_worst = 0.2, .no_core = true},
                         {.turn = 7, .good_worst = 0.08}}},
     .fill = mesh_sheets},
    {.facts = {.method = HEXCON_METHOD_DICED,
               .name = "diced",
               .label = "diced",
               .purpose =
                   "subdivided triangles or quads around any body: tetrahedra inside, each cut "
                   "into four hexes",
               .told = "diced, {coarse triangles} coarse triangles, {coarse quads} coarse quads, "
                       "{tetrahedra} tetrahedra inside[, {pillows} pillow]",
               .pillow = true,
               .tetrahedralise = true,
               .holes = true,
               .cavities = true,
               .hexes_a_quad = 3,
               .tries = {{.turn = 4, .good_worst = 0.08, .most_hexes = 6}}},
     .fill = mesh_diced},
    {.facts = {.method = HEXCON_METHOD_SMALLEST,
               .name = "smallest",
               .label = "smallest",
               .purpose = "up to 16 quads around a ball: the smallest filling known, from a table",
               .told = "smallest[, {pillows} pillow]",
               .pillow = true,
               .hexes_a_quad = 4,
               .tries = {{.turn = 5, .good_worst = 0.08, .most_hexes = 6}}},
     .fill = mesh_smallest},
    {.facts = {.method = HEXCON_METHOD_SHELLING,
               .name = "shelling",
               .label = "shelling",
               .purpose =
                   "irregular surfaces of balls, up to some 400 quads: edges rotate in shells "
                   "under the surface, then as sheets",
               .told = "shelling, {rotations} rotated edges in {shells} shells[, {pillows} pillow]",
               .pillow = true,
               .hexes_a_quad = 4,
               .tries = {{.turn = 6, .good_worst = 0.08}}},
     .fill = mesh_shelling},
    {.facts = {.method = HEXCON_METHOD_CELLS,
               .name = "cells",
               .label = "cells",
               .purpose =
                   "any body, also with boundary layers: a cell of hexes on each pair of quads, "
                   "and tetrahedra inside, each cut into four hexes",
               .told = "cells, {layers} layers, {tetrahedra} tetrahedra inside[, {pillows} pillow]",
               .pillow = true,
               .layers = true,
               .tetrahedralise = true,
               .holes = true,
               .cavities = true,
               .hexes_a_quad = 45,
               .tries = {{.turn = 8, .good_worst = 0}}},
     .fill = mesh_cells},
    {.facts = {.method = HEXCON_METHOD_FOUR_SPLIT,
               .name = "four-split",
               .label = "four-split",
               .purpose =
                   "layers of hexes under any surface, down to quads that are all split in four",
               .told = "four-split",
               .topological = true,
               .pairing = true,
               .holes = true,
               .cavities = true,
               .odd_paths = true,
               .hexes_a_quad = 28},
     .fill = mesh_topological},
    {.facts = {.method = HEXCON_METHOD_PYRAMID,
               .name = "pyramid",
               .label = "pyramid",
               .purpose = "Carbonera and Shepherd's pyramids, in balls",
               .told = "pyramid",
               .topological = true,
               .pairing = true,
               .hexes_a_quad = 76},
     .fill = mesh_topological},
    {.facts = {.method = HEXCON_METHOD_PYRAMID_ALT,
               .name = "pyramid-alt",
               .label = "pyramid, alternative",
               .purpose = "pyramids under Mitchell's split layers, in balls",
               .told = "pyramid-alt",
               .topological = true,
               .pairing = true,
               .hexes_a_quad = 58},
     .fill = mesh_topological},
    {.facts = {.method = HEXCON_METHOD_GEODE,
               .name = "geode",
               .label = "geode",
               .purpose = "Carbonera and Shepherd's Geodes; with tetrahedra inside round holes too",
               .told = "geode",
               .topological = true,
               .pairing = true,
               .tetrahedralise = true,
               .holes = true,
               .cavities = true,
               .hexes_a_quad = 130},
     .fill = mesh_topological},
    {.facts = {.method = HEXCON_METHOD_GEODE_ALT,
               .name = "geode-alt",
               .label = "geode, alternative",
               .purpose =
                   "Geodes under Mitchell's split layers; with tetrahedra inside round holes "
                   "too",
               .told = "geode-alt",
               .topological = true,
               .pairing = true,
               .tetrahedralise = true,
               .holes = true,
               .cavities = true,
               .hexes_a_quad = 112},
     .fill = mesh_topological},
    {.facts = {.method = HEXCON_METHOD_PILLOWED,
               .name = "pillowed",
               .label = "pillowed",
               .purpose = "geode-alt without doublets: two hexes share one face at most",
               .told = "pillowed",
               .topological = true,
               .pairing = true,
               .tetrahedralise = true,
               .holes = true,
               .cavities = true,
               .hexes_a_quad = 139},
     .fill = mesh_topological},
};

enum { ROWS = sizeof rows / sizeof *rows };

_Static_assert((int)ROWS == (int)HEXCON_METHOD_COUNT, "each method has one row");

const method_row *method_find(hexcon_method method) {
  for (size_t i = 0; i < ROWS; i++)
    if (rows[i].facts.method == method)
      return &rows[i];
  return NULL;
}

const hexcon_method_try *method_try_of_turn(int turn, const method_row **row) {
  for (size_t i = 0; i < ROWS; i++)
    for (size_t k = 0; k < HEXCON_METHOD_TRIES; k++)
      if (rows[i].facts.tries[k].turn == turn) {
        *row = &rows[i];
        return &rows[i].facts.tries[k];
      }
  return NULL;
}

void method_list(method_predicate is_so, char *text) {
  size_t length = 0;
  text[0] = '\0';
  for (size_t i = 0; i < ROWS; i++) {
    if (!is_so(&rows[i].facts))
      continue;
    int written = snprintf(text + length, METHOD_LIST - length, "%s%s", length > 0 ? ", " : "",
                           rows[i].facts.name);
    if (written < 0 || (size_t)written >= METHOD_LIST - length)
      return;
    length += (size_t)written;
  }
}

const hexcon_method_facts *hexcon_method_info(size_t row) {
  return row < ROWS ? &rows[row].facts : NULL;
}

const char *hexcon_pairing_name(int pairing) {
  static const char *const names[HEXCON_PAIRING_COUNT] = {[HEXCON_PAIRING_ALL] = "all",
                                                          [HEXCON_PAIRING_FEWEST] = "fewest",
                                                          [HEXCON_PAIRING_NONE] = "none",
                                                          [HEXCON_PAIRING_GIVEN] = "given"};
  return pairing >= 0 && pairing < HEXCON_PAIRING_COUNT ? names[pairing] : NULL;
}
