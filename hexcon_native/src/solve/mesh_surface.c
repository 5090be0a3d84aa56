/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The public call that fills a surface. */
#include <math.h>
#include <string.h>

#include "embedding/embedding.h"
#include "hexmesh/scaled_jacobian.h"
#include "homology/odd_cycles.h"
#include "methods.h"
#include "solve/auto/mesh_auto.h"
#include "solve/common/mesh_pillow.h"
#include "solve/common/mesh_result.h"
#include "solve/proposal/mesh_proposal.h"
#include "surface/build.h"
#include "surface/numbering.h"
#include "surface/shells.h"
#include "verify/certificate.h"
#include "verify/curved_quality.h"

/** `auto` is no method to turn to: it hands every option on. */
static bool takes_layers(const hexcon_method_facts *facts) {
  return facts->layers && facts->method != HEXCON_METHOD_AUTO;
}

static bool takes_core(const hexcon_method_facts *facts) {
  return facts->core;
}

static bool takes_pairing(const hexcon_method_facts *facts) {
  return facts->pairing;
}

static bool takes_proposal(const hexcon_method_facts *facts) {
  return facts->proposal;
}

static bool takes_pillow(const hexcon_method_facts *facts) {
  return facts->pillow;
}

static bool fills_cavities(const hexcon_method_facts *facts) {
  return facts->cavities && !facts->topological && facts->method != HEXCON_METHOD_AUTO;
}

/** An option that only some methods take was given to another one. */
static hexcon_status refuse_option(hexcon_context *context, const char *option,
                                   method_predicate takes_it) {
  char methods[METHOD_LIST];
  method_list(takes_it, methods);
  return context_fail(context, HEXCON_BAD_ARGUMENT, "%s: only for method %s", option, methods);
}

static hexcon_status check_pairing_options(hexcon_context *context,
                                           const hexcon_mesh_options *options, bool takes) {
  if ((int)options->pairing < 0 || options->pairing >= HEXCON_PAIRING_COUNT)
    return context_fail(context, HEXCON_BAD_ARGUMENT, "there is no pairing number %d",
                        (int)options->pairing);
  if (options->pairing == HEXCON_PAIRING_GIVEN && options->pair_count > 0 && !options->pairs)
    return context_fail(context, HEXCON_BAD_ARGUMENT, "the given pairs are missing");
  if (options->pairing != HEXCON_PAIRING_ALL && !takes)
    return refuse_option(context, "a pairing", takes_pairing);
  return HEXCON_OK;
}

static hexcon_status check_options(hexcon_context *context, const hexcon_mesh_options *options) {
  const method_row *method = method_find(options->method);
  if (!method)
    return context_fail(context, HEXCON_BAD_ARGUMENT, "there is no method number %d",
                        (int)options->method);
  if (options->order < 0 || options->order > 2)
    return context_fail(context, HEXCON_BAD_ARGUMENT, "order %d: it must be 1 or 2",
                        options->order);
  if (options->layers < 0 || options->threads < 0)
    return context_fail(context, HEXCON_BAD_ARGUMENT,
                        "layers %d and threads %d must not be negative", options->layers,
                        options->threads);
  if (options->layers > 0 && !method->facts.layers)
    return refuse_option(context, "boundary layers", takes_layers);
  if (options->pillow < HEXCON_PILLOW_NEVER || options->pillow > HEXCON_PILLOW_MOST)
    return context_fail(context, HEXCON_BAD_ARGUMENT,
                        "pillow %d: it must be a number of sheets up to %d, or automatic, or never",
                        options->pillow, HEXCON_PILLOW_MOST);
  if (options->pillow > 0 && !method->facts.pillow)
    return refuse_option(context, "a pillow", takes_pillow);
  if (options->no_core && !method->facts.core)
    return refuse_option(context, "to refuse a core", takes_core);
  if (options->proposal && !method->facts.proposal)
    return refuse_option(context, "a proposal", takes_proposal);
  if (options->method == HEXCON_METHOD_PROPOSAL && !options->proposal)
    return context_fail(context, HEXCON_BAD_ARGUMENT, "method proposal needs proposed hexes");
  if (!(options->budget >= 0))
    return context_fail(context, HEXCON_BAD_ARGUMENT,
                        "the time budget must be a number of seconds, not below zero");
  return check_pairing_options(context, options, method->facts.pairing);
}

/* --------------------------------------------------------------------------- what can be filled */

