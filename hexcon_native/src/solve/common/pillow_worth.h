/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** When the hexes of a pillow are not in vain. */
#ifndef HEXCON_SOLVE_COMMON_PILLOW_WORTH_H
#define HEXCON_SOLVE_COMMON_PILLOW_WORTH_H

#include "filled_mesh.h"

/** A worst scaled Jacobian from here on is good enough without a pillow. */
#define PILLOW_POOR_WORST 0.4

/** What the worst scaled Jacobian must come to, from what it is. */
double pillow_least_worth(double worst);

/** Whether the mesh with a pillow is to be taken: fewer hexes are not positive, or the worst is
 * clearly better, or no worse and the mean is clearly better. */
bool pillow_is_worth(const filled_mesh *pillowed, const filled_mesh *plain);

#endif
