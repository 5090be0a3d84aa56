/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "small_fillings.h"

#include <stdlib.h>
#include <string.h>

#include "surface/build.h"
#include "surface/numbering.h"

/** Digits of ids and coordinates, and how many of them make one. */
static const char digits[] = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz-_";
enum { DIGITS = 64, ID_DIGITS = 2, PLACE_DIGITS = 3 };
enum { HEX_LENGTH = 8 * ID_DIGITS, POINT_LENGTH = 3 * PLACE_DIGITS };
enum { MOST_IDS = DIGITS * DIGITS, PLACE_STEPS = DIGITS * DIGITS * DIGITS - 1 };

/** Faces of a hex in VTK order, outward. */
static const unsigned char hex_faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                              {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

void small_filling_free(hexcon_context *context, small_filling *filling) {
  context_free(context, filling->hexes);
  context_free(context, filling->places);
  *filling = (small_filling){0};
}

/* ------------------------------------------------------------------------------------- reading */

static hexcon_status damaged(hexcon_context *context, const small_filling_record *record,
                             const char *fault) {
  return context_fail(context, HEXCON_BAD_ARGUMENT, "the filling of class %s is damaged: %s",
                      record->code, fault);
}

/** A number of so many digits; -1 if a character is no digit. */
static int32_t read_number(const char *text, int length) {
  int32_t number = 0;
  for (int i = 0; i < length; i++) {
    const char *digit = text[i] ? strchr(digits, text[i]) : NULL;
    if (!digit)
      return -1;
    number = DIGITS * number + (int32_t)(digit - digits);
  }
  return number;
}

static bool read_arrays(const small_filling_record *record, small_filling *out) {
  for (size_t i = 0; i < 8 * out->hex_count; i++) {
    out->hexes[i] = read_number(record->hexes + ID_DIGITS * i, ID_DIGITS);
    if (out->hexes[i] < 0 || (size_t)out->hexes[i] >= out->point_count)
      return false;
  }
  for (size_t i = 0; i < 3 * out->point_count; i++) {
    const int32_t steps = read_number(record->places + PLACE_DIGITS * i, PLACE_DIGITS);
    if (steps < 0)
      return false;
    out->places[i] = 2.0 * steps / (double)PLACE_STEPS - 1;
  }
  return true;
}

static hexcon_status read_record(hexcon_context *context, const small_filling_record *record,
                                 small_filling *out) {
  const size_t hexes = strlen(record->hexes), places = strlen(record->places);
  *out = (small_filling){.point_count = places / POINT_LENGTH,
                         .hex_count = hexes / HEX_LENGTH,
                         .certified = record->certified != 0};
  if (hexes % HEX_LENGTH || places % POINT_LENGTH || out->hex_count == 0 ||
      out->point_count > MOST_IDS)
    return damaged(context, record, "its length is wrong");
  out->hexes = context_allocate(context, out->hex_count, 8 * sizeof *out->hexes);
  out->places = context_allocate(context, out->point_count, 3 * sizeof *out->places);
  if (!out->hexes || !out->places)
    return HEXCON_OUT_OF_MEMORY;
  return read_arrays(record, out) ? HEXCON_OK
                                  : damaged(context, record, "it names what it does not have");
}

/* ------------------------------------------------------------------------------------ checking */

/** A hex's face: its points in any order as one number, and where it is. */
typedef struct face {
  uint64_t key;
  const int32_t *hex;
  int side;
} face;

static face make_face(const int32_t *hex, int side) {
  uint64_t ids[4] = {0};
  for (int i = 0; i < 4; i++) {
    const uint64_t id = (uint64_t)hex[hex_faces[side][i]];
    int at = i;
    for (; at > 0 && ids[at - 1] > id; at--)
      ids[at] = ids[at - 1];
    ids[at] = id;
  }
  return (face){((ids[0] * MOST_IDS + ids[1]) * MOST_IDS + ids[2]) * MOST_IDS + ids[3], hex, side};
}

static int compare_faces(const void *a, const void *b) {
  const uint64_t left = ((const face *)a)->key, right = ((const face *)b)->key;
  return (left > right) - (left < right);
}

/** Copy the faces met once. @return how many, or CODE_MOST_QUADS + 1: too many, or one met thrice
 */
static size_t lone_faces(const face *faces, size_t count, int32_t quads[4 * CODE_MOST_QUADS]) {
  size_t found = 0;
  for (size_t i = 0, end; i < count; i = end) {
    for (end = i; end < count && faces[end].key == faces[i].key;)
      end++;
    if (end - i > 2 || (end - i == 1 && found == CODE_MOST_QUADS))
      return CODE_MOST_QUADS + 1;
    for (int k = 0; end - i == 1 && k < 4; k++)
      quads[4 * found + (size_t)k] = faces[i].hex[hex_faces[faces[i].side][k]];
    found += end - i == 1;
  }
  return found;
}

/** Is the boundary the class, numbered as its code says? */
static hexcon_status check_boundary(hexcon_context *context, const small_filling_record *record,
                                    const int32_t *quads, size_t quad_count) {
  surface s;
  hexcon_status status = surface_build(context, NULL, quad_count + 2, quads, quad_count, &s);
  bool same = false;
  for (int32_t h = 0; !status && s.component_count == 1 && h < (int32_t)(4 * quad_count); h++)
    if (half_edge_start(&s, h) == 0 && half_edge_end(&s, h) == 1) {
      canonical_code walk = {0};
      surface_walk(&s, h, false, &walk);
      same = strcmp(walk.text, record->code) == 0;
      for (int32_t v = 0; same && v < (int32_t)quad_count + 2; v++)
        same = walk.order[v] == v;
    }
  surface_free(context, &s);
  if (status == HEXCON_OUT_OF_MEMORY)
    return status;
  return same ? HEXCON_OK : damaged(context, record, "its boundary is of another class");
}

static hexcon_status check_filling(hexcon_context *context, const small_filling_record *record,
                                   const small_filling *filling) {
  int32_t quads[4 * CODE_MOST_QUADS] = {0};
  size_t count = 0;
  face *faces = context_allocate(context, filling->hex_count, 6 * sizeof *faces);
  if (!faces)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t h = 0; h < filling->hex_count; h++)
    for (int side = 0; side < 6; side++)
      faces[count++] = make_face(filling->hexes + 8 * h, side);
  qsort(faces, count, sizeof *faces, compare_faces);
  const size_t lone = lone_faces(faces, count, quads);
  context_free(context, faces);
  if (lone == 0 || lone > CODE_MOST_QUADS || lone + 2 > filling->point_count)
    return damaged(context, record, "its hexes do not fill a small boundary");
  return check_boundary(context, record, quads, lone);
}

