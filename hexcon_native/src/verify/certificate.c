/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "certificate.h"

#include <stdio.h>
#include <string.h>

#include "bodies.h"
#include "curved_boundary.h"
#include "curved_jacobian.h"
#include "hexmesh/hex_arrays.h"
#include "jacobian_sign.h"
#include "middle_nodes.h"
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

/** What is judged: hexes of 8 nodes, or of 20, and then their corners besides. */
typedef struct judged {
  const double *points;
  size_t point_count, hex_count;
  const int32_t *corners; /* [hex_count][8] */
  const int32_t *nodes;   /* [hex_count][20]; NULL of hexes of 8 nodes */
} judged;

/** @param room  curved_jacobian_room() bytes, for hexes of 20 nodes */
static jacobian_sign prove_hex(const judged *mesh, size_t hex, void *room, double witness[3]) {
  if (!mesh->nodes)
    return prove_jacobian_sign_at(mesh->points, mesh->corners + 8 * hex, witness);
  double nodes[20][3];
  for (size_t n = 0; n < 20; n++)
    memcpy(nodes[n], mesh->points + 3 * (size_t)mesh->nodes[20 * hex + n], sizeof nodes[n]);
  return prove_curved_jacobian_sign(nodes, room, witness);
}

static hexcon_status check_jacobians(hexcon_context *context, const judged *mesh,
                                     hexcon_certificate *certificate) {
  suspects list = {0};
  void *room = context_allocate(context, mesh->nodes ? curved_jacobian_room() : 1, 1);
  hexcon_status status = room ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  for (size_t h = 0; !status && h < mesh->hex_count; h++) {
    double witness[3];
    jacobian_sign sign = prove_hex(mesh, h, room, witness);
    if (sign != JACOBIAN_POSITIVE)
      status = add_suspect(context, &list, (int32_t)h, witness);
    certificate->undecided_count += sign == JACOBIAN_UNDECIDED;
    if (!status && h % PROOFS == 0)
      status = context_progress(context, STAGE_JACOBIANS, (double)h / (double)mesh->hex_count);
  }
  context_free(context, room);
  certificate->nonpositive = list.hexes.ids;
  certificate->nonpositive_count = list.hexes.count;
  certificate->witnesses = list.witnesses;
  return status;
}

/** Of a boundary that is not exact nothing is said: its quads may be no surface at all. */
static hexcon_status check_embedding(hexcon_context *context, const judged *mesh,
                                     const int32_t *quads, size_t quad_count,
                                     hexcon_certificate *certificate) {
  hexcon_embedding *embedding = &certificate->embedding;
  if (!certificate->conforming || !certificate->boundary_exact ||
      (mesh->nodes && !certificate->proper)) {
    (void)snprintf(embedding->reason, sizeof embedding->reason,
                   "the quads are not the boundary of a conforming mesh");
    return HEXCON_OK;
  }
  if (mesh->nodes)
    return curved_boundary_check(context, mesh->points, mesh->point_count, mesh->nodes,
                                 mesh->hex_count, quads, quad_count, embedding);
  return bodies_prove(context, mesh->points, mesh->point_count, quads, quad_count, embedding);
}

/** Middle nodes after corners: hexes at fault join those that meet another improperly. */
static hexcon_status check_middle_nodes(hexcon_context *context, const judged *mesh,
                                        hexcon_certificate *certificate) {
  id_list list = {certificate->improper, certificate->improper_count, certificate->improper_count};
  hexcon_status status =
      middle_nodes_check(context, mesh->nodes, mesh->hex_count, mesh->point_count, &list);
  certificate->improper = list.ids;
  certificate->improper_count = list.count;
  certificate->proper = list.count == 0;
  return status;
}

static hexcon_status judge(hexcon_context *context, const judged *mesh, const int32_t *quads,
                           size_t quad_count, hexcon_certificate *certificate) {
  memset(certificate, 0, sizeof *certificate);
  hexcon_status status = topology_check(context, mesh->corners, mesh->hex_count, mesh->point_count,
                                        quads, quad_count, certificate);
  if (!status && mesh->nodes)
    status = check_middle_nodes(context, mesh, certificate);
  if (!status)
    status = check_jacobians(context, mesh, certificate);
  if (!status)
    status = check_embedding(context, mesh, quads, quad_count, certificate);
  certificate->certified = certificate->conforming && certificate->proper &&
                           certificate->boundary_exact && certificate->nonpositive_count == 0 &&
                           certificate->embedding.embedded == HEXCON_EMBEDDED_YES;
  if (status)
    hexcon_certificate_free(context, certificate);
  return status;
}

hexcon_status certificate_make(hexcon_context *context, const double *points, size_t point_count,
                               const int32_t *hexes, size_t hex_count, const int32_t *quads,
                               size_t quad_count, hexcon_certificate *certificate) {
  const judged mesh = {points, point_count, hex_count, hexes, NULL};
  return judge(context, &mesh, quads, quad_count, certificate);
}

hexcon_status certificate_make_second_order(hexcon_context *context, const double *points,
                                            size_t point_count, const int32_t *hexes,
                                            size_t hex_count, const int32_t *quads,
                                            size_t quad_count, hexcon_certificate *certificate) {
  memset(certificate, 0, sizeof *certificate);
  int32_t *corners = context_allocate(context, 8 * hex_count, sizeof *corners);
  if (!corners)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t h = 0; h < hex_count; h++)
    memcpy(corners + 8 * h, hexes + 20 * h, 8 * sizeof *corners);
  const judged mesh = {points, point_count, hex_count, corners, hexes};
  hexcon_status status = check_hex_corners(context, corners, hex_count);
  if (!status)
    status = judge(context, &mesh, quads, quad_count, certificate);
  context_free(context, corners);
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

hexcon_status hexcon_certify_second_order(hexcon_context *context, const double *points,
                                          size_t point_count, const int32_t *hexes,
                                          size_t hex_count, const int32_t *quads, size_t quad_count,
                                          hexcon_certificate *certificate) {
  context_clear(context);
  memset(certificate, 0, sizeof *certificate);
  hexcon_status status = check_second_order_arrays(context, points, point_count, hexes, hex_count);
  if (!status)
    status = check_quad_ids(context, point_count, quads, quad_count);
  if (!status)
    status = certificate_make_second_order(context, points, point_count, hexes, hex_count, quads,
                                           quad_count, certificate);
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
