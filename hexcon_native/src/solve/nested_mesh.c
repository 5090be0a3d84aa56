/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "nested_mesh.h"

#include <math.h>
#include <string.h>

#include "construct/dice.h"
#include "construct/pillow.h"
#include "shape/nested_placement.h"
#include "shape/pillow_placement.h"
#include "surface/colouring.h"
#include "surface/star_center.h"

/** The ridge of a pair lies this part of the way to the centre, .. */
static const double ridge_share = 0.1;
/** .. all split layers together leave this part of it: alternative ones less uneven a front, as
 * some of its points never move; .. */
static const double left_by_layers[] = {[SPLIT_ORIGINAL] = 0.6, [SPLIT_ALTERNATIVE] = 0.8};
/** .. and Geodes go on so far; what they leave is for tetrahedra. */
static const double geode_share = 0.5;

static void find_mean(const surface *s, double center[3]) {
  memset(center, 0, 3 * sizeof *center);
  for (size_t i = 0; i < 3 * s->point_count; i++)
    center[i % 3] += s->points[i] / (double)s->point_count;
}

/** A torus has no star centre: its Euler characteristic tells without looking for one. */
static bool is_sphere(const surface *s) {
  return s->point_count == s->quad_count + 2;
}

static hexcon_status find_center(hexcon_context *context, const surface *s, double center[3],
                                 bool *star_shaped) {
  double margin = -1;
  hexcon_status status =
      is_sphere(s) ? surface_star_center(context, s, center, &margin) : HEXCON_OK;
  *star_shaped = margin > 0;
  if (!status && is_sphere(s) && !*star_shaped) /* flat corners do no harm here */
    status = surface_mean_center(context, s, center, &margin);
  if (!status && !(margin > 0))
    find_mean(s, center);
  *star_shaped = margin > 0;
  return status;
}

hexcon_status nested_mesh_new(hexcon_context *context, const surface *s, nested_mesh *out,
                              bool *star_shaped) {
  memset(out, 0, sizeof *out);
  out->grown.point_count = s->point_count;
  out->points = context_allocate(context, s->point_count, 3 * sizeof *out->points);
  if (!out->points)
    return HEXCON_OUT_OF_MEMORY;
  memcpy(out->points, s->points, 3 * s->point_count * sizeof *out->points);
  return find_center(context, s, out->center, star_shaped);
}

void nested_mesh_free(hexcon_context *context, nested_mesh *mesh) {
  context_free(context, mesh->points);
  context_free(context, mesh->grown.hexes);
  memset(mesh, 0, sizeof *mesh);
}

static hexcon_status grow_points(hexcon_context *context, nested_mesh *mesh) {
  double *grown =
      context_grow(context, mesh->points, mesh->grown.point_count, 3 * sizeof *mesh->points);
  if (!grown)
    return HEXCON_OUT_OF_MEMORY;
  mesh->points = grown;
  return HEXCON_OK;
}

/** Place a stage's points: those near the older ones, then the others, by their shares. */
static hexcon_status place(hexcon_context *context, nested_mesh *mesh, const mean_points *made,
                           double near_share, double far_share) {
  hexcon_status status = grow_points(context, mesh);
  if (status)
    return status;
  place_drawn_means(made->means, made->near_count, made->first, mesh->center, near_share,
                    mesh->points);
  place_drawn_means(made->means + 4 * made->near_count, made->count - made->near_count,
                    made->first + made->near_count, mesh->center, far_share, mesh->points);
  return HEXCON_OK;
}

hexcon_status nested_mesh_pair(hexcon_context *context, const surface *s, const int32_t *partner,
                               nested_mesh *mesh, paired_quads *out) {
  hexcon_status status = paired_transition_build(context, s, partner, &mesh->grown, out);
  return status ? status : place(context, mesh, &out->points, ridge_share, 0);
}

/* ------------------------------------------------------------------------------------ split layers
 */

