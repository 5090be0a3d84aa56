/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The certificate of a hex mesh, for callers that already hold checked arrays. */
#ifndef HEXCON_VERIFY_CERTIFICATE_H
#define HEXCON_VERIFY_CERTIFICATE_H

#include "base/context.h"

/** As hexcon_certify, without its check of the arrays and without forgetting the last error. */
hexcon_status certificate_make(hexcon_context *context, const double *points, size_t point_count,
                               const int32_t *hexes, size_t hex_count, const int32_t *quads,
                               size_t quad_count, hexcon_certificate *certificate);

/** As hexcon_certify_second_order, without its checks but that of corners, and without forgetting
 * the last error. */
hexcon_status certificate_make_second_order(hexcon_context *context, const double *points,
                                            size_t point_count, const int32_t *hexes,
                                            size_t hex_count, const int32_t *quads,
                                            size_t quad_count, hexcon_certificate *certificate);

#endif
