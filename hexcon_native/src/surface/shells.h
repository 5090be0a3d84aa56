/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The shells of a surface: which bound bodies, which cavities, and which way they face. */
#ifndef HEXCON_SURFACE_SHELLS_H
#define HEXCON_SURFACE_SHELLS_H

#include "half_edges.h"

/**
 * Find the shells inside an even number of others, which bound bodies, and those inside an odd
 * number, which bound cavities; turn every shell whose quads do not face out of the solid.
 * @param s  connected, with points; receives is_cavity, cavity_count, turned
 * Cost: linear for one shell. Else the quads of shell A for each shell whose bounding box lies in
 * that of A; boxes are compared with those they overlap in x.
 * Shells that cross each other have no inside: they are placed by one point of each.
 * @return OUT_OF_MEMORY
 */
hexcon_status surface_orient_shells(hexcon_context *context, surface *s);

/** Outer shells: a solid in one part has one. Without points, all components count. */
static inline size_t surface_body_count(const surface *s) {
  return s->component_count - s->cavity_count;
}

#endif