static void mark_crossed(const surface *s, const surface_loops *loops, const int32_t *families,
                         int32_t family, uint8_t *crossed) {
  for (int32_t h = 0; h < (int32_t)(4 * s->quad_count); h++)
    crossed[h] = families[loops->loop_of_passage[surface_passage(h)]] == family;
}

static hexcon_status add_layer(hexcon_context *context, split_front *front, split_kind kind,
                               const uint8_t *crossed, uint8_t *sides, double share,
                               nested_mesh *mesh) {
  mean_points made = {0};
  size_t *starts =
      mesh->thin ? context_allocate(context, front->s->quad_count + 1, sizeof *starts) : NULL;
  hexcon_status status = surface_sides(context, front->s, crossed, sides);
  if (mesh->thin && !starts)
    status = HEXCON_OUT_OF_MEMORY;
  if (!status)
    status =
        split_front_add_layer(context, front, kind, crossed, sides, &mesh->grown, starts, &made);
  if (!status)
    status = place(context, mesh, &made, share / 2, share);
  if (!status && mesh->thin)
    status =
        thin_columns_go_down(context, mesh->thin, front->s, &mesh->grown, starts, front->points);
  context_free(context, made.means);
  context_free(context, starts);
  return status;
}

hexcon_status nested_mesh_split(hexcon_context *context, split_front *front, split_kind kind,
                                const surface_loops *loops, const int32_t *family_of_loop,
                                size_t family_count, nested_mesh *mesh, size_t *added) {
  uint8_t *crossed = context_allocate(context, front->s->quad_count, 4);
  uint8_t *sides = context_allocate(context, front->s->point_count, 1);
  hexcon_status status = crossed && sides ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  double share = 1 - pow(left_by_layers[kind], 1 / (double)family_count);
  for (size_t family = 0; !status && family < family_count; family++) {
    size_t before = mesh->grown.hex_count;
    status = context_progress(context, "split layers", (double)family / (double)family_count);
    mark_crossed(front->s, loops, family_of_loop, (int32_t)family, crossed);
    if (!status)
      status = add_layer(context, front, kind, crossed, sides, share, mesh);
    added[family] = mesh->grown.hex_count - before;
  }
  context_free(context, crossed);
  context_free(context, sides);
  return status;
}

/* ---------------------------------------------------------------------------------------- closures
 */

static void find_rows(const hex_template *t, const char *const labels[4], int rows[4]) {
  for (size_t i = 0; i < 4; i++)
    rows[i] = template_row(t, labels[i]);
}

/** Where the template's points lie over a quad. A template with an apex is a pyramid: there the
 * rays to the apex take the place of uprights.
 * @param depth  share of the way to the centre at its inner end */
static split_place *make_places(hexcon_context *context, const hex_template *t, bool pyramid,
                                double depth) {
  static const char *const corner_labels[] = {"B0", "B1", "B2", "B3"};
  static const char *const edge_labels[] = {"EB0", "EB1", "EB2", "EB3"};
  int corners[4], edges[4], middle = template_row(t, "Bc");
  find_rows(t, corner_labels, corners);
  find_rows(t, edge_labels, edges);
  split_place *places = context_allocate(context, t->point_count, sizeof *places);
  for (size_t row = 0; places && row < t->point_count; row++) {
    const double *at = t->points[row].place;
    double spread = pyramid && at[2] < 1 ? 1 / (1 - at[2]) : 1;
    const double local[3] = {0.5 + spread * (at[0] - 0.5), 0.5 + spread * (at[1] - 0.5), at[2]};
    places[row] = split_place_at(local, corners, edges, middle, depth);
  }
  return places;
}

static void add_template(const split_closure *c, const split_place *places, size_t quad,
                         int32_t *ids, nested_mesh *mesh) {
  const hex_template *t = c->shape;
  split_closure_points(c, quad, ids);
  for (size_t row = 0; row < t->point_count; row++)
    if (t->points[row].place[2] > 0)
      place_over_split_quad(&places[row], ids, ids[row], mesh->center, mesh->points);
  int32_t *hex = mesh->grown.hexes + 8 * mesh->grown.hex_count;
  mesh->grown.hex_count += t->hex_count;
  for (size_t h = 0; h < t->hex_count; h++, hex += 8)
    for (size_t i = 0; i < 8; i++)
      hex[i] = ids[t->hexes[h][i]];
}

