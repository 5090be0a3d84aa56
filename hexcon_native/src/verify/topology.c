/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "topology.h"

#include "boundary.h"
#include "manifold.h"
#include "proper.h"

typedef struct topology {
  corner_table corners;
  point_star star;
  face_table faces;
  manifold links;
  id_list improper, doublets;
} topology;

static hexcon_status make_room(hexcon_context *context, const int32_t *hexes, size_t hex_count,
                               size_t point_count, topology *t) {
  hexcon_status status = corner_table_build(context, hexes, hex_count, point_count, &t->corners);
  if (!status)
    status = point_star_new(context, &t->corners, point_count, &t->star);
  if (!status)
    status = face_table_new(context, hex_count, &t->faces);
  if (!status)
    status = manifold_new(context, &t->star, &t->links);
  return status;
}

static hexcon_status visit_points(hexcon_context *context, const int32_t *hexes, size_t point_count,
                                  topology *t) {
  hexcon_status status = HEXCON_OK;
  for (size_t v = 0; !status && v < point_count; v++) {
    point_star_gather(&t->star, hexes, &t->corners, (int32_t)v);
    face_table_enter(&t->faces, &t->star);
    manifold_enter(&t->links, &t->star);
    status = proper_check(context, &t->star, &t->improper);
    if (!status && v % CONTEXT_PATIENCE == 0)
      status = context_progress(context, STAGE_LINKS, (double)v / (double)point_count);
  }
  return status;
}

/** Lists that are handed over, also after an error. */
static void report(const topology *t, size_t hex_count, hexcon_certificate *certificate) {
  certificate->improper = t->improper.ids;
  certificate->improper_count = t->improper.count;
  certificate->doublets = t->doublets.ids;
  certificate->doublet_count = t->doublets.count / 2;
  certificate->conforming = t->faces.crowded_count == 0 && t->links.links_are_discs;
  certificate->proper = t->improper.count == 0;
  certificate->euler = (int64_t)t->links.used_point_count - (int64_t)t->links.edge_count +
                       (int64_t)t->faces.face_count - (int64_t)hex_count;
}

hexcon_status topology_check(hexcon_context *context, const int32_t *hexes, size_t hex_count,
                             size_t point_count, const int32_t *quads, size_t quad_count,
                             hexcon_certificate *certificate) {
  topology t = {0};
  hexcon_status status = make_room(context, hexes, hex_count, point_count, &t);
  if (!status)
    status = visit_points(context, hexes, point_count, &t);
  if (!status)
    status = context_progress(context, STAGE_PAIRS, 0);
  if (!status)
    status = proper_find_doublets(context, hex_count, &t.faces, &t.doublets);
  if (!status)
    status = boundary_check(context, hexes, hex_count, &t.faces, quads, quad_count,
                            &certificate->boundary_exact);
  report(&t, hex_count, certificate);
  corner_table_free(context, &t.corners);
  point_star_free(context, &t.star);
  face_table_free(context, &t.faces);
  manifold_free(context, &t.links);
  return status;
}
