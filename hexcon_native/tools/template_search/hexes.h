/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** How hexes meet, and hex meshes up to renumbering. Points are bytes, hexes in VTK order. */
#ifndef TEMPLATE_SEARCH_HEXES_H
#define TEMPLATE_SEARCH_HEXES_H

#include <stdbool.h>
#include <stdint.h>

/** The common points are none, one, an edge of both, or a face of both. */
bool hexes_meet_properly(const uint8_t a[8], const uint8_t b[8]);

/** The same hex seen in a mirror. */
void hex_mirror(uint8_t hex[8]);

/** Thorough mixing of 64 bits. */
uint64_t mixed(uint64_t x);

/**
 * A number that depends on the mesh and the colours of its points, not on the numbering: equal
 * meshes have equal numbers, different ones hardly ever.
 * @param colours  [256], overwritten: points that need to be told apart at the start have
 *                 different colours
 * @param rounds   how often colours spread to neighbours: more tell more meshes apart
 */
uint64_t hexes_fingerprint(const uint8_t (*hexes)[8], int count, uint64_t colours[256], int rounds);

#endif
