/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "mesh_topological.h"

#include <string.h>

#include "construct/paired_transition.h"
#include "nested_closure.h"
#include "pairing/given_pairs.h"
#include "pairing/pair_crossings.h"
#include "pairing/pairing.h"
#include "surface/build.h"
#include "surface/loop_families.h"

/** How each method goes on from the surface. */
typedef struct recipe {
  hexcon_status (*close)(hexcon_context *context, const split_front *front,
                         const hexcon_mesh_options *options, nested_mesh *mesh, size_t *tetrahedra);
  hexcon_method method;
  split_kind kind;
  bool pillows;
} recipe;

static const recipe recipes[] = {
    {NULL, HEXCON_METHOD_FOUR_SPLIT, SPLIT_ORIGINAL, false},
    {nested_mesh_close_by_pyramids, HEXCON_METHOD_PYRAMID, SPLIT_ORIGINAL, false},
    {nested_mesh_close_by_pyramids, HEXCON_METHOD_PYRAMID_ALT, SPLIT_ALTERNATIVE, false},
    {nested_mesh_close_by_geodes, HEXCON_METHOD_GEODE, SPLIT_ORIGINAL, false},
    {nested_mesh_close_by_geodes, HEXCON_METHOD_GEODE_ALT, SPLIT_ALTERNATIVE, false},
    {nested_mesh_close_by_geodes, HEXCON_METHOD_PILLOWED, SPLIT_ALTERNATIVE, true},
};

static const recipe *find_recipe(hexcon_method method) {
  for (size_t i = 0; i < sizeof recipes / sizeof *recipes; i++)
    if (recipes[i].method == method)
      return &recipes[i];
  return NULL;
}

/* ------------------------------------------------------------------------------------------
 * pairing */

static hexcon_status choose_pairs(hexcon_context *context, const surface *s,
                                  const hexcon_mesh_options *options, int32_t *partner) {
  size_t pair_count;
  switch (options->pairing) {
  case HEXCON_PAIRING_ALL:
    return surface_pair_across_single_edges(context, s, partner);
  case HEXCON_PAIRING_FEWEST:
    return surface_pair_crossings(context, s, partner, &pair_count);
  case HEXCON_PAIRING_GIVEN:
    return surface_read_pairs(context, s, options->pairs, options->pair_count, partner);
  default:
    memset(partner, -1, s->quad_count * sizeof *partner);
    return HEXCON_OK;
  }
}

/** The surface under the pairs, and how it comes from the given one. */
typedef struct paired_surface {
  int32_t *partner; /* [quad_count of the given one] a half-edge, -1: none */
  size_t pair_count;
  paired_quads made;
} paired_surface;

static void paired_surface_free(hexcon_context *context, paired_surface *paired) {
  context_free(context, paired->partner);
  paired_quads_free(context, &paired->made);
}

static size_t count_pairs(const int32_t *partner, size_t quad_count) {
  size_t paired = 0;
  for (size_t q = 0; q < quad_count; q++)
    paired += partner[q] >= 0;
  return paired / 2;
}

/** Pair, and lay the paired transition. @param out free with paired_surface_free, also after an
 * error */
static hexcon_status pair(hexcon_context *context, const surface *s,
                          const hexcon_mesh_options *options, nested_mesh *nested,
                          hexcon_mesh *mesh, paired_surface *out) {
  double start = mesh_clock();
  memset(out, 0, sizeof *out);
  out->partner = context_allocate(context, s->quad_count, sizeof *out->partner);
  hexcon_status status =
      out->partner ? choose_pairs(context, s, options, out->partner) : HEXCON_OUT_OF_MEMORY;
  mesh_note_seconds(mesh, "pairing", start);
  start = mesh_clock();
  if (!status) {
    out->pair_count = count_pairs(out->partner, s->quad_count);
    mesh_note(mesh, "pairs", (double)out->pair_count);
    status = nested_mesh_pair(context, s, out->partner, nested, &out->made);
  }
  mesh_note_hexes(mesh, HEXES_OF_PAIRED_TRANSITION, nested->grown.hex_count);
  mesh_note_seconds(mesh, "paired transition", start);
  return status;
}

/* ------------------------------------------------------------------------------------- split
 * layers */

/** More layers than this are told of together. */
enum { LAYERS_TOLD = 9 };

static void note_layers(hexcon_mesh *mesh, const size_t *added, size_t count) {
  mesh_note(mesh, "split layers", (double)count);
  size_t rest = 0;
  for (size_t layer = 0; layer < count; layer++) {
    if (layer + 1 < LAYERS_TOLD || count == LAYERS_TOLD)
      mesh_note_hexes_of_one(mesh, HEXES_OF_SPLIT_LAYER, layer + 1, added[layer]);
    else
      rest += added[layer];
  }
  if (rest > 0)
    mesh_note_hexes(mesh, HEXES_OF_FURTHER_LAYERS, rest);
}

