/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Running a core call from Python: GIL released, progress and Ctrl-C cancel, errors raised. */
#ifndef HEXCON_PYTHON_RUN_H
#define HEXCON_PYTHON_RUN_H

#include <Python.h>

#include "hexcon.h"

/** One call of the core. */
typedef struct run {
  hexcon_context *context;
  PyObject *callback;    /* borrowed; NULL for none */
  PyThreadState *thread; /* while the GIL is released */
  bool interrupted;      /* an exception of the callback, or Ctrl-C, is pending */
} run;

/** @param callback  None, or a callable (stage, fraction) -> anything; False cancels.
 * Returns false with an exception set. */
bool run_begin(run *r, PyObject *callback);
/** Release the GIL before the core call, take it again after. */
void run_release(run *r);
void run_acquire(run *r);
/** Free the context. Returns true if the call succeeded, else false with an exception set. */
bool run_end(run *r, hexcon_status status);

#endif
