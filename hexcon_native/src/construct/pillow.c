/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "pillow.h"

#include <stdlib.h>

/** Faces of a hex in VTK order, counter-clockwise seen from outside. */
static const unsigned char hex_faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                              {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

/** A face of a hex of the set, known by its points in ascending order, and its hex's part. */
typedef struct set_face {
  int32_t points[4], part;
  int32_t side; /* 6 * place in the set + face */
} set_face;

typedef struct pillow {
  const int32_t *set, *parts;
  size_t set_count;
  growing_mesh *mesh;
  set_face *faces;  /* [6 set_count] equal ones beside each other */
  int32_t *parents; /* [8 set_count] union-find of the set's corners, joined across inner faces */
  int32_t *copies;  /* [8 set_count] of roots: the point that the corners get; -1: their own */
} pillow;

static const int32_t *hex_of(const pillow *p, size_t place) {
  return p->mesh->hexes + 8 * (size_t)p->set[place];
}

static int compare_faces(const void *a, const void *b) {
  const set_face *left = a, *right = b;
  for (size_t i = 0; i < 4; i++)
    if (left->points[i] != right->points[i])
      return left->points[i] < right->points[i] ? -1 : 1;
  if (left->part != right->part)
    return left->part < right->part ? -1 : 1;
  return (left->side > right->side) - (left->side < right->side);
}

static bool same_face(const set_face *a, const set_face *b) {
  return a->part == b->part && memcmp(a->points, b->points, sizeof a->points) == 0;
}

static void read_face(const pillow *p, size_t side, set_face *face) {
  const int32_t *hex = hex_of(p, side / 6);
  face->side = (int32_t)side;
  face->part = p->parts[side / 6];
  for (size_t i = 0; i < 4; i++) {
    int32_t point = hex[hex_faces[side % 6][i]];
    size_t at = i;
    for (; at > 0 && face->points[at - 1] > point; at--)
      face->points[at] = face->points[at - 1];
    face->points[at] = point;
  }
}

/** Equal faces come together: by their lowest points, and sorted among the few that share it. */
static hexcon_status sort_faces(hexcon_context *context, pillow *p) {
  size_t points = p->mesh->point_count, sides = 6 * p->set_count;
  size_t *starts = context_allocate_zeroed(context, points + 1, sizeof *starts);
  if (!starts)
    return HEXCON_OUT_OF_MEMORY;
  set_face face;
  hexcon_status status = HEXCON_OK;
  for (size_t side = 0; !status && side < sides; side++) {
    status = context_pass(context, side);
    read_face(p, side, &face);
    starts[face.points[0] + 1]++;
  }
  for (size_t v = 0; v < points; v++)
    starts[v + 1] += starts[v];
  for (size_t side = 0; !status && side < sides; side++) {
    status = context_pass(context, side);
    read_face(p, side, &face);
    p->faces[starts[face.points[0]]++] = face;
  }
  for (size_t v = 0, start = 0; !status && v < points; start = starts[v++]) {
    qsort(p->faces + start, starts[v] - start, sizeof *p->faces, compare_faces);
    status = context_pass(context, v);
  }
  context_free(context, starts);
  return status;
}

static int32_t root_of(pillow *p, int32_t corner) {
  while (p->parents[corner] != corner) {
    p->parents[corner] = p->parents[p->parents[corner]];
    corner = p->parents[corner];
  }
  return corner;
}

/** Join the corners of two hexes at the face between them. */
static void join(pillow *p, const set_face *a, const set_face *b) {
  size_t one = (size_t)a->side / 6, two = (size_t)b->side / 6;
  for (size_t i = 0; i < 4; i++) {
    int32_t corners[2] = {-1, -1};
    for (size_t k = 0; k < 8; k++) {
      if (hex_of(p, one)[k] == a->points[i])
        corners[0] = (int32_t)(8 * one + k);
      if (hex_of(p, two)[k] == a->points[i])
        corners[1] = (int32_t)(8 * two + k);
    }
    p->parents[root_of(p, corners[0])] = root_of(p, corners[1]);
  }
}

/** Whether face i is on the outside of the set. */
static bool is_outside(const pillow *p, size_t i) {
  bool as_before = i > 0 && same_face(&p->faces[i - 1], &p->faces[i]);
  bool as_after = i + 1 < 6 * p->set_count && same_face(&p->faces[i], &p->faces[i + 1]);
  return !as_before && !as_after;
}

static size_t join_inside(pillow *p) {
  size_t outside = 0;
  for (size_t corner = 0; corner < 8 * p->set_count; corner++)
    p->parents[corner] = (int32_t)corner;
  for (size_t i = 0; i < 6 * p->set_count; i++)
    if (is_outside(p, i))
      outside++;
    else if (i > 0 && same_face(&p->faces[i - 1], &p->faces[i]))
      join(p, &p->faces[i - 1], &p->faces[i]);
  return outside;
}

static int32_t corner_at(int32_t side, size_t i) {
  return side / 6 * 8 + hex_faces[side % 6][i];
}

/** Give copies to what lies on the outside. */
static hexcon_status copy_points(hexcon_context *context, pillow *p, pillow_points *points) {
  memset(p->copies, -1, 8 * p->set_count * sizeof *p->copies);
  points->first = p->mesh->point_count;
  points->originals = context_allocate(context, 8 * p->set_count, sizeof *points->originals);
  if (!points->originals)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t i = 0; i < 6 * p->set_count; i++)
    for (size_t k = 0; k < 4 && is_outside(p, i); k++) {
      int32_t corner = corner_at(p->faces[i].side, k), root = root_of(p, corner);
      if (p->copies[root] >= 0)
        continue;
      p->copies[root] = (int32_t)p->mesh->point_count++;
      points->originals[points->count++] = hex_of(p, (size_t)corner / 8)[corner % 8];
    }
  return HEXCON_OK;
}