static hexcon_status check_one_body(hexcon_context *context, const surface *s) {
  const size_t bodies = surface_body_count(s);
  if (bodies == 1)
    return HEXCON_OK;
  uint8_t *seen = context_allocate_zeroed(context, s->component_count, sizeof *seen);
  if (!seen)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t q = 0; q < s->quad_count; q++) {
    int32_t component = s->component_of_quad[q];
    if (!seen[component] && !s->is_cavity[component])
      context_add_element(context, (int32_t)q);
    seen[component] = 1;
  }
  context_free(context, seen);
  return context_fail(context, HEXCON_SEVERAL_COMPONENTS,
                      "the surface bounds %zu separate bodies, side by side or one in a cavity of "
                      "another (one quad of each outer shell listed); mesh them one by one",
                      bodies);
}

/** Erickson's theorem would allow an odd shell, if another one is odd too, but no construction here
 * joins quads of different shells. */
static hexcon_status check_even_shells(hexcon_context *context, const surface *s) {
  uint8_t *odd = context_allocate_zeroed(context, s->component_count, sizeof *odd);
  if (!odd)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t q = 0; q < s->quad_count; q++)
    odd[s->component_of_quad[q]] ^= 1;
  size_t count = 0;
  for (size_t q = 0; q < s->quad_count; q++)
    if (odd[s->component_of_quad[q]]) {
      odd[s->component_of_quad[q]] = 0;
      context_add_element(context, (int32_t)q);
      count++;
    }
  context_free(context, odd);
  if (count > 0)
    return context_fail(context, HEXCON_ODD,
                        "%zu of the surface's %zu shells have an odd number of quads (one quad of "
                        "each listed): a hex mesh may exist, but none that HexCon makes; change "
                        "the size a little",
                        count, s->component_count);
  return HEXCON_OK;
}

static hexcon_status check_even(hexcon_context *context, const surface *s) {
  if (s->quad_count % 2 == 0)
    return s->component_count > 1 ? check_even_shells(context, s) : HEXCON_OK;
  return context_fail(context, HEXCON_ODD,
                      "the surface has %zu quads, an odd number: no hex mesh has such a "
                      "boundary; change the size a little or subdivide the quads",
                      s->quad_count);
}

static hexcon_status refuse_odd_cycles(hexcon_context *context, const odd_cycles *found) {
  for (size_t i = 0; i < found->point_count; i++)
    context_add_element(context, found->points[i]);
  if (found->path_count == 1)
    return context_fail(context, HEXCON_NO_HEX_MESH,
                        "no hex mesh has this boundary: a closed path of %zu edges (its points "
                        "listed) bounds a surface inside and is odd; change the size so that it "
                        "becomes even",
                        found->point_count);
  return context_fail(context, HEXCON_NO_HEX_MESH,
                      "no hex mesh has this boundary: %zu closed paths (their points listed, path "
                      "after path) bound a surface inside together, and their %zu edges are an odd "
                      "number; change the size so that it becomes even",
                      found->path_count, found->point_count);
}

/** A method that fills no body may lay layers, under which any boundary can be left. */
static hexcon_status check_odd_cycles(hexcon_context *context, const surface *s,
                                      const hexcon_mesh_options *options,
                                      hexcon_fillable *fillable) {
  odd_cycles found;
  if (method_find(options->method)->facts.odd_paths)
    return HEXCON_OK;
  hexcon_status status = odd_cycles_find(context, s, &found);
  *fillable = found.fillable;
  if (!status && found.fillable == HEXCON_FILLABLE_NO)
    status = refuse_odd_cycles(context, &found);
  odd_cycles_free(context, &found);
  return status;
}

static hexcon_status refuse_embedding(hexcon_context *context, const hexcon_embedding *found) {
  for (size_t i = 0; i < 2 * found->pair_count; i++)
    context_add_element(context, found->pairs[i]);
  return context_fail(
      context, HEXCON_SELF_INTERSECTING,
      "the surface bounds no solid: %s (listed, pair after pair). Where a thin wall "
      "or a small radius is meshed too coarsely a smaller size helps",
      found->reason);
}

/** Quads that are folded, each by itself, are the methods' business: some say what is wrong there,
 * and topology does not care. */
static bool only_folds(const hexcon_embedding *found) {
  for (size_t i = 0; i < found->pair_count; i++)
    if (found->pairs[2 * i] != found->pairs[2 * i + 1])
      return false;
  return found->embedded == HEXCON_EMBEDDED_NO;
}

