/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "coarse_surface.h"

#include <string.h>

#include "base/vector.h"
#include "tuple_table.h"

typedef struct reading {
  hexcon_context *context;
  const surface *s;
  int8_t *corners; /* [quad_count] which corner of each quad is a coarse one; -1: not known */
  int32_t *queue;  /* [quad_count] */
  int32_t *ids;    /* [point_count] coarse ids of coarse corners, NOT_CORNER of others */
  size_t fault_count;
} reading;

enum { NOT_CORNER = -1 };

static void reading_free(hexcon_context *context, reading *r) {
  context_free(context, r->corners);
  context_free(context, r->queue);
  context_free(context, r->ids);
}

static hexcon_status reading_new(hexcon_context *context, const surface *s, reading *out) {
  *out = (reading){.context = context,
                   .s = s,
                   .corners = context_allocate(context, s->quad_count, sizeof *out->corners),
                   .queue = context_allocate(context, s->quad_count, sizeof *out->queue),
                   .ids = context_allocate(context, s->point_count, sizeof *out->ids)};
  return out->corners && out->queue && out->ids ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

static void blame(reading *r, int32_t quad) {
  context_add_element(r->context, quad);
  r->fault_count++;
}

/* ------------------------------------------------------------------------------------- classes */

/** Where the quad across a half-edge must have its coarse corner: the two ends of an edge are a
 * middle and a corner, or a middle and a centre, which lies opposite to the corner. */
static int8_t corner_across(const reading *r, int32_t half_edge) {
  static const unsigned char turns[4] = {1, 2, 3, 0};
  int32_t side = half_edge & 3, twin = r->s->twins[half_edge];
  int32_t step = (side - r->corners[half_edge_quad(half_edge)]) & 3;
  return (int8_t)((twin + turns[step]) & 3);
}

/** Breadth-first over the shell of a quad whose class is known. */
static void spread_class(reading *r, int32_t seed) {
  const surface *s = r->s;
  size_t head = 0, tail = 0;
  r->queue[tail++] = seed;
  while (head < tail) {
    int32_t quad = r->queue[head++];
    for (int32_t h = 4 * quad; h < 4 * quad + 4; h++) {
      int32_t other = half_edge_quad(s->twins[h]);
      if (r->corners[other] >= 0)
        continue;
      r->corners[other] = corner_across(r, h);
      r->queue[tail++] = other;
    }
  }
}

/** From the first quad of each shell; then every edge is looked at from both sides. */
static void spread_classes(reading *r, const uint8_t *ways) {
  const surface *s = r->s;
  memset(r->corners, -1, s->quad_count * sizeof *r->corners);
  for (int32_t q = 0; q < (int32_t)s->quad_count; q++)
    if (r->corners[q] < 0) {
      r->corners[q] = (int8_t)ways[s->component_of_quad[q]];
      spread_class(r, q);
    }
  for (int32_t h = 0; h < (int32_t)(4 * s->quad_count); h++)
    if (h < s->twins[h] && r->corners[half_edge_quad(s->twins[h])] != corner_across(r, h))
      blame(r, half_edge_quad(h));
}

/** The point of a quad so many steps after its coarse corner: 1 and 3 middles, 2 the centre. */
static int32_t point_of(const reading *r, int32_t quad, int step) {
  return r->s->quads[4 * quad + ((r->corners[quad] + step) & 3)];
}

/** A middle has four quads around it, a centre three or four. `ids` holds the numbers meanwhile. */
static void check_degrees(reading *r) {
  const surface *s = r->s;
  memset(r->ids, 0, s->point_count * sizeof *r->ids);
  for (size_t i = 0; i < 4 * s->quad_count; i++)
    r->ids[s->quads[i]]++;
  for (int32_t q = 0; q < (int32_t)s->quad_count; q++) {
    int32_t around = r->ids[point_of(r, q, 2)];
    bool fits = around == 3 || around == 4;
    for (int step = 1; step < 4; step += 2)
      fits = fits && r->ids[point_of(r, q, step)] == 4;
    if (!fits)
      blame(r, q);
  }
}

/* --------------------------------------------------------------------------------------- faces */

static hexcon_status number_points(reading *r, coarse_surface *out) {
  const surface *s = r->s;
  for (size_t v = 0; v < s->point_count; v++)
    r->ids[v] = NOT_CORNER;
  for (int32_t q = 0; q < (int32_t)s->quad_count; q++)
    r->ids[point_of(r, q, 0)] = 0;
  for (size_t v = 0; v < s->point_count; v++)
    out->point_count += r->ids[v] != NOT_CORNER;
  out->points = context_allocate(r->context, out->point_count, sizeof *out->points);
  if (!out->points)
    return HEXCON_OUT_OF_MEMORY;
  size_t next = 0;
  for (size_t v = 0; v < s->point_count; v++)
    if (r->ids[v] != NOT_CORNER) {
      out->points[next] = (int32_t)v;
      r->ids[v] = (int32_t)next++;
    }
  return HEXCON_OK;
}

/** The half-edge from the centre in the next quad around it, counter-clockwise. */
static int32_t next_around(const reading *r, int32_t from_center) {
  return r->s->twins[half_edge_turn(from_center, -1)];
}

static int32_t from_center(const reading *r, int32_t quad) {
  return 4 * quad + ((r->corners[quad] + 2) & 3);
}

/** Number of quads around a quad's centre; 0 if this is not the first of them. */
static size_t face_size(const reading *r, int32_t quad) {
  size_t size = 0;
  int32_t first = from_center(r, quad), h = first;
  do {
    if (half_edge_quad(h) < quad)
      return 0;
    size++;
    h = next_around(r, h);
  } while (h != first);
  return size;
}

static void write_face(const reading *r, int32_t quad, size_t size, size_t face,
                       coarse_surface *out) {
  int32_t h = from_center(r, quad);
  out->centers[face] = r->s->quads[h];
  for (size_t i = 0; i < 4; i++) {
    int32_t at = half_edge_quad(h);
    out->faces[4 * face + i] = i < size ? r->ids[point_of(r, at, 0)] : -1;
    out->middles[4 * face + i] = i < size ? point_of(r, at, 1) : -1;
    h = i < size ? next_around(r, h) : h;
  }
}

static hexcon_status write_faces(const reading *r, coarse_surface *out) {
  int32_t count = (int32_t)r->s->quad_count;
  for (int32_t q = 0; q < count; q++) {
    size_t size = face_size(r, q);
    out->triangle_count += size == 3;
    out->quad_count += size == 4;
  }
  size_t faces = out->triangle_count + out->quad_count;
  out->faces = context_allocate(r->context, 4 * faces, sizeof *out->faces);
  out->middles = context_allocate(r->context, 4 * faces, sizeof *out->middles);
  out->centers = context_allocate(r->context, faces, sizeof *out->centers);
  if (!out->faces || !out->middles || !out->centers)
    return HEXCON_OUT_OF_MEMORY;
  size_t next_triangle = 0, next_quad = out->triangle_count;
  for (int32_t q = 0; q < count; q++) {
    size_t size = face_size(r, q);
    if (size == 3)
      write_face(r, q, size, next_triangle++, out);
    if (size == 4)
      write_face(r, q, size, next_quad++, out);
  }
  return HEXCON_OK;
}

/** Tetrahedra know an edge by its ends: no two may have the same. Nor may a face have a corner
 * twice. */
static hexcon_status check_edges(reading *r) {
  const surface *s = r->s;
  tuple_table table;
  hexcon_status status = tuple_table_new(r->context, 2 * s->quad_count, &table);
  for (int32_t q = 0; !status && q < (int32_t)s->quad_count; q++) {
    int32_t after = next_around(r, from_center(r, q)), middle = point_of(r, q, 1);
    int32_t corners[3] = {point_of(r, q, 0), point_of(r, half_edge_quad(after), 0),
                          point_of(r, half_edge_quad(next_around(r, after)), 0)};
    if (tuple_table_number(&table, corners[0], corners[1], -1, middle) != middle ||
        corners[0] == corners[2])
      blame(r, q);
  }
  tuple_table_free(r->context, &table);
  return status;
}

/* ------------------------------------------------------------------------------------ geometry */

static double departure_from(const surface *s, int32_t point, const coarse_surface *c,
                             const int32_t *corners, size_t count) {
  double offset[3];
  memcpy(offset, s->points + 3 * (size_t)point, sizeof offset);
  for (size_t i = 0; i < count; i++)
    vector_add_scaled(offset, -1 / (double)count, s->points + 3 * (size_t)c->points[corners[i]]);
  return vector_length(offset);
}

static double side_length(const surface *s, const coarse_surface *c, const int32_t ends[2]) {
  double along[3];
  vector_subtract(s->points + 3 * (size_t)c->points[ends[0]],
                  s->points + 3 * (size_t)c->points[ends[1]], along);
  return vector_length(along);
}

static double mean_departure(const surface *s, const coarse_surface *c) {
  size_t faces = c->triangle_count + c->quad_count;
  double total = 0, lengths = 0;
  for (size_t f = 0; f < faces; f++) {
    const int32_t *corners = c->faces + 4 * f;
    size_t size = f < c->triangle_count ? 3 : 4;
    total += departure_from(s, c->centers[f], c, corners, size);
    for (size_t i = 0; i < size; i++) {
      int32_t ends[2] = {corners[i], corners[(i + 1) % size]};
      total += departure_from(s, c->middles[4 * f + i], c, ends, 2);
      lengths += side_length(s, c, ends);
    }
  }
  return lengths > 0 ? total / lengths : 0;
}

/* -------------------------------------------------------------------------------------- reading */

static hexcon_status check_faults(const reading *r) {
  return r->fault_count == 0
             ? HEXCON_OK
             : context_fail(
                   r->context, HEXCON_NOT_DICED,
                   "the surface is no subdivision of a coarser one of triangles and quads: "
                   "%zu quads (listed) do not fit, counted from the way that fits best; "
                   "split every edge in two and cut every face about its centre, or choose "
                   "another method",
                   r->fault_count);
}

static hexcon_status read_surface(reading *r, const uint8_t *ways, coarse_surface *out) {
  spread_classes(r, ways);
  hexcon_status status = check_faults(r);
  if (!status) {
    check_degrees(r);
    status = check_faults(r);
  }
  if (!status)
    status = check_edges(r);
  if (!status)
    status = check_faults(r);
  if (!status)
    status = number_points(r, out);
  if (!status)
    status = write_faces(r, out);
  if (!status && r->s->points)
    out->departure = mean_departure(r->s, out);
  return status;
}

hexcon_status coarse_surface_read(hexcon_context *context, const surface *s, const uint8_t *ways,
                                  coarse_surface *out, size_t *fault_count) {
  memset(out, 0, sizeof *out);
  reading r;
  hexcon_status status = reading_new(context, s, &r);
  if (!status)
    status = read_surface(&r, ways, out);
  if (fault_count)
    *fault_count = r.fault_count;
  reading_free(context, &r);
  return status;
}

void coarse_surface_free(hexcon_context *context, coarse_surface *c) {
  context_free(context, c->points);
  context_free(context, c->faces);
  context_free(context, c->middles);
  context_free(context, c->centers);
  memset(c, 0, sizeof *c);
}