/** A template over every quad. */
static hexcon_status add_templates(hexcon_context *context, const split_closure *c, double depth,
                                   nested_mesh *mesh) {
  size_t quads = c->front->s->quad_count;
  hexcon_status status = growing_mesh_reserve(context, &mesh->grown, quads * c->shape->hex_count,
                                              c->point_count - mesh->grown.point_count);
  mesh->grown.point_count = c->point_count;
  if (!status)
    status = grow_points(context, mesh);
  split_place *places = make_places(context, c->shape, c->has_apex, depth);
  int32_t *ids = context_allocate(context, c->shape->point_count, sizeof *ids);
  if (!places || !ids)
    status = HEXCON_OUT_OF_MEMORY;
  for (size_t q = 0; !status && q < quads; q++) {
    add_template(c, places, q, ids, mesh);
    if (q % 65536 == 0)
      status = context_progress(context, "closure", (double)q / (double)quads);
  }
  context_free(context, places);
  context_free(context, ids);
  return status;
}

hexcon_status nested_mesh_close_by_pyramids(hexcon_context *context, const split_front *front,
                                            nested_mesh *mesh) {
  split_closure c;
  hexcon_status status =
      split_closure_new(context, front, &template_pyramid_16, NULL, mesh->grown.point_count, &c);
  if (!status)
    status = add_templates(context, &c, 1, mesh);
  split_closure_free(context, &c);
  return status;
}

/** Two triangles of every quad's inner end, as dice wants them; a tetrahedron on each. */
typedef struct inner_triangles {
  int32_t *corners, *means, *side_middles, *tetrahedra;
} inner_triangles;

static void write_triangles(const split_closure *c, size_t quad, int32_t *ids, int32_t apex,
                            const inner_triangles *out) {
  static const char *const corners[2][3] = {{"T0", "T1", "T2"}, {"T0", "T2", "T3"}};
  static const char *const middles[2][3] = {{"ET0", "ET1", "N"}, {"N", "ET2", "ET3"}};
  static const char *const means[2] = {"Ga", "Gb"};
  split_closure_points(c, quad, ids);
  for (size_t k = 0; k < 2; k++) {
    size_t triangle = 2 * quad + k;
    out->means[triangle] = ids[template_row(c->shape, means[k])];
    for (size_t i = 0; i < 3; i++) {
      out->corners[3 * triangle + i] = ids[template_row(c->shape, corners[k][i])];
      out->side_middles[3 * triangle + i] = ids[template_row(c->shape, middles[k][i])];
      out->tetrahedra[4 * triangle + i] = out->corners[3 * triangle + i];
    }
    out->tetrahedra[4 * triangle + 3] = apex;
  }
}

/** Append diced tetrahedra and the centre, the point `apex`. */
static hexcon_status append_diced(hexcon_context *context, const inner_triangles *t, size_t count,
                                  int32_t apex, nested_mesh *mesh) {
  diced_triangles known = {count, t->corners, t->means, t->side_middles};
  diced_complex diced;
  size_t first = (size_t)apex + 1;
  hexcon_status status = dice(context, t->tetrahedra, count, &known, first, &diced);
  if (!status)
    status = growing_mesh_reserve(context, &mesh->grown, diced.hex_count, 1 + diced.point_count);
  if (!status) {
    mesh->grown.point_count = first + diced.point_count;
    status = grow_points(context, mesh);
  }
  if (!status) {
    memcpy(mesh->points + 3 * (size_t)apex, mesh->center, sizeof mesh->center);
    memcpy(mesh->grown.hexes + 8 * mesh->grown.hex_count, diced.hexes,
           8 * diced.hex_count * sizeof *diced.hexes);
    mesh->grown.hex_count += diced.hex_count;
    place_drawn_means(diced.means, diced.point_count, first, mesh->center, 0, mesh->points);
  }
  dice_free(context, &diced);
  return status;
}

