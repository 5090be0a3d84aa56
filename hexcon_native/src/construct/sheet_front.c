/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "sheet_front.h"

#include <string.h>

static hexcon_status grow_points(hexcon_context *context, sheet_front *front, size_t count) {
  if (count <= front->point_room)
    return HEXCON_OK;
  size_t room = count + count / 2;
  int32_t *below = context_grow(context, front->below, room, sizeof *below);
  front->below = below ? below : front->below;
  int32_t *image = context_grow(context, front->image, room, sizeof *image);
  front->image = image ? image : front->image;
  uint32_t *marks = context_grow(context, front->marks, room, sizeof *marks);
  front->marks = marks ? marks : front->marks;
  if (!below || !image || !marks)
    return HEXCON_OUT_OF_MEMORY;
  memset(image + front->point_room, -1, (room - front->point_room) * sizeof *image);
  memset(marks + front->point_room, 0, (room - front->point_room) * sizeof *marks);
  front->point_room = room;
  return HEXCON_OK;
}

static hexcon_status copy_surface(hexcon_context *context, const surface *s, sheet_front *out) {
  size_t sides = 4 * s->quad_count;
  out->s = (surface){.point_count = s->point_count,
                     .quad_count = s->quad_count,
                     .component_count = s->component_count};
  out->s.quads = context_allocate(context, sides, sizeof *out->s.quads);
  out->s.twins = context_allocate(context, sides, sizeof *out->s.twins);
  if (!out->s.quads || !out->s.twins)
    return HEXCON_OUT_OF_MEMORY;
  memcpy(out->s.quads, s->quads, sides * sizeof *out->s.quads);
  memcpy(out->s.twins, s->twins, sides * sizeof *out->s.twins);
  return HEXCON_OK;
}

hexcon_status front_begin(hexcon_context *context, const surface *s, sheet_front *out) {
  memset(out, 0, sizeof *out);
  hexcon_status status = copy_surface(context, s, out);
  if (!status)
    status = surface_find_loops(context, s, &out->loops);
  if (!status)
    status = grow_points(context, out, s->point_count);
  if (status)
    return status;
  size_t loops = out->loops.count;
  out->alive_count = s->quad_count;
  out->mesh.point_count = s->point_count;
  out->alive = context_allocate(context, s->quad_count, sizeof *out->alive);
  out->loop_starts = context_allocate(context, loops, sizeof *out->loop_starts);
  out->gone = context_allocate_zeroed(context, loops, sizeof *out->gone);
  out->rungs = context_allocate(context, s->quad_count, sizeof *out->rungs);
  out->layers = context_allocate(context, loops, sizeof *out->layers);
  if (!out->alive || !out->loop_starts || !out->gone || !out->rungs || !out->layers)
    return HEXCON_OUT_OF_MEMORY;
  memset(out->alive, 1, s->quad_count);
  for (size_t i = 0; i < loops; i++)
    out->loop_starts[i] = out->loops.entries[out->loops.offsets[i]];
  return HEXCON_OK;
}

void front_free(hexcon_context *context, sheet_front *front) {
  context_free(context, front->s.quads);
  context_free(context, front->s.twins);
  surface_loops_free(context, &front->loops);
  context_free(context, front->alive);
  context_free(context, front->loop_starts);
  context_free(context, front->gone);
  context_free(context, front->mesh.hexes);
  context_free(context, front->quad_of_hex);
  context_free(context, front->below);
  context_free(context, front->image);
  context_free(context, front->marks);
  context_free(context, front->rungs);
  context_free(context, front->layers);
  memset(front, 0, sizeof *front);
}

int32_t front_loop_start(sheet_front *front, size_t loop) {
  /* A quad taken away still knows what came after it, and that is nearer to what is left. */
  int32_t entry = front->loop_starts[loop];
  while (!front->alive[half_edge_quad(entry)])
    entry = front->s.twins[half_edge_turn(entry, 2)];
  return front->loop_starts[loop] = entry;
}

/* ------------------------------------------------------------------------------------ the layer */

/** Points of the rims go to the other side of the rings. */
static void set_images(sheet_front *front, const int32_t *rungs, size_t count, bool set) {
  for (size_t i = 0; i < count; i++)
    front->image[half_edge_start(&front->s, rungs[i])] =
        set ? half_edge_end(&front->s, rungs[i]) : -1;
}

