/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "nested_closure.h"

#include <string.h>

#include "construct/dice.h"
#include "construct/split_closure.h"
#include "solve/common/closure.h"

/** Geodes go on so far to the anchors; what they leave is for tetrahedra. */
static const double geode_share = 0.5;

/* --------------------------------------------------------------------------- a template a quad */

static void find_rows(const hex_template *t, const char *const labels[4], int rows[4]) {
  for (size_t i = 0; i < 4; i++)
    rows[i] = template_row(t, labels[i]);
}

/** Where the template's points lie over a quad. A template with an apex is a pyramid: there the
 * rays to the apex take the place of uprights.
 * @param depth  share of the way to the anchors at its inner end */
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
  anchors to = nested_mesh_anchors(mesh);
  split_closure_points(c, quad, ids);
  for (size_t row = 0; row < t->point_count; row++)
    if (t->points[row].place[2] > 0)
      place_over_split_quad(&places[row], ids, ids[row], &to, mesh->points);
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
    status = nested_mesh_grow_points(context, mesh);
  split_place *places = make_places(context, c->shape, c->has_apex, depth);
  int32_t *ids = context_allocate(context, c->shape->point_count, sizeof *ids);
  if (!places || !ids)
    status = HEXCON_OUT_OF_MEMORY;
  for (size_t q = 0; !status && q < quads; q++) {
    add_template(c, places, q, ids, mesh);
    if (q % CONTEXT_PATIENCE == 0)
      status = context_progress(context, STAGE_CLOSURE, (double)q / (double)quads);
  }
  context_free(context, places);
  context_free(context, ids);
  return status;
}

hexcon_status nested_mesh_close_by_pyramids(hexcon_context *context, const split_front *front,
                                            const hexcon_mesh_options *options, nested_mesh *mesh,
                                            size_t *tetrahedra) {
  split_closure c;
  (void)options;
  *tetrahedra = 0;
  hexcon_status status =
      split_closure_new(context, front, &template_pyramid_16, NULL, mesh->grown.point_count, &c);
  if (!status)
    status = add_templates(context, &c, 1, mesh);
  split_closure_free(context, &c);
  return status;
}

/** Two triangles of every quad's inner end, seen from the hexes, as dice wants them. */
typedef struct inner_triangles {
  size_t count;
  int32_t *corners, *means, *side_middles;
} inner_triangles;

