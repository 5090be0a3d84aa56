/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The public call that fills a surface. */
#include <string.h>

#include "mesh_auto.h"
#include "mesh_cells.h"
#include "mesh_diced.h"
#include "mesh_result.h"
#include "mesh_sheets.h"
#include "mesh_shelling.h"
#include "mesh_smallest.h"
#include "mesh_swept.h"
#include "mesh_topological.h"
#include "surface/half_edges.h"
#include "verify/certificate.h"
#include "verify/scaled_jacobian.h"

static hexcon_status check_pairing_options(hexcon_context *context,
                                           const hexcon_mesh_options *options) {
  if ((int)options->pairing < 0 || options->pairing >= HEXCON_PAIRING_COUNT)
    return context_fail(context, HEXCON_BAD_ARGUMENT, "there is no pairing number %d",
                        (int)options->pairing);
  if (options->pairing == HEXCON_PAIRING_GIVEN && options->pair_count > 0 && !options->pairs)
    return context_fail(context, HEXCON_BAD_ARGUMENT, "the given pairs are missing");
  if (options->pairing != HEXCON_PAIRING_ALL && !method_is_topological(options->method))
    return context_fail(context, HEXCON_BAD_ARGUMENT,
                        "a pairing is for the topological methods: pyramid, geode and their like");
  return HEXCON_OK;
}

static hexcon_status check_options(hexcon_context *context, const hexcon_mesh_options *options) {
  if ((int)options->method < 0 || options->method >= HEXCON_METHOD_COUNT)
    return context_fail(context, HEXCON_BAD_ARGUMENT, "there is no method number %d",
                        (int)options->method);
  if (options->order < 0 || options->order > 2)
    return context_fail(context, HEXCON_BAD_ARGUMENT, "order %d: it must be 1 or 2",
                        options->order);
  if (options->layers < 0 || options->threads < 0)
    return context_fail(context, HEXCON_BAD_ARGUMENT,
                        "layers %d and threads %d must not be negative", options->layers,
                        options->threads);
  if (options->layers > 0 && options->method != HEXCON_METHOD_AUTO &&
      options->method != HEXCON_METHOD_CELLS)
    return context_fail(context, HEXCON_BAD_ARGUMENT,
                        "only cells have boundary layers: choose method cells");
  if (!(options->budget >= 0))
    return context_fail(context, HEXCON_BAD_ARGUMENT,
                        "the time budget must be a number of seconds, not below zero");
  return check_pairing_options(context, options);
}

/** One component with an even number of quads: what any hex mesh of one body needs. */
static hexcon_status check_fillable(hexcon_context *context, const surface *s) {
  if (s->component_count > 1) {
    int32_t next = 0;
    for (size_t q = 0; q < s->quad_count; q++)
      if (s->component_of_quad[q] == next) {
        context_add_element(context, (int32_t)q);
        next++;
      }
    return context_fail(context, HEXCON_SEVERAL_COMPONENTS,
                        "the surface has %zu separate parts (one quad of each listed); mesh them "
                        "one by one",
                        s->component_count);
  }
  if (s->quad_count % 2)
    return context_fail(context, HEXCON_ODD,
                        "the surface has %zu quads, an odd number: no hex mesh has such a "
                        "boundary; change the size a little or subdivide the quads",
                        s->quad_count);
  return HEXCON_OK;
}

/** What was made in time is proved, even after the deadline. */
static hexcon_status certify(hexcon_context *context, hexcon_mesh *mesh) {
  double start = mesh_clock(), deadline = context->deadline;
  context->deadline = 0;
  hexcon_status status =
      certificate_make(context, mesh->points, mesh->point_count, mesh->hexes, mesh->hex_count,
                       mesh->quads, mesh->quad_count, &mesh->certificate);
  mesh_note_seconds(mesh, "certificate", start);
  mesh->checked = true;
  context->deadline = deadline;
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
                      "(listed)%s%s; %s. Allow uncertified meshes to look at it",
                      c->nonpositive_count, mesh->hex_count,
                      c->conforming && c->proper ? "" : ", its complex is not proper",
                      c->boundary_exact ? "" : ", its boundary differs from the surface",
                      mesh->bound > 0 ? "a finer surface may help"
                                      : "the surface's own corners leave no room for a valid hex "
                                        "there");
}

static hexcon_status construct(hexcon_context *context, const surface *s,
                               const hexcon_mesh_options *options, hexcon_mesh *mesh) {
  mesh->topological = method_is_topological(options->method);
  if (mesh->topological)
    return mesh_topological(context, s, options, mesh);
  if (options->method == HEXCON_METHOD_SWEPT)
    return mesh_swept(context, s, mesh);
  if (options->method == HEXCON_METHOD_SHEETS)
    return mesh_sheets(context, s, options, mesh);
  if (options->method == HEXCON_METHOD_DICED)
    return mesh_diced(context, s, options, mesh);
  if (options->method == HEXCON_METHOD_SMALLEST)
    return mesh_smallest(context, s, options, mesh);
  if (options->method == HEXCON_METHOD_SHELLING)
    return mesh_shelling(context, s, options, mesh);
  return mesh_cells(context, s, options, mesh);
}

/** Topological methods do not look at the quality on their way. */
static hexcon_status measure(hexcon_context *context, hexcon_mesh *mesh) {
  if (mesh->quality)
    return HEXCON_OK;
  mesh->quality = context_allocate(context, mesh->hex_count, sizeof *mesh->quality);
  if (!mesh->quality)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t h = 0; h < mesh->hex_count; h++)
    mesh->quality[h] = scaled_jacobian(mesh->points, mesh->hexes + 8 * h);
  return HEXCON_OK;
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
  hexcon_status status = construct(context, s, options, mesh);
  if (status || options->skip_certificate)
    return status;
  status = measure(context, mesh);
  return status ? status : certify(context, mesh);
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
  if (!status && options->order == 2) {
    double start = mesh_clock();
    status = mesh_raise_order(context, mesh);
    mesh_note_seconds(mesh, "second order", start);
  }
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
  surface s;
  double start = mesh_clock();
  context->deadline = chosen.budget > 0 ? start + chosen.budget : 0;
  status = surface_build(context, points, point_count, quads, quad_count, &s);
  if (!status)
    status = check_fillable(context, &s);
  hexcon_mesh *made = status ? NULL : context_allocate_zeroed(context, 1, sizeof *made);
  if (!status && !made)
    status = HEXCON_OUT_OF_MEMORY;
  if (!status) {
    double checks = mesh_clock() - start;
    status = fill_surface(context, &s, &chosen, made);
    mesh_note(made, "seconds checks", checks);
  }
  surface_free(context, &s);
  context->deadline = 0;
  if (status)
    hexcon_mesh_free(context, made);
  else
    *mesh = made;
  return status;
}
