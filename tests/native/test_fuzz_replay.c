/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** What libFuzzer has found, and as much again by chance: replayed without clang. */
#include <dirent.h>
#include <stdio.h>
#include <string.h>

#include "fuzz_call.h"
#include "support.h"

enum { MOST_BYTES = 4096, LEAST_FILES = 20, RANDOM_CALLS = 1500, CALL_COUNT = 11, MESHING = 9 };

/** fuzz_call aborts where something does not hold. */
static void corpus(void **state) {
  (void)state;
  DIR *folder = opendir(FUZZ_CORPUS);
  size_t files = 0;
  assert_non_null(folder);
  for (struct dirent *entry = readdir(folder); entry; entry = readdir(folder)) {
    char path[1024];
    uint8_t bytes[MOST_BYTES];
    if (entry->d_name[0] == '.')
      continue;
    assert_true(snprintf(path, sizeof path, "%s/%s", FUZZ_CORPUS, entry->d_name) <
                (int)sizeof path);
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    size_t size = fread(bytes, 1, sizeof bytes, file);
    assert_int_equal(fclose(file), 0);
    print_message("%s\n", entry->d_name);
    fuzz_call(bytes, size);
    files++;
  }
  assert_int_equal(closedir(folder), 0);
  assert_true(files >= LEAST_FILES);
}

/** All calls but meshing, which is slow, and has test_fuzz. */
static void random_calls(void **state) {
  (void)state;
  uint64_t random = 15;
  for (int round = 0; round < RANDOM_CALLS; round++) {
    uint8_t bytes[64];
    size_t size = 12 + random_below(&random, sizeof bytes - 12);
    for (size_t i = 0; i < size; i++) /* small numbers lead deeper */
      bytes[i] = (uint8_t)random_below(&random, random_below(&random, 2) ? 256 : 8);
    bytes[0] = (uint8_t)(round % CALL_COUNT == MESHING ? MESHING + 1 : round % CALL_COUNT);
    if (round % 4)
      memset(bytes + 2, 0, 2); /* no allocation fails, nothing cancels */
    fuzz_call(bytes, size);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(corpus),
      cmocka_unit_test(random_calls),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
