/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "cells.h"

#include <string.h>

/** What a template's point is on the surface, told by its label. */
typedef enum point_kind {
  OUTER,   /* O: a corner of the quad */
  INNER,   /* I: the same corner further in */
  UPRIGHT, /* M: between them, at black corners */
  SIDE,    /* C: in the side over an edge */
  EDGE,    /* E: the middle of an inner edge */
  MIDDLE,  /* N: the middle of the inner diagonal */
  FIRST_MEAN,
  SECOND_MEAN, /* Ga, Gb: of the triangles at inner corners 2 and 0 */
  INSIDE
} point_kind;

typedef struct point_role {
  point_kind kind;
  bool second;   /* belongs to the second quad of the pair */
  size_t corner; /* of its quad; for SIDE and EDGE the side that begins there */
} point_role;

/** Sets of points of the mesh, by what they are. */
typedef struct cell_numbering {
  int32_t *upright;  /* [point_count] of black points; -1 for white ones */
  int32_t *edge;     /* [4 quad_count] by half-edge */
  int32_t *side;     /* [4 quad_count] by half-edge; -1 inside pairs */
  size_t first_quad; /* N, Ga, Gb of quad q: first_quad + 3 q .. */
  size_t first_inside;
} cell_numbering;

static bool read_role(const char *label, point_role *role) {
  static const struct {
    const char *letters;
    point_kind kind;
  } kinds[] = {{"int", INSIDE}, {"Ga", FIRST_MEAN}, {"Gb", SECOND_MEAN}, {"O", OUTER}, {"I", INNER},
               {"M", UPRIGHT},  {"C", SIDE},        {"E", EDGE},         {"N", MIDDLE}};
  *role = (point_role){.second = label[0] == 'b'};
  label += role->second;
  for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
    size_t length = strlen(kinds[k].letters);
    if (strncmp(label, kinds[k].letters, length) != 0)
      continue;
    role->kind = kinds[k].kind;
    if (label[length])
      role->corner = (size_t)(label[length] - '0');
    return role->corner < 4;
  }
  return false;
}

static hexcon_status read_roles(hexcon_context *context, const hex_template *t, point_role *roles) {
  for (size_t i = 0; i < t->point_count; i++)
    if (!read_role(t->points[i].label, &roles[i]))
      return context_fail(context, HEXCON_BAD_ARGUMENT,
                          "template %s is damaged: a point is labelled %s", t->name,
                          t->points[i].label);
  return HEXCON_OK;
}

static void cell_numbering_free(hexcon_context *context, cell_numbering *n) {
  context_free(context, n->upright);
  context_free(context, n->edge);
  context_free(context, n->side);
}

/** Number everything that cells share; *next is the first free id. */
static hexcon_status cell_numbering_new(hexcon_context *context, const surface *s,
                                        const uint8_t *colours, const int32_t *partner,
                                        size_t *next, cell_numbering *out) {
  size_t corners = 4 * s->quad_count;
  memset(out, 0, sizeof *out);
  out->upright = context_allocate(context, s->point_count, sizeof *out->upright);
  out->edge = context_allocate(context, corners, sizeof *out->edge);
  out->side = context_allocate(context, corners, sizeof *out->side);
  if (!out->upright || !out->edge || !out->side)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t v = 0; v < s->point_count; v++)
    out->upright[v] = colours[v] ? -1 : (int32_t)(*next)++;
  for (size_t h = 0; h < corners; h++) {
    size_t twin = (size_t)s->twins[h];
    bool is_paired = partner[h / 4] == (int32_t)h;
    out->edge[h] = twin < h ? out->edge[twin] : (int32_t)(*next)++;
    out->side[h] = is_paired ? -1 : twin < h ? out->side[twin] : (int32_t)(*next)++;
  }
  out->first_quad = *next;
  out->first_inside = *next + 3 * s->quad_count;
  return HEXCON_OK;
}

/** The half-edge of a quad that starts at the template's corner `corner`, or ends there: seen from
 * inside the first quad is passed against its half-edges, the second along them. */
static int32_t half_edge_at(const surface *s, int32_t base, bool second, size_t corner) {
  int steps = (int)corner;
  return second ? half_edge_turn(s->twins[base], steps) : half_edge_turn(base, -steps);
}

/** Id of one point of the cell over the pair at half-edge `base`, which runs from white to black.
 */
static int32_t point_id(const surface *s, const cell_numbering *n, const cell_complex *cells,
                        int32_t base, const point_role *role, size_t *inside) {
  int32_t h = half_edge_at(s, base, role->second, role->corner);
  size_t vertex = (size_t)(role->second ? half_edge_start(s, h) : half_edge_end(s, h));
  size_t of_quad = n->first_quad + 3 * (size_t)half_edge_quad(h);
  switch (role->kind) {
  case OUTER:
    return (int32_t)(cells->layers * s->point_count + vertex);
  case INNER:
    return (int32_t)(cells->first_inner + vertex);
  case UPRIGHT:
    return n->upright[vertex];
  case EDGE:
    return n->edge[h];
  case SIDE:
    return n->side[h];
  case MIDDLE:
    return (int32_t)of_quad;
  case FIRST_MEAN:
    return (int32_t)(of_quad + 1);
  case SECOND_MEAN:
    return (int32_t)(of_quad + 2);
  default:
    return (int32_t)(n->first_inside + (*inside)++);
  }
}

