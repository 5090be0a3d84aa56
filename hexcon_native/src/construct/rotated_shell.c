/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "rotated_shell.h"

enum { HEXAGON = 6, PRISM = 2 * HEXAGON };

void rotated_shell_free(hexcon_context *context, rotated_shell *shell) {
  context_free(context, shell->mesh.hexes);
  context_free(context, shell->inner.quads);
  context_free(context, shell->inner.twins);
  context_free(context, shell->cell_points);
  context_free(context, shell->mirrored);
  *shell = (rotated_shell){0};
}

/** A copy of the surface that will be rotated, and room for everything. */
static hexcon_status begin(hexcon_context *context, const surface *s, const rotation_plan *plan,
                           rotated_shell *out) {
  const hex_template *cell = &template_rotation_38;
  size_t sides = 4 * s->quad_count;
  *out = (rotated_shell){.cell = cell};
  hexcon_status status = template_check(context, cell);
  if (status)
    return status;
  out->inner = (surface){.point_count = s->point_count,
                         .quad_count = s->quad_count,
                         .component_count = s->component_count};
  out->inner.quads = context_allocate(context, sides, sizeof *out->inner.quads);
  out->inner.twins = context_allocate(context, sides, sizeof *out->inner.twins);
  out->cell_points =
      context_allocate(context, plan->count * cell->point_count, sizeof *out->cell_points);
  out->mirrored = context_allocate(context, plan->count, sizeof *out->mirrored);
  if (!out->inner.quads || !out->inner.twins || !out->cell_points || !out->mirrored)
    return HEXCON_OUT_OF_MEMORY;
  memcpy(out->inner.quads, s->quads, sides * sizeof *s->quads);
  memcpy(out->inner.twins, s->twins, sides * sizeof *s->twins);
  out->mesh.point_count = (plan->shell_count + 1) * s->point_count;
  return growing_mesh_reserve(context, &out->mesh,
                              plan->shell_count * s->quad_count + plan->count * cell->hex_count,
                              plan->count * cell->point_count);
}

/** Points of the template's hexagon: the label's end of the prism, counted about it. */
static hexcon_status find_rows(hexcon_context *context, const hex_template *cell, int rows[PRISM]) {
  for (int i = 0; i < PRISM; i++) {
    const char label[] = {i < HEXAGON ? 'T' : 'B', (char)('0' + i % HEXAGON), '\0'};
    rows[i] = template_row(cell, label);
    if (rows[i] < 0)
      return context_fail(context, HEXCON_BAD_ARGUMENT,
                          "template %s is damaged: it has no point %s", cell->name, label);
  }
  return HEXCON_OK;
}

/** Copy the template under a hexagon whose corners are known on the level above. */
static void add_cell(rotated_shell *shell, const int rows[PRISM], const int32_t corners[HEXAGON],
                     size_t above, size_t width, bool mirrored) {
  const hex_template *cell = shell->cell;
  int32_t *ids = shell->cell_points + shell->cell_count * cell->point_count;
  for (size_t i = 0; i < cell->point_count; i++)
    ids[i] = -1;
  for (int i = 0; i < PRISM; i++) {
    int about = mirrored ? (HEXAGON - i % HEXAGON) % HEXAGON : i % HEXAGON;
    ids[rows[i]] = (int32_t)(above + (i < HEXAGON ? 0 : width)) + corners[about];
  }
  for (size_t i = 0; i < cell->point_count; i++)
    if (ids[i] < 0)
      ids[i] = (int32_t)shell->mesh.point_count++;
  for (size_t h = 0; h < cell->hex_count; h++) {
    int32_t *hex = shell->mesh.hexes + 8 * shell->mesh.hex_count++;
    for (int i = 0; i < 8; i++) /* turned inside out, a mirrored hex is positive */
      hex[i] = ids[cell->hexes[h][mirrored ? (i + 4) % 8 : i]];
  }
  shell->mirrored[shell->cell_count++] = mirrored;
}

/** A hex under each quad that is in none of the shell's hexagons. */
static void add_plain_hexes(rotated_shell *shell, const uint8_t *in_cell, size_t above,
                            size_t width) {
  for (size_t q = 0; q < shell->inner.quad_count; q++) {
    int32_t outer[4], inner[4];
    for (int k = 0; k < 4; k++) {
      outer[k] = (int32_t)above + shell->inner.quads[4 * q + (size_t)k];
      inner[k] = outer[k] + (int32_t)width;
    }
    if (!in_cell[q])
      growing_mesh_add(&shell->mesh, outer, inner);
  }
}

/** The surface under a shell is proper, at least where it was rotated. */
static bool is_proper(const surface *s, const rotation_plan *plan, size_t level,
                      const int32_t *pairs) {
  for (size_t i = 0; i < plan->count; i++)
    if (plan->shells[i] == level && !surface_rotation_is_proper(s, pairs + 2 * i))
      return false;
  return true;
}

/** @return false if the rotations do not fit */
static bool add_shell(const rotation_plan *plan, size_t level, const int rows[PRISM],
                      int32_t *pairs, uint8_t *in_cell, rotated_shell *shell) {
  size_t width = shell->inner.point_count, above = level * width;
  memset(in_cell, 0, shell->inner.quad_count);
  for (size_t i = 0; i < plan->count; i++) {
    edge_rotation r = plan->rotations[i];
    rotation_undo undo;
    int32_t corners[HEXAGON];
    if (plan->shells[i] != level)
      continue;
    rotation_hexagon(&shell->inner, r.half_edge, corners);
    if (!surface_rotate_unchecked(&shell->inner, r, &undo))
      return false;
    memcpy(pairs + 2 * i, undo.quads, sizeof undo.quads);
    in_cell[undo.quads[0]] = in_cell[undo.quads[1]] = 1;
    add_cell(shell, rows, corners, above, width, r.step == 2);
  }
  add_plain_hexes(shell, in_cell, above, width);
  return is_proper(&shell->inner, plan, level, pairs);
}

hexcon_status rotated_shell_build(hexcon_context *context, const surface *s,
                                  const rotation_plan *plan, rotated_shell *out, bool *fits) {
  int rows[PRISM] = {0};
  *fits = true;
  hexcon_status status = begin(context, s, plan, out);
  if (!status)
    status = find_rows(context, out->cell, rows);
  if (status)
    return status;
  uint8_t *in_cell = context_allocate(context, s->quad_count, sizeof *in_cell);
  int32_t *pairs = context_allocate(context, plan->count, 2 * sizeof *pairs);
  status = in_cell && pairs ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  for (size_t level = 0; !status && *fits && level < plan->shell_count; level++)
    *fits = add_shell(plan, level, rows, pairs, in_cell, out);
  context_free(context, in_cell);
  context_free(context, pairs);
  return status;
}
