/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "buffers.h"

#include <stdlib.h>
#include <string.h>

#include "hexcon.h"

void array_copy_free(array_copy *copy) {
  free(copy->items);
  *copy = (array_copy){NULL, 0};
}

/** @param from  NULL: free what was converted (Py_CLEANUP_SUPPORTED) */
static int copy_rows(PyObject *from, array_copy *to, size_t row_bytes) {
  Py_buffer view;
  if (!from) {
    array_copy_free(to);
    return 1;
  }
  *to = (array_copy){NULL, 0};
  if (PyObject_GetBuffer(from, &view, PyBUF_SIMPLE) < 0)
    return 0;
  const size_t bytes = (size_t)view.len;
  if (bytes % row_bytes) {
    PyErr_Format(PyExc_ValueError, "a buffer of %zu bytes has no whole rows of %zu", bytes,
                 row_bytes);
  } else if ((to->items = malloc(bytes ? bytes : 1))) {
    if (bytes)
      memcpy(to->items, view.buf, bytes);
    to->count = bytes / row_bytes;
  } else {
    PyErr_NoMemory();
  }
  PyBuffer_Release(&view);
  return to->items ? Py_CLEANUP_SUPPORTED : 0;
}

static int copy_rows_or_none(PyObject *from, array_copy *to, size_t row_bytes) {
  if (from != Py_None)
    return copy_rows(from, to, row_bytes);
  *to = (array_copy){NULL, 0};
  return Py_CLEANUP_SUPPORTED;
}

int copy_points(PyObject *from, void *to) {
  return copy_rows(from, to, 3 * sizeof(double));
}

int copy_any_points(PyObject *from, void *to) {
  return copy_rows_or_none(from, to, 3 * sizeof(double));
}

int copy_quads(PyObject *from, void *to) {
  return copy_rows(from, to, 4 * sizeof(int32_t));
}

int copy_hexes(PyObject *from, void *to) {
  return copy_rows(from, to, 8 * sizeof(int32_t));
}

int copy_any_hexes(PyObject *from, void *to) {
  return copy_rows_or_none(from, to, 8 * sizeof(int32_t));
}

int copy_pairs(PyObject *from, void *to) {
  return copy_rows_or_none(from, to, 2 * sizeof(int32_t));
}

int copy_flags(PyObject *from, void *to) {
  return copy_rows(from, to, 1);
}

int copy_numbers(PyObject *from, void *to) {
  return copy_rows(from, to, sizeof(int32_t));
}

int copy_carriers(PyObject *from, void *to) {
  return copy_rows(from, to, sizeof(hexcon_carrier));
}

bool write_points(const array_copy *from, PyObject *to) {
  Py_buffer view;
  if (PyObject_GetBuffer(to, &view, PyBUF_WRITABLE) < 0)
    return false;
  bool fits = (size_t)view.len == from->count * 3 * sizeof(double);
  if (!fits)
    PyErr_SetString(PyExc_BufferError, "the points were resized while they were worked on");
  else if (view.len > 0)
    memcpy(view.buf, from->items, (size_t)view.len);
  PyBuffer_Release(&view);
  return fits;
}

PyObject *buffer_copy(const void *items, size_t count, size_t size) {
  if (count > PY_SSIZE_T_MAX / size)
    return PyErr_NoMemory();
  return PyByteArray_FromStringAndSize(items, (Py_ssize_t)(count * size));
}
