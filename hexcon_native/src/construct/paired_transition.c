/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "paired_transition.h"

/** Points 1 .. 10 of a pair are numbered as in the paper's figure 2, at 0 .. 9. Its quads are seen
 * counter-clockwise from inside, and so its hexes are positive as they are written there. */
static const unsigned char pair_hexes[2][8] = {{0, 1, 4, 3, 7, 6, 9, 8}, {1, 2, 5, 4, 6, 7, 8, 9}};

/** The cell of six, counter-clockwise from outside; even ones lie before the first hex. */
static const unsigned char pair_quads[6][4] = {{7, 6, 1, 0}, {7, 2, 1, 6}, {3, 8, 7, 0},
                                               {8, 5, 2, 7}, {4, 9, 8, 3}, {9, 4, 5, 8}};

/** Ids of a pair's points; the half-edge `shared` belongs to its first quad. */
static void name_points(const surface *s, int32_t shared, size_t pair, const mean_points *made,
                        int32_t points[10]) {
  int32_t twin = s->twins[shared];
  points[0] = half_edge_start(s, half_edge_turn(shared, 2));
  points[1] = half_edge_end(s, shared);
  points[2] = half_edge_start(s, half_edge_turn(twin, -1));
  points[3] = half_edge_start(s, half_edge_turn(shared, -1));
  points[4] = half_edge_start(s, shared);
  points[5] = half_edge_start(s, half_edge_turn(twin, 2));
  size_t ridge = made->first + 2 * pair, foot = ridge + made->near_count;
  points[6] = (int32_t)foot;
  points[7] = (int32_t)ridge;
  points[8] = (int32_t)(ridge + 1);
  points[9] = (int32_t)(foot + 1);
}

/** Points 8 and 9 are a ridge over the shared edge, at its thirds; 7 and 10 lie on the lines from
 * the ridge's ends to the edge's, so that both hexes have all the room there is. */
static void write_means(size_t pair, const int32_t points[10], const mean_points *made) {
  const int32_t means[4][4] = {{points[1], points[1], points[4], -1},
                               {points[1], points[4], points[4], -1},
                               {points[1], points[7], -1, -1},
                               {points[4], points[8], -1, -1}};
  memcpy(made->means + 8 * pair, means[0], 8 * sizeof(int32_t));
  memcpy(made->means + 4 * made->near_count + 8 * pair, means[2], 8 * sizeof(int32_t));
}

/** A pair that shares two edges has point 3 at 1, or 6 at 4: there two quads of its cell of six are
 * one face between its hexes. */
static bool is_inside(const int32_t points[10], size_t quad) {
  return (quad < 2 && points[0] == points[2]) || (quad > 3 && points[3] == points[5]);
}

static void write_pair(const surface *s, int32_t shared, size_t pair, growing_mesh *mesh,
                       paired_quads *out) {
  int32_t points[10];
  name_points(s, shared, pair, &out->points, points);
  write_means(pair, points, &out->points);
  for (size_t h = 0; h < 2; h++, mesh->hex_count++)
    for (size_t i = 0; i < 8; i++)
      mesh->hexes[8 * mesh->hex_count + i] = points[pair_hexes[h][i]];
  for (size_t quad = 0; quad < 6; quad++) {
    int32_t *row = out->quads + 4 * out->quad_count;
    if (is_inside(points, quad))
      continue;
    for (size_t i = 0; i < 4; i++)
      row[i] = points[pair_quads[quad][i]];
    out->hexes[out->quad_count++] = (int32_t)(mesh->hex_count - 2 + quad % 2);
  }
}

static hexcon_status write_all(hexcon_context *context, const surface *s, const int32_t *partner,
                               growing_mesh *mesh, paired_quads *out) {
  size_t pair = 0;
  hexcon_status status = HEXCON_OK;
  for (size_t q = 0; !status && q < s->quad_count; q++) {
    if (partner[q] >= 0 && half_edge_quad(s->twins[partner[q]]) > (int32_t)q)
      write_pair(s, partner[q], pair++, mesh, out);
    status = context_pass(context, q);
  }
  for (size_t q = 0; q < s->quad_count; q++)
    if (partner[q] < 0) {
      out->hexes[out->quad_count] = -1;
      memcpy(out->quads + 4 * out->quad_count++, s->quads + 4 * q, 4 * sizeof *out->quads);
    }
  return status;
}

hexcon_status paired_transition_build(hexcon_context *context, const surface *s,
                                      const int32_t *partner, growing_mesh *mesh,
                                      paired_quads *out) {
  memset(out, 0, sizeof *out);
  size_t paired = 0;
  for (size_t q = 0; q < s->quad_count; q++)
    paired += partner[q] >= 0;
  size_t pairs = paired / 2;
  hexcon_status status = growing_mesh_reserve(context, mesh, 2 * pairs, 4 * pairs);
  if (status)
    return status;
  out->points = (mean_points){mesh->point_count, 4 * pairs, 2 * pairs, NULL};
  out->quads = context_allocate(context, s->quad_count + 4 * pairs, 4 * sizeof *out->quads);
  out->hexes = context_allocate(context, s->quad_count + 4 * pairs, sizeof *out->hexes);
  out->points.means = context_allocate(context, 4 * pairs, 4 * sizeof(int32_t));
  if (!out->quads || !out->hexes || !out->points.means)
    return HEXCON_OUT_OF_MEMORY;
  mesh->point_count += 4 * pairs;
  return write_all(context, s, partner, mesh, out);
}

int32_t paired_transition_end(size_t first, size_t pairs, const int32_t *hexes, int32_t point) {
  if ((size_t)point < first)
    return point;
  size_t end = ((size_t)point - first) % (2 * pairs); /* all ridges, then all their feet */
  return hexes[16 * (end / 2) + 1 + end % 2];
}

void paired_quads_free(hexcon_context *context, paired_quads *paired) {
  context_free(context, paired->quads);
  context_free(context, paired->hexes);
  context_free(context, paired->points.means);
  memset(paired, 0, sizeof *paired);
}
