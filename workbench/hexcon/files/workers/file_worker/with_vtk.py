# SPDX-License-Identifier: LGPL-2.1-or-later
"""VTK's readers of .vtu, .vtp, .vts, .vtr, .vti and legacy .vtk, of .ply, Exodus and CGNS."""
import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkObject

from hexcon.femmesh.hexahedron import FACES

from .cut_short import check_legacy, check_xml
from .mesh import groups_of_fields, joined, mesh_arrays
from .ply_length import check_ply, with_line_end

# VTK's cell type -> meshio's name, number of points
_KINDS = {5: ("triangle", 3), 9: ("quad", 4), 10: ("tetra", 4), 12: ("hexahedron", 8), 13: ("wedge", 6), 14: ("pyramid", 5),
          22: ("triangle6", 6), 23: ("quad8", 8), 28: ("quad9", 9), 24: ("tetra10", 10), 25: ("hexahedron20", 20),
          29: ("hexahedron27", 27), 26: ("wedge15", 15), 27: ("pyramid13", 13),
          70: ("quad9", 9), 72: ("hexahedron27", 27)}   # Lagrange's, of second order: corners come first
_POLYGON = 7
_POLYGONS = {3: "triangle", 4: "quad"}
# Cells whose points go row by row, not round: the same with places in another sequence.
_PIXEL, _VOXEL = 8, 11
_ROWWISE = {_PIXEL: ("quad", [0, 1, 3, 2]), _VOXEL: ("hexahedron", [0, 1, 3, 2, 4, 5, 7, 6])}
_PASSED_OVER = {1: "vertex", 2: "vertex", 3: "line", 4: "line", 21: "line3", 35: "line4", 68: "line"}
_READERS = {".vtu": ("vtkIOXML", "vtkXMLUnstructuredGridReader"), ".vtp": ("vtkIOXML", "vtkXMLPolyDataReader"),
            ".vts": ("vtkIOXML", "vtkXMLStructuredGridReader"), ".vtr": ("vtkIOXML", "vtkXMLRectilinearGridReader"),
            ".vti": ("vtkIOXML", "vtkXMLImageDataReader"), ".ply": ("vtkIOPLY", "vtkPLYReader"),
            ".vtk": ("vtkIOLegacy", "vtkDataSetReader")}


def read(path):
    """Arrays of mesh.mesh_arrays. Raises ValueError."""
    vtkObject.GlobalWarningDisplayOff()
    ending = os.path.splitext(path)[1].lower()
    _check_head(path, ending)
    reader = _reader(ending)
    reader.SetFileName(with_line_end(path) if ending == ".ply" else path)
    if ending == ".vtk":
        reader.ReadAllScalarsOn()
        reader.ReadAllFieldsOn()
    reader.Update()
    return arrays_of(reader.GetOutput())


def arrays_of(data):
    """Arrays of mesh.mesh_arrays of a vtkDataSet."""
    data = _as_unstructured(data)
    if data is None or not data.GetNumberOfCells() or not data.GetPoints():
        raise ValueError("VTK finds no cells in it")
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    found = _rows_by_kind(data, len(points))
    blocks, places = joined([(kind, rows) for kind, rows, _ in found])
    groups = _groups(data, found, places)
    if not any(kind == "faces" for _, kind, _ in groups):   # HexCon before 0.3 wrote no sides
        groups += groups_of_fields(_fields(data.GetFieldData()))
    return mesh_arrays(points, blocks, groups)


def _check_head(path, ending):
    with open(path, "rb") as stream:
        head = stream.read(256).lower()
    if ending == ".ply" and not head.startswith(b"ply"):
        raise ValueError("not a PLY file")
    if ending != ".ply" and b"vtk" not in head:
        raise ValueError("not a VTK file")
    if ending == ".vtk":
        check_legacy(path)
    else:
        (check_ply if ending == ".ply" else check_xml)(path)


def _reader(ending):
    import importlib
    module, name = _READERS[ending]
    return getattr(importlib.import_module("vtkmodules." + module), name)()


def _as_unstructured(data):
    """Structured grids, and images, as the cells that they stand for."""
    if data is None or not data.IsA("vtkDataSet"):
        return None
    if data.IsA("vtkPolyData") or data.IsA("vtkUnstructuredGrid"):
        return data
    from vtkmodules.vtkFiltersCore import vtkAppendFilter
    together = vtkAppendFilter()
    together.AddInputData(data)
    together.Update()
    return together.GetOutput()


