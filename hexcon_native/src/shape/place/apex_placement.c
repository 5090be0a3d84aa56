/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "apex_placement.h"

#include <math.h>
#include <string.h>

#include "base/vector.h"

/** A pyramid is at most this high, in lengths of its sides, .. */
static const double highest = 0.5;
/** .. and its sides take at most this part of the angle between two faces: two of them leave the
 * rest for tetrahedra. */
static const double angle_share = 0.38;

typedef struct face_frame {
  double middle[3], inward[3]; /* the mean of the corners; a unit normal */
} face_frame;

static const double *corner(const coarse_faces *f, const double *points, size_t face, size_t i) {
  return points + 3 * (size_t)f->corner_ids[f->corners[4 * face + i]];
}

static face_frame frame_of(const coarse_faces *f, const double *points, size_t face) {
  bool triangle = face < f->triangle_count;
  size_t count = triangle ? 3 : 4;
  face_frame frame = {0};
  double first[3], second[3];
  for (size_t i = 0; i < count; i++)
    vector_add_scaled(frame.middle, 1 / (double)count, corner(f, points, face, i));
  vector_subtract(corner(f, points, face, 2), corner(f, points, face, 0), first);
  vector_subtract(corner(f, points, face, triangle ? 1 : 3), corner(f, points, face, 1), second);
  if (triangle)
    vector_subtract(corner(f, points, face, 1), corner(f, points, face, 0), second);
  vector_cross(first, second, frame.inward);
  double length = vector_length(frame.inward), sign = triangle ? 1 : -1;
  for (size_t k = 0; k < 3; k++)
    frame.inward[k] *= length > 0 ? sign / length : 0;
  return frame;
}

/** Angle inside the body between two faces that share an edge. */
static double angle_between(const face_frame *a, const face_frame *b) {
  double across[3], product = vector_dot(a->inward, b->inward);
  vector_subtract(b->middle, a->middle, across);
  double bend = acos(fmax(-1, fmin(1, product)));
  return vector_dot(across, a->inward) > 0 ? acos(-1.0) - bend : acos(-1.0) + bend;
}

/** Distance of a face's middle from its side i. */
static double distance_to_side(const coarse_faces *f, const double *points, size_t face, size_t i,
                               const face_frame *frame) {
  double along[3], to_middle[3], product[3];
  const double *start = corner(f, points, face, i), *end = corner(f, points, face, (i + 1) % 4);
  vector_subtract(end, start, along);
  vector_subtract(frame->middle, start, to_middle);
  vector_cross(along, to_middle, product);
  double length = vector_length(along);
  return length > 0 ? vector_length(product) / length : 0;
}

/** How far the surface itself comes in over a quad, beyond the mean of its corners. */
static double inward_bulge(const coarse_faces *f, const double *points, size_t face,
                           const face_frame *frame) {
  double most = 0, offset[3];
  vector_subtract(points + 3 * (size_t)f->centers[face], frame->middle, offset);
  most = fmax(most, vector_dot(offset, frame->inward));
  for (size_t i = 0; i < 4; i++) {
    vector_subtract(points + 3 * (size_t)f->middles[4 * face + i], frame->middle, offset);
    most = fmax(most, vector_dot(offset, frame->inward));
  }
  return most;
}

/** Height of a quad's pyramid. @param neighbours  the two faces at each middle */
static double height_of(const coarse_faces *f, const double *points, size_t face,
                        const face_frame *frames, const int32_t *neighbours) {
  double height = 0;
  for (size_t i = 0; i < 4; i++)
    height += highest / 2 * distance_to_side(f, points, face, i, &frames[face]);
  for (size_t i = 0; i < 4; i++) {
    const int32_t *both = neighbours + 2 * (size_t)f->middles[4 * face + i];
    size_t other = (size_t)(both[0] == (int32_t)face ? both[1] : both[0]);
    double slope = angle_share * angle_between(&frames[face], &frames[other]);
    double room = distance_to_side(f, points, face, i, &frames[face]);
    height = slope < 1.5 ? fmin(height, room * tan(slope)) : height;
  }
  return height;
}

static void find_neighbours(const coarse_faces *f, size_t point_count, int32_t *neighbours) {
  for (size_t i = 0; i < 2 * point_count; i++)
    neighbours[i] = -1;
  for (size_t face = 0; face < f->triangle_count + f->quad_count; face++)
    for (size_t i = 0; i < (face < f->triangle_count ? 3u : 4u); i++) {
      int32_t *both = neighbours + 2 * (size_t)f->middles[4 * face + i];
      both[both[0] >= 0] = (int32_t)face;
    }
}

static void place_apex(const coarse_faces *f, size_t face, const face_frame *frames,
                       const int32_t *neighbours, double scale, int32_t apex, double *points) {
  double height = scale * height_of(f, points, face, frames, neighbours);
  double *to = points + 3 * (size_t)apex;
  memcpy(to, frames[face].middle, 3 * sizeof *to);
  vector_add_scaled(to, height + inward_bulge(f, points, face, &frames[face]), frames[face].inward);
}

hexcon_status place_apices(hexcon_context *context, const coarse_faces *faces, double scale,
                           const int32_t *apices, size_t point_count, double *points) {
  size_t count = faces->triangle_count + faces->quad_count;
  face_frame *frames = context_allocate(context, count, sizeof *frames);
  int32_t *neighbours = context_allocate(context, point_count, 2 * sizeof *neighbours);
  hexcon_status status = frames && neighbours ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  if (!status) {
    for (size_t face = 0; face < count; face++)
      frames[face] = frame_of(faces, points, face);
    find_neighbours(faces, point_count, neighbours);
    for (size_t q = 0; q < faces->quad_count; q++)
      place_apex(faces, faces->triangle_count + q, frames, neighbours, scale, apices[q], points);
  }
  context_free(context, frames);
  context_free(context, neighbours);
  return status;
}