static hexcon_status check_embedding(hexcon_context *context, const surface *s,
                                     const hexcon_mesh_options *options) {
  hexcon_embedding found;
  if (options->allow_topological && method_find(options->method)->facts.topological)
    return HEXCON_OK;
  double start = mesh_clock();
  hexcon_status status =
      embedding_prove(context, s->points, s->point_count, s->quads, s->quad_count, &found);
  context->again = mesh_clock() - start; /* the certificate does it again */
  if (!status && found.embedded != HEXCON_EMBEDDED_YES && !only_folds(&found))
    status = refuse_embedding(context, &found);
  hexcon_embedding_free(context, &found);
  return status;
}

/** What any hex mesh of one body needs of its boundary, whatever its topology; see
 * check_odd_cycles.
 */
static hexcon_status check_body(hexcon_context *context, const surface *s,
                                const hexcon_mesh_options *options) {
  hexcon_status status = check_embedding(context, s, options);
  if (!status)
    status = check_one_body(context, s);
  return status ? status : check_even(context, s);
}

static hexcon_status check_cavities(hexcon_context *context, const surface *s,
                                    const hexcon_method_facts *method) {
  if (s->cavity_count == 0 || method->cavities)
    return HEXCON_OK;
  char others[METHOD_LIST];
  method_list(fills_cavities, others);
  return context_fail(context, HEXCON_NOT_A_BALL,
                      "the body has cavities, %zu in number: method %s fills bodies without any; "
                      "others may do: %s",
                      s->cavity_count, method->name, others);
}

/* -------------------------------------------------------------------------------------- filling */

/** The time for it has been reserved. */
static hexcon_status certify(hexcon_context *context, hexcon_mesh *mesh) {
  double start = mesh_clock();
  hexcon_status status =
      certificate_make(context, mesh->points, mesh->point_count, mesh->hexes, mesh->hex_count,
                       mesh->quads, mesh->quad_count, &mesh->certificate);
  mesh_note_seconds(mesh, "certificate", start);
  mesh->checked = true;
  return status;
}

/** Refuse what is not proved, unless it was never claimed or the caller wants it all the same. */
static hexcon_status judge(hexcon_context *context, const hexcon_mesh_options *options,
                           const hexcon_mesh *mesh) {
  const hexcon_certificate *c = &mesh->certificate;
  bool good = mesh->topological ? c->conforming && c->boundary_exact : c->certified;
  if (good || !mesh->checked || options->allow_uncertified)
    return HEXCON_OK;
  for (size_t i = 0; i < c->nonpositive_count; i++)
    context_add_element(context, c->nonpositive[i]);
  return context_fail(context, HEXCON_NOT_CERTIFIED,
                      "the mesh could not be certified: %zu of %zu hexes are not proved positive "
                      "(listed)%s%s%s; %s. Allow uncertified meshes to look at it",
                      c->nonpositive_count, mesh->hex_count,
                      c->conforming && c->proper ? "" : ", its complex is not proper",
                      c->boundary_exact ? "" : ", its boundary differs from the surface",
                      c->embedding.embedded == HEXCON_EMBEDDED_YES ? ""
                                                                   : ", its boundary is folded",
                      mesh->bound > 0 ? "a finer surface may help"
                                      : "the surface's own corners leave no room for a valid hex "
                                        "there");
}

static hexcon_status construct(hexcon_context *context, const surface *s,
                               const hexcon_mesh_options *options, hexcon_mesh *mesh) {
  const method_row *method = method_find(options->method);
  mesh->method = method->facts.name;
  mesh->topological = method->facts.topological;
  hexcon_status status = check_cavities(context, s, &method->facts);
  if (!status)
    status = method->fill(context, s, options, mesh);
  return status || !method->facts.pillow ? status : mesh_pillow(context, s, options, mesh);
}

/** Topological methods do not look at the quality on their way. */
static hexcon_status measure(hexcon_context *context, hexcon_mesh *mesh) {
  if (mesh->quality)
    return HEXCON_OK;
  mesh->quality = context_allocate(context, mesh->hex_count, sizeof *mesh->quality);
  if (!mesh->quality)
    return HEXCON_OUT_OF_MEMORY;
  hexcon_status status = HEXCON_OK;
  for (size_t h = 0; !status && h < mesh->hex_count; h++) {
    mesh->quality[h] = scaled_jacobian(mesh->points, mesh->hexes + 8 * h);
    status = context_pass(context, h);
  }
  return status;
}