static hexcon_status inner_triangles_new(hexcon_context *context, size_t quads,
                                         inner_triangles *out) {
  out->count = 2 * quads;
  out->corners = context_allocate(context, 3 * out->count, sizeof *out->corners);
  out->means = context_allocate(context, out->count, sizeof *out->means);
  out->side_middles = context_allocate(context, 3 * out->count, sizeof *out->side_middles);
  return out->corners && out->means && out->side_middles ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

static void inner_triangles_free(hexcon_context *context, inner_triangles *t) {
  context_free(context, t->corners);
  context_free(context, t->means);
  context_free(context, t->side_middles);
}

static void write_triangles(const split_closure *c, size_t quad, int32_t *ids,
                            const inner_triangles *out) {
  static const char *const corners[2][3] = {{"T0", "T2", "T1"}, {"T0", "T3", "T2"}};
  static const char *const middles[2][3] = {{"N", "ET1", "ET0"}, {"ET3", "ET2", "N"}};
  static const char *const means[2] = {"Ga", "Gb"};
  split_closure_points(c, quad, ids);
  for (size_t k = 0; k < 2; k++) {
    size_t triangle = 2 * quad + k;
    out->means[triangle] = ids[template_row(c->shape, means[k])];
    for (size_t i = 0; i < 3; i++) {
      out->corners[3 * triangle + i] = ids[template_row(c->shape, corners[k][i])];
      out->side_middles[3 * triangle + i] = ids[template_row(c->shape, middles[k][i])];
    }
  }
}

static hexcon_status list_triangles(hexcon_context *context, const split_closure *c,
                                    const inner_triangles *out) {
  int32_t *ids = context_allocate(context, c->shape->point_count, sizeof *ids);
  if (!ids)
    return HEXCON_OUT_OF_MEMORY;
  hexcon_status status = HEXCON_OK;
  for (size_t q = 0; !status && q < c->front->s->quad_count; q++) {
    write_triangles(c, q, ids, out);
    status = context_pass(context, q);
  }
  context_free(context, ids);
  return status;
}

/** The mesh's id of a tetrahedron's corner: the Geodes' inner corners come first, new ones last. */
static int32_t mesh_id(const split_closure *c, int32_t id) {
  size_t row = (size_t)id, corners = c->front->corner_count;
  return (int32_t)(row < corners ? c->first_corner + row : c->point_count + row - corners);
}

/** Append diced tetrahedra and the points that these brought. */
static hexcon_status append_diced(hexcon_context *context, const split_closure *c,
                                  const inner_triangles *t, const closure *inside,
                                  nested_mesh *mesh) {
  diced_triangles known = {t->count, t->corners, t->means, t->side_middles};
  diced_complex diced = {0};
  size_t first = c->point_count + inside->point_count;
  for (size_t i = 0; i < 4 * inside->tetrahedron_count; i++)
    inside->tetrahedra[i] = mesh_id(c, inside->tetrahedra[i]);
  hexcon_status status =
      dice(context, inside->tetrahedra, inside->tetrahedron_count, &known, first, &diced);
  if (!status)
    status = growing_mesh_reserve(context, &mesh->grown, diced.hex_count,
                                  inside->point_count + diced.point_count);
  if (!status) {
    mesh->grown.point_count = first + diced.point_count;
    status = nested_mesh_grow_points(context, mesh);
  }
  if (!status) {
    memcpy(mesh->points + 3 * c->point_count, inside->points,
           3 * inside->point_count * sizeof *inside->points);
    memcpy(mesh->grown.hexes + 8 * mesh->grown.hex_count, diced.hexes,
           8 * diced.hex_count * sizeof *diced.hexes);
    mesh->grown.hex_count += diced.hex_count;
    status = place_plain_means(context, diced.means, diced.point_count, first, mesh->points);
  }
  dice_free(context, &diced);
  return status;
}

static bool is_ball(const split_front *front) {
  return front->s->component_count == 1 && front->corner_count == front->s->quad_count + 2;
}

static hexcon_status fail_without_tetrahedra(hexcon_context *context,
                                             const hexcon_mesh_options *options) {
  return context_fail(context, HEXCON_NOT_A_BALL,
                      "the body has holes or cavities, and %s: between the Geodes it takes "
                      "tetrahedra that keep their triangles; %s",
                      options->tetrahedralise ? "no tetrahedra were found inside"
                                              : "no mesher of tetrahedra was given",
                      options->tetrahedralise
                          ? "thin parts may need smaller quads"
                          : "give one, or let method four-split build the layers alone");
}

/** A star from the centre where it sees the surface: two tetrahedra on each Geode, as in the paper.
 * Elsewhere the caller's tetrahedra. Where there are none, a ball's star is right in its topology,
 * however it overlaps; nothing else is. */
static hexcon_status find_tetrahedra(hexcon_context *context, const split_closure *c,
                                     const inner_triangles *t, const hexcon_mesh_options *options,
                                     const nested_mesh *mesh, closure *inside) {
  size_t corners = c->front->corner_count;
  bool found = false;
  int32_t *local = context_allocate(context, 3 * t->count, sizeof *local);
  hexcon_status status = local ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  for (size_t i = 0; local && i < 3 * t->count; i++)
    local[i] = t->corners[i] - (int32_t)c->first_corner;
  if (!status && !mesh->star_shaped)
    status = closure_tetrahedra(context, mesh->points + 3 * c->first_corner, corners, local,
                                t->count, options, inside, &found);
  if (!status && !found) {
    closure_free(context, inside);
    status = is_ball(c->front)
                 ? closure_star(context, corners, local, t->count, mesh->center, inside)
                 : fail_without_tetrahedra(context, options);
  }
  context_free(context, local);
  return status;
}

static hexcon_status close_geodes(hexcon_context *context, const split_closure *c,
                                  const hexcon_mesh_options *options, nested_mesh *mesh,
                                  size_t *tetrahedra) {
  inner_triangles t = {0};
  closure inside = {0};
  hexcon_status status = inner_triangles_new(context, c->front->s->quad_count, &t);
  if (!status)
    status = context_progress(context, STAGE_TETRAHEDRA, 0);
  if (!status)
    status = list_triangles(context, c, &t);
  if (!status)
    status = find_tetrahedra(context, c, &t, options, mesh, &inside);
  *tetrahedra = inside.tetrahedron_count;
  if (!status)
    status = append_diced(context, c, &t, &inside, mesh);
  closure_free(context, &inside);
  inner_triangles_free(context, &t);
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
                                          const hexcon_mesh_options *options, nested_mesh *mesh,
                                          size_t *tetrahedra) {
  split_closure c = {0};
  *tetrahedra = 0;
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
    status = close_geodes(context, &c, options, mesh, tetrahedra);
  split_closure_free(context, &c);
  context_free(context, turns);
  return status;
}
