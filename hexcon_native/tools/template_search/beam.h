/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * Fillings of a target: a beam goes inward from its boundary, one hex at a time, and keeps the
 * cavities that promise the fewest hexes; those that are in the table are filled from it.
 */
#ifndef TEMPLATE_SEARCH_BEAM_H
#define TEMPLATE_SEARCH_BEAM_H

#include "table.h"
#include "target.h"

typedef struct filling {
  int hex_count;
  uint8_t hexes[MOST_HEXES][8];
} filling;

/** Name of a filling up to renumbering its inner points; never 0. */
uint64_t filling_name(const target *goal, const filling *f);

typedef struct beam_options {
  int width;         /**< cavities kept at each step */
  int most_quads;    /**< of a cavity, or as many as the target has */
  int most_hexes;    /**< in a filling */
  int most_fillings; /**< then stop */
  double noise;      /**< added to the promised hexes, to search elsewhere with another seed */
  double seconds;
  uint64_t seed;
} beam_options;

typedef void (*filling_visitor)(void *user, const filling *f);
/** @return the number of different proper fillings visited */
int beam_search(const table *inner, const target *t, const beam_options *options,
                filling_visitor visit, void *user);

#endif
