/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "mesher_call.h"

#include "buffers.h"

void mesher_call_release(mesher_call *call) {
  Py_CLEAR(call->points);
  Py_CLEAR(call->tetrahedra);
}

/** @return whether both are bytes of whole rows */
static bool take_result(mesher_call *call, PyObject *result, hexcon_tetrahedra *out) {
  const Py_ssize_t point_row = 3 * (Py_ssize_t)sizeof(double),
                   corner_row = 4 * (Py_ssize_t)sizeof(int32_t);
  char *points, *tetrahedra;
  Py_ssize_t point_bytes, tetrahedron_bytes;
  if (!PyArg_ParseTuple(result, "SS", &call->points, &call->tetrahedra)) {
    call->points = call->tetrahedra = NULL; /* borrowed where they were set */
    return false;
  }
  Py_INCREF(call->points);
  Py_INCREF(call->tetrahedra);
  if (PyBytes_AsStringAndSize(call->points, &points, &point_bytes) < 0 ||
      PyBytes_AsStringAndSize(call->tetrahedra, &tetrahedra, &tetrahedron_bytes) < 0)
    return false;
  if (point_bytes % point_row || tetrahedron_bytes % corner_row) {
    PyErr_SetString(PyExc_ValueError, "new points have 3 float64, tetrahedra 4 int32 each");
    return false;
  }
  out->points = (const double *)(const void *)points;
  out->point_count = (size_t)(point_bytes / point_row);
  out->tetrahedra = (const int32_t *)(const void *)tetrahedra;
  out->tetrahedron_count = (size_t)(tetrahedron_bytes / corner_row);
  return true;
}

bool call_mesher(void *user, const double *points, size_t point_count, const int32_t *triangles,
                 size_t triangle_count, hexcon_tetrahedra *out) {
  mesher_call *call = user;
  run_acquire(call->r);
  mesher_call_release(call);
  PyObject *given = buffer_copy(points, 3 * point_count, sizeof(double)),
           *corners = buffer_copy(triangles, 3 * triangle_count, sizeof(int32_t)), *result = NULL;
  if (given && corners)
    result = PyObject_CallFunctionObjArgs(call->callable, given, corners, NULL);
  bool found = result && result != Py_None && take_result(call, result, out);
  if (PyErr_Occurred())
    call->r->interrupted = true;
  Py_XDECREF(result);
  Py_XDECREF(given);
  Py_XDECREF(corners);
  run_release(call->r);
  return found;
}
