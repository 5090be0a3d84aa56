/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "sliding_call.h"

#include <string.h>

#include "buffers.h"
#include "run.h"

/** What points slide on, converted, and whom to ask. */
typedef struct sliding_call {
  run r;
  PyObject *callable; /* borrowed: (bytes of points, bytes of tags) -> (bytes of places, bytes of
                         directions); None: nobody is asked */
  array_copy carrier_of_point, starts, pieces, facet_points, facets, piece_of_facet, facet_normals;
} sliding_call;

static void sliding_call_free(sliding_call *call) {
  array_copy_free(&call->carrier_of_point);
  array_copy_free(&call->starts);
  array_copy_free(&call->pieces);
  array_copy_free(&call->facet_points);
  array_copy_free(&call->facets);
  array_copy_free(&call->piece_of_facet);
  array_copy_free(&call->facet_normals);
}

/** Of a tuple (facet points, facets' corners, pieces, normals). @return 0 with an exception set */
static int copy_facets(PyObject *from, void *to) {
  sliding_call *call = to;
  if (!PyTuple_Check(from)) {
    PyErr_SetString(PyExc_TypeError, "facets are a tuple");
    return 0;
  }
  if (!PyArg_ParseTuple(from, "O&O&O&O&", copy_points, &call->facet_points, copy_numbers,
                        &call->facets, copy_numbers, &call->piece_of_facet, copy_points,
                        &call->facet_normals))
    return 0;
  size_t count = call->piece_of_facet.count;
  if (call->facets.count == 3 * count && call->facet_normals.count == 3 * count)
    return 1;
  PyErr_Format(PyExc_ValueError, "%zu corners and %zu normals for %zu facets", call->facets.count,
               call->facet_normals.count, count);
  return 0;
}

/** Copy rows of points out of bytes. @return false with an exception set */
static bool take_rows(PyObject *from, size_t count, double *to) {
  char *bytes;
  Py_ssize_t length;
  if (PyBytes_AsStringAndSize(from, &bytes, &length) < 0)
    return false;
  if ((size_t)length != 3 * count * sizeof *to) {
    PyErr_Format(PyExc_ValueError, "project answers with %zd bytes for %zu points", length, count);
    return false;
  }
  memcpy(to, bytes, (size_t)length);
  return true;
}

/** A hexcon_project; user is the sliding_call. An exception cancels the core's call. */
static bool ask(void *user, size_t count, const double *points, const int32_t *tags,
                double *projected, double *directions) {
  sliding_call *call = user;
  run_acquire(&call->r);
  PyObject *places, *ways, *result = NULL, *given = buffer_copy(points, 3 * count, sizeof(double)),
                           *which = buffer_copy(tags, count, sizeof *tags);
  if (given && which)
    result = PyObject_CallFunctionObjArgs(call->callable, given, which, NULL);
  bool answered = result && PyArg_ParseTuple(result, "SS", &places, &ways) &&
                  take_rows(places, count, projected) && take_rows(ways, count, directions);
  if (!answered)
    call->r.interrupted = true;
  Py_XDECREF(result);
  Py_XDECREF(given);
  Py_XDECREF(which);
  run_release(&call->r);
  return answered;
}

/** @return false with an exception set, where the arrays do not fit one another */
static bool describe(sliding_call *call, size_t point_count, hexcon_sliding *out) {
  const int32_t *starts = call->starts.items;
  if (call->carrier_of_point.count != point_count || call->starts.count == 0 ||
      starts[call->starts.count - 1] < 0 ||
      (size_t)starts[call->starts.count - 1] != call->pieces.count) {
    PyErr_Format(PyExc_ValueError, "%zu rows for %zu points, or %zu pieces that starts do not span",
                 call->carrier_of_point.count, point_count, call->pieces.count);
    return false;
  }
  *out = (hexcon_sliding){.carrier_of_point = call->carrier_of_point.items,
                          .carrier_count = call->starts.count - 1,
                          .starts = starts,
                          .pieces = call->pieces.items,
                          .project = call->callable == Py_None ? NULL : ask,
                          .project_user = call,
                          .facet_point_count = call->facet_points.count,
                          .facet_count = call->piece_of_facet.count,
                          .facet_points = call->facet_points.items,
                          .facets = call->facets.items,
                          .piece_of_facet = call->piece_of_facet.items,
                          .facet_normals = call->facet_normals.items};
  return true;
}

PyObject *project_points(PyObject *module, PyObject *arguments) {
  (void)module;
  array_copy points;
  sliding_call call = {0};
  hexcon_sliding sliding;
  PyObject *result = NULL, *directions = NULL;
  if (!PyArg_ParseTuple(arguments, "O&O&O&O&OO&", copy_points, &points, copy_numbers,
                        &call.carrier_of_point, copy_numbers, &call.starts, copy_carriers,
                        &call.pieces, &call.callable, copy_facets, &call)) {
    sliding_call_free(&call);
    return NULL;
  }
  if (describe(&call, points.count, &sliding))
    directions = buffer_copy(NULL, 3 * points.count, sizeof(double));
  if (directions && run_begin(&call.r, Py_None)) {
    double *out = (double *)(void *)PyByteArray_AsString(directions);
    run_release(&call.r);
    hexcon_status status = hexcon_project_points(call.r.context, points.items, points.count,
                                                 &sliding, points.items, out);
    run_acquire(&call.r);
    if (run_end(&call.r, status))
      result = Py_BuildValue("NO", buffer_copy(points.items, 3 * points.count, sizeof(double)),
                             directions);
  }
  Py_XDECREF(directions);
  sliding_call_free(&call);
  array_copy_free(&points);
  return result;
}

/** What was reached is written over the points, also when the call is cancelled. */
PyObject *relax(PyObject *module, PyObject *arguments) {
  (void)module;
  array_copy positions, hexes;
  sliding_call call = {0};
  hexcon_relax_options options = {0};
  hexcon_sliding sliding;
  PyObject *given, *callback, *result = NULL;
  if (!PyArg_ParseTuple(arguments, "OO&O&O&O&OO&iiiidO", &given, copy_hexes, &hexes, copy_numbers,
                        &call.carrier_of_point, copy_numbers, &call.starts, copy_carriers,
                        &call.pieces, &call.callable, copy_facets, &call, &options.max_rounds,
                        &options.passes, &options.mean_passes, &options.threads, &options.budget,
                        &callback)) {
    sliding_call_free(&call);
    return NULL;
  }
  if (copy_points(given, &positions) && describe(&call, positions.count, &sliding) &&
      run_begin(&call.r, callback)) {
    run_release(&call.r);
    hexcon_status status =
        hexcon_relax(call.r.context, positions.items, positions.count, hexes.items, hexes.count,
                     &sliding, &options, positions.items);
    run_acquire(&call.r);
    bool written = call.r.interrupted || write_points(&positions, given);
    if (run_end(&call.r, status) && written)
      result = Py_BuildValue("");
  }
  sliding_call_free(&call);
  array_copy_free(&positions);
  array_copy_free(&hexes);
  return result;
}
