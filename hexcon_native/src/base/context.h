/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The context of a series of calls: last error, progress, allocation. */
#ifndef HEXCON_BASE_CONTEXT_H
#define HEXCON_BASE_CONTEXT_H

#include "hexcon.h"
#include "stages.h"

/* Of the C library that is linked: gcc takes Windows' for that of 1998, which knows no %zu. */
#ifdef __MINGW32__
#define CONTEXT_PRINTF gnu_printf
#else
#define CONTEXT_PRINTF printf
#endif

/** At most this many offending ids are kept; include/hexcon.h promises it. */
#define CONTEXT_MAX_ELEMENTS 1000

/** Every count of things that get an id must stay below this. */
#define CONTEXT_MAX_COUNT ((size_t)INT32_MAX)

struct hexcon_context {
  hexcon_progress progress;
  void *progress_user;
  hexcon_reallocate reallocate;
  void *reallocate_user;
  double deadline;      /**< by system_clock; 0: none */
  double budget;        /**< seconds; 0: none */
  double reserve;       /**< seconds before the deadline at which the work is stopped; see
                             context_reserve and context_finish */
  double rate;          /**< seconds that it takes to finish a hex: to measure and prove it */
  double left_out;      /**< part of its effort that a method had better spare; 0: none */
  double again;         /**< seconds of what was done to the surface, and is done again to finish */
  progress_stage stage; /**< told last; at first the checks */
  double fraction;      /**< told last */
  char figures[80];     /**< of the mesh at work, in words; "": none yet */
  size_t element_count;
  int32_t elements[CONTEXT_MAX_ELEMENTS];
  char message[512];
};

/** Forget the last error. Every public call starts with it. */
void context_clear(hexcon_context *context);

/** Add an offending id; ids beyond the limit are dropped. */
void context_add_element(hexcon_context *context, int32_t element);

/** Store the words (printf) of a fault and return its status. */
hexcon_status context_fail(hexcon_context *context, hexcon_status status, const char *format, ...)
    __attribute__((format(CONTEXT_PRINTF, 3, 4)));

/**
 * What is known of the mesh at work: progress says it after every stage's name from here on, until
 * another call. The only place that knows how.
 * @param hexes     0: nothing is said
 * @param inverted  hexes not proved positive
 * @param worst     scaled Jacobian, said where no hex is inverted; NAN: not known yet
 */
void context_tell_mesh(hexcon_context *context, size_t hexes, size_t inverted, double worst);

/** Tell the caller of a stage and of the mesh at work; false to cancel. */
bool context_report(hexcon_context *context, progress_stage stage, double fraction);

/** Report progress; HEXCON_CANCELLED if the user wants to stop, HEXCON_OUT_OF_TIME after the
 * deadline, with the error stored. */
hexcon_status context_progress(hexcon_context *context, progress_stage stage, double fraction);

/** Set the deadline, and what it takes to finish a hex, as far as known (0: nothing).
 * @param budget  seconds from `start`; 0: none */
void context_limit(hexcon_context *context, double start, double budget);

/**
 * A mesh of so many hexes is being made: stop early enough to prove it. Where the estimate says
 * that there is no time for that, what is finished is not worked on any more, so that the proof has
 * all that is left; and the rest goes on to the end: nothing is lost by it, and estimates are
 * rough.
 * @param hexes     0: none is, and there is nothing to stop for
 * @param finished  whether the mesh could be proved as it is
 */
void context_reserve(hexcon_context *context, size_t hexes, bool finished);

/** What is begun is worth this part of the usual effort, and of the time that is left, if there is
 * a deadline. @return the deadline, for context_resume */
double context_be_brief(hexcon_context *context, double part);

/** All the time is there again, and all the effort is worth while. */
void context_resume(hexcon_context *context, double deadline);

/** The part of its usual effort that what is being done is worth: 1, or what context_be_brief said.
 */
double context_patience(const hexcon_context *context);

/** Nothing more is begun: the time reserved is there to be used, and the tolerance of the budget
 * besides, a second or 5 %. */
void context_finish(hexcon_context *context);

/** Whether the time ran out, and what there is is only finished. */
bool context_is_finishing(const hexcon_context *context);

/** As context_progress, with the stage and the fraction that were told last. */
hexcon_status context_ask(hexcon_context *context);

/** Items that are worked on between two questions whether to go on: some milliseconds. */
#define CONTEXT_PATIENCE ((size_t)1 << 13)

/** In a loop over what may be many: ask after every CONTEXT_PATIENCE-th item. */
static inline hexcon_status context_pass(hexcon_context *context, size_t item) {
  return (item + 1) % CONTEXT_PATIENCE ? HEXCON_OK : context_ask(context);
}

/** Between short loops: ask if the one before was over many items. */
static inline hexcon_status context_after(hexcon_context *context, size_t items) {
  return items < CONTEXT_PATIENCE ? HEXCON_OK : context_ask(context);
}

/**
 * Allocate count items of size bytes, not initialised; count 0 gives a valid pointer.
 * @return NULL when out of memory or on overflow, with the error stored.
 */
void *context_allocate(hexcon_context *context, size_t count, size_t size);
/** As context_allocate, filled with zeros. */
void *context_allocate_zeroed(hexcon_context *context, size_t count, size_t size);
/** Grow an array; the old one stays valid when NULL is returned. */
void *context_grow(hexcon_context *context, void *memory, size_t count, size_t size);
/** NULL is allowed. */
void context_free(hexcon_context *context, void *memory);

#endif
