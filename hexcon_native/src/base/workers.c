/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "workers.h"

#include <stdatomic.h>
#include <string.h>

#include "system_threads.h"

typedef struct shared_work {
  hexcon_context *parent;
  system_lock allocation; /* the caller's allocator need not be safe for threads */
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
  long processors = wanted > 0 ? wanted : system_processors();
  return processors < 1 ? 1 : processors > WORKERS_MAX ? WORKERS_MAX : (int)processors;
}

static void *locked_reallocate(void *user, void *memory, size_t size) {
  shared_work *shared = user;
  system_lock_take(&shared->allocation);
  void *result = shared->parent->reallocate(shared->parent->reallocate_user, memory, size);
  system_lock_give(&shared->allocation);
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

static void run_worker(void *argument) {
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
  system_thread threads[WORKERS_MAX];
  system_task tasks[WORKERS_MAX];
  int started = 1;
  for (int i = 0; i < count; i++) {
    workers[i].shared = shared;
    workers[i].number = i;
    tasks[i] = (system_task){run_worker, &workers[i]};
    workers[i].context.reallocate = locked_reallocate;
    workers[i].context.reallocate_user = shared;
    workers[i].context.progress = report;
    workers[i].context.progress_user = &workers[i];
    workers[i].context.deadline = shared->parent->deadline;
    workers[i].context.reserve = shared->parent->reserve;
    workers[i].context.budget = shared->parent->budget;
    workers[i].context.stage = shared->stage;
  }
  while (started < count && system_thread_start(&threads[started], &tasks[started]))
    started++;
  run_worker(&workers[0]);
  for (int i = 1; i < started; i++)
    system_thread_join(threads[i]);
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
  if (system_lock_begin(&shared.allocation)) {
    run_threads(&shared, workers, threads);
    system_lock_end(&shared.allocation);
    status = take_fault(context, workers, threads);
  } else {
    (void)context_fail(context, HEXCON_OUT_OF_MEMORY, "no lock for %d threads", threads);
  }
  context_free(context, workers);
  return status;
}
