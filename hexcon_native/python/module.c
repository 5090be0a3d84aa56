/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * hexcon_native._core: the core's calls on copies of contiguous buffers. hexcon_native/__init__.py
 * checks shapes and types, converts, and wraps the results; nothing else should import this module.
 */
#include "buffers.h"
#include "mesher_call.h"
#include "run.h"
#include "sliding_call.h"
#include "tables.h"

static PyObject *boolean(bool value) {
  return PyBool_FromLong(value);
}

static PyObject *report_as_dict(const hexcon_surface_report *r) {
  return Py_BuildValue(
      "{s:n,s:n,s:n,s:n,s:n,s:i,s:L,s:L,s:N,s:N,s:N,s:N,s:N,s:(ddd),s:d,s:d,s:n,s:n}", "quads",
      (Py_ssize_t)r->quad_count, "points", (Py_ssize_t)r->point_count, "edges",
      (Py_ssize_t)r->edge_count, "components", (Py_ssize_t)r->component_count, "cavities",
      (Py_ssize_t)r->cavity_count, "fillable", (int)r->fillable, "euler", (long long)r->euler,
      "genus", (long long)r->genus, "even", boolean(r->even), "bipartite", boolean(r->bipartite),
      "oriented", boolean(r->oriented), "convex", boolean(r->convex), "star_shaped",
      boolean(r->star_shaped), "star_center", r->star_center[0], r->star_center[1],
      r->star_center[2], "star_margin", r->star_margin, "volume", r->volume, "loop_count",
      (Py_ssize_t)r->loop_count, "self_crossing_count", (Py_ssize_t)r->self_crossing_count);
}

static PyObject *check_surface(PyObject *module, PyObject *arguments) {
  (void)module;
  array_copy points, quads;
  if (!PyArg_ParseTuple(arguments, "O&O&", copy_points, &points, copy_quads, &quads))
    return NULL;
  run r;
  hexcon_surface_report report;
  PyObject *result = NULL;
  if (run_begin(&r, Py_None)) {
    run_release(&r);
    hexcon_status status = hexcon_check_surface(r.context, points.items, points.count, quads.items,
                                                quads.count, &report);
    run_acquire(&r);
    if (run_end(&r, status))
      result = report_as_dict(&report);
  }
  array_copy_free(&points);
  array_copy_free(&quads);
  return result;
}

static PyObject *orient_surface(PyObject *module, PyObject *arguments) {
  (void)module;
  array_copy points, quads;
  if (!PyArg_ParseTuple(arguments, "O&O&", copy_points, &points, copy_quads, &quads))
    return NULL;
  run r;
  size_t bodies = 0, cavities = 0;
  PyObject *result = NULL;
  if (run_begin(&r, Py_None)) {
    run_release(&r);
    hexcon_status status = hexcon_orient_surface(r.context, points.items, points.count, quads.items,
                                                 quads.count, &bodies, &cavities);
    run_acquire(&r);
    if (run_end(&r, status))
      result = Py_BuildValue("Nnn", buffer_copy(quads.items, 4 * quads.count, sizeof(int32_t)),
                             (Py_ssize_t)bodies, (Py_ssize_t)cavities);
  }
  array_copy_free(&points);
  array_copy_free(&quads);
  return result;
}

static PyObject *loops_as_tuple(const hexcon_loops *loops) {
  return Py_BuildValue(
      "NNN", buffer_copy(loops->offsets, loops->count + 1, sizeof *loops->offsets),
      buffer_copy(loops->quads, loops->offsets[loops->count], sizeof *loops->quads),
      buffer_copy(loops->self_crossings, loops->count, sizeof *loops->self_crossings));
}

static PyObject *loops(PyObject *module, PyObject *arguments) {
  (void)module;
  array_copy quads;
  if (!PyArg_ParseTuple(arguments, "O&", copy_quads, &quads))
    return NULL;
  run r;
  PyObject *result = NULL;
  if (run_begin(&r, Py_None)) {
    hexcon_loops found;
    run_release(&r);
    hexcon_status status = hexcon_surface_loops(r.context, quads.items, quads.count, &found);
    run_acquire(&r);
    if (!status) {
      result = loops_as_tuple(&found);
      hexcon_loops_free(r.context, &found);
    }
    if (!run_end(&r, status))
      Py_CLEAR(result);
  }
  array_copy_free(&quads);
  return result;
}