static hexcon_status split_along(hexcon_context *context, split_front *front, split_kind kind,
                                 const surface_loops *loops, nested_mesh *nested,
                                 hexcon_mesh *mesh) {
  size_t family_count = 0;
  int32_t *families = context_allocate(context, loops->count, sizeof *families);
  size_t *added = context_allocate(context, loops->count, sizeof *added);
  hexcon_status status = families && added ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  if (!status)
    status = surface_loop_families(context, front->s, loops, families, &family_count);
  if (!status)
    status = nested_mesh_split(context, front, kind, loops, families, family_count, nested, added);
  if (!status)
    note_layers(mesh, added, family_count);
  context_free(context, families);
  context_free(context, added);
  return status;
}

static hexcon_status split(hexcon_context *context, split_front *front, split_kind kind,
                           nested_mesh *nested, hexcon_mesh *mesh) {
  double start = mesh_clock();
  surface_loops loops;
  hexcon_status status = surface_find_loops(context, front->s, &loops);
  if (!status)
    status = split_along(context, front, kind, &loops, nested, mesh);
  surface_loops_free(context, &loops);
  mesh_note_seconds(mesh, "split layers", start);
  return status;
}

/* ------------------------------------------------------------------------------------------
 * closure */

/** The front's quads, all split in four, seen from the hexes' outside. */
static hexcon_status append_front(hexcon_context *context, const split_front *front,
                                  hexcon_mesh *mesh) {
  const surface *s = front->s;
  size_t count = mesh->quad_count + 4 * s->quad_count;
  int32_t *quads = context_grow(context, mesh->quads, count, 4 * sizeof *quads);
  if (!quads)
    return HEXCON_OUT_OF_MEMORY;
  mesh->quads = quads;
  for (int32_t h = 0; h < (int32_t)(4 * s->quad_count); h++) {
    size_t before = split_edge_node(front, half_edge_turn(h, -1));
    size_t center = split_center_node(front, (size_t)half_edge_quad(h));
    const int32_t quad[4] = {front->points[half_edge_start(s, h)], front->points[before],
                             front->points[center], front->points[split_edge_node(front, h)]};
    memcpy(quads + 4 * mesh->quad_count++, quad, sizeof quad);
  }
  return HEXCON_OK;
}

static hexcon_status close(hexcon_context *context, const recipe *r, const split_front *front,
                           const hexcon_mesh_options *options, nested_mesh *nested,
                           hexcon_mesh *mesh) {
  double start = mesh_clock();
  size_t before = nested->grown.hex_count, tetrahedra = 0;
  hexcon_status status = r->close ? r->close(context, front, options, nested, &tetrahedra)
                                  : append_front(context, front, mesh);
  mesh_note(mesh, "four-split quads", (double)front->s->quad_count);
  mesh_note(mesh, "tetrahedra", (double)tetrahedra);
  mesh_note_hexes(mesh, HEXES_OF_CLOSURE, nested->grown.hex_count - before);
  mesh_note_seconds(mesh, "closure", start);
  return status;
}

static void hand_over(nested_mesh *nested, hexcon_mesh *mesh) {
  mesh->points = nested->points;
  mesh->hexes = nested->grown.hexes;
  mesh->point_count = nested->grown.point_count;
  mesh->hex_count = nested->grown.hex_count;
  mesh->order = 1;
  nested->points = NULL;
  nested->grown.hexes = NULL;
}

static hexcon_status pillow(hexcon_context *context, nested_mesh *nested, hexcon_mesh *mesh) {
  double start = mesh_clock();
  size_t before = nested->grown.hex_count;
  hexcon_status status = nested_mesh_pillow(context, nested);
  mesh_note_hexes(mesh, HEXES_OF_PILLOWS, nested->grown.hex_count - before);
  mesh_note_seconds(mesh, "pillows", start);
  return status;
}

/** All that comes after the pairing, under the quads that it left. */
static hexcon_status fill_coarse(hexcon_context *context, const recipe *r, const surface *coarse,
                                 const paired_quads *paired, const hexcon_mesh_options *options,
                                 nested_mesh *nested, hexcon_mesh *mesh) {
  split_front front = {0};
  thin_columns thin = {0};
  hexcon_status status = split_front_new(context, coarse, &front);
  if (!status && r->pillows) {
    status = thin_columns_find(context, coarse, paired->hexes, &thin);
    nested->thin = &thin;
  }
  if (!status)
    status = split(context, &front, r->kind, nested, mesh);
  if (!status)
    status = close(context, r, &front, options, nested, mesh);
  if (!status && r->pillows)
    status = pillow(context, nested, mesh);
  nested->thin = NULL;
  thin_columns_free(context, &thin);
  split_front_free(context, &front);
  return status;
}

