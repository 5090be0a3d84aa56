/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "shell_copy.h"

#include <string.h>

hexcon_status shell_copies_new(hexcon_context *context, const surface *s, shell_copies *out) {
  *out = (shell_copies){
      .s = s,
      .first = context_allocate_zeroed(context, s->component_count + 1, sizeof *out->first),
      .quads = context_allocate(context, s->quad_count, sizeof *out->quads),
      .new_quad = context_allocate(context, s->quad_count, sizeof *out->new_quad),
      .new_point = context_allocate(context, s->point_count, sizeof *out->new_point)};
  if (!out->first || !out->quads || !out->new_quad || !out->new_point)
    return HEXCON_OUT_OF_MEMORY;
  memset(out->new_point, -1, s->point_count * sizeof *out->new_point);
  for (size_t q = 0; q < s->quad_count; q++)
    out->new_quad[q] = (int32_t)out->first[s->component_of_quad[q] + 1]++;
  for (size_t c = 0; c < s->component_count; c++)
    out->first[c + 1] += out->first[c];
  for (size_t q = 0; q < s->quad_count; q++)
    out->quads[out->first[s->component_of_quad[q]] + (size_t)out->new_quad[q]] = (int32_t)q;
  return HEXCON_OK;
}

void shell_copies_free(hexcon_context *context, shell_copies *copies) {
  context_free(context, copies->first);
  context_free(context, copies->quads);
  context_free(context, copies->new_quad);
  context_free(context, copies->new_point);
  *copies = (shell_copies){0};
}

int32_t shell_copies_quad(const shell_copies *copies, size_t component, int32_t quad) {
  return copies->quads[copies->first[component] + (size_t)quad];
}

static void number_points(shell_copies *copies, const int32_t *quads, surface *shell) {
  for (size_t q = 0; q < shell->quad_count; q++)
    for (size_t i = 0; i < 4; i++) {
      int32_t v = copies->s->quads[4 * (size_t)quads[q] + i];
      if (copies->new_point[v] < 0)
        copies->new_point[v] = (int32_t)shell->point_count++;
    }
}

static void write_shell(const shell_copies *copies, const int32_t *quads, double *points,
                        surface *shell) {
  const surface *s = copies->s;
  for (size_t q = 0; q < shell->quad_count; q++)
    for (size_t i = 0; i < 4; i++) {
      const size_t from = 4 * (size_t)quads[q] + i;
      const int32_t v = s->quads[from], twin = s->twins[from];
      shell->quads[4 * q + i] = copies->new_point[v];
      shell->twins[4 * q + i] = 4 * copies->new_quad[half_edge_quad(twin)] + (twin & 3);
      memcpy(points + 3 * (size_t)copies->new_point[v], s->points + 3 * (size_t)v,
             3 * sizeof *points);
    }
}

hexcon_status shell_copies_take(hexcon_context *context, shell_copies *copies, size_t component,
                                surface *shell) {
  const int32_t *quads = copies->quads + copies->first[component];
  const size_t count = copies->first[component + 1] - copies->first[component];
  *shell = (surface){.quad_count = count, .component_count = 1};
  number_points(copies, quads, shell);
  double *points = context_allocate(context, shell->point_count, 3 * sizeof *points);
  shell->points = points;
  shell->quads = context_allocate(context, count, 4 * sizeof *shell->quads);
  shell->twins = context_allocate(context, count, 4 * sizeof *shell->twins);
  shell->component_of_quad =
      context_allocate_zeroed(context, count, sizeof *shell->component_of_quad);
  if (!points || !shell->quads || !shell->twins || !shell->component_of_quad)
    return HEXCON_OUT_OF_MEMORY;
  write_shell(copies, quads, points, shell);
  return HEXCON_OK;
}

void shell_copy_free(hexcon_context *context, surface *shell) {
  context_free(context, (void *)shell->points);
  surface_free(context, shell);
}