def _fields(held):
    """{name: array} of the numeric arrays of a vtkFieldData."""
    arrays = {held.GetArrayName(k): held.GetArray(k) for k in range(held.GetNumberOfArrays())}
    return {name: vtk_to_numpy(array) for name, array in arrays.items() if array is not None and name}


def _rows_by_kind(data, point_count):
    """[(kind, (k,n) rows, numbers (k,) of the cells)], each type of cells once. From the bare arrays, checked: on a damaged
    file VTK's own access by cell reads anywhere."""
    if data.IsA("vtkPolyData"):
        if data.GetNumberOfStrips():
            raise ValueError("triangle strips; quads are needed")
        before = data.GetNumberOfVerts() + data.GetNumberOfLines()
        cells, codes = data.GetPolys(), None
    else:
        cells, codes, before = data.GetCells(), vtk_to_numpy(data.GetCellTypesArray()), 0
    offsets = vtk_to_numpy(cells.GetOffsetsArray()).astype(np.int64)
    entries = vtk_to_numpy(cells.GetConnectivityArray()).astype(np.int64)
    sizes = np.diff(offsets)
    if codes is None:
        codes = np.full(len(sizes), _POLYGON)
    if len(codes) != len(sizes) or not len(sizes) or offsets[0] != 0 or (sizes < 0).any() or offsets[-1] > len(entries):
        raise ValueError("its cells are not as many, or as long, as they should be")
    if len(entries) and (entries.min() < 0 or entries.max() >= point_count):
        raise ValueError("a cell names a point that does not exist")
    found = []
    for code, size in np.unique(np.column_stack([codes, sizes]), axis=0).tolist():
        numbers = np.flatnonzero((codes == code) & (sizes == size))
        rows = entries[offsets[numbers][:, None] + np.arange(size)]
        if code in _ROWWISE and size == len(_ROWWISE[code][1]):
            found.append((_ROWWISE[code][0], rows[:, _ROWWISE[code][1]], before + numbers))
        else:
            found.append((_kind_of(code, size), rows, before + numbers))
    return found


def _kind_of(code, count):
    if code == _POLYGON:
        if count not in _POLYGONS:
            raise ValueError(f"a {count}-gon; quads are needed")
        return _POLYGONS[count]
    if code in _PASSED_OVER:
        return _PASSED_OVER[code]
    kind, right = _KINDS.get(code, (f"polyhedron, VTK type {code}", count))
    if count != right:
        raise ValueError(f"a {kind} with {count} points")
    return kind


# ------------------------------------------------------------------------------ groups

def _groups(data, found, places):
    """[(name, kind, members)]: what HexCon writes (arrays of 0 and 1, six for the sides of each hex, or one for a point),
    and of quads each value of an array of whole numbers, called NAME=3, or NAME where the array is of 0 and 1."""
    groups = []
    for name, array in _fields(data.GetPointData()).items():
        if array.ndim == 1 and array.dtype == np.uint8 and _is_mask(array):
            groups.append((name, "nodes", np.flatnonzero(array)))
    for name, array in _fields(data.GetCellData()).items():
        for (kind, rows, numbers), (_, first) in zip(found, places):
            if not numbers.size or numbers.max() >= len(array):
                continue
            if kind.startswith("hexahedron") and array.ndim == 2 and array.shape[1] == 6 and array.dtype.kind in "iu":
                groups += _of_sides(name, array[numbers], rows)
            elif kind.startswith("quad") and array.ndim == 1 and array.dtype.kind in "iu":
                groups += _of_quads(name, array[numbers], kind, first)
    return groups


def _is_mask(array):
    return len(array) and array.max() == 1


def _of_sides(name, values, rows):
    if name == "face_of_side":
        return [(f"Face{n}", "faces", rows[:, FACES][values == n]) for n in np.unique(values[values > 0]).tolist()]
    return [(name, "faces", rows[:, FACES][values == 1])] if _is_mask(values) else []


_MOST_VALUES = 1000     # of an array that means groups


def _of_quads(name, values, kind, first):
    found = np.unique(values).tolist()
    if len(found) < 2 or len(found) > _MOST_VALUES:
        return []
    if found == [0, 1]:
        return [(name, kind, first + np.flatnonzero(values == 1))]
    return [(f"{name}={value}", kind, first + np.flatnonzero(values == value)) for value in found if value > 0]
