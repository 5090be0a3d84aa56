/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "certificate.h"

#include <stdio.h>
#include <string.h>

#include "bodies.h"
#include "embedding/embedding.h"
#include "hexmesh/hex_arrays.h"
#include "jacobian_sign.h"
#include "proper.h"
#include "surface/checks.h"
#include "topology.h"

/** Hexes proved between two questions whether to go on: exact arithmetic takes tens of microseconds
 * for each. */
enum { PROOFS = 1 << 9 };

/** Hexes not proved positive, and for each of them three coordinates. */
typedef struct suspects {
  id_list hexes;
  double *witnesses;
} suspects;

static hexcon_status add_suspect(hexcon_context *context, suspects *list, int32_t hex,
                                 const double witness[3]) {
  size_t capacity = list->hexes.capacity;
  hexcon_status status = id_list_append(context, &list->hexes, hex);
  if (!status && list->hexes.capacity > capacity) {
    size_t size = 3 * sizeof *list->witnesses;
    double *grown = context_grow(context, list->witnesses, list->hexes.capacity, size);
    if (!grown)
      return HEXCON_OUT_OF_MEMORY;
    list->witnesses = grown;
  }
  if (!status)
    memcpy(list->witnesses + 3 * (list->hexes.count - 1), witness, 3 * sizeof *witness);
  return status;
}

static hexcon_status check_jacobians(hexcon_context *context, const double *points,
                                     const int32_t *hexes, size_t hex_count,
                                     hexcon_certificate *certificate) {
  suspects list = {0};
  hexcon_status status = HEXCON_OK;
  for (size_t h = 0; !status && h < hex_count; h++) {
    double witness[3];
    jacobian_sign sign = prove_jacobian_sign_at(points, hexes + 8 * h, witness);
    if (sign != JACOBIAN_POSITIVE)
      status = add_suspect(context, &list, (int32_t)h, witness);
    certificate->undecided_count += sign == JACOBIAN_UNDECIDED;
    if (!status && h % PROOFS == 0)
      status = context_progress(context, STAGE_JACOBIANS, (double)h / (double)hex_count);
  }
  certificate->nonpositive = list.hexes.ids;
  certificate->nonpositive_count = list.hexes.count;
  certificate->witnesses = list.witnesses;
  return status;
}

/** Of a boundary that is not exact nothing is said: its quads may be no surface at all. */
static hexcon_status check_embedding(hexcon_context *context, const double *points,
                                     size_t point_count, const int32_t *quads, size_t quad_count,
                                     hexcon_certificate *certificate) {
  hexcon_embedding *embedding = &certificate->embedding;
  if (!certificate->conforming || !certificate->boundary_exact) {
    (void)snprintf(embedding->reason, sizeof embedding->reason,
                   "the quads are not the boundary of a conforming mesh");
    return HEXCON_OK;
  }
  hexcon_status status =
      embedding_prove(context, points, point_count, quads, quad_count, embedding);
  if (!status && embedding->embedded == HEXCON_EMBEDDED_YES)
    status = bodies_check(context, points, point_count, quads, quad_count, embedding);
  return status;
}

hexcon_status certificate_make(hexcon_context *context, const double *points, size_t point_count,
                               const int32_t *hexes, size_t hex_count, const int32_t *quads,
                               size_t quad_count, hexcon_certificate *certificate) {
  memset(certificate, 0, sizeof *certificate);
  hexcon_status status =
      topology_check(context, hexes, hex_count, point_count, quads, quad_count, certificate);
  if (!status)
    status = check_jacobians(context, points, hexes, hex_count, certificate);
  if (!status)
    status = check_embedding(context, points, point_count, quads, quad_count, certificate);
  certificate->certified = certificate->conforming && certificate->proper &&
                           certificate->boundary_exact && certificate->nonpositive_count == 0 &&
                           certificate->embedding.embedded == HEXCON_EMBEDDED_YES;
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
  context_free(context, certificate->witnesses);
  context_free(context, certificate->doublets);
  context_free(context, certificate->improper);
  hexcon_embedding_free(context, &certificate->embedding);
  memset(certificate, 0, sizeof *certificate);
}
