/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "split_front.h"

/** What a layer does at a node of the front. */
typedef enum node_kind { ABSENT, RIGHT, LEFT, SPLIT } node_kind;

typedef struct split_layer {
  const split_front *front;
  split_kind kind;
  const uint8_t *crossed, *sides;
  uint8_t left;    /* the side that is called left */
  uint8_t *nodes;  /* [node_count] node_kind */
  int32_t *middle; /* [node_count] points inside the layer; -1: none */
  int32_t *inner;  /* [node_count] points of the front behind it */
  growing_mesh *mesh;
  size_t *starts; /* [quad_count + 1] first hex over every quad; may be NULL */
  mean_points *points;
} split_layer;

/** Number the coarse points that quads have, in ascending order. */
static void number_corners(const surface *s, split_front *out) {
  memset(out->corners, -1, s->point_count * sizeof *out->corners);
  for (size_t i = 0; i < 4 * s->quad_count; i++)
    out->corners[s->quads[i]] = 0;
  for (size_t v = 0; v < s->point_count; v++)
    if (out->corners[v] == 0)
      out->corners[v] = (int32_t)out->corner_count++;
}

hexcon_status split_front_new(hexcon_context *context, const surface *s, split_front *out) {
  size_t corners = 4 * s->quad_count;
  memset(out, 0, sizeof *out);
  out->s = s;
  out->edge_count = 2 * s->quad_count;
  out->node_count = s->point_count + out->edge_count + s->quad_count;
  out->edges = context_allocate(context, corners, sizeof *out->edges);
  out->corners = context_allocate(context, s->point_count, sizeof *out->corners);
  out->points = context_allocate(context, out->node_count, sizeof *out->points);
  if (!out->edges || !out->corners || !out->points)
    return HEXCON_OUT_OF_MEMORY;
  number_corners(s, out);
  int32_t next = 0;
  for (size_t h = 0; h < corners; h++)
    out->edges[h] = (size_t)s->twins[h] < h ? out->edges[s->twins[h]] : next++;
  for (size_t node = 0; node < out->node_count; node++)
    out->points[node] = node < s->point_count && out->corners[node] >= 0 ? (int32_t)node : -1;
  return HEXCON_OK;
}

void split_front_free(hexcon_context *context, split_front *front) {
  context_free(context, front->edges);
  context_free(context, front->corners);
  context_free(context, front->points);
  memset(front, 0, sizeof *front);
}

/* --------------------------------------------------------------------------- a quad of the front
 */

/** The nodes of one coarse quad, turned so that a crossing loop goes from edge 0 to edge 2 and has
 * corner 0 to its left. */
typedef struct quad_nodes {
  size_t corners[4], edges[4], center;
  bool crossed, split[2]; /* split[i]: at edges i and i + 2 */
} quad_nodes;

static quad_nodes read_quad(const split_layer *l, size_t quad) {
  const split_front *f = l->front;
  const int32_t *corners = f->s->quads + 4 * quad;
  const uint8_t *crossed = l->crossed + 4 * quad;
  quad_nodes n = {.center = split_center_node(f, quad), .crossed = crossed[0] || crossed[1]};
  size_t turn = !crossed[0] && crossed[1];
  if (n.crossed && l->sides[corners[turn]] != l->left)
    turn += 2;
  for (size_t i = 0; i < 4; i++) {
    size_t side = (i + turn) % 4;
    n.corners[i] = (size_t)corners[side];
    n.edges[i] = split_edge_node(f, (int32_t)(4 * quad + side));
  }
  for (size_t i = 0; i < 2; i++)
    n.split[i] = f->points[n.edges[i]] >= 0;
  return n;
}

/** The quads in which a quad is split already, as nodes. Returns how many. */
static size_t list_parts(const quad_nodes *n, size_t parts[4][4]) {
  const size_t *c = n->corners, *e = n->edges;
  if (n->split[0] && n->split[1]) {
    for (size_t i = 0; i < 4; i++) {
      const size_t part[4] = {c[i], e[i], n->center, e[(i + 3) % 4]};
      memcpy(parts[i], part, sizeof part);
    }
    return 4;
  }
  size_t i = n->split[0] ? 0 : 1;
  if (n->split[i]) {
    const size_t two[2][4] = {{c[i], e[i], e[i + 2], c[(i + 3) % 4]},
                              {e[i], c[i + 1], c[i + 2], e[i + 2]}};
    memcpy(parts, two, sizeof two);
    return 2;
  }
  memcpy(parts[0], c, sizeof parts[0]);
  return 1;
}

/** Rows of nodes across a loop: the left end, the new middle, the right end. */
typedef size_t crossing[3];

/** Those of a crossed quad, along the loop. Returns how many. */
static size_t list_crossings(const quad_nodes *n, crossing rows[3]) {
  size_t count = 0;
  const crossing first = {n->corners[0], n->edges[0], n->corners[1]};
  const crossing last = {n->corners[3], n->edges[2], n->corners[2]};
  const crossing between = {n->edges[3], n->center, n->edges[1]};
  memcpy(rows[count++], first, sizeof first);
  if (n->split[1])
    memcpy(rows[count++], between, sizeof between);
  memcpy(rows[count++], last, sizeof last);
  return count;
}

