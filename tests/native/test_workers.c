/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Work shared out to threads: all of it done once, faults and cancellation heard of, the caller's
 * allocator and progress callback spared. Threads note what they see; only main asserts. */
#include <float.h>
#include <math.h>
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>

#ifdef _WIN32
#define WIN32_LEAN_AND_MEAN /* sockets have names of ours */
#include <windows.h>
#else
#include <threads.h>
#endif

#include "base/workers.h"
#include "support.h"

enum { MOST_THREADS = 8, MOST_ITEMS = 200 };

static const size_t counts[] = {0, 1, 2, 7, MOST_ITEMS};
enum { COUNTS = sizeof counts / sizeof *counts };

/** Let other threads run. */
static void yield(void) {
#ifdef _WIN32
  (void)SwitchToThread();
#else
  thrd_yield();
#endif
}

/** Another address in each thread. */
static const void *this_thread(void) {
  static _Thread_local char here;
  return &here;
}

/* ------------------------------------------------------------------------------------ all done */

typedef struct ledger {
  atomic_int done[MOST_ITEMS];
  atomic_int highest_worker;
  size_t fail_at; /* item, or SIZE_MAX */
} ledger;

static hexcon_status note_item(void *user, hexcon_context *context, int worker, size_t item) {
  ledger *l = user;
  atomic_fetch_add(&l->done[item], 1);
  int highest = atomic_load(&l->highest_worker);
  while (worker > highest && !atomic_compare_exchange_weak(&l->highest_worker, &highest, worker))
    ;
  if (item != l->fail_at)
    return HEXCON_OK;
  context_add_element(context, (int32_t)item);
  context_add_element(context, 77);
  return context_fail(context, HEXCON_NOT_SWEPT, "item %zu is not swept", item);
}

static void every_item_once(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  for (int threads = 1; threads <= MOST_THREADS; threads++)
    for (size_t c = 0; c < COUNTS; c++) {
      ledger l = {.fail_at = SIZE_MAX};
      assert_int_equal(workers_run(context, threads, counts[c], STAGE_MEASURING, note_item, &l),
                       HEXCON_OK);
      for (size_t i = 0; i < MOST_ITEMS; i++)
        assert_int_equal(l.done[i], i < counts[c]);
      assert_true(l.highest_worker < threads);
      assert_string_equal(hexcon_context_message(context), "");
    }
  hexcon_context_free(context);
}

static void count_of_threads(void **state) {
  (void)state;
  assert_int_equal(workers_count(3), 3);
  assert_int_equal(workers_count(WORKERS_MAX + 1), WORKERS_MAX);
  assert_in_range(workers_count(0), 1, WORKERS_MAX);
}

/* -------------------------------------------------------------------------------------- faults */

static void fault_arrives(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  for (int threads = 1; threads <= MOST_THREADS; threads++)
    for (size_t fail_at = 0; fail_at < MOST_ITEMS; fail_at += 61) {
      char words[64];
      (void)snprintf(words, sizeof words, "item %zu is not swept", fail_at);
      ledger l = {.fail_at = fail_at};
      context_clear(context);
      assert_int_equal(workers_run(context, threads, MOST_ITEMS, STAGE_MEASURING, note_item, &l),
                       HEXCON_NOT_SWEPT);
      assert_string_equal(hexcon_context_message(context), words);
      assert_elements(context, (int32_t[]){(int32_t)fail_at, 77}, 2);
      for (size_t i = 0; i < MOST_ITEMS; i++)
        assert_true(l.done[i] == 1 || (l.done[i] == 0 && i > fail_at));
      if (threads == 1)
        assert_int_equal(l.done[(fail_at + 1) % MOST_ITEMS], 0);
    }
  hexcon_context_free(context);
}

/** Two workers and the calling thread, in step: each holds one item. */
typedef struct meeting {
  atomic_bool asking; /* worker 1 asks whether to go on, until it is told not to */
  atomic_bool failed; /* worker 2 has */
} meeting;

static hexcon_status meet(void *user, hexcon_context *context, int worker, size_t item) {
  (void)item;
  meeting *m = user;
  hexcon_status status = HEXCON_OK;
  if (worker == 0)
    while (!atomic_load(&m->failed))
      yield();
  while (worker == 1 && !status) {
    status = context_progress(context, STAGE_MEASURING, 0.5);
    atomic_store(&m->asking, true);
  }
  if (worker == 2) {
    while (!atomic_load(&m->asking))
      yield();
    status = context_fail(context, HEXCON_NOT_SWEPT, "the fault itself");
    atomic_store(&m->failed, true);
  }
  return status;
}

/** A worker that stops because another failed does not hide why. */
static void fault_is_not_taken_for_cancellation(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  meeting m = {0};
  assert_int_equal(workers_run(context, 3, 3, STAGE_MEASURING, meet, &m), HEXCON_NOT_SWEPT);
  assert_string_equal(hexcon_context_message(context), "the fault itself");
  hexcon_context_free(context);
}

/* -------------------------------------------------------------------------------- cancellation */

typedef struct listener {
  const void *caller;
  int calls, cancel_at;
  bool wrong_thread, wrong_words;
} listener;

static bool listen(void *user, const char *stage, double fraction) {
  listener *l = user;
  l->wrong_thread |= this_thread() != l->caller;
  l->wrong_words |= strcmp(stage, "measuring, 64 hexes") != 0 || !(fraction >= 0 && fraction <= 1);
  return ++l->calls != l->cancel_at;
}

static hexcon_status ask(void *user, hexcon_context *context, int worker, size_t item) {
  (void)worker;
  hexcon_status status = HEXCON_OK;
  for (int i = 0; !status && i < 20; i++)
    status = context_progress(context, STAGE_UNTANGLING, (double)i / 20);
  atomic_fetch_add((atomic_size_t *)user, item + 1);
  yield();
  return status;
}

