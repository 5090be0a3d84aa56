/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The public call that repairs hex meshes of any origin, by a pillow where moving points fails. */
#include <string.h>

#include "hexmesh/hex_arrays.h"
#include "solve/common/pillow_worth.h"
#include "solve/common/pillowed_mesh.h"

static hexcon_status check_options(hexcon_context *context, const hexcon_repair_options *options) {
  if (options->pillow >= HEXCON_PILLOW_NEVER && options->pillow <= HEXCON_PILLOW_MOST &&
      options->threads >= 0)
    return HEXCON_OK;
  return context_fail(context, HEXCON_BAD_ARGUMENT,
                      "repair: pillow %d must be a number of sheets up to %d, or automatic, or "
                      "never; threads %d must not be negative",
                      options->pillow, HEXCON_PILLOW_MOST, options->threads);
}

static hexcon_status copy_given(hexcon_context *context, const double *points, size_t point_count,
                                const int32_t *hexes, size_t hex_count, filled_mesh *out) {
  hexcon_status status = filled_mesh_new(context, point_count, hex_count, out);
  if (status)
    return status;
  memcpy(out->points, points, 3 * point_count * sizeof *out->points);
  memcpy(out->hexes, hexes, 8 * hex_count * sizeof *out->hexes);
  return HEXCON_OK;
}

static bool is_good(const filled_mesh *mesh) {
  return mesh->inverted == 0 && mesh->worst >= PILLOW_POOR_WORST;
}

/** Replace the mesh by one with a pillow, if that is wanted or better. */
static hexcon_status lay(hexcon_context *context, const uint8_t *fixed,
                         const hexcon_repair_options *options, filled_mesh *mesh, size_t *laid) {
  const bool wanted = options->pillow > 0;
  if (options->pillow == HEXCON_PILLOW_NEVER || (!wanted && is_good(mesh)))
    return HEXCON_OK;
  const size_t sheets = wanted ? (size_t)options->pillow : 1;
  filled_mesh made;
  hexcon_status status = pillowed_mesh_make(context, mesh, fixed, sheets, options->threads, &made);
  if (!status && (wanted || pillow_is_worth(&made, mesh))) {
    filled_mesh plain = *mesh;
    *mesh = made;
    made = plain;
    *laid = sheets;
  }
  filled_mesh_free(context, &made);
  return status;
}

static void hand_over(filled_mesh *from, size_t pillows, hexcon_repaired *out) {
  *out = (hexcon_repaired){.point_count = from->point_count,
                           .hex_count = from->hex_count,
                           .points = from->points,
                           .hexes = from->hexes,
                           .pillows = pillows};
  from->points = NULL;
  from->hexes = NULL;
}

static hexcon_status check(hexcon_context *context, const double *points, size_t point_count,
                           const int32_t *hexes, size_t hex_count,
                           const hexcon_repair_options *options) {
  hexcon_status status = check_options(context, options);
  if (!status)
    status = check_hex_arrays(context, points, point_count, hexes, hex_count);
  return status ? status : check_hex_corners(context, hexes, hex_count);
}

hexcon_status hexcon_repair(hexcon_context *context, const double *points, size_t point_count,
                            const int32_t *hexes, size_t hex_count, const uint8_t *fixed,
                            const hexcon_repair_options *options, hexcon_repaired *out) {
  const hexcon_repair_options chosen = options ? *options : (hexcon_repair_options){0};
  const hexcon_optimize_options moving = {.threads = chosen.threads, .mean_passes = 2};
  filled_mesh mesh = {0};
  size_t pillows = 0;
  context_clear(context);
  *out = (hexcon_repaired){0};
  hexcon_status status = check(context, points, point_count, hexes, hex_count, &chosen);
  if (!status)
    status = copy_given(context, points, point_count, hexes, hex_count, &mesh);
  if (!status)
    status = filled_mesh_improve_free(context, fixed, &moving, &mesh);
  if (!status)
    status = lay(context, fixed, &chosen, &mesh, &pillows);
  if (!status)
    hand_over(&mesh, pillows, out);
  filled_mesh_free(context, &mesh);
  return status;
}

void hexcon_repaired_free(hexcon_context *context, hexcon_repaired *repaired) {
  context_free(context, repaired->points);
  context_free(context, repaired->hexes);
  memset(repaired, 0, sizeof *repaired);
}
