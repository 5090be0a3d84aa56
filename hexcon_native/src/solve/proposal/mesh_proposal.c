/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "mesh_proposal.h"

#include <math.h>
#include <string.h>

#include "hexmesh/hex_arrays.h"
#include "solve/common/filled_mesh.h"
#include "solve/common/quality_bound.h"
#include "surface/checks.h"
#include "verify/topology.h"

/** Improvement stops at this part of what the surface allows, and aims at this much where that is
 * next to nothing. */
static const double near_the_bound = 0.95, least_target = 1e-3;

/* ----------------------------------------------------------------------------------------- checks
 */

static hexcon_status check_use(hexcon_context *context, const hexcon_proposal *proposal,
                               size_t surface_point_count) {
  uint8_t *used = context_allocate_zeroed(context, proposal->point_count, sizeof *used);
  size_t unused = 0;
  if (!used)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t i = 0; i < 8 * proposal->hex_count; i++)
    if ((size_t)proposal->hexes[i] >= surface_point_count)
      used[(size_t)proposal->hexes[i] - surface_point_count] = 1;
  for (size_t v = 0; v < proposal->point_count; v++)
    if (!used[v]) {
      context_add_element(context, (int32_t)v);
      unused++;
    }
  context_free(context, used);
  if (unused > 0)
    return context_fail(
        context, HEXCON_BAD_PROPOSAL,
        "%zu inner points of the proposal (its rows listed) are in none of its hexes", unused);
  return HEXCON_OK;
}

hexcon_status proposal_check(hexcon_context *context, const hexcon_proposal *proposal,
                             size_t surface_point_count) {
  if (proposal->hex_count == 0)
    return context_fail(context, HEXCON_EMPTY, "the proposal has no hexes");
  if (!proposal->hexes)
    return context_fail(context, HEXCON_BAD_ARGUMENT, "the proposal's hexes are missing");
  if (proposal->hex_count > CONTEXT_MAX_COUNT / 20 ||
      proposal->point_count > CONTEXT_MAX_COUNT - surface_point_count)
    return context_fail(context, HEXCON_TOO_LARGE,
                        "a proposal of %zu hexes is more than 32-bit ids hold",
                        proposal->hex_count);
  hexcon_status status = check_ids(context, surface_point_count + proposal->point_count,
                                   proposal->hexes, proposal->hex_count, 8, "proposed hexes");
  if (!status)
    status = check_hex_corners(context, proposal->hexes, proposal->hex_count);
  if (!status && proposal->points)
    status = check_points(context, proposal->points, proposal->point_count, largest_coordinate);
  return status ? status : check_use(context, proposal, surface_point_count);
}

/** What no place of the inner points can mend. */
static hexcon_status check_topology(hexcon_context *context, const surface *s,
                                    const filled_mesh *m) {
  hexcon_certificate found = {0};
  hexcon_status status = topology_check(context, m->hexes, m->hex_count, m->point_count, s->quads,
                                        s->quad_count, &found);
  bool sound = found.conforming && found.boundary_exact;
  bool conforming = found.conforming;
  for (size_t i = 0; !status && i < found.improper_count; i++)
    context_add_element(context, found.improper[i]);
  hexcon_certificate_free(context, &found);
  if (status || sound)
    return status;
  return context_fail(context, HEXCON_BAD_PROPOSAL,
                      conforming ? "the boundary of the proposed hexes is not the surface's quads, "
                                   "facing outwards"
                                 : "the proposed hexes are no conforming mesh: hexes that meet "
                                   "improperly are listed");
}

/* ---------------------------------------------------------------------------------------- filling
 */

/** Points without a place start in the middle: improvement begins with a better map then. */
static void place(const surface *s, const hexcon_proposal *proposal, filled_mesh *m) {
  double *inner = m->points + 3 * s->point_count, middle[3] = {0, 0, 0};
  if (proposal->points) {
    memcpy(inner, proposal->points, 3 * proposal->point_count * sizeof *inner);
    return;
  }
  for (size_t i = 0; i < 3 * s->point_count; i++)
    middle[i % 3] += s->points[i] / (double)s->point_count;
  for (size_t i = 0; i < 3 * proposal->point_count; i++)
    inner[i] = middle[i % 3];
}

static hexcon_status take(hexcon_context *context, const surface *s,
                          const hexcon_proposal *proposal, filled_mesh *m) {
  hexcon_status status =
      filled_mesh_new(context, s->point_count + proposal->point_count, proposal->hex_count, m);
  if (status)
    return status;
  memcpy(m->points, s->points, 3 * s->point_count * sizeof *m->points);
  memcpy(m->hexes, proposal->hexes, 8 * proposal->hex_count * sizeof *m->hexes);
  place(s, proposal, m);
  context_reserve(context, proposal->hex_count, false);
  return check_topology(context, s, m);
}

/** Untangle, and raise the worst, the mean with it, where they fall short. */
static hexcon_status improve(hexcon_context *context, const surface *s, int threads, double bound,
                             filled_mesh *m) {
  const hexcon_optimize_options options = {
      .threads = threads, .target = fmax(near_the_bound * bound, least_target), .mean_passes = 2};
  if (m->inverted == 0 && m->worst >= options.target)
    return HEXCON_OK;
  return filled_mesh_improve(context, s->point_count, &options, m);
}

hexcon_status mesh_proposal(hexcon_context *context, const surface *s,
                            const hexcon_mesh_options *options, hexcon_mesh *mesh) {
  filled_mesh m = {0};
  double bound = 0, start = mesh_clock();
  hexcon_status status = take(context, s, options->proposal, &m);
  if (!status)
    status = quality_bound(context, s, m.points, m.hexes, m.hex_count, &bound);
  if (!status)
    status = filled_mesh_measure(context, &m);
  const size_t inverted = m.inverted;
  bool measured = !status;
  if (measured)
    status = improve(context, s, options->threads, bound, &m);
  status = mesh_settle(context, status, measured, mesh);
  if (!status) {
    mesh_note(mesh, "inverted as proposed", (double)inverted);
    filled_mesh_hand_over(&m, bound, s->quad_count, mesh);
  }
  filled_mesh_free(context, &m);
  mesh_note_seconds(mesh, "proposal", start);
  return status;
}
