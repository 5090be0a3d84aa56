/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Arrays that cross the border between Python and the core. */
#ifndef HEXCON_PYTHON_BUFFERS_H
#define HEXCON_PYTHON_BUFFERS_H

#include <Python.h>

#include <stdbool.h>
#include <stdint.h>

/**
 * What the core works on: a copy, aligned, and nobody else's. While the GIL is released, other
 * threads and callbacks may change or free what they gave.
 */
typedef struct array_copy {
  void *items;  /**< NULL for None */
  size_t count; /**< of rows */
} array_copy;

void array_copy_free(array_copy *copy);

/**
 * Converters for PyArg_ParseTuple's "O&", from contiguous buffers of whole rows to array_copy; what
 * was converted is freed where a later argument fails. copy_pairs and copy_any_... take None.
 */
int copy_points(PyObject *from, void *to);     /**< rows of 3 float64 */
int copy_any_points(PyObject *from, void *to); /**< or None */
int copy_quads(PyObject *from, void *to);      /**< rows of 4 int32 */
int copy_hexes(PyObject *from, void *to);      /**< rows of 8 int32 */
int copy_any_hexes(PyObject *from, void *to);  /**< or None */
int copy_pairs(PyObject *from, void *to);      /**< rows of 2 int32, or None */
int copy_flags(PyObject *from, void *to);      /**< bytes */
int copy_numbers(PyObject *from, void *to);    /**< rows of 1 int32 */
int copy_carriers(PyObject *from, void *to);   /**< rows of one hexcon_carrier */

/** Write rows of 3 float64 over the buffer they were copied from.
 * @return false with an exception set, if it is another size now, or read-only */
bool write_points(const array_copy *from, PyObject *to);

/** A bytearray with a copy of count items of size bytes; NULL with an exception set. */
PyObject *buffer_copy(const void *items, size_t count, size_t size);

#endif