static PyObject *colouring(PyObject *module, PyObject *arguments) {
  (void)module;
  array_copy quads;
  Py_ssize_t point_count;
  if (!PyArg_ParseTuple(arguments, "O&n", copy_quads, &quads, &point_count))
    return NULL;
  run r;
  PyObject *colours = buffer_copy(NULL, (size_t)point_count, 1);
  if (colours && run_begin(&r, Py_None)) {
    uint8_t *out = (uint8_t *)PyByteArray_AsString(colours);
    run_release(&r);
    hexcon_status status =
        hexcon_surface_colouring(r.context, quads.items, quads.count, (size_t)point_count, out);
    run_acquire(&r);
    if (!run_end(&r, status))
      Py_CLEAR(colours);
  } else {
    Py_CLEAR(colours);
  }
  array_copy_free(&quads);
  return colours;
}

static PyObject *pairing(PyObject *module, PyObject *arguments) {
  (void)module;
  array_copy points, quads;
  Py_ssize_t point_count;
  PyObject *callback;
  if (!PyArg_ParseTuple(arguments, "O&nO&O", copy_any_points, &points, &point_count, copy_quads,
                        &quads, &callback))
    return NULL;
  run r;
  PyObject *pairs = buffer_copy(NULL, quads.count / 2, 2 * sizeof(int32_t));
  if (pairs && run_begin(&r, callback)) {
    int32_t *out = (int32_t *)(void *)PyByteArray_AsString(pairs);
    run_release(&r);
    hexcon_status status = hexcon_surface_pairing(r.context, points.items,
                                                  points.items ? points.count : (size_t)point_count,
                                                  quads.items, quads.count, out);
    run_acquire(&r);
    if (!run_end(&r, status))
      Py_CLEAR(pairs);
  } else {
    Py_CLEAR(pairs);
  }
  array_copy_free(&points);
  array_copy_free(&quads);
  return pairs;
}

static PyObject *pairing_of_crossings(PyObject *module, PyObject *arguments) {
  (void)module;
  array_copy quads;
  Py_ssize_t point_count;
  PyObject *callback;
  if (!PyArg_ParseTuple(arguments, "nO&O", &point_count, copy_quads, &quads, &callback))
    return NULL;
  run r;
  size_t pair_count = 0;
  PyObject *pairs = buffer_copy(NULL, quads.count / 2, 2 * sizeof(int32_t));
  if (pairs && run_begin(&r, callback)) {
    int32_t *out = (int32_t *)(void *)PyByteArray_AsString(pairs);
    run_release(&r);
    hexcon_status status = hexcon_surface_pairing_of_crossings(
        r.context, (size_t)point_count, quads.items, quads.count, out, &pair_count);
    run_acquire(&r);
    if (!run_end(&r, status) ||
        PyByteArray_Resize(pairs, (Py_ssize_t)(2 * pair_count * sizeof(int32_t))))
      Py_CLEAR(pairs);
  } else {
    Py_CLEAR(pairs);
  }
  array_copy_free(&quads);
  return pairs;
}

static PyObject *quality(PyObject *module, PyObject *arguments) {
  (void)module;
  array_copy points, hexes;
  int order;
  if (!PyArg_ParseTuple(arguments, "O&O&i", copy_points, &points, copy_numbers, &hexes, &order))
    return NULL;
  run r;
  const size_t count = hexes.count / (order == 2 ? 20 : 8);
  PyObject *values = buffer_copy(NULL, count, sizeof(double));
  if (values && run_begin(&r, Py_None)) {
    double *out = (double *)(void *)PyByteArray_AsString(values);
    run_release(&r);
    hexcon_status status = (order == 2 ? hexcon_quality_second_order : hexcon_quality)(
        r.context, points.items, points.count, hexes.items, count, out);
    run_acquire(&r);
    if (!run_end(&r, status))
      Py_CLEAR(values);
  } else {
    Py_CLEAR(values);
  }
  array_copy_free(&points);
  array_copy_free(&hexes);
  return values;
}

