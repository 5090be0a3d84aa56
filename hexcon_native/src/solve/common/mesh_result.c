/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "mesh_result.h"

#include <stdio.h>
#include <string.h>

#include "base/system_clock.h"
#include "raise_order.h"

void mesh_note(hexcon_mesh *mesh, const char *name, double value) {
  for (size_t i = 0; i < mesh->figure_count; i++)
    if (strcmp(mesh->figures[i].name, name) == 0) {
      mesh->figures[i].value = value;
      return;
    }
  if (mesh->figure_count == MAX_FIGURES)
    return;
  hexcon_figure *figure = &mesh->figures[mesh->figure_count++];
  (void)snprintf(figure->name, sizeof figure->name, "%s", name);
  figure->value = value;
}

double mesh_figure(const hexcon_mesh *mesh, const char *name) {
  for (size_t i = 0; i < mesh->figure_count; i++)
    if (strcmp(mesh->figures[i].name, name) == 0)
      return mesh->figures[i].value;
  return 0;
}

void mesh_log(hexcon_mesh *mesh, const char *line) {
  size_t room = sizeof mesh->log - mesh->log_length; /* at least 1 */
  int written = snprintf(mesh->log + mesh->log_length, room, "%s\n", line);
  if (written > 0)
    mesh->log_length += (size_t)written < room ? (size_t)written : room - 1;
}

hexcon_status mesh_settle(hexcon_context *context, hexcon_status status, bool found,
                          hexcon_mesh *mesh) {
  if (status != HEXCON_OUT_OF_TIME || !found)
    return status;
  mesh_log(mesh, "the time budget ran out: the best mesh until then");
  context_clear(context);
  context_finish(context);
  return HEXCON_OK;
}

bool mesh_stop(hexcon_context *context, hexcon_status status) {
  if (status == HEXCON_OUT_OF_TIME)
    context_finish(context);
  return status == HEXCON_OK || status == HEXCON_OUT_OF_TIME;
}

double mesh_clock(void) {
  return system_clock();
}

void mesh_note_seconds(hexcon_mesh *mesh, const char *stage, double start) {
  char name[48];
  (void)snprintf(name, sizeof name, "seconds %s", stage);
  mesh_note(mesh, name, mesh_clock() - start);
}

void mesh_note_hexes(hexcon_mesh *mesh, hex_stage stage, size_t hexes) {
  char name[48];
  (void)snprintf(name, sizeof name, "hexes of %s", hexcon_hex_stage(stage)->name);
  mesh_note(mesh, name, (double)hexes);
}

static bool tells_stages(const hexcon_mesh *mesh) {
  for (size_t i = 0; i < mesh->figure_count; i++)
    if (strncmp(mesh->figures[i].name, "hexes of ", strlen("hexes of ")) == 0)
      return true;
  return false;
}

void mesh_note_outer_hexes(hexcon_mesh *mesh, hex_stage stage, size_t hexes) {
  if (!tells_stages(mesh))
    mesh_note_hexes(mesh, HEXES_OF_INSIDE, mesh->hex_count - hexes);
  if (mesh->figure_count == MAX_FIGURES)
    return;
  mesh_note_hexes(mesh, stage, hexes);
  hexcon_figure figure = mesh->figures[mesh->figure_count - 1];
  memmove(mesh->figures + 1, mesh->figures, (mesh->figure_count - 1) * sizeof figure);
  mesh->figures[0] = figure;
}

void mesh_note_hexes_of_one(hexcon_mesh *mesh, hex_stage stage, size_t number, size_t hexes) {
  char name[48];
  (void)snprintf(name, sizeof name, "hexes of %s %zu", hexcon_hex_stage(stage)->name, number);
  mesh_note(mesh, name, (double)hexes);
}

hexcon_status mesh_raise_order(hexcon_context *context, hexcon_mesh *mesh) {
  hexcon_second_order raised;
  hexcon_status status =
      raise_order(context, mesh->points, mesh->point_count, mesh->hexes, mesh->hex_count, &raised);
  if (status)
    return status;
  context_free(context, mesh->points);
  context_free(context, mesh->hexes);
  mesh->points = raised.points;
  mesh->hexes = raised.hexes;
  mesh->point_count = raised.point_count;
  mesh->order = 2;
  return HEXCON_OK;
}

void mesh_clear(hexcon_context *context, hexcon_mesh *mesh) {
  context_free(context, mesh->points);
  context_free(context, mesh->hexes);
  context_free(context, mesh->quads);
  context_free(context, mesh->quality);
  hexcon_certificate_free(context, &mesh->certificate);
  *mesh = (hexcon_mesh){0};
}

void hexcon_mesh_free(hexcon_context *context, hexcon_mesh *mesh) {
  if (!mesh)
    return;
  mesh_clear(context, mesh);
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
size_t hexcon_mesh_quad_count(const hexcon_mesh *mesh) {
  return mesh->quad_count;
}

bool hexcon_mesh_is_topological(const hexcon_mesh *mesh) {
  return mesh->topological;
}

bool hexcon_mesh_is_checked(const hexcon_mesh *mesh) {
  return mesh->checked;
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

const char *hexcon_mesh_log(const hexcon_mesh *mesh) {
  return mesh->log;
}
