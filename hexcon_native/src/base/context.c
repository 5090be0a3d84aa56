/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "context.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "system_clock.h"

/** A budget may be overrun by so many seconds, or by this part of it: a little less than what is
 * promised, which leaves some time to hand the mesh over. */
static const double least_tolerance = 0.7, tolerance = 0.04;

static void *c_library_reallocate(void *user, void *memory, size_t size) {
  (void)user;
  if (size == 0) {
    free(memory);
    return NULL;
  }
  return realloc(memory, size);
}

hexcon_context *hexcon_context_new_with(hexcon_reallocate reallocate, void *user) {
  if (!reallocate)
    reallocate = c_library_reallocate;
  hexcon_context *context = reallocate(user, NULL, sizeof *context);
  if (!context)
    return NULL;
  memset(context, 0, sizeof *context);
  context->reallocate = reallocate;
  context->reallocate_user = user;
  return context;
}

hexcon_context *hexcon_context_new(void) {
  return hexcon_context_new_with(NULL, NULL);
}

void hexcon_context_free(hexcon_context *context) {
  if (context)
    context->reallocate(context->reallocate_user, context, 0);
}

void hexcon_context_set_progress(hexcon_context *context, hexcon_progress progress, void *user) {
  context->progress = progress;
  context->progress_user = user;
}

const char *hexcon_context_message(const hexcon_context *context) {
  return context->message;
}

size_t hexcon_context_elements(const hexcon_context *context, const int32_t **elements) {
  *elements = context->elements;
  return context->element_count;
}

void context_clear(hexcon_context *context) {
  context->element_count = 0;
  context->message[0] = '\0';
  context->figures[0] = '\0';
  context->stage = STAGE_CHECKS;
  context->fraction = 0;
}

void context_add_element(hexcon_context *context, int32_t element) {
  if (context->element_count < CONTEXT_MAX_ELEMENTS)
    context->elements[context->element_count++] = element;
}

hexcon_status context_fail(hexcon_context *context, hexcon_status status, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  (void)vsnprintf(context->message, sizeof context->message, format, arguments);
  va_end(arguments);
  return status;
}

void context_tell_mesh(hexcon_context *context, size_t hexes, size_t inverted, double worst) {
  char *figures = context->figures;
  const size_t size = sizeof context->figures;
  figures[0] = '\0';
  if (hexes > 0 && inverted > 0)
    (void)snprintf(figures, size, ", %zu of %zu hexes inverted", inverted, hexes);
  else if (hexes > 0 && isnan(worst))
    (void)snprintf(figures, size, ", %zu hexes", hexes);
  else if (hexes > 0)
    (void)snprintf(figures, size, ", %zu hexes, worst scaled Jacobian %.3f", hexes, worst);
}

bool context_report(hexcon_context *context, progress_stage stage, double fraction) {
  char words[sizeof context->figures + 64];
  context->stage = stage;
  context->fraction = fraction;
  if (!context->progress)
    return true;
  (void)snprintf(words, sizeof words, "%s%s", hexcon_progress_stage(stage)->name, context->figures);
  return context->progress(context->progress_user, words, fraction);
}

void context_limit(hexcon_context *context, double start, double budget) {
  context->budget = budget;
  context->deadline = budget > 0 ? start + budget : 0;
  context->reserve = context->rate = context->again = 0;
}

void context_reserve(hexcon_context *context, size_t hexes, bool finished) {
  const double needed = context->again + context->rate * (double)hexes;
  const bool fits = context->deadline > 0 && system_clock() + needed <= context->deadline;
  context->reserve = hexes > 0 && (fits || finished) ? needed : 0;
}

double context_be_brief(hexcon_context *context, double part) {
  const double deadline = context->deadline;
  if (deadline > 0)
    context->deadline = fmin(deadline, system_clock() + part * (deadline - system_clock()));
  context->left_out = 1 - part;
  return deadline;
}

void context_resume(hexcon_context *context, double deadline) {
  context->deadline = deadline;
  context->left_out = 0;
}

double context_patience(const hexcon_context *context) {
  return 1 - context->left_out;
}

void context_finish(hexcon_context *context) {
  context->reserve = -fmax(least_tolerance, tolerance * context->budget);
}

bool context_is_finishing(const hexcon_context *context) {
  return context->reserve < 0;
}

hexcon_status context_ask(hexcon_context *context) {
  return context_progress(context, context->stage, context->fraction);
}

hexcon_status context_progress(hexcon_context *context, progress_stage stage, double fraction) {
  const char *name = hexcon_progress_stage(stage)->name;
  if (!context_report(context, stage, fraction))
    return context_fail(context, HEXCON_CANCELLED, "cancelled during %s", name);
  if (context->deadline > 0 && system_clock() > context->deadline - context->reserve)
    return context_fail(context, HEXCON_OUT_OF_TIME,
                        "the time budget ran out during %s, before there was a mesh: allow more "
                        "time, or mesh with larger quads",
                        name);
  return HEXCON_OK;
}

void *context_grow(hexcon_context *context, void *memory, size_t count, size_t size) {
  if (count == 0)
    count = 1;
  void *grown = NULL;
  if (count <= SIZE_MAX / size)
    grown = context->reallocate(context->reallocate_user, memory, count * size);
  if (!grown)
    (void)context_fail(context, HEXCON_OUT_OF_MEMORY,
                       "out of memory: %zu items of %zu bytes; use a coarser surface or a machine "
                       "with more memory",
                       count, size);
  return grown;
}

void *context_allocate(hexcon_context *context, size_t count, size_t size) {
  return context_grow(context, NULL, count, size);
}

void *context_allocate_zeroed(hexcon_context *context, size_t count, size_t size) {
  void *memory = context_allocate(context, count, size);
  if (memory)
    memset(memory, 0, (count ? count : 1) * size);
  return memory;
}

void context_free(hexcon_context *context, void *memory) {
  if (memory)
    context->reallocate(context->reallocate_user, memory, 0);
}
