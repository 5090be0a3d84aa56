/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "target.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/vector.h"
#include "hexes.h"
#include "hexmesh/hex_tables.h"
#include "support.h"

/** `v id x y z label` */
static void read_point(target *t, const char *line) {
  double x[3];
  const char *rest = line + 1;
  const int id = whole_number(&rest, 0, INT_MAX);
  for (int k = 0; k < 3; k++)
    x[k] = real_number(&rest);
  if (strncmp(rest + strspn(rest, " \t"), "int", 3) == 0)
    return;
  if (id != t->point_count || id == MOST_TARGET_POINTS)
    stop("boundary points must come first, numbered 0, 1, 2 ..., and not too many");
  memcpy(t->points[t->point_count++], x, sizeof x);
}

/** `q a b c d` */
static void read_quad(target *t, const char *line) {
  const char *rest = line + 1;
  if (t->quad_count == MOST_QUADS)
    stop("too many boundary quads");
  for (int i = 0; i < 4; i++)
    t->quads[t->quad_count][i] = (uint8_t)whole_number(&rest, 0, t->point_count - 1);
  t->quad_count++;
}

/** How far the quad across side k of quad q lies behind the plane of q there, in edge lengths. */
static double depth_behind(const target *t, const uint8_t quad[4], int k, const uint8_t other[4]) {
  double edge[3], inward[3], normal[3], deepest = 0;
  const double *at = t->points[quad[k]];
  vector_subtract(t->points[quad[(k + 1) & 3]], at, edge);
  vector_subtract(t->points[quad[(k + 2) & 3]], at, inward);
  vector_cross(edge, inward, normal);
  for (int i = 0; i < 4; i++) {
    double to[3];
    vector_subtract(t->points[other[i]], at, to);
    const double depth = -vector_dot(normal, to) / vector_length(normal) / vector_length(edge);
    deepest = depth > deepest ? depth : deepest;
  }
  return deepest;
}

static void sort_edges(target *t) {
  const double flatness = 1e-3;
  ball cavity;
  target_cavity(t, &cavity);
  const sphere *s = &cavity.surface;
  for (int d = 0; d < 4 * s->quad_count; d++) {
    const uint8_t from = s->corner[s->twin[d]], to = s->corner[d];
    const uint8_t *quad = t->quads[d >> 2], *other = t->quads[s->twin[d] >> 2];
    int k = 0;
    while (quad[k] != from)
      k++;
    const bool sharp = depth_behind(t, quad, k, other) > flatness;
    t->edges[from][to] = t->edges[to][from] = sharp ? SHARP_EDGE : FLAT_EDGE;
  }
}

void target_read(target *t, const char *path) {
  char line[256];
  FILE *file = fopen(path, "r");
  *t = (target){0};
  if (!file) {
    stop("cannot open the target");
  } else {
    while (fgets(line, sizeof line, file))
      if (line[0] == 'v')
        read_point(t, line);
      else if (line[0] == 'q')
        read_quad(t, line);
    (void)fclose(file);
  }
  sort_edges(t);
}

void target_cavity(const target *t, ball *cavity) {
  *cavity = (ball){.point_count = t->point_count};
  sphere *s = &cavity->surface;
  s->quad_count = t->quad_count;
  s->vertex_count = t->point_count;
  for (int q = 0; q < t->quad_count; q++)
    for (int i = 0; i < 4; i++)
      s->corner[4 * q + i] = t->quads[q][3 - i];
  for (int v = 0; v < t->point_count; v++)
    cavity->point[v] = (uint8_t)v;
  if (!sphere_link(s) || !sphere_is_sphere(s) || !sphere_three_connected(s))
    stop("the target is no three-connected quadrangulation of the sphere");
  for (int d = 0; d < 4 * s->quad_count; d++)
    cavity->marked[d] = t->edges[s->corner[d]][s->corner[s->twin[d]]] == SHARP_EDGE;
}

static bool corner_allowed(const target *t, const uint8_t hex[8], int corner) {
  const double tiny = 1e-6;
  double edges[3][3], product[3];
  int known = 0;
  for (int k = 0; k < 3; k++) {
    const uint8_t to = hex[hex_corner_neighbours[corner][k]];
    if (to < t->point_count)
      vector_subtract(t->points[to], t->points[hex[corner]], edges[known++]);
  }
  if (known == 3)
    return vector_determinant(edges[0], edges[1], edges[2]) > tiny;
  if (known < 2)
    return true;
  vector_cross(edges[0], edges[1], product);
  return vector_length(product) > tiny;
}