/** Two triangles of a quad whose template corner 0 is where half-edge h starts (or ends). */
static void write_triangles(const surface *s, const cell_numbering *n, int32_t base, bool second,
                            cell_complex *cells) {
  static const size_t corners[2][3] = {{1, 3, 2}, {0, 3, 1}}; /* clockwise from inside */
  size_t quad = (size_t)half_edge_quad(half_edge_at(s, base, second, 0));
  for (size_t k = 0; k < 2; k++) {
    size_t row = 2 * quad + k;
    cells->triangle_means[row] = (int32_t)(n->first_quad + 3 * quad + 1 + k);
    for (size_t i = 0; i < 3; i++) {
      size_t from = corners[k][i], to = corners[k][(i + 1) % 3];
      int32_t h = half_edge_at(s, base, second, from);
      cells->triangles[3 * row + i] = second ? half_edge_start(s, h) : half_edge_end(s, h);
      /* side j of the quad runs between template corners j and j + 1 */
      size_t low = (from + 1) % 4 == to ? from : to;
      bool diagonal = (from + 2) % 4 == to;
      cells->side_middles[3 * row + i] = diagonal ? (int32_t)(n->first_quad + 3 * quad)
                                                  : n->edge[half_edge_at(s, base, second, low)];
    }
    if (second) { /* the mirror image */
      int32_t *t = cells->triangles + 3 * row, *m = cells->side_middles + 3 * row, kept = t[1];
      t[1] = t[2];
      t[2] = kept;
      kept = m[0];
      m[0] = m[2];
      m[2] = kept;
    }
  }
}

static hexcon_status write_layers(hexcon_context *context, const surface *s, size_t layers,
                                  int32_t *hex) {
  hexcon_status status = HEXCON_OK;
  for (size_t layer = 0; layer < layers; layer++)
    for (size_t q = 0; !status && q < s->quad_count; q++, hex += 8) {
      for (size_t i = 0; i < 4; i++) {
        hex[4 + i] = (int32_t)(layer * s->point_count) + s->quads[4 * q + i];
        hex[i] = hex[4 + i] + (int32_t)s->point_count;
      }
      status = context_pass(context, q);
    }
  return status;
}

static hexcon_status write_cells(hexcon_context *context, const surface *s, const uint8_t *colours,
                                 const int32_t *partner, const cell_numbering *n,
                                 const point_role *roles, cell_complex *cells) {
  const hex_template *t = cells->domino;
  int32_t *hex = cells->hexes + 8 * cells->layers * s->quad_count, *points = cells->cell_points;
  size_t inside = 0;
  hexcon_status status = write_layers(context, s, cells->layers, cells->hexes);
  for (size_t q = 0; !status && q < s->quad_count; q++) {
    status = context_pass(context, q);
    if (colours[half_edge_start(s, partner[q])] == 0)
      continue; /* the pair's other quad has the half-edge from white to black */
    for (size_t i = 0; i < t->point_count; i++)
      points[i] = point_id(s, n, cells, partner[q], &roles[i], &inside);
    for (size_t h = 0; h < t->hex_count; h++, hex += 8)
      for (size_t i = 0; i < 8; i++)
        hex[i] = points[t->hexes[h][i]];
    points += t->point_count;
    write_triangles(s, n, partner[q], false, cells);
    write_triangles(s, n, partner[q], true, cells);
  }
  cells->point_count = n->first_inside + inside;
  return status;
}

static hexcon_status allocate_tables(hexcon_context *context, const surface *s,
                                     cell_complex *cells) {
  size_t quads = s->quad_count, width = cells->domino->point_count;
  cells->cell_count = quads / 2;
  cells->first_inner = (cells->layers + 1) * s->point_count;
  size_t most = cells->layers < CONTEXT_MAX_COUNT / 8 ? cells->layers : CONTEXT_MAX_COUNT / 8;
  if (quads > CONTEXT_MAX_COUNT / (8 * (cells->domino->hex_count + most)))
    return context_fail(context, HEXCON_TOO_LARGE,
                        "cells over %zu quads with %zu layers are more than 32-bit ids hold", quads,
                        cells->layers);
  cells->hex_count = cells->layers * quads + cells->cell_count * cells->domino->hex_count;
  cells->hexes = context_allocate(context, 8 * cells->hex_count, sizeof *cells->hexes);
  cells->cell_points = context_allocate(context, cells->cell_count * width, sizeof(int32_t));
  cells->triangles = context_allocate(context, 6 * quads, sizeof *cells->triangles);
  cells->triangle_means = context_allocate(context, 2 * quads, sizeof *cells->triangle_means);
  cells->side_middles = context_allocate(context, 6 * quads, sizeof *cells->side_middles);
  bool complete = cells->hexes && cells->cell_points && cells->triangles && cells->triangle_means &&
                  cells->side_middles;
  return complete ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

hexcon_status cells_build(hexcon_context *context, const surface *s, const uint8_t *colours,
                          const int32_t *partner, size_t layers, cell_complex *out) {
  memset(out, 0, sizeof *out);
  out->domino = &template_domino_62;
  out->layers = layers;
  cell_numbering n = {0};
  point_role *roles = context_allocate(context, out->domino->point_count, sizeof *roles);
  hexcon_status status = roles ? template_check(context, out->domino) : HEXCON_OUT_OF_MEMORY;
  if (!status)
    status = read_roles(context, out->domino, roles);
  if (!status)
    status = allocate_tables(context, s, out);
  size_t next = out->first_inner + s->point_count;
  if (!status)
    status = cell_numbering_new(context, s, colours, partner, &next, &n);
  if (!status)
    status = write_cells(context, s, colours, partner, &n, roles, out);
  cell_numbering_free(context, &n);
  context_free(context, roles);
  return status;
}

void cells_free(hexcon_context *context, cell_complex *cells) {
  context_free(context, cells->hexes);
  context_free(context, cells->cell_points);
  context_free(context, cells->triangles);
  context_free(context, cells->triangle_means);
  context_free(context, cells->side_middles);
  memset(cells, 0, sizeof *cells);
}