/** The mesh to be proved, to the user with every stage; what is inverted is not known before. */
static void tell(hexcon_context *context, const hexcon_mesh *mesh) {
  double worst = 1;
  for (size_t h = 0; h < mesh->hex_count; h++)
    worst = fmin(worst, mesh->quality[h]);
  context_tell_mesh(context, mesh->hex_count, 0, worst);
}

/** Give the mesh the caller's ids, points and quads: before it is proved, so that the proof is of
 * what the caller gets. */
static hexcon_status name_as_given(hexcon_context *context, const numbering *names,
                                   hexcon_mesh *mesh) {
  hexcon_status status = HEXCON_OK;
  memcpy(mesh->points, names->given_points, 3 * names->point_count * sizeof *mesh->points);
  memcpy(mesh->quads, names->given_quads, 4 * names->quad_count * sizeof *mesh->quads);
  numbering_name_points(names, mesh->quads + 4 * names->quad_count,
                        4 * (mesh->quad_count - names->quad_count));
  for (size_t h = 0; !status && h < mesh->hex_count; h++) {
    numbering_name_points(names, mesh->hexes + 8 * h, 8);
    status = context_pass(context, h);
  }
  return status;
}

/** By one method, certified or not. */
static hexcon_status fill_by_method(hexcon_context *context, const surface *s,
                                    const hexcon_mesh_options *options, hexcon_mesh *mesh) {
  mesh->quad_count = s->quad_count;
  mesh->quads = context_allocate(context, 4 * s->quad_count, sizeof *mesh->quads);
  if (!mesh->quads)
    return HEXCON_OUT_OF_MEMORY;
  memcpy(mesh->quads, s->quads, 4 * s->quad_count * sizeof *mesh->quads);
  mesh_note(mesh, "turned outward", s->turned);
  context_reserve(context, 0, false);
  hexcon_status status = construct(context, s, options, mesh);
  context_finish(context);
  if (!status)
    status = name_as_given(context, s->names, mesh);
  if (status || options->skip_certificate)
    return status;
  status = measure(context, mesh);
  if (!status) {
    tell(context, mesh);
    status = certify(context, mesh);
    context_tell_mesh(context, 0, 0, NAN);
  }
  return status;
}

/** The mesh with straight edges that have points in their middles, which are rounded: so it is
 * proved again. */
static hexcon_status make_second_order(hexcon_context *context, const hexcon_mesh_options *options,
                                       hexcon_mesh *mesh) {
  double start = mesh_clock();
  hexcon_status status = mesh_raise_order(context, mesh);
  if (!status && mesh->checked && !mesh->topological) {
    hexcon_certificate_free(context, &mesh->certificate);
    status = certificate_make_second_order(context, mesh->points, mesh->point_count, mesh->hexes,
                                           mesh->hex_count, mesh->quads, mesh->quad_count,
                                           &mesh->certificate);
    if (!status)
      status = judge(context, options, mesh);
    if (!status)
      status = curved_qualities(context, mesh->points, mesh->hexes, mesh->hex_count, mesh->quality);
  }
  mesh_note_seconds(mesh, "second order", start);
  return status;
}

static hexcon_status fill_surface(hexcon_context *context, const surface *s,
                                  const hexcon_mesh_options *options, hexcon_mesh *mesh) {
  hexcon_mesh_options proving = *options;
  proving.skip_certificate = false;
  hexcon_status status = options->method == HEXCON_METHOD_AUTO
                             ? mesh_auto(context, s, &proving, fill_by_method, mesh)
                             : fill_by_method(context, s, options, mesh);
  if (!status)
    status = judge(context, options, mesh);
  return status || options->order != 2 ? status : make_second_order(context, options, mesh);
}

/** The points of an odd closed path are listed: say what it means for this body. */
static hexcon_status explain_colours(hexcon_context *context, hexcon_fillable fillable) {
  return context_fail(
      context, HEXCON_NOT_BIPARTITE,
      "the method needs points that can be coloured black and white along edges, "
      "but a closed path of an odd number of edges (its points listed) goes round a "
      "hole or a handle. %s; choose another size, so that the path becomes even, "
      "or quads for a sweep",
      fillable == HEXCON_FILLABLE_YES
          ? "It bounds nothing inside: the surface does have a hex mesh in "
            "principle, but not by this method"
          : "Whether the surface has a hex mesh at all could not be told");
}

