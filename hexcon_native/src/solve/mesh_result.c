/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "mesh_result.h"

#include <stdio.h>
#include <string.h>
#include <time.h>

#include "construct/second_order.h"

void mesh_note(hexcon_mesh *mesh, const char *name, double value) {
  if (mesh->figure_count == MAX_FIGURES)
    return;
  hexcon_figure *figure = &mesh->figures[mesh->figure_count++];
  (void)snprintf(figure->name, sizeof figure->name, "%s", name);
  figure->value = value;
}

double mesh_clock(void) {
  struct timespec now;
  (void)timespec_get(&now, TIME_UTC);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

void mesh_note_seconds(hexcon_mesh *mesh, const char *stage, double start) {
  char name[48];
  (void)snprintf(name, sizeof name, "seconds %s", stage);
  mesh_note(mesh, name, mesh_clock() - start);
}

/** Points with the edges' midpoints after them. */
static double *append_midpoints(hexcon_context *context, const hexcon_mesh *mesh,
                                const edge_table *edges) {
  double *points =
      context_allocate(context, 3 * (mesh->point_count + edges->count), sizeof *points);
  if (!points)
    return NULL;
  memcpy(points, mesh->points, 3 * mesh->point_count * sizeof *points);
  for (size_t e = 0; e < edges->count; e++) {
    const double *a = mesh->points + 3 * (size_t)edges->ends[e][0];
    const double *b = mesh->points + 3 * (size_t)edges->ends[e][1];
    for (size_t i = 0; i < 3; i++)
      points[3 * (mesh->point_count + e) + i] = a[i] + (b[i] - a[i]) / 2;
  }
  return points;
}

hexcon_status mesh_raise_order(hexcon_context *context, hexcon_mesh *mesh) {
  edge_table edges;
  hexcon_status status = edge_table_build(context, mesh->hexes, mesh->hex_count, &edges);
  int32_t *hexes = status ? NULL : context_allocate(context, 20 * mesh->hex_count, sizeof *hexes);
  double *points = hexes ? append_midpoints(context, mesh, &edges) : NULL;
  if (!points) {
    context_free(context, hexes);
    edge_table_free(context, &edges);
    return status ? status : HEXCON_OUT_OF_MEMORY;
  }
  for (size_t h = 0; h < mesh->hex_count; h++) {
    memcpy(hexes + 20 * h, mesh->hexes + 8 * h, 8 * sizeof *hexes);
    for (size_t e = 0; e < 12; e++)
      hexes[20 * h + 8 + e] = (int32_t)mesh->point_count + edges.of_hex[12 * h + e];
  }
  context_free(context, mesh->points);
  context_free(context, mesh->hexes);
  mesh->points = points;
  mesh->hexes = hexes;
  mesh->point_count += edges.count;
  mesh->order = 2;
  edge_table_free(context, &edges);
  return HEXCON_OK;
}

void hexcon_mesh_free(hexcon_context *context, hexcon_mesh *mesh) {
  if (!mesh)
    return;
  context_free(context, mesh->points);
  context_free(context, mesh->hexes);
  context_free(context, mesh->quads);
  context_free(context, mesh->quality);
  hexcon_certificate_free(context, &mesh->certificate);
  context_free(context, mesh);
}

size_t hexcon_mesh_point_count(const hexcon_mesh *mesh) {
  return mesh->point_count;
}
size_t hexcon_mesh_hex_count(const hexcon_mesh *mesh) {
  return mesh->hex_count;
}
int hexcon_mesh_order(const hexcon_mesh *mesh) {
  return mesh->order;
}
const double *hexcon_mesh_points(const hexcon_mesh *mesh) {
  return mesh->points;
}
const int32_t *hexcon_mesh_hexes(const hexcon_mesh *mesh) {
  return mesh->hexes;
}
const int32_t *hexcon_mesh_quads(const hexcon_mesh *mesh) {
  return mesh->quads;
}
const char *hexcon_mesh_method(const hexcon_mesh *mesh) {
  return mesh->method;
}
const hexcon_certificate *hexcon_mesh_certificate(const hexcon_mesh *mesh) {
  return &mesh->certificate;
}
const double *hexcon_mesh_quality(const hexcon_mesh *mesh) {
  return mesh->quality;
}
size_t hexcon_mesh_report(const hexcon_mesh *mesh, const hexcon_figure **figures) {
  *figures = mesh->figures;
  return mesh->figure_count;
}