static PyObject *embedding_as_dict(const hexcon_embedding *e) {
  return Py_BuildValue("{s:i,s:N,s:n,s:s}", "embedded", (int)e->embedded, "pairs",
                       buffer_copy(e->pairs, 2 * e->pair_count, sizeof(int32_t)), "twins",
                       (Py_ssize_t)e->twin_count, "reason", e->reason);
}

static PyObject *embedding(PyObject *module, PyObject *arguments) {
  (void)module;
  array_copy points, quads;
  PyObject *callback;
  if (!PyArg_ParseTuple(arguments, "O&O&O", copy_points, &points, copy_quads, &quads, &callback))
    return NULL;
  run r;
  PyObject *result = NULL;
  if (run_begin(&r, callback)) {
    hexcon_embedding found;
    run_release(&r);
    hexcon_status status = hexcon_surface_embedding(r.context, points.items, points.count,
                                                    quads.items, quads.count, &found);
    run_acquire(&r);
    if (!status) {
      result = embedding_as_dict(&found);
      hexcon_embedding_free(r.context, &found);
    }
    if (!run_end(&r, status))
      Py_CLEAR(result);
  }
  array_copy_free(&points);
  array_copy_free(&quads);
  return result;
}

static PyObject *certificate_as_dict(const hexcon_certificate *c) {
  return Py_BuildValue(
      "{s:N,s:N,s:N,s:N,s:L,s:N,s:N,s:n,s:N,s:N,s:N}", "certified", boolean(c->certified),
      "conforming", boolean(c->conforming), "proper", boolean(c->proper), "boundary_exact",
      boolean(c->boundary_exact), "euler", (long long)c->euler, "nonpositive",
      buffer_copy(c->nonpositive, c->nonpositive_count, sizeof(int32_t)), "witnesses",
      buffer_copy(c->witnesses, 3 * c->nonpositive_count, sizeof(double)), "undecided",
      (Py_ssize_t)c->undecided_count, "doublets",
      buffer_copy(c->doublets, 2 * c->doublet_count, sizeof(int32_t)), "improper",
      buffer_copy(c->improper, c->improper_count, sizeof(int32_t)), "embedding",
      embedding_as_dict(&c->embedding));
}

static PyObject *certify(PyObject *module, PyObject *arguments) {
  (void)module;
  array_copy points, hexes, quads;
  PyObject *callback;
  int order;
  if (!PyArg_ParseTuple(arguments, "O&O&O&iO", copy_points, &points, copy_numbers, &hexes,
                        copy_quads, &quads, &order, &callback))
    return NULL;
  run r;
  PyObject *result = NULL;
  if (run_begin(&r, callback)) {
    hexcon_certificate certificate;
    const size_t nodes = order == 2 ? 20 : 8;
    run_release(&r);
    hexcon_status status = (order == 2 ? hexcon_certify_second_order : hexcon_certify)(
        r.context, points.items, points.count, hexes.items, hexes.count / nodes, quads.items,
        quads.count, &certificate);
    run_acquire(&r);
    if (!status) {
      result = certificate_as_dict(&certificate);
      hexcon_certificate_free(r.context, &certificate);
    }
    if (!run_end(&r, status))
      Py_CLEAR(result);
  }
  array_copy_free(&points);
  array_copy_free(&hexes);
  array_copy_free(&quads);
  return result;
}

/** The core reads as many rows of these as there are points. */
static bool is_of_points(const array_copy *array, const array_copy *points) {
  if (array->count != points->count)
    PyErr_Format(PyExc_ValueError, "%zu rows for %zu points", array->count, points->count);
  return array->count == points->count;
}

/** What was reached is written over the points, also when the call is cancelled. */
static PyObject *optimize(PyObject *module, PyObject *arguments) {
  (void)module;
  array_copy positions, hexes, fixed;
  hexcon_optimize_options options = {0};
  PyObject *given, *callback, *result = NULL;
  if (!PyArg_ParseTuple(arguments, "OO&O&iidiO", &given, copy_hexes, &hexes, copy_flags, &fixed,
                        &options.max_rounds, &options.threads, &options.target,
                        &options.mean_passes, &callback))
    return NULL;
  run r;
  if (copy_points(given, &positions) && is_of_points(&fixed, &positions) &&
      run_begin(&r, callback)) {
    run_release(&r);
    hexcon_status status = hexcon_optimize(r.context, positions.items, positions.count, hexes.items,
                                           hexes.count, fixed.items, &options, positions.items);
    run_acquire(&r);
    bool written = r.interrupted || write_points(&positions, given);
    if (run_end(&r, status) && written)
      result = Py_BuildValue("");
  }
  array_copy_free(&positions);
  array_copy_free(&hexes);
  array_copy_free(&fixed);
  return result;
}