static hexcon_status close_geodes(hexcon_context *context, const split_closure *c,
                                  nested_mesh *mesh) {
  size_t quads = c->front->s->quad_count, count = 2 * quads;
  int32_t apex = (int32_t)mesh->grown.point_count;
  inner_triangles t = {context_allocate(context, 3 * count, sizeof(int32_t)),
                       context_allocate(context, count, sizeof(int32_t)),
                       context_allocate(context, 3 * count, sizeof(int32_t)),
                       context_allocate(context, 4 * count, sizeof(int32_t))};
  int32_t *ids = context_allocate(context, c->shape->point_count, sizeof *ids);
  hexcon_status status = context_progress(context, "tetrahedra", 0);
  if (!t.corners || !t.means || !t.side_middles || !t.tetrahedra || !ids)
    status = HEXCON_OUT_OF_MEMORY;
  for (size_t q = 0; !status && q < quads; q++)
    write_triangles(c, q, ids, apex, &t);
  if (!status)
    status = append_diced(context, &t, count, apex, mesh);
  context_free(context, t.corners);
  context_free(context, t.means);
  context_free(context, t.side_middles);
  context_free(context, t.tetrahedra);
  context_free(context, ids);
  return status;
}

/** Take note of the Geodes' hexes in thin columns; `first_hex` is the first of all. */
static hexcon_status go_down_geodes(hexcon_context *context, const split_closure *c,
                                    size_t first_hex, nested_mesh *mesh) {
  const surface *s = c->front->s;
  size_t *starts = context_allocate(context, s->quad_count + 1, sizeof *starts);
  int32_t *ends = context_allocate(context, s->point_count, sizeof *ends);
  hexcon_status status = starts && ends ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  for (size_t q = 0; !status && q <= s->quad_count; q++)
    starts[q] = first_hex + c->shape->hex_count * q;
  for (size_t v = 0; !status && v < s->point_count; v++)
    ends[v] = (int32_t)(c->first_corner + v);
  if (!status)
    status = thin_columns_go_down(context, mesh->thin, s, &mesh->grown, starts, ends);
  context_free(context, starts);
  context_free(context, ends);
  return status;
}

hexcon_status nested_mesh_close_by_geodes(hexcon_context *context, const split_front *front,
                                          nested_mesh *mesh) {
  split_closure c = {0};
  size_t first_hex = mesh->grown.hex_count;
  uint8_t *turns = context_allocate(context, front->s->quad_count, 1);
  hexcon_status status =
      turns ? split_closure_choose_diagonals(context, front->s, turns) : HEXCON_OUT_OF_MEMORY;
  if (!status)
    status =
        split_closure_new(context, front, &template_geode_26, turns, mesh->grown.point_count, &c);
  if (!status)
    status = add_templates(context, &c, geode_share, mesh);
  if (!status && mesh->thin)
    status = go_down_geodes(context, &c, first_hex, mesh);
  if (!status)
    status = close_geodes(context, &c, mesh);
  split_closure_free(context, &c);
  context_free(context, turns);
  return status;
}

/* --------------------------------------------------------------------------------------- pillowing
 */

hexcon_status nested_mesh_pillow(hexcon_context *context, nested_mesh *mesh) {
  thin_columns *thin = mesh->thin;
  pillow_points copies = {0};
  hexcon_status status = thin_columns_sort_out(context, thin, mesh->grown.hex_count);
  if (!status)
    status =
        pillow_hexes(context, thin->hexes, thin->parts, thin->hex_count, &mesh->grown, &copies);
  if (!status)
    status = grow_points(context, mesh);
  if (!status)
    status = place_pillow(context, mesh->grown.hexes, thin->hexes, thin->hex_count,
                          copies.originals, copies.first, copies.count, mesh->points);
  context_free(context, copies.originals);
  return status;
}
