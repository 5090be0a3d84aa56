/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "split_closure.h"

#include <string.h>

#include "tuple_table.h"

typedef enum role_kind {
  BASE_CORNER,
  BASE_EDGE,
  BASE_CENTER,
  INNER_CORNER,
  SIDE, /* one of an edge's points on its own: F, D, ET */
  LEFT_OF_SIDE,
  RIGHT_OF_SIDE, /* they change places in the neighbour across the side */
  OF_QUAD,
  APEX
} role_kind;

typedef struct closure_role {
  role_kind kind;
  size_t place;  /* corner or side of the template */
  size_t offset; /* among the points of its edge or quad */
} closure_role;

static const struct {
  const char *letters;
  role_kind kind;
} label_kinds[] = {{"int", OF_QUAD},     {"Ga", OF_QUAD},   {"Gb", OF_QUAD}, {"N", OF_QUAD},
                   {"Bc", BASE_CENTER},  {"EB", BASE_EDGE}, {"ET", SIDE},    {"B", BASE_CORNER},
                   {"T", INNER_CORNER},  {"F", SIDE},       {"D", SIDE},     {"L", LEFT_OF_SIDE},
                   {"R", RIGHT_OF_SIDE}, {"A", APEX}};

static bool read_label(const char *label, closure_role *role) {
  for (size_t k = 0; k < sizeof label_kinds / sizeof *label_kinds; k++) {
    size_t length = strlen(label_kinds[k].letters);
    if (strncmp(label, label_kinds[k].letters, length) != 0)
      continue;
    *role = (closure_role){.kind = label_kinds[k].kind};
    if (label[length])
      role->place = (size_t)(label[length] - '0');
    return role->place < 4;
  }
  return false;
}

/** Points of an edge are told apart by the letter before the side's number. */
static size_t edge_offset(const split_closure *c, const char *label) {
  static const char *const letters[] = {"L", "R", "F", "D", "ET"};
  size_t offset = 0;
  for (size_t k = 0; k < sizeof letters / sizeof *letters; k++) {
    size_t length = strlen(letters[k]);
    char first[4] = {0};
    memcpy(first, letters[k], length);
    first[length] = '0';
    if (strncmp(label, letters[k], length) == 0 && label[length] >= '0' && label[length] <= '3')
      return offset;
    offset += template_row(c->shape, first) >= 0;
  }
  return offset;
}

static hexcon_status read_roles(hexcon_context *context, split_closure *c) {
  const hex_template *t = c->shape;
  c->roles = context_allocate_zeroed(context, t->point_count, sizeof *c->roles);
  if (!c->roles)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t row = 0; row < t->point_count; row++) {
    closure_role *role = &c->roles[row];
    const char *label = t->points[row].label;
    if (!read_label(label, role))
      return context_fail(context, HEXCON_BAD_ARGUMENT,
                          "template %s is damaged: a point is labelled %s", t->name, label);
    bool of_side = role->kind == SIDE || role->kind == LEFT_OF_SIDE || role->kind == RIGHT_OF_SIDE;
    if (of_side)
      role->offset = edge_offset(c, label);
    if (role->kind == OF_QUAD)
      role->offset = c->quad_points++;
    if (of_side && role->place == 0)
      c->edge_points++;
    if (role->kind == INNER_CORNER && role->place == 0)
      c->corner_points++;
    c->has_apex |= role->kind == APEX;
  }
  return HEXCON_OK;
}

hexcon_status split_closure_new(hexcon_context *context, const split_front *front,
                                const hex_template *shape, uint8_t *turns, size_t first_point,
                                split_closure *out) {
  memset(out, 0, sizeof *out);
  out->front = front;
  out->shape = shape;
  out->turns = turns;
  hexcon_status status = template_check(context, shape);
  if (!status)
    status = read_roles(context, out);
  const surface *s = front->s;
  out->first_corner = first_point;
  out->first_edge = out->first_corner + out->corner_points * front->corner_count;
  out->first_quad = out->first_edge + out->edge_points * front->edge_count;
  out->point_count = out->first_quad + out->quad_points * s->quad_count + out->has_apex;
  if (!status && out->point_count > CONTEXT_MAX_COUNT)
    status = context_fail(context, HEXCON_TOO_LARGE,
                          "the mesh has more points than 32-bit ids hold; mesh with larger quads");
  return status;
}

void split_closure_free(hexcon_context *context, split_closure *c) {
  context_free(context, c->roles);
  memset(c, 0, sizeof *c);
}

/** Side i runs against its half-edge: the base is seen from inside. */
static int32_t side_half_edge(size_t quad, size_t turn, size_t side) {
  return (int32_t)(4 * quad + ((turn + 3 - side) & 3));
}

void split_closure_points(const split_closure *c, size_t quad, int32_t *points) {
  const split_front *f = c->front;
  size_t turn = c->turns ? c->turns[quad] : 0;
  for (size_t row = 0; row < c->shape->point_count; row++) {
    closure_role role = c->roles[row];
    int32_t half_edge = side_half_edge(quad, turn, role.place);
    size_t corner = (size_t)f->s->quads[4 * quad + ((turn + 4 - role.place) & 3)];
    size_t of_edge = c->first_edge + c->edge_points * (size_t)f->edges[half_edge];
    bool along = f->s->twins[half_edge] > half_edge;
    size_t id = 0;
    switch (role.kind) {
    case BASE_CORNER:
      id = (size_t)f->points[corner];
      break;
    case BASE_EDGE:
      id = (size_t)f->points[split_edge_node(f, half_edge)];
      break;
    case BASE_CENTER:
      id = (size_t)f->points[split_center_node(f, quad)];
      break;
    case INNER_CORNER:
      id = c->first_corner + (size_t)f->corners[corner];
      break;
    case SIDE:
      id = of_edge + role.offset;
      break;
    case LEFT_OF_SIDE: /* offsets 0 and 1 */
      id = of_edge + !along;
      break;
    case RIGHT_OF_SIDE:
      id = of_edge + along;
      break;
    case OF_QUAD:
      id = c->first_quad + c->quad_points * quad + role.offset;
      break;
    case APEX:
      id = c->point_count - 1;
      break;
    }
    points[row] = (int32_t)id;
  }
}

/* --------------------------------------------------------------------------------------- diagonals
 */

hexcon_status split_closure_choose_diagonals(hexcon_context *context, const surface *s,
                                             uint8_t *turns) {
  size_t count = 2 * s->quad_count;
  tuple_table table;
  int32_t *numbers = context_allocate(context, count, sizeof *numbers);
  uint8_t *repeated = context_allocate_zeroed(context, count, sizeof *repeated);
  hexcon_status status = tuple_table_new(context, count, &table);
  if (!numbers || !repeated)
    status = HEXCON_OUT_OF_MEMORY;
  for (size_t d = 0; !status && d < count; d++) {
    const int32_t *corner = s->quads + 4 * (d / 2) + d % 2;
    numbers[d] = tuple_table_number(&table, corner[0], corner[2], -1, (int32_t)d);
    repeated[numbers[d]] |= numbers[d] != (int32_t)d;
    status = context_pass(context, d);
  }
  for (size_t q = 0; !status && q < s->quad_count; q++)
    turns[q] = repeated[numbers[2 * q]];
  tuple_table_free(context, &table);
  context_free(context, numbers);
  context_free(context, repeated);
  return status;
}
