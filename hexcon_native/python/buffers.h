/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Arrays that cross the border between Python and the core. */
#ifndef HEXCON_PYTHON_BUFFERS_H
#define HEXCON_PYTHON_BUFFERS_H

#include <Python.h>

#include <stdint.h>

/** Rows of a contiguous buffer whose rows have `width` items of `size` bytes. */
size_t buffer_rows(const Py_buffer *buffer, size_t width, size_t size);

/** A bytearray with a copy of count items of size bytes; NULL with an exception set. */
PyObject *buffer_copy(const void *items, size_t count, size_t size);

#endif
