/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** libFuzzer's entry; `make fuzz` builds and runs it. */
#include "fuzz_call.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz_call(data, size);
  return 0;
}
