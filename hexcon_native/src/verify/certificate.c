/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "certificate.h"

#include <string.h>

#include "boundary.h"
#include "corner_table.h"
#include "face_table.h"
#include "hex_arrays.h"
#include "jacobian_sign.h"
#include "manifold.h"
#include "proper.h"
#include "surface/checks.h"

static hexcon_status check_topology(hexcon_context *context, const int32_t *hexes, size_t hex_count,
                                    size_t point_count, const face_table *faces,
                                    hexcon_certificate *certificate) {
  corner_table corners = {0};
  manifold_facts facts = {0};
  id_list improper = {0}, doublets = {0};
  hexcon_status status = corner_table_build(context, hexes, hex_count, point_count, &corners);
  if (!status)
    status = context_progress(context, "certificate: links", 0.3);
  if (!status)
    status = manifold_check(context, hexes, hex_count, point_count, faces, &corners, &facts);
  if (!status)
    status = context_progress(context, "certificate: pairs", 0.5);
  if (!status)
    status = proper_check(context, hexes, point_count, faces, &corners, &improper);
  if (!status)
    status = proper_find_doublets(context, hex_count, faces, &doublets);
  corner_table_free(context, &corners);
  certificate->improper = improper.ids;
  certificate->improper_count = improper.count;
  certificate->doublets = doublets.ids;
  certificate->doublet_count = doublets.count / 2;
  certificate->conforming = faces->crowded_count == 0 && facts.links_are_discs;
  certificate->proper = improper.count == 0;
  certificate->euler = (int64_t)facts.used_point_count - (int64_t)facts.edge_count +
                       (int64_t)faces->face_count - (int64_t)hex_count;
  return status;
}

static hexcon_status check_jacobians(hexcon_context *context, const double *points,
                                     const int32_t *hexes, size_t hex_count,
                                     hexcon_certificate *certificate) {
  id_list nonpositive = {0};
  hexcon_status status = HEXCON_OK;
  for (size_t h = 0; !status && h < hex_count; h++) {
    jacobian_sign sign = prove_jacobian_sign(points, hexes + 8 * h);
    if (sign != JACOBIAN_POSITIVE)
      status = id_list_append(context, &nonpositive, (int32_t)h);
    certificate->undecided_count += sign == JACOBIAN_UNDECIDED;
    if (!status && h % 65536 == 0)
      status = context_progress(context, "certificate: Jacobians", (double)h / (double)hex_count);
  }
  certificate->nonpositive = nonpositive.ids;
  certificate->nonpositive_count = nonpositive.count;
  return status;
}

hexcon_status certificate_make(hexcon_context *context, const double *points, size_t point_count,
                               const int32_t *hexes, size_t hex_count, const int32_t *quads,
                               size_t quad_count, hexcon_certificate *certificate) {
  memset(certificate, 0, sizeof *certificate);
  face_table faces;
  hexcon_status status = face_table_build(context, hexes, hex_count, &faces);
  if (!status)
    status = boundary_check(context, hexes, hex_count, &faces, quads, quad_count,
                            &certificate->boundary_exact);
  if (!status)
    status = check_topology(context, hexes, hex_count, point_count, &faces, certificate);
  face_table_free(context, &faces);
  if (!status)
    status = check_jacobians(context, points, hexes, hex_count, certificate);
  certificate->certified = certificate->conforming && certificate->proper &&
                           certificate->boundary_exact && certificate->nonpositive_count == 0;
  if (status)
    hexcon_certificate_free(context, certificate);
  return status;
}

/** The quads only need valid ids: what else is wrong with them, the comparison shows. */
static hexcon_status check_quad_ids(hexcon_context *context, size_t point_count,
                                    const int32_t *quads, size_t quad_count) {
  if (quad_count > CONTEXT_MAX_COUNT / 4)
    return context_fail(context, HEXCON_TOO_LARGE, "%zu quads are more than 32-bit ids hold",
                        quad_count);
  return check_ids(context, point_count, quads, quad_count, 4, "quads");
}

hexcon_status hexcon_certify(hexcon_context *context, const double *points, size_t point_count,
                             const int32_t *hexes, size_t hex_count, const int32_t *quads,
                             size_t quad_count, hexcon_certificate *certificate) {
  context_clear(context);
  memset(certificate, 0, sizeof *certificate);
  hexcon_status status = check_hex_arrays(context, points, point_count, hexes, hex_count);
  if (!status)
    status = check_hex_corners(context, hexes, hex_count);
  if (!status)
    status = check_quad_ids(context, point_count, quads, quad_count);
  if (!status)
    status = certificate_make(context, points, point_count, hexes, hex_count, quads, quad_count,
                              certificate);
  return status;
}

void hexcon_certificate_free(hexcon_context *context, hexcon_certificate *certificate) {
  context_free(context, certificate->nonpositive);
  context_free(context, certificate->doublets);
  context_free(context, certificate->improper);
  memset(certificate, 0, sizeof *certificate);
}