/** One hex on a quad; the quad moves to its other end. */
static void lay_hex(sheet_front *front, int32_t quad) {
  int32_t *ids = front->s.quads + 4 * (size_t)quad, inner[4];
  for (int corner = 0; corner < 4; corner++) {
    int32_t *image = &front->image[ids[corner]];
    if (*image < 0) {
      *image = (int32_t)front->mesh.point_count++;
      front->below[*image] = ids[corner];
    }
    inner[corner] = *image;
  }
  front->quad_of_hex[front->mesh.hex_count] = quad;
  growing_mesh_add(&front->mesh, ids, inner);
  memcpy(ids, inner, sizeof inner);
}

/** Take rings away, or put them back: their quads keep their own neighbours, as in Knuth's dancing
 * links, so that the last ring taken away can be put back. */
static void link_rings(sheet_front *front, const int32_t *rungs, size_t count, bool alive) {
  int32_t *twins = front->s.twins;
  for (size_t i = 0; i < count; i++) {
    int32_t near = half_edge_turn(rungs[i], -1), far = half_edge_turn(rungs[i], 1);
    int32_t inside = twins[near], outside = twins[far];
    twins[inside] = alive ? near : outside;
    twins[outside] = alive ? far : inside;
    front->alive[half_edge_quad(rungs[i])] = alive;
    front->gone[front->loops.loop_of_passage[surface_passage(rungs[i])]] = !alive;
  }
  front->alive_count = alive ? front->alive_count + count : front->alive_count - count;
}

static hexcon_status reserve(hexcon_context *context, sheet_front *front, size_t quads) {
  /* Euler: with simple rims about it, a region has fewer inner points than quads. */
  hexcon_status status = growing_mesh_reserve(context, &front->mesh, quads, quads);
  if (!status)
    status = grow_points(context, front, front->mesh.point_count + quads);
  if (status)
    return status;
  int32_t *quad_of_hex =
      context_grow(context, front->quad_of_hex, front->mesh.hex_count + quads, sizeof *quad_of_hex);
  front->quad_of_hex = quad_of_hex ? quad_of_hex : front->quad_of_hex;
  return quad_of_hex ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

hexcon_status front_lay(hexcon_context *context, sheet_front *front, const front_region *region) {
  hexcon_status status = reserve(context, front, region->quad_count);
  if (status)
    return status;
  sheet_layer layer = {front->rung_count, front->mesh.hex_count, front->mesh.point_count};
  front->layers[front->layer_count++] = layer;
  memcpy(front->rungs + front->rung_count, region->rungs,
         region->rung_count * sizeof *front->rungs);
  front->rung_count += region->rung_count;
  set_images(front, region->rungs, region->rung_count, true);
  for (size_t i = 0; i < region->quad_count; i++)
    lay_hex(front, region->quads[i]);
  for (size_t i = 8 * layer.first_hex; i < 8 * front->mesh.hex_count; i++)
    front->image[front->mesh.hexes[i]] = -1;
  link_rings(front, region->rungs, region->rung_count, false);
  return HEXCON_OK;
}

void front_take_back(sheet_front *front) {
  sheet_layer layer = front->layers[--front->layer_count];
  while (front->mesh.hex_count > layer.first_hex) {
    size_t hex = --front->mesh.hex_count;
    memcpy(front->s.quads + 4 * (size_t)front->quad_of_hex[hex], front->mesh.hexes + 8 * hex + 4,
           4 * sizeof *front->s.quads);
  }
  front->mesh.point_count = layer.first_point;
  link_rings(front, front->rungs + layer.first_rung, front->rung_count - layer.first_rung, true);
  front->rung_count = layer.first_rung;
}

hexcon_status front_close(hexcon_context *context, sheet_front *front) {
  hexcon_status status = growing_mesh_reserve(context, &front->mesh, 1, 0);
  if (status)
    return status;
  int32_t quad = 0;
  while (!front->alive[quad])
    quad++;
  int32_t inner[4];
  for (int corner = 0; corner < 4; corner++) {
    int32_t wall = front->s.twins[4 * quad + corner]; /* from the next corner to this one */
    inner[corner] = half_edge_start(&front->s, half_edge_turn(wall, 2));
  }
  growing_mesh_add(&front->mesh, front->s.quads + 4 * (size_t)quad, inner);
  return HEXCON_OK;
}
