/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "workers.h"

#include <stdatomic.h>
#include <string.h>
#include <threads.h>
#include <unistd.h>

typedef struct shared_work {
  hexcon_context *parent;
  mtx_t allocation; /* the caller's allocator need not be safe for threads */
  atomic_size_t next;
  atomic_bool stopped;
  size_t count;
  progress_stage stage;
  work_function work;
  void *user;
} shared_work;

typedef struct worker {
  shared_work *shared;
  int number;
  hexcon_status status;
  hexcon_context context;
} worker;

int workers_count(int wanted) {
  long processors = wanted > 0 ? wanted : sysconf(_SC_NPROCESSORS_ONLN);
  return processors < 1 ? 1 : processors > WORKERS_MAX ? WORKERS_MAX : (int)processors;
}

static void *locked_reallocate(void *user, void *memory, size_t size) {
  shared_work *shared = user;
  (void)mtx_lock(&shared->allocation);
  void *result = shared->parent->reallocate(shared->parent->reallocate_user, memory, size);
  (void)mtx_unlock(&shared->allocation);
  return result;
}

/** The calling thread asks the user; the others only hear of it. What an item says of itself is not
 * the user's concern: there are many. */
static bool report(void *user, const char *stage, double fraction) {
  (void)stage, (void)fraction;
  worker *w = user;
  shared_work *shared = w->shared;
  if (w->number > 0)
    return !atomic_load(&shared->stopped);
  size_t begun = atomic_load(&shared->next);
  begun = begun < shared->count ? begun : shared->count;
  return context_report(shared->parent, shared->stage, (double)begun / (double)shared->count);
}

static int run_worker(void *argument) {
  worker *w = argument;
  shared_work *shared = w->shared;
  while (!w->status && !atomic_load(&shared->stopped)) {
    size_t item = atomic_fetch_add(&shared->next, 1);
    if (item >= shared->count)
      break;
    w->status = shared->work(shared->user, &w->context, w->number, item);
  }
  if (w->status)
    atomic_store(&shared->stopped, true);
  return 0;
}

/** Faults of the calling thread come first: it alone knows of a real cancellation. */
static hexcon_status take_fault(hexcon_context *context, const worker *workers, int count) {
  const worker *found = NULL;
  for (int i = 0; i < count; i++)
    if (workers[i].status && (!found || (found->number > 0 && found->status == HEXCON_CANCELLED)))
      found = &workers[i];
  if (!found)
    return HEXCON_OK;
  memcpy(context->message, found->context.message, sizeof context->message);
  memcpy(context->elements, found->context.elements, sizeof context->elements);
  context->element_count = found->context.element_count;
  return found->status;
}

static void run_threads(shared_work *shared, worker *workers, int count) {
  thrd_t threads[WORKERS_MAX];
  int started = 1;
  for (int i = 0; i < count; i++) {
    workers[i].shared = shared;
    workers[i].number = i;
    workers[i].context.reallocate = locked_reallocate;
    workers[i].context.reallocate_user = shared;
    workers[i].context.progress = report;
    workers[i].context.progress_user = &workers[i];
    workers[i].context.deadline = shared->parent->deadline;
    workers[i].context.reserve = shared->parent->reserve;
    workers[i].context.budget = shared->parent->budget;
    workers[i].context.stage = shared->stage;
  }
  while (started < count &&
         thrd_create(&threads[started], run_worker, &workers[started]) == thrd_success)
    started++;
  (void)run_worker(&workers[0]);
  for (int i = 1; i < started; i++)
    (void)thrd_join(threads[i], NULL);
}

hexcon_status workers_run(hexcon_context *context, int threads, size_t count, progress_stage stage,
                          work_function work, void *user) {
  if ((size_t)threads > count)
    threads = count > 0 ? (int)count : 1;
  worker *workers = context_allocate_zeroed(context, (size_t)threads, sizeof *workers);
  if (!workers)
    return HEXCON_OUT_OF_MEMORY;
  shared_work shared = {
      .parent = context, .count = count, .stage = stage, .work = work, .user = user};
  atomic_init(&shared.next, 0);
  atomic_init(&shared.stopped, false);
  hexcon_status status = HEXCON_OUT_OF_MEMORY;
  if (mtx_init(&shared.allocation, mtx_plain) == thrd_success) {
    run_threads(&shared, workers, threads);
    mtx_destroy(&shared.allocation);
    status = take_fault(context, workers, threads);
  } else {
    (void)context_fail(context, HEXCON_OUT_OF_MEMORY, "no lock for %d threads", threads);
  }
  context_free(context, workers);
  return status;
}