static PyObject *morph(PyObject *module, PyObject *arguments) {
  (void)module;
  array_copy positions, hexes, fixed, goal;
  hexcon_morph_options options = {0};
  int boundary_only;
  double reached = 0;
  PyObject *given, *callback, *result = NULL;
  if (!PyArg_ParseTuple(arguments, "OO&O&O&pdO", &given, copy_hexes, &hexes, copy_flags, &fixed,
                        copy_points, &goal, &boundary_only, &options.target, &callback))
    return NULL;
  options.boundary_only = boundary_only != 0;
  run r;
  if (copy_points(given, &positions) && is_of_points(&fixed, &positions) &&
      is_of_points(&goal, &positions) && run_begin(&r, callback)) {
    run_release(&r);
    hexcon_status status =
        hexcon_morph(r.context, positions.items, positions.count, hexes.items, hexes.count,
                     fixed.items, goal.items, &options, positions.items, &reached);
    run_acquire(&r);
    bool written = r.interrupted || write_points(&positions, given);
    if (run_end(&r, status) && written)
      result = Py_BuildValue("d", reached);
  }
  array_copy_free(&positions);
  array_copy_free(&hexes);
  array_copy_free(&fixed);
  array_copy_free(&goal);
  return result;
}

static PyObject *second_order_as_tuple(const hexcon_second_order *raised, size_t hex_count) {
  return Py_BuildValue("NN", buffer_copy(raised->points, 3 * raised->point_count, sizeof(double)),
                       buffer_copy(raised->hexes, 20 * hex_count, sizeof(int32_t)));
}

static PyObject *repaired_as_tuple(const hexcon_repaired *r) {
  return Py_BuildValue("NNn", buffer_copy(r->points, 3 * r->point_count, sizeof(double)),
                       buffer_copy(r->hexes, 8 * r->hex_count, sizeof(int32_t)),
                       (Py_ssize_t)r->pillows);
}

static PyObject *repair(PyObject *module, PyObject *arguments) {
  (void)module;
  array_copy points, hexes, fixed;
  hexcon_repair_options options = {0};
  PyObject *callback, *result = NULL;
  if (!PyArg_ParseTuple(arguments, "O&O&O&iiO", copy_points, &points, copy_hexes, &hexes,
                        copy_flags, &fixed, &options.pillow, &options.threads, &callback))
    return NULL;
  run r;
  if (is_of_points(&fixed, &points) && run_begin(&r, callback)) {
    hexcon_repaired repaired;
    run_release(&r);
    hexcon_status status = hexcon_repair(r.context, points.items, points.count, hexes.items,
                                         hexes.count, fixed.items, &options, &repaired);
    run_acquire(&r);
    if (!status)
      result = repaired_as_tuple(&repaired);
    hexcon_repaired_free(r.context, &repaired);
    if (!run_end(&r, status))
      Py_CLEAR(result);
  }
  array_copy_free(&points);
  array_copy_free(&hexes);
  array_copy_free(&fixed);
  return result;
}

static PyObject *raise_order(PyObject *module, PyObject *arguments) {
  (void)module;
  array_copy points, hexes;
  if (!PyArg_ParseTuple(arguments, "O&O&", copy_points, &points, copy_hexes, &hexes))
    return NULL;
  run r;
  PyObject *result = NULL;
  if (run_begin(&r, Py_None)) {
    hexcon_second_order raised;
    run_release(&r);
    hexcon_status status = hexcon_raise_order(r.context, points.items, points.count, hexes.items,
                                              hexes.count, &raised);
    run_acquire(&r);
    if (!status) {
      result = second_order_as_tuple(&raised, hexes.count);
      hexcon_second_order_free(r.context, &raised);
    }
    if (!run_end(&r, status))
      Py_CLEAR(result);
  }
  array_copy_free(&points);
  array_copy_free(&hexes);
  return result;
}

