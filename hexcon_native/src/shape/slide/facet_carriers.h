/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Carriers of several surfaces, or of none in closed form, whose facets tell where each counts. */
#ifndef HEXCON_SHAPE_SLIDE_FACET_CARRIERS_H
#define HEXCON_SHAPE_SLIDE_FACET_CARRIERS_H

#include "facet_tree.h"

/** The facets of a hexcon_sliding, which stay the caller's, sorted by carrier. */
typedef struct facet_carriers {
  const hexcon_sliding *given; /**< NULL: there are no facets */
  facet_tree *trees;           /**< [carrier_count]; count 0: a carrier without facets */
  double *reach; /**< [pieces] how far a closed form may be from its facets and still be meant */
} facet_carriers;

/** INDEX_OUT_OF_RANGE (facets, listed), BAD_ARGUMENT (carriers, listed), TOO_LARGE, OUT_OF_MEMORY,
 * CANCELLED, OUT_OF_TIME. O(n log n) of n facets.
 * @param pieces  normalised
 * @param out     free it also after an error */
hexcon_status facet_carriers_new(hexcon_context *context, const hexcon_sliding *given,
                                 const hexcon_carrier *pieces, facet_carriers *out);
void facet_carriers_free(hexcon_context *context, facet_carriers *facets);

/** Whether a carrier has facets. */
bool facet_carriers_know(const facet_carriers *facets, int32_t carrier);

/**
 * Put a point on a carrier that has facets: the nearest facet's piece counts. Where its closed form
 * is nearest too far from there, as beyond a border or on another sheet, the facet's own place is
 * put on it. A piece without closed form is the facets, curved by their normals: Vlachos, Peters,
 * Boyd and Mitchell, Curved PN triangles (2001).
 */
void facet_carriers_project(const facet_carriers *facets, const hexcon_carrier *pieces,
                            int32_t carrier, const double point[3], double nearest[3],
                            double direction[3]);

#endif
