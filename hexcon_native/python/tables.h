/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The core's tables as Python lists: nothing in Python types a name or a number of theirs again.
 */
#ifndef HEXCON_PYTHON_TABLES_H
#define HEXCON_PYTHON_TABLES_H

#include <Python.h>

/* Functions of a module, METH_NOARGS; module.c says what each returns. */
PyObject *table_of_methods(PyObject *module, PyObject *arguments);
PyObject *version_of_core(PyObject *module, PyObject *arguments);
PyObject *table_of_pairings(PyObject *module, PyObject *arguments);
PyObject *table_of_statuses(PyObject *module, PyObject *arguments);
PyObject *table_of_progress_stages(PyObject *module, PyObject *arguments);
PyObject *table_of_carriers(PyObject *module, PyObject *arguments);
PyObject *table_of_hex_stages(PyObject *module, PyObject *arguments);

#endif