/* --------------------------------------------------------------------------------- its new points
 */

/** Take note of a node and where its new points will lie: on the node's own point, or between two
 * others' where the layer splits. */
static void mark_nodes(const split_layer *l) {
  const split_front *f = l->front;
  const surface *s = f->s;
  memset(l->nodes, ABSENT, f->node_count);
  for (size_t v = 0; v < s->point_count; v++)
    if (f->points[v] >= 0)
      l->nodes[v] = l->sides[v] == l->left ? LEFT : RIGHT;
  for (int32_t h = 0; h < (int32_t)(4 * s->quad_count); h++)
    if (s->twins[h] > h) {
      size_t node = split_edge_node(f, h);
      if (l->crossed[h])
        l->nodes[node] = SPLIT;
      else if (f->points[node] >= 0)
        l->nodes[node] = l->nodes[half_edge_start(s, h)];
    }
  for (size_t q = 0; q < s->quad_count; q++) {
    quad_nodes n = read_quad(l, q);
    if (n.crossed && n.split[1])
      l->nodes[n.center] = SPLIT;
    else if (f->points[n.center] >= 0)
      l->nodes[n.center] = l->nodes[n.corners[0]];
  }
}

/** The two ends of what is split at an edge's or a quad's node. */
static void write_split_means(const split_layer *l, size_t node, size_t a, size_t b) {
  const int32_t *at = l->front->points;
  const int32_t mean[4] = {at[a], at[b], -1, -1};
  if (l->middle[node] >= 0)
    memcpy(l->points->means + 4 * ((size_t)l->middle[node] - l->points->first), mean, sizeof mean);
  memcpy(l->points->means + 4 * ((size_t)l->inner[node] - l->points->first), mean, sizeof mean);
}

static void write_means(const split_layer *l) {
  const split_front *f = l->front;
  const surface *s = f->s;
  for (size_t node = 0; node < f->node_count; node++) {
    const int32_t mean[4] = {f->points[node], -1, -1, -1};
    if (l->nodes[node] == ABSENT || l->nodes[node] == SPLIT)
      continue;
    if (l->middle[node] >= 0)
      memcpy(l->points->means + 4 * ((size_t)l->middle[node] - l->points->first), mean,
             sizeof mean);
    if (l->inner[node] != f->points[node])
      memcpy(l->points->means + 4 * ((size_t)l->inner[node] - l->points->first), mean, sizeof mean);
  }
  for (int32_t h = 0; h < (int32_t)(4 * s->quad_count); h++)
    if (s->twins[h] > h && l->crossed[h])
      write_split_means(l, split_edge_node(f, h), (size_t)half_edge_start(s, h),
                        (size_t)half_edge_end(s, h));
  for (size_t q = 0; q < s->quad_count; q++) {
    quad_nodes n = read_quad(l, q);
    if (l->nodes[n.center] == SPLIT)
      write_split_means(l, n.center, n.edges[1], n.edges[3]);
  }
}

/** Number the new points: those inside the layer, then those of the new front. */
static hexcon_status number_points(hexcon_context *context, const split_layer *l) {
  const split_front *f = l->front;
  bool whole = l->kind == SPLIT_ORIGINAL;
  size_t next = l->mesh->point_count;
  l->points->first = next;
  for (size_t node = 0; node < f->node_count; node++) {
    bool two = l->nodes[node] == LEFT || l->nodes[node] == SPLIT;
    l->middle[node] = whole && two ? (int32_t)next++ : -1;
  }
  l->points->near_count = next - l->points->first;
  for (size_t node = 0; node < f->node_count; node++) {
    bool moves = l->nodes[node] != ABSENT && (whole || l->nodes[node] != RIGHT);
    l->inner[node] = moves ? (int32_t)next++ : f->points[node];
  }
  l->points->count = next - l->points->first;
  l->points->means = context_allocate(context, l->points->count, 4 * sizeof(int32_t));
  if (!l->points->means)
    return HEXCON_OUT_OF_MEMORY;
  write_means(l);
  l->mesh->point_count = next;
  return context_after(context, l->points->count);
}

/* --------------------------------------------------------------------------------------- its hexes
 */

/** The hex between two rows of a profile across the loop: p, q are the ends of its outer side, r, t
 * those of its inner one, behind q and p. */
static void add_between(growing_mesh *mesh, const int32_t row[4], const int32_t next[4]) {
  const int32_t outer[4] = {row[0], row[1], next[1], next[0]};
  const int32_t inner[4] = {row[3], row[2], next[2], next[3]};
  growing_mesh_add(mesh, outer, inner);
}

