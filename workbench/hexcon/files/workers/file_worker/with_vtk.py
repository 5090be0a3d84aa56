# SPDX-License-Identifier: LGPL-2.1-or-later
"""VTK's readers of .vtu and legacy .vtk."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkObject

from .mesh import boundary_of, mesh_arrays

# VTK's cell type -> meshio's name, number of points
_KINDS = {5: ("triangle", 3), 9: ("quad", 4), 10: ("tetra", 4), 12: ("hexahedron", 8), 13: ("wedge", 6), 14: ("pyramid", 5),
          22: ("triangle6", 6), 23: ("quad8", 8), 28: ("quad9", 9), 24: ("tetra10", 10), 25: ("hexahedron20", 20),
          29: ("hexahedron27", 27), 26: ("wedge15", 15), 27: ("pyramid13", 13)}
_POLYGON = 7
_POLYGONS = {3: "triangle", 4: "quad"}


def read(path):
    """Arrays of mesh.mesh_arrays. Raises ValueError."""
    with open(path, "rb") as stream:
        if b"vtk" not in stream.read(256).lower():
            raise ValueError("not a VTK file")
    vtkObject.GlobalWarningDisplayOff()
    reader = _reader(path)
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutput()
    if data is None or not data.IsA("vtkPointSet") or not data.GetPoints() or not data.GetNumberOfCells():
        raise ValueError("VTK finds no cells in it")
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    blocks = [(_kind_of(code, count), rows, None) for (code, count), rows in _rows_by_kind(data, len(points)).items()]
    return mesh_arrays(points, blocks, boundary=boundary_of(_fields(data)))


def _reader(path):
    if path.lower().endswith(".vtu"):
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
        return vtkXMLUnstructuredGridReader()
    from vtkmodules.vtkIOLegacy import vtkDataSetReader
    return vtkDataSetReader()


def _kind_of(code, count):
    if code == _POLYGON:
        if count not in _POLYGONS:
            raise ValueError(f"a polygon with {count} sides")
        return _POLYGONS[count]
    kind, right = _KINDS.get(code, (f"vtk cell of type {code}", count))
    if count != right:
        raise ValueError(f"a {kind} with {count} points")
    return kind


def _fields(data):
    """{name: array} of the numeric field data."""
    held = data.GetFieldData()
    arrays = {held.GetArrayName(k): held.GetArray(k) for k in range(held.GetNumberOfArrays())}
    return {name: vtk_to_numpy(array) for name, array in arrays.items() if array is not None}


def _rows_by_kind(data, point_count):
    """{(VTK cell type, points): (k, points) rows}. From the bare arrays, checked: on a damaged file VTK's own
    access by cell reads anywhere."""
    if data.IsA("vtkPolyData"):
        cells, codes = data.GetPolys(), None
    elif data.IsA("vtkUnstructuredGrid"):
        cells, codes = data.GetCells(), vtk_to_numpy(data.GetCellTypesArray())
    else:
        raise ValueError(f"a {data.GetClassName()[3:]}, not an unstructured mesh")
    offsets, ids = (vtk_to_numpy(a).astype(np.int64) for a in (cells.GetOffsetsArray(), cells.GetConnectivityArray()))
    codes = np.full(len(offsets) - 1, _POLYGON) if codes is None else codes
    counts = np.diff(offsets)
    if (len(codes) != len(counts) or (counts < 0).any() or offsets[0] != 0 or offsets[-1] > len(ids)
            or ids.min(initial=0) < 0 or ids.max(initial=0) >= point_count):
        raise ValueError("its cells name points that do not exist")
    found = {}
    for code, count in np.unique(np.column_stack([codes, counts]), axis=0).tolist():
        starts = offsets[:-1][(codes == code) & (counts == count)]
        found[code, count] = ids[starts[:, None] + np.arange(count)]
    return found