static PyObject *figures_as_dict(const hexcon_mesh *mesh) {
  const hexcon_figure *figures;
  size_t count = hexcon_mesh_report(mesh, &figures);
  PyObject *dict = PyDict_New();
  for (size_t i = 0; dict && i < count; i++) {
    PyObject *value = PyFloat_FromDouble(figures[i].value);
    if (!value || PyDict_SetItemString(dict, figures[i].name, value) < 0)
      Py_CLEAR(dict);
    Py_XDECREF(value);
  }
  return dict;
}

/** None for an array that was left out. */
static PyObject *optional_copy(const void *array, size_t count, size_t size) {
  return array ? buffer_copy(array, count, size) : Py_BuildValue("");
}

static PyObject *mesh_as_dict(const hexcon_mesh *mesh) {
  size_t nodes = hexcon_mesh_order(mesh) == 2 ? 20 : 8, hexes = hexcon_mesh_hex_count(mesh);
  return Py_BuildValue(
      "{s:N,s:N,s:N,s:N,s:s,s:i,s:N,s:N,s:N,s:s}", "points",
      buffer_copy(hexcon_mesh_points(mesh), 3 * hexcon_mesh_point_count(mesh), sizeof(double)),
      "hexes", buffer_copy(hexcon_mesh_hexes(mesh), nodes * hexes, sizeof(int32_t)), "quads",
      buffer_copy(hexcon_mesh_quads(mesh), 4 * hexcon_mesh_quad_count(mesh), sizeof(int32_t)),
      "quality", optional_copy(hexcon_mesh_quality(mesh), hexes, sizeof(double)), "method",
      hexcon_mesh_method(mesh), "order", hexcon_mesh_order(mesh), "topological",
      boolean(hexcon_mesh_is_topological(mesh)), "certificate",
      hexcon_mesh_is_checked(mesh) ? certificate_as_dict(hexcon_mesh_certificate(mesh))
                                   : Py_BuildValue(""),
      "report", figures_as_dict(mesh), "log", hexcon_mesh_log(mesh));
}

static PyObject *mesh(PyObject *module, PyObject *arguments) {
  (void)module;
  array_copy points, quads, pairs, hexes, inner;
  Py_ssize_t inner_count;
  int method, order, allow_uncertified, threads, layers, pairing, skip_certificate, no_core,
      allow_topological, pillow;
  double budget;
  PyObject *callback, *tetrahedralise;
  if (!PyArg_ParseTuple(arguments, "O&O&iipiiOiO&O&nO&pppidO", copy_points, &points, copy_quads,
                        &quads, &method, &order, &allow_uncertified, &threads, &layers,
                        &tetrahedralise, &pairing, copy_pairs, &pairs, copy_any_hexes, &hexes,
                        &inner_count, copy_any_points, &inner, &skip_certificate, &no_core,
                        &allow_topological, &pillow, &budget, &callback))
    return NULL;
  run r;
  PyObject *result = NULL;
  if (run_begin(&r, callback)) {
    hexcon_mesh *made = NULL;
    mesher_call mesher = {&r, tetrahedralise, NULL, NULL};
    hexcon_proposal proposal = {hexes.count, hexes.items, (size_t)inner_count, inner.items};
    hexcon_mesh_options options = {.method = (hexcon_method)method,
                                   .order = order,
                                   .allow_uncertified = allow_uncertified != 0,
                                   .threads = threads,
                                   .layers = layers,
                                   .tetrahedralise = tetrahedralise == Py_None ? NULL : call_mesher,
                                   .tetrahedralise_user = &mesher,
                                   .proposal = hexes.items ? &proposal : NULL,
                                   .pairing = (hexcon_pairing)pairing,
                                   .pairs = pairs.items,
                                   .pair_count = pairs.count,
                                   .skip_certificate = skip_certificate != 0,
                                   .no_core = no_core != 0,
                                   .allow_topological = allow_topological != 0,
                                   .pillow = pillow,
                                   .budget = budget};
    run_release(&r);
    hexcon_status status = hexcon_mesh_surface(r.context, points.items, points.count, quads.items,
                                               quads.count, &options, &made);
    run_acquire(&r);
    mesher_call_release(&mesher);
    if (!status)
      result = mesh_as_dict(made);
    hexcon_mesh_free(r.context, made);
    if (!run_end(&r, status))
      Py_CLEAR(result);
  }
  array_copy_free(&pairs);
  array_copy_free(&hexes);
  array_copy_free(&inner);
  array_copy_free(&points);
  array_copy_free(&quads);
  return result;
}