static hexcon_status fill_inside(hexcon_context *context, const recipe *r,
                                 const paired_quads *paired, const hexcon_mesh_options *options,
                                 nested_mesh *nested, hexcon_mesh *mesh) {
  double start = mesh_clock();
  surface coarse;
  hexcon_status status = surface_build(context, NULL, nested->grown.point_count, paired->quads,
                                       paired->quad_count, &coarse);
  mesh_note_seconds(mesh, "paired surface", start);
  if (!status)
    status = fill_coarse(context, r, &coarse, paired, options, nested, mesh);
  surface_free(context, &coarse);
  return status;
}

/** Two quads alone have the same four corners, and a mesh knows a face by its corners. */
static hexcon_status check_distinct(hexcon_context *context, const surface *s) {
  if (s->quad_count > 2)
    return HEXCON_OK;
  context_add_element(context, 0);
  context_add_element(context, 1);
  return context_fail(
      context, HEXCON_UNFILLABLE_QUAD,
      "the surface is two quads (listed) with the same four corners: in a mesh both "
      "would be one face");
}

/** A star of tetrahedra, or of pyramids, closes balls only; tetrahedra of a mesher close anything.
 */
static hexcon_status check_closable(hexcon_context *context, const surface *s, const recipe *r,
                                    const hexcon_mesh_options *options, const char *method) {
  bool ball = surface_is_sphere(s);
  bool by_geodes = r->close == nested_mesh_close_by_geodes;
  if (!r->close || ball || (by_geodes && options->tetrahedralise))
    return HEXCON_OK;
  return context_fail(context, HEXCON_NOT_A_BALL,
                      "method %s fills bodies without holes and cavities only%s; this surface has "
                      "genus %zu and %zu parts: method four-split builds the layers under it, and "
                      "Geodes close it where a mesher of tetrahedra is given",
                      method, by_geodes ? " unless a mesher of tetrahedra is given" : "",
                      (2 * s->component_count + s->quad_count - s->point_count) / 2,
                      s->component_count);
}

/* ------------------------------------------------------------------- faults in the caller's terms
 */

/** A path over the paired quads becomes one over the surface: points of a pair go to the end of the
 * shared edge over which they lie, so that each step is along an edge, or none. */
static void list_surface_path(hexcon_context *context, size_t point_count, size_t pairs,
                              const int32_t *hexes) {
  size_t listed = context->element_count;
  context->element_count = 0;
  for (size_t i = 0; i < listed; i++) {
    int32_t point = paired_transition_end(point_count, pairs, hexes, context->elements[i]);
    size_t kept = context->element_count;
    if (kept == 0 || context->elements[kept - 1] != point)
      context_add_element(context, point);
  }
  size_t kept = context->element_count;
  if (kept > 1 && context->elements[0] == context->elements[kept - 1])
    context->element_count--;
}

/** No loop passes a quad of a pair twice: those listed come after them, and are the given ones of
 * no pair in their order. */
static void list_given_quads(hexcon_context *context, const surface *s,
                             const paired_surface *paired) {
  size_t listed = context->element_count;
  size_t after = paired->made.quad_count - (s->quad_count - 2 * paired->pair_count), next = 0;
  context->element_count = 0;
  for (size_t q = 0; q < s->quad_count && context->element_count < listed; q++) {
    if (paired->partner[q] >= 0)
      continue;
    if (context->elements[context->element_count] == (int32_t)(after + next++))
      context_add_element(context, (int32_t)q);
  }
}

static void name_fault(hexcon_context *context, hexcon_status status, const surface *s,
                       const paired_surface *paired, const nested_mesh *nested) {
  if (status == HEXCON_NO_SIDES)
    list_surface_path(context, s->point_count, paired->pair_count, nested->grown.hexes);
  if (status == HEXCON_SELF_CROSSING && paired->partner)
    list_given_quads(context, s, paired);
}

hexcon_status mesh_topological(hexcon_context *context, const surface *s,
                               const hexcon_mesh_options *options, hexcon_mesh *mesh) {
  const recipe *r = find_recipe(options->method);
  nested_mesh nested = {0};
  paired_surface paired = {0};
  hexcon_status status = check_distinct(context, s);
  if (!status)
    status = check_closable(context, s, r, options, mesh->method);
  if (!status)
    status = nested_mesh_new(context, s, &nested);
  if (!status)
    status = pair(context, s, options, &nested, mesh, &paired);
  if (!status)
    status = fill_inside(context, r, &paired.made, options, &nested, mesh);
  name_fault(context, status, s, &paired, &nested);
  paired_surface_free(context, &paired);
  if (!status) {
    mesh_log(mesh, "topological: conforming, but some Jacobians are zero or negative; no solver "
                   "should take it");
    if (!nested.star_shaped)
      mesh_log(mesh, "no point inside sees the whole surface: hexes may overlap");
    hand_over(&nested, mesh);
  }
  nested_mesh_free(context, &nested);
  return status;
}
