/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "run.h"

/** Called by the core without the GIL; takes it for as long as Python code runs. */
static bool report_progress(void *user, const char *stage, double fraction) {
  run *r = user;
  run_acquire(r);
  bool go_on = !r->interrupted && PyErr_CheckSignals() == 0;
  if (go_on && r->callback) {
    PyObject *answer = PyObject_CallFunction(r->callback, "sd", stage, fraction);
    const bool cancels = answer == Py_False;
    go_on = answer != NULL;
    Py_XDECREF(answer);
    if (cancels) { /* by its answer: no exception is set */
      run_release(r);
      return false;
    }
  }
  r->interrupted = !go_on;
  run_release(r);
  return go_on;
}

bool run_begin(run *r, PyObject *callback) {
  *r = (run){.callback = callback == Py_None ? NULL : callback};
  if (r->callback && !PyCallable_Check(r->callback)) {
    PyErr_SetString(PyExc_TypeError, "progress must be a callable (stage, fraction) or None");
    return false;
  }
  r->context = hexcon_context_new();
  if (!r->context) {
    PyErr_NoMemory();
    return false;
  }
  hexcon_context_set_progress(r->context, report_progress, r);
  return true;
}

void run_release(run *r) {
  r->thread = PyEval_SaveThread();
}

void run_acquire(run *r) {
  PyEval_RestoreThread(r->thread);
}

/** hexcon_native.errors.raise_status(message, status, elements) makes and raises the error. */
static void raise_error(const hexcon_context *context, hexcon_status status) {
  const int32_t *ids;
  size_t count = hexcon_context_elements(context, &ids);
  PyObject *elements = PyList_New((Py_ssize_t)count);
  for (size_t i = 0; elements && i < count; i++)
    PyList_SetItem(elements, (Py_ssize_t)i, PyLong_FromLong(ids[i]));
  PyObject *package = elements ? PyImport_ImportModule("hexcon_native") : NULL;
  PyObject *raised =
      package ? PyObject_CallMethod(package, "_raise", "siO", hexcon_context_message(context),
                                    (int)status, elements)
              : NULL;
  Py_XDECREF(raised);
  Py_XDECREF(package);
  Py_XDECREF(elements);
}

bool run_end(run *r, hexcon_status status) {
  if (status && !r->interrupted && !PyErr_Occurred())
    raise_error(r->context, status);
  hexcon_context_free(r->context);
  return status == HEXCON_OK && !PyErr_Occurred();
}
