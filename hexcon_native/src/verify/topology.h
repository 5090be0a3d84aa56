/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** What a certificate says of ids alone. */
#ifndef HEXCON_VERIFY_TOPOLOGY_H
#define HEXCON_VERIFY_TOPOLOGY_H

#include "base/context.h"

/**
 * Fill the facts of a certificate that need no coordinates. Point by point, each from the hexes
 * around it. Expected linear, whatever the numbering.
 * @param certificate  zeroed before; free its lists also after an error
 */
hexcon_status topology_check(hexcon_context *context, const int32_t *hexes, size_t hex_count,
                             size_t point_count, const int32_t *quads, size_t quad_count,
                             hexcon_certificate *certificate);

#endif