static void cancellation_from_the_calling_thread(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  for (int threads = 1; threads <= MOST_THREADS; threads++)
    for (int cancel_at = 0; cancel_at < 60; cancel_at += 6) {
      listener l = {.caller = this_thread(), .cancel_at = cancel_at};
      atomic_size_t sum = 0;
      context_clear(context);
      context_tell_mesh(context, 64, 0, NAN);
      hexcon_context_set_progress(context, listen, &l);
      hexcon_status status = workers_run(context, threads, MOST_ITEMS, STAGE_MEASURING, ask, &sum);
      bool cancelled =
          cancel_at > 0 && l.calls >= cancel_at; /* others may have done all the work */
      assert_int_equal(status, cancelled ? HEXCON_CANCELLED : HEXCON_OK);
      assert_true(!cancelled || l.calls == cancel_at);
      assert_true(cancelled || sum == (size_t)MOST_ITEMS * (MOST_ITEMS + 1) / 2);
      assert_false(l.wrong_thread || l.wrong_words);
      if (cancelled)
        assert_message(context);
    }
  hexcon_context_free(context);
}

static bool remember(void *user, const char *stage, double fraction) {
  (void)fraction;
  (void)snprintf(user, 100, "%s", stage);
  return true;
}

static void progress_tells_what_is_known_of_the_mesh(void **state) {
  (void)state;
  char told[100];
  hexcon_context *context = hexcon_context_new();
  hexcon_context_set_progress(context, remember, told);
  assert_int_equal(context_progress(context, STAGE_PAIRING, 0), HEXCON_OK);
  assert_string_equal(told, "pairing");
  context_tell_mesh(context, 4212, 0, NAN);
  assert_int_equal(context_progress(context, STAGE_PLACEMENT, 0), HEXCON_OK);
  assert_string_equal(told, "placement, 4212 hexes");
  context_tell_mesh(context, 4212, 17, -0.5);
  assert_int_equal(context_progress(context, STAGE_UNTANGLING, 0), HEXCON_OK);
  assert_string_equal(told, "untangling, 17 of 4212 hexes inverted");
  context_tell_mesh(context, 4212, 0, 0.3124);
  assert_int_equal(context_progress(context, STAGE_OPTIMISATION, 0), HEXCON_OK);
  assert_string_equal(told, "optimisation, 4212 hexes, worst scaled Jacobian 0.312");
  context_tell_mesh(context, SIZE_MAX, SIZE_MAX - 1, -DBL_MAX);
  assert_int_equal(context_progress(context, STAGE_JACOBIANS, 1), HEXCON_OK);
  assert_string_equal(told + strlen(told) - 15, " hexes inverted");
  context_clear(context);
  assert_int_equal(context_progress(context, STAGE_PAIRING, 0), HEXCON_OK);
  assert_string_equal(told, "pairing");
  hexcon_context_free(context);
}

/* ---------------------------------------------------------------------------------- allocation */

typedef struct fragile_memory {
  atomic_bool entered;
  atomic_int collisions;
  test_memory memory;
} fragile_memory;

/** Notices a second thread inside, and gives it time to come. */
static void *fragile_reallocate(void *user, void *memory, size_t size) {
  fragile_memory *f = user;
  if (atomic_exchange(&f->entered, true))
    atomic_fetch_add(&f->collisions, 1);
  yield();
  void *result = test_reallocate(&f->memory, memory, size);
  yield();
  atomic_store(&f->entered, false);
  return result;
}

static hexcon_status allocate(void *user, hexcon_context *context, int worker, size_t item) {
  (void)user, (void)worker;
  unsigned char *bytes = context_allocate(context, item + 1, 1);
  unsigned char *more = bytes ? context_grow(context, bytes, 2 * item + 2, 1) : NULL;
  if (more)
    memset(more, (int)item, 2 * item + 2);
  context_free(context, more ? more : bytes);
  return more ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

static void allocator_is_entered_by_one(void **state) {
  (void)state;
  for (int threads = 1; threads <= MOST_THREADS; threads++) {
    fragile_memory f = {0};
    hexcon_context *context = hexcon_context_new_with(fragile_reallocate, &f);
    assert_int_equal(workers_run(context, threads, MOST_ITEMS, STAGE_MEASURING, allocate, NULL),
                     HEXCON_OK);
    assert_int_equal(f.collisions, 0);
    assert_int_equal(f.memory.live, 1);
    hexcon_context_free(context);
  }
}

/** Any allocation fails, the caller's own or an item's. */
static void out_of_memory(void **state) {
  (void)state;
  for (int threads = 1; threads <= MOST_THREADS; threads++)
    for (size_t fail_at = 2; fail_at < 40; fail_at += 5) {
      fragile_memory f = {.memory = {.fail_at = fail_at}};
      hexcon_context *context = hexcon_context_new_with(fragile_reallocate, &f);
      assert_int_equal(workers_run(context, threads, MOST_ITEMS, STAGE_MEASURING, allocate, NULL),
                       HEXCON_OUT_OF_MEMORY);
      assert_message(context);
      assert_int_equal(f.collisions, 0);
      assert_int_equal(f.memory.live, 1);
      hexcon_context_free(context);
    }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(every_item_once),
      cmocka_unit_test(count_of_threads),
      cmocka_unit_test(fault_arrives),
      cmocka_unit_test(fault_is_not_taken_for_cancellation),
      cmocka_unit_test(cancellation_from_the_calling_thread),
      cmocka_unit_test(progress_tells_what_is_known_of_the_mesh),
      cmocka_unit_test(allocator_is_entered_by_one),
      cmocka_unit_test(out_of_memory),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