static PyMethodDef methods[] = {
    {"methods", table_of_methods, METH_NOARGS, "methods() -> list of dicts, one a method"},
    {"version", version_of_core, METH_NOARGS, "version() -> text"},
    {"pairings", table_of_pairings, METH_NOARGS, "pairings() -> list of names, by number"},
    {"statuses", table_of_statuses, METH_NOARGS,
     "statuses() -> list of (name, meaning, elements, advice), by number; 0 is OK"},
    {"progress_stages", table_of_progress_stages, METH_NOARGS,
     "progress_stages() -> list of (name, words)"},
    {"hex_stages", table_of_hex_stages, METH_NOARGS, "hex_stages() -> list of (name, words)"},
    {"carriers", table_of_carriers, METH_NOARGS,
     "carriers() -> list of (name, freedom, fields), by number"},
    {"project_points", project_points, METH_VARARGS,
     "project_points(points, carrier_of_point, starts, pieces, project or None, (facet "
     "points, facets, pieces of facets, normals)) -> (points, directions)"},
    {"relax", relax, METH_VARARGS,
     "relax(positions, hexes, carrier_of_point, starts, pieces, project or None, facets as "
     "project_points, rounds, passes, mean_passes, threads, budget, progress)"},
    {"check_surface", check_surface, METH_VARARGS, "check_surface(points, quads) -> dict"},
    {"orient_surface", orient_surface, METH_VARARGS,
     "orient_surface(points, quads) -> (quads, bodies, cavities)"},
    {"embedding", embedding, METH_VARARGS, "embedding(points, quads, progress) -> dict"},
    {"loops", loops, METH_VARARGS, "loops(quads) -> (offsets, quads, self_crossings)"},
    {"colouring", colouring, METH_VARARGS, "colouring(quads, point_count) -> bytearray"},
    {"pairing", pairing, METH_VARARGS,
     "pairing(points or None, point_count, quads, progress) -> bytearray of int32"},
    {"pairing_of_crossings", pairing_of_crossings, METH_VARARGS,
     "pairing_of_crossings(point_count, quads, progress) -> bytearray of int32"},
    {"quality", quality, METH_VARARGS, "quality(points, hexes, order) -> bytearray of float64"},
    {"certify", certify, METH_VARARGS, "certify(points, hexes, quads, order, progress) -> dict"},
    {"morph", morph, METH_VARARGS,
     "morph(positions, hexes, fixed, goal, boundary_only, target, progress) -> reached"},
    {"optimize", optimize, METH_VARARGS,
     "optimize(positions, hexes, fixed, rounds, threads, target, mean_passes, progress)"},
    {"repair", repair, METH_VARARGS,
     "repair(points, hexes, fixed, pillow, threads, progress) -> (points, hexes, pillows)"},
    {"raise_order", raise_order, METH_VARARGS, "raise_order(points, hexes) -> (points, hexes)"},
    {"mesh", mesh, METH_VARARGS,
     "mesh(points, quads, method, order, allow_uncertified, threads, layers, tetrahedralise, "
     "pairing, pairs or None, hexes or None, inner_count, inner or None, skip_certificate, "
     "no_core, allow_topological, pillow, budget, progress) -> "
     "dict"},
    {NULL, NULL, 0, NULL}};

static PyModuleDef_Slot slots[] = {{0, NULL}};

static struct PyModuleDef definition = {
    .m_base = PyModuleDef_HEAD_INIT,
    .m_name = "_core",
    .m_doc = "HexCon's core on contiguous buffers; use hexcon_native instead.",
    .m_size = 0,
    .m_methods = methods,
    .m_slots = slots};

PyMODINIT_FUNC PyInit__core(void); /* Python.h declares it for C++ only */

__attribute__((visibility("default"))) PyMODINIT_FUNC PyInit__core(void) {
  return PyModuleDef_Init(&definition);
}
