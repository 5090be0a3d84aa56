/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Every stage asks whether to go on, the oftener the larger the surface; whenever the answer is
 * no, and whenever the time is up, the call ends at once and leaves nothing behind. */
#include <stdlib.h>
#include <string.h>

#include "base/context.h"
#include "base/sorting.h"
#include "base/system_clock.h"
#include "support.h"

typedef struct asked {
  size_t calls, stop_at; /* 0: never */
  char last[32];
} asked;

static bool answer(void *user, const char *stage, double fraction) {
  asked *a = user;
  assert_true(fraction >= 0 && fraction <= 1);
  strncpy(a->last, stage, sizeof a->last - 1);
  return ++a->calls != a->stop_at;
}

static hexcon_status fill(const test_mesh *s, hexcon_method method, double budget, asked *a) {
  test_memory memory = {0};
  hexcon_context *context = hexcon_context_new_with(test_reallocate, &memory);
  const hexcon_mesh_options options = {.method = method, .budget = budget, .threads = 1};
  hexcon_mesh *mesh = NULL;
  hexcon_context_set_progress(context, answer, a);
  hexcon_status status = hexcon_mesh_surface(context, s->points, s->surface_point_count, s->quads,
                                             s->quad_count, &options, &mesh);
  if (status)
    assert_null(mesh);
  if (status == HEXCON_CANCELLED || status == HEXCON_OUT_OF_TIME)
    assert_message(context);
  hexcon_mesh_free(context, mesh);
  hexcon_context_free(context);
  assert_int_equal(memory.live, 0);
  return status;
}

static const hexcon_method methods[] = {HEXCON_METHOD_SWEPT, HEXCON_METHOD_SHEETS,
                                        HEXCON_METHOD_DICED, HEXCON_METHOD_PYRAMID,
                                        HEXCON_METHOD_PILLOWED};
enum { METHODS = sizeof methods / sizeof *methods };

/** A flat box: one hex thick, so that it has few hexes for its many quads. */
static test_mesh make_plate(int n) {
  return make_box(n, n, 1);
}

static void asks_grow_with_the_surface(void **state) {
  (void)state;
  test_mesh small = make_plate(8), large = make_plate(64), larger = make_plate(128);
  for (int m = 0; m < 2; m++) { /* swept, and recognition alone: what is diced is not found */
    asked few = {0}, more = {0}, most = {0};
    const hexcon_method method = m ? HEXCON_METHOD_DICED : HEXCON_METHOD_SWEPT;
    hexcon_status status = fill(&small, method, 0, &few);
    assert_int_equal(fill(&large, method, 0, &more), status);
    assert_int_equal(fill(&larger, method, 0, &most), status);
    print_message("method %d: %zu, %zu, %zu calls\n", (int)method, few.calls, more.calls,
                  most.calls);
    assert_true(few.calls < more.calls && 2 * more.calls < most.calls);
  }
  test_mesh_free(&small);
  test_mesh_free(&large);
  test_mesh_free(&larger);
}

/** Some of the calls, from the first on: between them, each is some thousands of items' work. */
static void every_stage_can_be_cancelled(void **state) {
  (void)state;
  test_mesh plate = make_plate(48);
  uint64_t random = 1;
  for (int m = 0; m < METHODS; m++) {
    asked all = {.stop_at = 400};
    (void)fill(&plate, methods[m], 0, &all);
    for (size_t k = 1, step; k < all.calls; k += step) {
      asked some = {.stop_at = k};
      assert_int_equal(fill(&plate, methods[m], 0, &some), HEXCON_CANCELLED);
      assert_int_equal(some.calls, k); /* not asked again */
      step = 1 + k / 4 + random_below(&random, 4);
    }
  }
  test_mesh_free(&plate);
}

/** Too little for anything, however fast the machine is. */
static void no_time_at_all(void **state) {
  (void)state;
  test_mesh plate = make_plate(48);
  for (int m = 0; m < METHODS; m++) {
    asked a = {0};
    assert_int_equal(fill(&plate, methods[m], 1e-9, &a), HEXCON_OUT_OF_TIME);
    assert_int_equal(a.calls, 1);
  }
  test_mesh_free(&plate);
}