static void add_hexes(pillow *p) {
  for (size_t i = 0; i < 6 * p->set_count; i++) {
    int32_t side = p->faces[i].side, outer[4], inner[4];
    if (!is_outside(p, i))
      continue;
    for (size_t k = 0; k < 4; k++) {
      outer[k] = hex_of(p, (size_t)side / 6)[hex_faces[side % 6][k]];
      inner[k] = p->copies[root_of(p, corner_at(side, k))];
    }
    growing_mesh_add(p->mesh, outer, inner);
  }
  for (size_t corner = 0; corner < 8 * p->set_count; corner++) {
    int32_t copy = p->copies[root_of(p, (int32_t)corner)];
    if (copy >= 0)
      p->mesh->hexes[8 * (size_t)p->set[corner / 8] + corner % 8] = copy;
  }
}

static hexcon_status draw_back(hexcon_context *context, pillow *p, pillow_points *points) {
  hexcon_status status = sort_faces(context, p);
  if (status)
    return status;
  size_t outside = join_inside(p);
  status = context_after(context, p->set_count);
  if (!status)
    status = growing_mesh_reserve(context, p->mesh, outside, 4 * outside);
  if (!status)
    status = copy_points(context, p, points);
  if (!status)
    status = context_after(context, p->set_count);
  if (!status)
    add_hexes(p);
  return status ? status : context_after(context, p->set_count);
}

hexcon_status pillow_hexes(hexcon_context *context, const int32_t *set, const int32_t *parts,
                           size_t set_count, growing_mesh *mesh, pillow_points *points) {
  memset(points, 0, sizeof *points);
  if (set_count > CONTEXT_MAX_COUNT / 8)
    return context_fail(context, HEXCON_TOO_LARGE, "%zu hexes are too many to be pillowed",
                        set_count);
  pillow p = {.set = set,
              .parts = parts,
              .set_count = set_count,
              .mesh = mesh,
              .faces = context_allocate(context, 6 * set_count, sizeof *p.faces),
              .parents = context_allocate(context, 8 * set_count, sizeof *p.parents),
              .copies = context_allocate(context, 8 * set_count, sizeof *p.copies)};
  hexcon_status status =
      p.faces && p.parents && p.copies ? draw_back(context, &p, points) : HEXCON_OUT_OF_MEMORY;
  context_free(context, p.faces);
  context_free(context, p.parents);
  context_free(context, p.copies);
  return status;
}
