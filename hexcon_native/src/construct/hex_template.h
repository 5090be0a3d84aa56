/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Templates: fixed hex tables with named boundary points; resources/templates tells of each. */
#ifndef HEXCON_CONSTRUCT_HEX_TEMPLATE_H
#define HEXCON_CONSTRUCT_HEX_TEMPLATE_H

#include "base/context.h"

typedef struct template_point {
  double place[3];
  const char *label; /**< "int" inside */
} template_point;

typedef struct hex_template {
  const char *name;
  size_t point_count, hex_count, quad_count;
  const template_point *points;
  const int32_t (*hexes)[8]; /**< VTK order, positive */
  const int32_t (*quads)[4]; /**< the boundary, outward */
} hex_template;

/** Made from resources/templates by the build. */
extern const hex_template template_domino_62, template_geode_26, template_pyramid_16,
    template_rotation_38, template_schneiders_pyramid_36;

/**
 * Check a template's table: ids in range, every face in two hexes or one of the outward quads.
 * @return BAD_ARGUMENT with the template's name and the fault, OUT_OF_MEMORY. Linear.
 */
hexcon_status template_check(hexcon_context *context, const hex_template *t);

/** Row of the point with this label; -1 if there is none. */
int template_row(const hex_template *t, const char *label);

#endif
