/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "tables.h"

#include "hexcon.h"

/** A row for Python. @return NULL beyond the last row, or with an error set */
typedef PyObject *(*row_maker)(size_t row);

static PyObject *list_of_rows(row_maker make) {
  PyObject *list = PyList_New(0), *made;
  for (size_t row = 0; list && (made = make(row)); row++) {
    if (PyList_Append(list, made) < 0)
      Py_CLEAR(list);
    Py_DECREF(made);
  }
  if (PyErr_Occurred())
    Py_CLEAR(list);
  return list;
}

/* ------------------------------------------------------------------------------------- methods */

static PyObject *boolean(bool value) {
  return PyBool_FromLong(value);
}

/** One try of auto; None where there is none. */
static PyObject *try_row(const hexcon_method_try *t) {
  if (t->turn == 0)
    return Py_BuildValue("");
  return Py_BuildValue("{s:i,s:d,s:n,s:N}", "turn", t->turn, "good_worst", t->good_worst,
                       "most_hexes", (Py_ssize_t)t->most_hexes, "no_core", boolean(t->no_core));
}

static PyObject *method_row(size_t row) {
  const hexcon_method_facts *f = hexcon_method_info(row);
  if (!f)
    return NULL;
  return Py_BuildValue(
      "{s:i,s:s,s:s,s:s,s:s,s:N,s:N,s:N,s:N,s:N,s:N,s:N,s:N,s:N,s:N,s:N,s:d,s:(NN)}", "number",
      (int)f->method, "name", f->name, "label", f->label, "purpose", f->purpose, "told", f->told,
      "topological", boolean(f->topological), "layers", boolean(f->layers), "core",
      boolean(f->core), "pairing", boolean(f->pairing), "pillow", boolean(f->pillow),
      "tetrahedralise", boolean(f->tetrahedralise), "proposal", boolean(f->proposal), "holes",
      boolean(f->holes), "cavities", boolean(f->cavities), "odd_colours", boolean(f->odd_colours),
      "odd_paths", boolean(f->odd_paths), "hexes_a_quad", f->hexes_a_quad, "tries",
      try_row(&f->tries[0]), try_row(&f->tries[1]));
}

PyObject *table_of_methods(PyObject *module, PyObject *arguments) {
  (void)module, (void)arguments;
  return list_of_rows(method_row);
}

PyObject *version_of_core(PyObject *module, PyObject *arguments) {
  (void)module, (void)arguments;
  return PyUnicode_FromString(hexcon_version());
}

static PyObject *pairing_row(size_t row) {
  const char *name = hexcon_pairing_name((int)row);
  return name ? PyUnicode_FromString(name) : NULL;
}

PyObject *table_of_pairings(PyObject *module, PyObject *arguments) {
  (void)module, (void)arguments;
  return list_of_rows(pairing_row);
}

/* ----------------------------------------------------------------------------- faults and stages
 */

static PyObject *status_row(size_t row) {
  const hexcon_status_facts *f = hexcon_status_info((int)row);
  return f ? Py_BuildValue("(ssss)", f->name, f->meaning, f->elements, f->advice) : NULL;
}

PyObject *table_of_statuses(PyObject *module, PyObject *arguments) {
  (void)module, (void)arguments;
  return list_of_rows(status_row);
}

static PyObject *stage_row(const hexcon_stage_facts *f) {
  return f ? Py_BuildValue("(ss)", f->name, f->words) : NULL;
}

static PyObject *progress_stage_row(size_t row) {
  return stage_row(hexcon_progress_stage(row));
}

PyObject *table_of_progress_stages(PyObject *module, PyObject *arguments) {
  (void)module, (void)arguments;
  return list_of_rows(progress_stage_row);
}

static PyObject *hex_stage_row(size_t row) {
  return stage_row(hexcon_hex_stage(row));
}

PyObject *table_of_hex_stages(PyObject *module, PyObject *arguments) {
  (void)module, (void)arguments;
  return list_of_rows(hex_stage_row);
}

/* ------------------------------------------------------------------------------------ carriers */

static PyObject *carrier_row(size_t row) {
  const hexcon_carrier_facts *f = hexcon_carrier_info((int)row);
  return f ? Py_BuildValue("(sis)", f->name, f->freedom, f->fields) : NULL;
}

PyObject *table_of_carriers(PyObject *module, PyObject *arguments) {
  (void)module, (void)arguments;
  return list_of_rows(carrier_row);
}