/** Fill a surface that is numbered canonically. */
static hexcon_status mesh_numbered(hexcon_context *context, const surface *s,
                                   const hexcon_mesh_options *options, double start,
                                   hexcon_mesh *made) {
  hexcon_fillable fillable = HEXCON_FILLABLE_UNKNOWN;
  hexcon_status status = check_odd_cycles(context, s, options, &fillable);
  double checks = mesh_clock() - start;
  if (!status)
    status = fill_surface(context, s, options, made);
  if (status == HEXCON_NOT_BIPARTITE)
    status = explain_colours(context, fillable);
  mesh_note(made, "seconds checks", checks);
  return status;
}

/** With the caller's proposal in canonical points. */
static hexcon_status mesh_with_proposal(hexcon_context *context, const surface *s,
                                        const hexcon_mesh_options *options, double start,
                                        hexcon_mesh *made) {
  if (!options->proposal)
    return mesh_numbered(context, s, options, start, made);
  const size_t corners = 8 * options->proposal->hex_count;
  int32_t *ranks = context_allocate(context, s->point_count, sizeof *ranks);
  int32_t *hexes = context_allocate(context, corners, sizeof *hexes);
  hexcon_status status = ranks && hexes ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  hexcon_proposal proposal = *options->proposal;
  hexcon_mesh_options numbered = *options;
  if (!status) {
    numbering_rank_points(s->names, ranks);
    for (size_t i = 0; i < corners; i++) {
      int32_t given = proposal.hexes[i];
      hexes[i] = (size_t)given < s->point_count ? ranks[given] : given;
    }
    proposal.hexes = hexes;
    numbered.proposal = &proposal;
    status = mesh_numbered(context, s, &numbered, start, made);
  }
  context_free(context, ranks);
  context_free(context, hexes);
  return status;
}

/** With the caller's pairs in canonical quads. */
static hexcon_status mesh_with_pairs(hexcon_context *context, const surface *s,
                                     const hexcon_mesh_options *options, double start,
                                     hexcon_mesh *made) {
  const bool given = options->pairing == HEXCON_PAIRING_GIVEN;
  const size_t count = given ? options->pair_count : 0;
  int32_t *pairs = context_allocate(context, count, 2 * sizeof *pairs);
  if (!pairs)
    return HEXCON_OUT_OF_MEMORY;
  hexcon_mesh_options numbered = *options;
  numbered.pairs = pairs;
  numbering_rank_quads(s->names, options->pairs, 2 * count, pairs);
  hexcon_status status = mesh_with_proposal(context, s, &numbered, start, made);
  context_free(context, pairs);
  return status;
}

/** It takes so many times as long to measure, prove and hand over a hex as to read, check and
 * number a quad: measured at 10^4 to 10^6 quads. */
static const double rate_to_finish = 3.5;

/** Number the surface canonically and fill it. @param given its quads and adjacency go */
static hexcon_status mesh_built(hexcon_context *context, surface *given,
                                const hexcon_mesh_options *options, double start,
                                hexcon_mesh **mesh) {
  numbering names;
  surface s;
  hexcon_mesh *made = NULL;
  hexcon_status status = numbering_new(context, given, &names, &s);
  context->rate =
      rate_to_finish * (mesh_clock() - start - context->again) / (double)given->quad_count;
  surface_free(context, given);
  if (!status) {
    made = context_allocate_zeroed(context, 1, sizeof *made);
    status = made ? mesh_with_pairs(context, &s, options, start, made) : HEXCON_OUT_OF_MEMORY;
    numbering_name_elements(context, &names, status);
  }
  numbering_free(context, &names, &s);
  if (status)
    hexcon_mesh_free(context, made);
  else
    *mesh = made;
  return status;
}

hexcon_status hexcon_mesh_surface(hexcon_context *context, const double *points, size_t point_count,
                                  const int32_t *quads, size_t quad_count,
                                  const hexcon_mesh_options *options, hexcon_mesh **mesh) {
  context_clear(context);
  *mesh = NULL;
  hexcon_mesh_options chosen = options ? *options : (hexcon_mesh_options){0};
  hexcon_status status = check_options(context, &chosen);
  if (status)
    return status;
  surface given;
  double start = mesh_clock();
  context_limit(context, start, chosen.budget);
  status = surface_build(context, points, point_count, quads, quad_count, &given);
  if (!status)
    status = check_body(context, &given, &chosen);
  if (!status && chosen.proposal)
    status = proposal_check(context, chosen.proposal, point_count);
  if (!status)
    status = mesh_built(context, &given, &chosen, start, mesh);
  surface_free(context, &given);
  context_limit(context, start, 0);
  return status;
}