hexcon_status small_filling_check(hexcon_context *context, const small_filling_record *record) {
  small_filling filling;
  hexcon_status status = read_record(context, record, &filling);
  if (!status)
    status = check_filling(context, record, &filling);
  small_filling_free(context, &filling);
  return status;
}

/* ------------------------------------------------------------------------------------- look-up */

/** Two quads with the same opposite corners leave no room for hexes that meet properly. */
static hexcon_status check_opposite_corners(hexcon_context *context, const surface *s) {
  int32_t quad_of[CODE_MOST_POINTS][CODE_MOST_POINTS];
  memset(quad_of, -1, sizeof quad_of);
  for (int32_t q = 0; q < (int32_t)s->quad_count; q++)
    for (int k = 0; k < 2; k++) {
      const int32_t a = s->quads[4 * q + k], b = s->quads[4 * q + k + 2];
      const int32_t other = quad_of[a][b];
      quad_of[a][b] = quad_of[b][a] = q;
      if (other < 0)
        continue;
      context_add_element(context, other);
      context_add_element(context, q);
      return context_fail(context, HEXCON_NO_SMALL_FILLING,
                          "quads %d and %d have two opposite corners in common: no hex mesh "
                          "without doublets has both",
                          (int)numbering_quad_name(s, other), (int)numbering_quad_name(s, q));
    }
  return HEXCON_OK;
}

static hexcon_status check_small(hexcon_context *context, const surface *s) {
  if (s->quad_count > CODE_MOST_QUADS)
    return context_fail(context, HEXCON_NO_SMALL_FILLING,
                        "the surface has %zu quads; the table of small fillings ends at %d",
                        s->quad_count, CODE_MOST_QUADS);
  if (!surface_is_sphere(s))
    return context_fail(context, HEXCON_NOT_A_BALL,
                        "small fillings are of bodies without holes: %zu quads with %zu points "
                        "are no sphere's",
                        s->quad_count, s->point_count);
  return check_opposite_corners(context, s);
}

static int compare_codes(const void *text, const void *record) {
  return strcmp(text, ((const small_filling_record *)record)->code);
}

/** Boundary points get the surface's ids; what was mirrored is turned inside out. */
static hexcon_status relabel(hexcon_context *context, const canonical_code *code,
                             size_t boundary_count, small_filling *filling) {
  double *places = context_allocate(context, filling->point_count, 3 * sizeof *places);
  if (!places)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t i = 0; i < filling->point_count; i++) {
    double *place = places + 3 * (i < boundary_count ? (size_t)code->order[i] : i);
    memcpy(place, filling->places + 3 * i, 3 * sizeof *place);
    if (code->mirrored)
      place[2] = -place[2];
  }
  for (size_t i = 0; i < 8 * filling->hex_count; i++)
    if ((size_t)filling->hexes[i] < boundary_count)
      filling->hexes[i] = code->order[filling->hexes[i]];
  for (size_t i = 0; code->mirrored && i < 8 * filling->hex_count; i++)
    if (i % 8 < 4) {
      const int32_t bottom = filling->hexes[i];
      filling->hexes[i] = filling->hexes[i + 4];
      filling->hexes[i + 4] = bottom;
    }
  context_free(context, filling->places);
  filling->places = places;
  return HEXCON_OK;
}

hexcon_status small_class_find(hexcon_context *context, const surface *s,
                               const small_filling_table *table, small_class *out) {
  canonical_code code = {0};
  *out = (small_class){0};
  hexcon_status status = check_small(context, s);
  if (status)
    return status;
  out->walk_count = surface_canonical_walks(s, out->walks);
  surface_walk(s, out->walks[0].half_edge, out->walks[0].mirrored, &code);
  out->record =
      bsearch(code.text, table->records, table->count, sizeof *table->records, compare_codes);
  return out->record
             ? HEXCON_OK
             : context_fail(context, HEXCON_NO_SMALL_FILLING,
                            "the table of small fillings has none for this surface of %zu quads",
                            s->quad_count);
}

hexcon_status small_filling_read(hexcon_context *context, const surface *s,
                                 const small_class *found, size_t walk, small_filling *out) {
  canonical_code code = {0};
  *out = (small_filling){0};
  hexcon_status status = read_record(context, found->record, out);
  if (!status)
    status = check_filling(context, found->record, out);
  surface_walk(s, found->walks[walk].half_edge, found->walks[walk].mirrored, &code);
  return status ? status : relabel(context, &code, s->point_count, out);
}