bool target_allows(const target *t, const uint8_t hex[8]) {
  for (int i = 0; i < 8; i++)
    if (hex[i] < t->point_count && !corner_allowed(t, hex, i))
      return false;
  return true;
}

static int compare_words(const void *a, const void *b) {
  const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
  return (x > y) - (x < y);
}

/** Points as one number that does not depend on their order. */
static uint32_t packed(const uint8_t *hex, const uint8_t *corners, int count) {
  uint8_t ids[4] = {0};
  for (int i = 0; i < count; i++) {
    int at = i;
    for (; at > 0 && ids[at - 1] > hex[corners[i]]; at--)
      ids[at] = ids[at - 1];
    ids[at] = hex[corners[i]];
  }
  return (uint32_t)ids[0] << 24 | (uint32_t)ids[1] << 16 | (uint32_t)ids[2] << 8 | ids[3];
}

/** Length of the run of equal words that begins at i. */
static int run_length(const uint32_t *words, int count, int i) {
  int end = i;
  while (end < count && words[end] == words[i])
    end++;
  return end - i;
}

/** @return the number of faces, or -1 if the lone ones are not the target's */
static int count_faces(const target *t, const uint8_t (*hexes)[8], int count) {
  const uint8_t whole[4] = {0, 1, 2, 3};
  uint32_t faces[6 * MOST_HEXES] = {0}, quads[MOST_QUADS] = {0};
  int number = 0, lone = 0;
  for (int h = 0; h < count; h++)
    for (int f = 0; f < 6; f++)
      faces[6 * h + f] = packed(hexes[h], hex_faces[f], 4);
  for (int q = 0; q < t->quad_count; q++)
    quads[q] = packed(t->quads[q], whole, 4);
  qsort(faces, 6 * (size_t)count, sizeof *faces, compare_words);
  qsort(quads, (size_t)t->quad_count, sizeof *quads, compare_words);
  for (int i = 0, run; i < 6 * count; i += run, number++) {
    run = run_length(faces, 6 * count, i);
    if (run > 2)
      return -1;
    if (run == 1 && (lone == t->quad_count || quads[lone++] != faces[i]))
      return -1;
  }
  return lone == t->quad_count ? number : -1;
}

/** @return the number of edges, or -1 if one has too few hexes */
static int count_edges(const target *t, const uint8_t (*hexes)[8], int count) {
  static const int least[] = {[NO_EDGE] = 3, [SHARP_EDGE] = 1, [FLAT_EDGE] = 2};
  uint32_t edges[12 * MOST_HEXES] = {0};
  int number = 0;
  for (int h = 0; h < count; h++)
    for (int e = 0; e < 12; e++)
      edges[12 * h + e] = packed(hexes[h], hex_edges[e], 2);
  qsort(edges, 12 * (size_t)count, sizeof *edges, compare_words);
  for (int i = 0, run; i < 12 * count; i += run, number++) {
    const uint32_t a = edges[i] >> 24, b = edges[i] >> 16 & 255;
    const uint32_t size = (uint32_t)t->point_count;
    run = run_length(edges, 12 * count, i);
    if (run < least[a < size && b < size ? t->edges[a][b] : NO_EDGE])
      return -1;
  }
  return number;
}

static int count_points(const uint8_t (*hexes)[8], int count) {
  bool used[256] = {false};
  int number = 0;
  for (int h = 0; h < count; h++)
    for (int i = 0; i < 8; i++) {
      number += !used[hexes[h][i]];
      used[hexes[h][i]] = true;
    }
  return number;
}

bool target_filled(const target *t, const uint8_t (*hexes)[8], int count) {
  const int faces = count_faces(t, hexes, count);
  const int edges = faces < 0 ? -1 : count_edges(t, hexes, count);
  if (edges < 0 || count_points(hexes, count) - edges + faces - count != 1)
    return false;
  for (int i = 0; i < count; i++)
    for (int j = 0; j < i; j++)
      if (!hexes_meet_properly(hexes[i], hexes[j]))
        return false;
  return true;
}
