/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "hex_template.h"

#include <stdlib.h>
#include <string.h>

/** Ids of a template fit in a byte, and so a face in a number. */
enum { MAX_TEMPLATE_POINTS = 255 };

/** Faces of a hex in VTK order. */
static const unsigned char hex_faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                              {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

int template_row(const hex_template *t, const char *label) {
  for (size_t i = 0; i < t->point_count; i++)
    if (strcmp(t->points[i].label, label) == 0)
      return (int)i;
  return -1;
}

static int compare_bytes(const void *a, const void *b) {
  return (int)*(const unsigned char *)a - (int)*(const unsigned char *)b;
}

static int compare_keys(const void *a, const void *b) {
  uint32_t left = *(const uint32_t *)a, right = *(const uint32_t *)b;
  return (left > right) - (left < right);
}

/** One number for a face's four points in any order. */
static uint32_t face_key(const int32_t corners[4]) {
  unsigned char bytes[4];
  for (size_t i = 0; i < 4; i++)
    bytes[i] = (unsigned char)corners[i];
  qsort(bytes, 4, 1, compare_bytes);
  return (uint32_t)bytes[0] << 24 | (uint32_t)bytes[1] << 16 | (uint32_t)bytes[2] << 8 | bytes[3];
}

static bool ids_in_range(const hex_template *t) {
  const int32_t *hexes = &t->hexes[0][0], *quads = &t->quads[0][0];
  bool valid = t->point_count <= MAX_TEMPLATE_POINTS;
  for (size_t i = 0; i < 8 * t->hex_count; i++)
    valid &= hexes[i] >= 0 && (size_t)hexes[i] < t->point_count;
  for (size_t i = 0; i < 4 * t->quad_count; i++)
    valid &= quads[i] >= 0 && (size_t)quads[i] < t->point_count;
  return valid;
}

/** Every face of a hex is met once more: by another hex or by a quad. */
static bool faces_match(const hex_template *t, uint32_t *keys) {
  size_t count = 0;
  for (size_t h = 0; h < t->hex_count; h++)
    for (size_t k = 0; k < 6; k++) {
      int32_t corners[4];
      for (size_t i = 0; i < 4; i++)
        corners[i] = t->hexes[h][hex_faces[k][i]];
      keys[count++] = face_key(corners);
    }
  for (size_t q = 0; q < t->quad_count; q++)
    keys[count++] = face_key(t->quads[q]);
  qsort(keys, count, sizeof *keys, compare_keys);
  bool match = count % 2 == 0;
  for (size_t i = 0; match && i < count; i += 2)
    match = keys[i] == keys[i + 1] && (i + 2 == count || keys[i + 2] != keys[i]);
  return match;
}

hexcon_status template_check(hexcon_context *context, const hex_template *t) {
  if (!ids_in_range(t))
    return context_fail(context, HEXCON_BAD_ARGUMENT,
                        "template %s is damaged: it names points that it does not have", t->name);
  uint32_t *keys = context_allocate(context, 6 * t->hex_count + t->quad_count, sizeof *keys);
  if (!keys)
    return HEXCON_OUT_OF_MEMORY;
  bool match = faces_match(t, keys);
  context_free(context, keys);
  return match
             ? HEXCON_OK
             : context_fail(context, HEXCON_BAD_ARGUMENT,
                            "template %s is damaged: its hexes do not fill its boundary", t->name);
}