/** A reserve brings the end forward, finishing puts it off. */
static void reserves(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  double now = system_clock();
  context_limit(context, now - 50, 100); /* half of it is gone */
  context->rate = 1e-3;
  assert_int_equal(context_ask(context), HEXCON_OK);
  context_reserve(context, 45000, false); /* 45 s: more than half of the budget, and there are 50 */
  assert_close(context->reserve, 45, 1e-9);
  assert_int_equal(context_ask(context), HEXCON_OK);
  context_reserve(context, 1000000, false); /* more than there is: to the end */
  assert_close(context->reserve, 0, 1e-9);
  assert_int_equal(context_ask(context), HEXCON_OK);
  context_reserve(context, 1000000, true); /* what there is can only be proved at once */
  assert_int_equal(context_ask(context), HEXCON_OUT_OF_TIME);
  context_reserve(context, 0, true);
  assert_int_equal(context_ask(context), HEXCON_OK);
  context_limit(context, now - 100.5, 100);
  assert_int_equal(context_ask(context), HEXCON_OUT_OF_TIME);
  context_finish(context); /* 4 s more */
  assert_int_equal(context_ask(context), HEXCON_OK);
  context_limit(context, now - 1000, 100);
  context_finish(context);
  assert_int_equal(context_ask(context), HEXCON_OUT_OF_TIME);
  context_limit(context, now, 0);
  context_finish(context);
  assert_int_equal(context_ask(context), HEXCON_OK);
  hexcon_context_free(context);
}

/** A part of the time that is left, and of the effort, until all is there again. */
static void brief_tries(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  assert_close(context_patience(context), 1, 0);
  double deadline = context_be_brief(context, 0.25); /* there is no end: no other comes of it */
  assert_close(context->deadline, 0, 0);
  assert_close(context_patience(context), 0.25, 1e-15);
  context_resume(context, deadline);
  assert_close(context_patience(context), 1, 0);
  double now = system_clock();
  context_limit(context, now, 1000);
  deadline = context_be_brief(context, 0.25);
  assert_true(context->deadline > now + 240 && context->deadline < now + 260);
  context_resume(context, deadline);
  assert_close(context->deadline, now + 1000, 1e-6);
  hexcon_context_free(context);
}

static int compare(const void *a, const void *b) {
  const int32_t one = *(const int32_t *)a, other = *(const int32_t *)b;
  return (one > other) - (one < other);
}

static void sorting(void **state) {
  (void)state;
  static const size_t counts[] = {0, 1, 2, 1000, 65536, 65537, 200000, 400001};
  uint64_t random = 5;
  for (size_t c = 0; c < sizeof counts / sizeof *counts; c++) {
    const size_t count = counts[c];
    int32_t *items = malloc((count + 1) * sizeof *items),
            *expected = malloc((count + 1) * sizeof *items);
    for (size_t i = 0; i < count; i++)
      items[i] = expected[i] = (int32_t)random_below(&random, count);
    qsort(expected, count, sizeof *items, compare);
    hexcon_context *context = hexcon_context_new();
    int64_t sum = 0;
    for (size_t stop = 3; stop < 40 && count > 65536; stop += 9) { /* all are still there */
      int64_t left = 0;
      asked once = {.stop_at = stop};
      hexcon_context_set_progress(context, answer, &once);
      hexcon_status status = context_sort(context, items, count, sizeof *items, compare);
      assert_int_equal(status, once.calls < stop ? HEXCON_OK : HEXCON_CANCELLED);
      for (size_t i = 0; i < count; i++)
        left += items[i] - expected[i];
      sum |= left;
    }
    assert_true(sum == 0);
    hexcon_context_set_progress(context, NULL, NULL);
    assert_int_equal(context_sort(context, items, count, sizeof *items, compare), HEXCON_OK);
    assert_memory_equal(items, expected, count * sizeof *items);
    hexcon_context_free(context);
    free(items);
    free(expected);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(asks_grow_with_the_surface),
                                     cmocka_unit_test(every_stage_can_be_cancelled),
                                     cmocka_unit_test(no_time_at_all),
                                     cmocka_unit_test(reserves),
                                     cmocka_unit_test(brief_tries),
                                     cmocka_unit_test(sorting)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
