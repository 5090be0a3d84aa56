/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Bytes that stand for a call of the core: which one, on what mesh, damaged how. */
#ifndef HEXCON_TESTS_FUZZ_CALL_H
#define HEXCON_TESTS_FUZZ_CALL_H

#include <stddef.h>
#include <stdint.h>

/**
 * Make the call and check what must hold of its outcome, whatever was given; aborts where it does
 * not. Bytes that are missing are 0; every string of bytes is a call.
 *
 * byte 0       the call
 * byte 1       the mesh that is damaged, see seeds
 * byte 2       the allocation that fails, and
 * byte 3       the progress report that cancels; 0: none (but a call is never unbounded)
 * bytes 4 - 11 options, as the call has them
 * then damages, of a byte for what is done and as many as that needs for where and how much
 */
void fuzz_call(const uint8_t *data, size_t size);

#endif