/** The quads of the profile at a row: the paper's figure 6, case 2, seen along the loop. */
static size_t list_profile(const split_layer *l, const crossing at, int32_t quads[3][4]) {
  const int32_t *outer = l->front->points, *middle = l->middle, *inner = l->inner;
  size_t left = at[0], new = at[1], right = at[2];
  if (l->kind == SPLIT_ALTERNATIVE) {
    const int32_t only[4] = {outer[left], outer[right], inner[new], inner[left]};
    memcpy(quads[0], only, sizeof only);
    return 1;
  }
  const int32_t three[3][4] = {{outer[left], outer[right], middle[new], middle[left]},
                               {middle[new], outer[right], inner[right], inner[new]},
                               {middle[left], middle[new], inner[new], inner[left]}};
  memcpy(quads, three, sizeof three);
  return 3;
}

static void add_crossed(const split_layer *l, const quad_nodes *n) {
  crossing rows[3];
  int32_t here[3][4], next[3][4];
  size_t count = list_crossings(n, rows);
  for (size_t row = 0; row + 1 < count; row++) {
    size_t quads = list_profile(l, rows[row], here);
    (void)list_profile(l, rows[row + 1], next);
    for (size_t i = 0; i < quads; i++)
      add_between(l->mesh, here[i], next[i]);
  }
}

static void add_column(const split_layer *l, const size_t part[4]) {
  int32_t outer[4], middle[4], inner[4];
  for (size_t i = 0; i < 4; i++) {
    outer[i] = l->front->points[part[i]];
    middle[i] = l->middle[part[i]];
    inner[i] = l->inner[part[i]];
  }
  bool left = l->nodes[part[0]] == LEFT;
  if (l->kind == SPLIT_ORIGINAL && left) {
    growing_mesh_add(l->mesh, outer, middle);
    growing_mesh_add(l->mesh, middle, inner);
  } else if (l->kind == SPLIT_ORIGINAL || left) {
    growing_mesh_add(l->mesh, outer, inner);
  }
}

static hexcon_status add_hexes(hexcon_context *context, const split_layer *l) {
  hexcon_status status = HEXCON_OK;
  for (size_t q = 0; !status && q < l->front->s->quad_count; q++) {
    quad_nodes n = read_quad(l, q);
    size_t parts[4][4], count = n.crossed ? 0 : list_parts(&n, parts);
    if (l->starts)
      l->starts[q] = l->mesh->hex_count;
    if (n.crossed)
      add_crossed(l, &n);
    for (size_t i = 0; i < count; i++)
      add_column(l, parts[i]);
    status = context_pass(context, q);
  }
  if (l->starts)
    l->starts[l->front->s->quad_count] = l->mesh->hex_count;
  return status;
}

/** Hexes of the layer if `left` is called left. */
static size_t count_hexes(const split_layer *l, uint8_t left) {
  size_t count = 0;
  bool whole = l->kind == SPLIT_ORIGINAL;
  for (size_t q = 0; q < l->front->s->quad_count; q++) {
    quad_nodes n = read_quad(l, q);
    size_t parts = ((size_t)n.split[0] + 1) * ((size_t)n.split[1] + 1);
    if (n.crossed)
      count += (whole ? 3 : 1) * parts;
    else
      count += parts * ((size_t)whole + (l->sides[n.corners[0]] == left));
  }
  return count;
}

static hexcon_status build_layer(hexcon_context *context, split_layer *l) {
  size_t counts[2] = {count_hexes(l, 0), count_hexes(l, 1)};
  l->left = counts[1] < counts[0];
  hexcon_status status =
      growing_mesh_reserve(context, l->mesh, counts[l->left], 2 * l->front->node_count);
  if (!status)
    status = context_after(context, l->front->node_count);
  if (status)
    return status;
  mark_nodes(l);
  status = context_after(context, l->front->node_count);
  if (!status)
    status = number_points(context, l);
  if (!status)
    status = add_hexes(context, l);
  return status;
}

hexcon_status split_front_add_layer(hexcon_context *context, split_front *front, split_kind kind,
                                    const uint8_t *crossed, const uint8_t *sides,
                                    growing_mesh *mesh, size_t *starts, mean_points *points) {
  memset(points, 0, sizeof *points);
  split_layer l = {.front = front,
                   .kind = kind,
                   .crossed = crossed,
                   .sides = sides,
                   .nodes = context_allocate(context, front->node_count, 1),
                   .middle = context_allocate(context, front->node_count, sizeof *l.middle),
                   .inner = context_allocate(context, front->node_count, sizeof *l.inner),
                   .mesh = mesh,
                   .starts = starts,
                   .points = points};
  hexcon_status status =
      l.nodes && l.middle && l.inner ? build_layer(context, &l) : HEXCON_OUT_OF_MEMORY;
  if (!status) {
    int32_t *old = front->points;
    front->points = l.inner;
    l.inner = old;
  }
  context_free(context, l.nodes);
  context_free(context, l.middle);
  context_free(context, l.inner);
  return status;
}
