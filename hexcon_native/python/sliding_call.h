/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** What points slide on, given by Python, and calls that need it. */
#ifndef HEXCON_PYTHON_SLIDING_CALL_H
#define HEXCON_PYTHON_SLIDING_CALL_H

#include <Python.h>

/* Functions of a module, METH_VARARGS; module.c says what each takes. */
PyObject *project_points(PyObject *module, PyObject *arguments);
PyObject *relax(PyObject *module, PyObject *arguments);

#endif
