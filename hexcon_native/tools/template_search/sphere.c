/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "sphere.h"

#include <string.h>

#include "hexmesh/hex_tables.h"

bool sphere_link(sphere *s) {
  uint8_t dart_between[MOST_VERTICES][MOST_VERTICES];
  const int darts = 4 * s->quad_count;
  memset(dart_between, NONE, sizeof dart_between);
  memset(s->degree, 0, sizeof s->degree);
  for (int d = 0; d < darts; d++) {
    const uint8_t from = s->corner[d], to = s->corner[dart_turned(d, 1)];
    if (from == to || dart_between[from][to] != NONE)
      return false;
    dart_between[from][to] = (uint8_t)d;
    s->degree[from]++;
  }
  for (int d = 0; d < darts; d++) {
    s->twin[d] = dart_between[s->corner[dart_turned(d, 1)]][s->corner[d]];
    if (s->twin[d] == NONE)
      return false;
  }
  return true;
}

bool sphere_three_connected(const sphere *s) {
  uint64_t opposite[MOST_VERTICES] = {0};
  for (int q = 0; q < s->quad_count; q++)
    for (int i = 0; i < 2; i++) {
      const int a = s->corner[4 * q + i], b = s->corner[4 * q + i + 2];
      if (a == b || (opposite[a] >> b & 1))
        return false;
      opposite[a] |= UINT64_C(1) << b;
      opposite[b] |= UINT64_C(1) << a;
    }
  return true;
}

/** Length of the fan of quads in which a dart lies. */
static int fan_length(const sphere *s, int dart) {
  int length = 0, d = dart;
  do {
    d = dart_rotated(s, d, false);
    length++;
  } while (d != dart);
  return length;
}

static int quads_reached(const sphere *s) {
  bool seen[MOST_QUADS] = {true};
  int queue[MOST_QUADS] = {0}, count = 1;
  for (int i = 0; i < count; i++)
    for (int k = 0; k < 4; k++) {
      const int q = s->twin[4 * queue[i] + k] >> 2;
      if (!seen[q])
        queue[count++] = q;
      seen[q] = true;
    }
  return count;
}

bool sphere_is_sphere(const sphere *s) {
  for (int d = 0; d < 4 * s->quad_count; d++)
    if (fan_length(s, d) != s->degree[s->corner[d]])
      return false;
  return s->vertex_count == s->quad_count + 2 && quads_reached(s) == s->quad_count;
}

void sphere_cube(sphere *s) {
  *s = (sphere){.quad_count = 6, .vertex_count = 8};
  memcpy(s->corner, hex_faces, sizeof hex_faces);
  (void)sphere_link(s);
}
