/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "mesh_auto.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/system_clock.h"
#include "solve/common/filled_mesh.h"
#include "solve/methods.h"

/** A method with the options of one of its tries. */
typedef struct candidate {
  const method_row *row;
  const hexcon_method_try *with;
  char name[48];
} candidate;

/** As good as the surface allows is good. */
static const double near_the_bound = 0.8;

static const mesh_taste preference = {
    .enough = 0.3, .clearly = 0.05, .clear_mean = 0.05, .fewer = true};

static double worst_of(const hexcon_mesh *mesh) {
  double worst = 1;
  for (size_t h = 0; h < mesh->hex_count; h++)
    worst = fmin(worst, mesh->quality[h]);
  return worst;
}

static double mean_of(const hexcon_mesh *mesh) {
  double mean = 0;
  for (size_t h = 0; h < mesh->hex_count; h++)
    mean += mesh->quality[h] / (double)mesh->hex_count;
  return mean;
}

/** What is not certified counts as inverted. */
static mesh_worth worth_of(const hexcon_mesh *mesh) {
  return (mesh_worth){mesh->certificate.certified ? 0 : 1, mesh->hex_count, worst_of(mesh),
                      mean_of(mesh)};
}

static bool is_better(const hexcon_mesh *a, const hexcon_mesh *b) {
  if (!b->hexes)
    return true;
  mesh_worth one = worth_of(a), other = worth_of(b);
  return mesh_worth_exceeds(&one, &other, &preference);
}

static void log_mesh(hexcon_mesh *told, const candidate *c, const hexcon_mesh *mesh) {
  char line[256];
  (void)snprintf(line, sizeof line, "%s: %zu hexes, scaled Jacobian min %.4f, mean %.4f, %s",
                 c->name, mesh->hex_count, worst_of(mesh), mean_of(mesh),
                 mesh->certificate.certified ? "certified" : "not certified");
  mesh_log(told, line);
}

static void log_fault(const hexcon_context *context, hexcon_mesh *told, const candidate *c) {
  char line[640];
  (void)snprintf(line, sizeof line, "%s: %s", c->name, context->message);
  mesh_log(told, line);
}

static bool is_good(const candidate *c, const hexcon_mesh *mesh) {
  double wanted = fmin(c->with->good_worst, near_the_bound * mesh->bound);
  return mesh->certificate.certified && worst_of(mesh) >= wanted &&
         (c->with->most_hexes == 0 || mesh->hex_count / mesh->quad_count <= c->with->most_hexes);
}

/** Give the best mesh's own log the account of what was tried. */
static void append_log(hexcon_mesh *told, const hexcon_mesh *best) {
  char line[MAX_LOG];
  size_t length = 0;
  for (size_t i = 0; i < best->log_length; i++) {
    line[length++] = best->log[i];
    if (best->log[i] == '\n') {
      line[length - 1] = '\0';
      mesh_log(told, line);
      length = 0;
    }
  }
}

/** Try one method. @param good receives whether no other is needed */
static hexcon_status try_candidate(hexcon_context *context, const surface *s,
                                   const hexcon_mesh_options *options, method_function fill,
                                   const candidate *c, hexcon_mesh *told, hexcon_mesh *best,
                                   bool *good) {
  hexcon_mesh_options chosen = *options;
  hexcon_mesh *made = context_allocate_zeroed(context, 1, sizeof *made);
  if (!made)
    return HEXCON_OUT_OF_MEMORY;
  chosen.method = c->row->facts.method;
  chosen.no_core = c->with->no_core;
  context_clear(context);
  hexcon_status status = fill(context, s, &chosen, made);
  if (status) {
    log_fault(context, told, c);
  } else {
    log_mesh(told, c, made);
    if (is_better(made, best)) {
      mesh_clear(context, best);
      *best = *made;
      *made = (hexcon_mesh){0};
    }
  }
  *good = best->hexes && is_good(c, best);
  hexcon_mesh_free(context, made);
  return status;
}

/** Part of the usual effort that a further method is worth: what it can still win of the worst
 * scaled Jacobian, after a certified mesh; but some, as it may win by its mean or fewer hexes. */
static double worth_of_a_try(const hexcon_mesh *best) {
  const double least = 0.1;
  double enough = fmin(preference.enough, near_the_bound * best->bound);
  if (!best->hexes || !best->certificate.certified)
    return 1;
  return enough > 0 ? fmax(least, 1 - worst_of(best) / enough) : least;
}

/** Whether the time is up for all, and not for one try alone. */
static bool is_time_up(const hexcon_context *context) {
  return context->deadline > 0 && system_clock() >= context->deadline;
}

/** @return whether there is one */
static bool find_candidate(int turn, candidate *c) {
  c->with = method_try_of_turn(turn, &c->row);
  if (!c->with)
    return false;
  const char *core = c->row->facts.core && !c->with->no_core ? " and a core" : "";
  (void)snprintf(c->name, sizeof c->name, "%s%s", c->row->facts.name, core);
  return true;
}

static void explain(hexcon_mesh *told, const hexcon_mesh *best, bool good) {
  char line[160];
  (void)snprintf(line, sizeof line, "chosen: %s, %s", best->method,
                 !best->certificate.certified ? "though it is not certified"
                 : good                       ? "good enough"
                                              : "the best of these");
  mesh_log(told, line);
}

hexcon_status mesh_auto(hexcon_context *context, const surface *s,
                        const hexcon_mesh_options *options, method_function fill,
                        hexcon_mesh *mesh) {
  hexcon_mesh *told = context_allocate_zeroed(context, 1, sizeof *told);
  if (!told)
    return HEXCON_OUT_OF_MEMORY;
  hexcon_status status = HEXCON_OK;
  bool good = false;
  candidate c;
  for (int turn = 1; !good && find_candidate(turn, &c); turn++) {
    if ((options->layers > 0 && !c.row->facts.layers) ||
        (c.row->facts.proposal && !options->proposal))
      continue;
    double deadline = context_be_brief(context, worth_of_a_try(mesh));
    status = try_candidate(context, s, options, fill, &c, told, mesh, &good);
    context_resume(context, deadline);
    if (status == HEXCON_OUT_OF_TIME && !is_time_up(context))
      continue;
    if (status && !fault_is_about_method(status))
      break;
  }
  if (mesh->hexes && (fault_is_about_method(status) || status == HEXCON_OUT_OF_TIME)) {
    status = HEXCON_OK;
    context_clear(context);
    explain(told, mesh, good);
    append_log(told, mesh);
    memcpy(mesh->log, told->log, sizeof mesh->log);
    mesh->log_length = told->log_length;
  }
  hexcon_mesh_free(context, told);
  return status;
}
