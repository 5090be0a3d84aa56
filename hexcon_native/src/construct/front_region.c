/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Regions of a front: the rings about them, their quads, and whether a layer can lie on them. */
#include <string.h>

#include "sheet_front.h"
#include "strips.h"

hexcon_status front_region_new(hexcon_context *context, const sheet_front *front,
                               front_region *out) {
  size_t slots = front->s.quad_count;
  memset(out, 0, sizeof *out);
  out->rungs = context_allocate(context, slots, sizeof *out->rungs);
  out->quads = context_allocate(context, slots, sizeof *out->quads);
  out->marks = context_allocate_zeroed(context, slots, sizeof *out->marks);
  return out->rungs && out->quads && out->marks ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

void front_region_free(hexcon_context *context, front_region *region) {
  context_free(context, region->rungs);
  context_free(context, region->quads);
  context_free(context, region->marks);
  memset(region, 0, sizeof *region);
}

void front_region_begin(const sheet_front *front, int32_t entry, front_region *region) {
  region->rung_count = region->quad_count = 0;
  region->mark += 2;
  if (region->mark < 2) { /* all marks are used up: begin again */
    memset(region->marks, 0, front->s.quad_count * sizeof *region->marks);
    region->mark = 2;
  }
  (void)front_region_add_ring(front, entry, region);
}

bool front_region_add_ring(const sheet_front *front, int32_t entry, front_region *region) {
  int32_t start = entry;
  do {
    if (region->marks[half_edge_quad(entry)] == region->mark)
      return false;
    region->rungs[region->rung_count++] = entry;
    region->marks[half_edge_quad(entry)] = region->mark;
    entry = ring_next(&front->s, entry);
  } while (entry != start);
  return true;
}

static int32_t quad_inside(const sheet_front *front, int32_t rung) {
  return half_edge_quad(front->s.twins[half_edge_turn(rung, -1)]);
}

static void reach(int32_t quad, front_region *region) {
  if (region->marks[quad] >= region->mark)
    return;
  region->marks[quad] = region->mark + 1;
  region->quads[region->quad_count++] = quad;
}

bool front_region_fill(const sheet_front *front, size_t limit, front_region *region) {
  reach(quad_inside(front, region->rungs[0]), region);
  for (size_t i = 0; i < region->quad_count && region->quad_count <= limit; i++)
    for (int side = 0; side < 4; side++)
      reach(half_edge_quad(front->s.twins[4 * region->quads[i] + side]), region);
  bool whole = region->quad_count <= limit;
  for (size_t i = 0; whole && i < region->rung_count; i++)
    whole = region->marks[quad_inside(front, region->rungs[i])] == region->mark + 1;
  return whole;
}

/* -------------------------------------------------------------------------------------- checks */

static uint32_t next_mark(sheet_front *front) {
  if (++front->mark == 0) {
    memset(front->marks, 0, front->point_room * sizeof *front->marks);
    front->mark = 1;
  }
  return front->mark;
}

/** Mark a point. @return false: it has been met before */
static bool meet(sheet_front *front, int32_t point) {
  bool first = front->marks[point] != front->mark;
  front->marks[point] = front->mark;
  return first;
}

/** As the new front will have it. */
static int32_t moved(const sheet_front *front, int32_t point) {
  int32_t image = front->image[point];
  return image < 0 ? point : image;
}

/** No rim passes a point twice. */
static bool rims_are_simple(sheet_front *front, const front_region *region) {
  (void)next_mark(front);
  for (size_t i = 0; i < region->rung_count; i++)
    if (!meet(front, half_edge_start(&front->s, region->rungs[i])) ||
        !meet(front, half_edge_end(&front->s, region->rungs[i])))
      return false;
  return true;
}

/**
 * The ring about the point where a rung's ends come together: the quads outside, then those of the
 * region, each with the point across it and one neighbour.
 */
static bool seam_point_is_proper(sheet_front *front, int32_t rung) {
  const surface *s = &front->s;
  int32_t before = s->twins[rung]; /* leaves the ring's quad before, by the rung */
  int32_t stop_outside = half_edge_turn(before, -1), stop_inside = half_edge_turn(before, 1);
  size_t degree = 0;
  (void)next_mark(front);
  bool proper = meet(front, half_edge_end(s, rung));
  for (int32_t h = s->twins[half_edge_turn(rung, 1)]; proper && h != stop_outside; degree++) {
    proper = meet(front, half_edge_start(s, h)) &&
             meet(front, half_edge_start(s, half_edge_turn(h, -1)));
    h = s->twins[half_edge_turn(h, 1)];
  }
  for (int32_t h = s->twins[half_edge_turn(rung, -1)]; proper && h != stop_inside; degree++) {
    proper = meet(front, moved(front, half_edge_start(s, half_edge_turn(h, 2)))) &&
             meet(front, moved(front, half_edge_start(s, half_edge_turn(h, -1))));
    h = s->twins[half_edge_turn(h, -1)];
  }
  return proper && degree >= 3;
}

bool front_can_lay(sheet_front *front, const front_region *region) {
  if (!rims_are_simple(front, region))
    return false;
  for (size_t i = 0; i < region->rung_count; i++)
    front->image[half_edge_start(&front->s, region->rungs[i])] =
        half_edge_end(&front->s, region->rungs[i]);
  bool proper = true;
  for (size_t i = 0; proper && i < region->rung_count; i++)
    proper = seam_point_is_proper(front, region->rungs[i]);
  for (size_t i = 0; i < region->rung_count; i++)
    front->image[half_edge_start(&front->s, region->rungs[i])] = -1;
  return proper;
}
