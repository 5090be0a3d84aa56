/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "filled_mesh.h"

#include <math.h>
#include <string.h>

#include "hexmesh/scaled_jacobian.h"
#include "shape/improve/improve.h"
#include "verify/jacobian_sign.h"

hexcon_status filled_mesh_new(hexcon_context *context, size_t point_count, size_t hex_count,
                              filled_mesh *out) {
  *out = (filled_mesh){.point_count = point_count, .hex_count = hex_count};
  out->points = context_allocate(context, point_count, 3 * sizeof *out->points);
  out->hexes = context_allocate(context, hex_count, 8 * sizeof *out->hexes);
  out->quality = context_allocate(context, hex_count, sizeof *out->quality);
  return out->points && out->hexes && out->quality ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

void filled_mesh_free(hexcon_context *context, filled_mesh *mesh) {
  context_free(context, mesh->points);
  context_free(context, mesh->hexes);
  context_free(context, mesh->quality);
  memset(mesh, 0, sizeof *mesh);
}

hexcon_status filled_mesh_measure(hexcon_context *context, filled_mesh *mesh) {
  hexcon_status status = HEXCON_OK;
  mesh->inverted = 0;
  mesh->worst = 1;
  mesh->mean = 0;
  for (size_t h = 0; !status && h < mesh->hex_count; h++) {
    const int32_t *hex = mesh->hexes + 8 * h;
    mesh->quality[h] = scaled_jacobian(mesh->points, hex);
    mesh->inverted += prove_jacobian_sign(mesh->points, hex) != JACOBIAN_POSITIVE;
    mesh->worst = fmin(mesh->worst, mesh->quality[h]);
    mesh->mean += mesh->quality[h] / (double)mesh->hex_count;
    status = context_pass(context, h);
  }
  return status;
}

bool mesh_worth_exceeds(const mesh_worth *a, const mesh_worth *b, const mesh_taste *taste) {
  if (a->inverted != b->inverted)
    return a->inverted < b->inverted;
  double worst = fmin(a->worst, taste->enough) - fmin(b->worst, taste->enough);
  if (fabs(worst) > taste->clearly)
    return worst > 0;
  if (fabs(a->mean - b->mean) > taste->clear_mean)
    return a->mean > b->mean;
  return taste->fewer && a->hex_count < b->hex_count;
}

static mesh_worth worth_of(const filled_mesh *mesh) {
  return (mesh_worth){mesh->inverted, mesh->hex_count, mesh->worst, mesh->mean};
}

bool filled_mesh_is_better(const filled_mesh *a, const filled_mesh *b, const mesh_taste *taste) {
  mesh_worth one = worth_of(a), other = worth_of(b);
  return !b->points || mesh_worth_exceeds(&one, &other, taste);
}

void filled_mesh_hand_over(filled_mesh *from, double bound, size_t quad_count, hexcon_mesh *mesh) {
  mesh->points = from->points;
  mesh->hexes = from->hexes;
  mesh->quality = from->quality;
  mesh->point_count = from->point_count;
  mesh->hex_count = from->hex_count;
  mesh->order = 1;
  mesh->bound = bound;
  mesh_note(mesh, "hexes per quad", (double)from->hex_count / (double)quad_count);
  mesh_note(mesh, "optimisation rounds", (double)from->rounds);
  mesh_note(mesh, "surface bound", bound);
  memset(from, 0, sizeof *from);
}

hexcon_status filled_mesh_improve_free(hexcon_context *context, const uint8_t *fixed,
                                       const hexcon_optimize_options *options, filled_mesh *mesh) {
  size_t rounds = 0;
  hexcon_status status = improve_mesh(context, mesh->points, mesh->point_count, mesh->hexes,
                                      mesh->hex_count, fixed, options, &rounds);
  mesh->rounds += rounds;
  hexcon_status measured =
      mesh_stop(context, status) ? filled_mesh_measure(context, mesh) : HEXCON_OK;
  return measured ? measured : status;
}

hexcon_status filled_mesh_improve(hexcon_context *context, size_t fixed_count,
                                  const hexcon_optimize_options *options, filled_mesh *mesh) {
  uint8_t *fixed = context_allocate_zeroed(context, mesh->point_count, sizeof *fixed);
  if (!fixed)
    return HEXCON_OUT_OF_MEMORY;
  memset(fixed, 1, fixed_count);
  hexcon_status status = filled_mesh_improve_free(context, fixed, options, mesh);
  context_free(context, fixed);
  return status;
}
