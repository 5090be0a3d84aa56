/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "buffers.h"

size_t buffer_rows(const Py_buffer *buffer, size_t width, size_t size) {
  return (size_t)buffer->len / (width * size);
}

PyObject *buffer_copy(const void *items, size_t count, size_t size) {
  return PyByteArray_FromStringAndSize(items, (Py_ssize_t)(count * size));
}
