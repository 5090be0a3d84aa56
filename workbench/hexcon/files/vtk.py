# SPDX-License-Identifier: LGPL-2.1-or-later
""".vtu and .vtk through VTK: hexahedra with data, for ParaView.

The cells are the hexahedra alone, so that a viewer shows one solid. The sides of hexes carry names: cell data
face_of_side (H,6) is the CAD face of each side, in the order of hexahedron.FACES, 0 inside and on none; a named group
is
an array (H,6) of 0 and 1, a group of nodes point data of 0 and 1, under its name. The .vtu has the boundary quads, and
their CAD faces, as field data boundary_quads (n,4) and face_of_quad (n,) too; in legacy .vtk those stand before the
points, where Gmsh looks for nothing else.
"""
import numpy as np

import hexcon_native
from hexcon.errors import FaultCode, ToolError

_CELL_TYPE = {1: 12, 2: 25}  # VTK_HEXAHEDRON, VTK_QUADRATIC_HEXAHEDRON


def _vtk():
    try:
        from vtkmodules import vtkCommonCore, vtkCommonDataModel, vtkIOLegacy, vtkIOXML
        from vtkmodules.util import numpy_support
    except ImportError as error:
        raise ToolError("writing .vtu and .vtk needs VTK's Python modules (Debian: apt install "
                        "python3-vtk9)", FaultCode.TOOL_MISSING) from error
    return vtkCommonCore, vtkCommonDataModel, vtkIOLegacy, vtkIOXML, numpy_support


def _add_arrays(to, arrays, numpy_support, integer=np.int64):
    for name, array in arrays.items():
        array = np.asarray(array)
        kind = array.dtype if array.dtype == np.uint8 else float if array.dtype.kind == "f" else integer
        array = np.ascontiguousarray(array, kind)
        held = numpy_support.numpy_to_vtk(array, deep=1)
        held.SetName(name)
        to.AddArray(held)


def _cells(hexes, data_model, numpy_support):
    count, size = hexes.shape
    cells = data_model.vtkCellArray()
    cells.SetData(numpy_support.numpy_to_vtkIdTypeArray(
        np.arange(0, size * count + 1, size, dtype=np.int64), deep=1),
        numpy_support.numpy_to_vtkIdTypeArray(
            np.ascontiguousarray(hexes.ravel(), np.int64), deep=1))
    return cells


def _grid(elements, point_data, cell_data, integer=np.int64):
    """vtkUnstructuredGrid of the elements and all data."""
    core, data_model, _, _, numpy_support = _vtk()
    grid = data_model.vtkUnstructuredGrid()
    points = core.vtkPoints()
    points.SetData(numpy_support.numpy_to_vtk(np.ascontiguousarray(elements.points), deep=1))
    grid.SetPoints(points)
    grid.SetCells(_CELL_TYPE[elements.order], _cells(elements.hexes, data_model, numpy_support))
    quality = hexcon_native.quality(elements.points, elements.hexes).scaled_jacobian
    _add_arrays(grid.GetCellData(), {"scaled_jacobian": quality, **_sides(elements), **(cell_data or {})},
                numpy_support, integer)
    _add_arrays(grid.GetPointData(), {**_node_groups(elements), **(point_data or {})}, numpy_support, integer)
    return grid


def _sides(elements):
    """Cell data that name the sides of hexes: (H,6) each."""
    faces = np.zeros((len(elements.hexes), 6), np.int64)
    faces[elements.hex_of_quad, elements.side_of_quad] = elements.face_of_quad
    arrays = {"face_of_side": faces} if faces.any() else {}
    for name, rows in elements.quad_groups.items():
        arrays[name] = np.zeros((len(elements.hexes), 6), np.uint8)
        arrays[name][elements.hex_of_quad[rows], elements.side_of_quad[rows]] = 1
    return arrays


def _node_groups(elements):
    arrays = {}
    for name in elements.node_groups:
        arrays[name] = np.zeros(len(elements.points), np.uint8)
        arrays[name][elements.nodes_of_set(name)] = 1
    return arrays


def _write(writer, path, grid):
    """Through memory: where a disk is full VTK 9 ends the whole process (free(): invalid pointer)."""
    writer.WriteToOutputStringOn()
    writer.SetInputData(grid)
    if writer.Write() != 1:
        raise OSError(f"VTK could not write it (error {writer.GetErrorCode()})")
    with open(path, "wb") as stream:
        said = writer.GetOutputStdString() if hasattr(writer, "GetOutputStdString") else writer.GetOutputString()
        stream.write(said if isinstance(said, bytes) else said.encode())  # VTK decodes what happens to be UTF-8


def write_vtu(path, elements, point_data=None, cell_data=None):
    """point_data, cell_data: {name: (P,) or (P,k)}, {name: (H,) or (H,k)}, optional."""
    writer = _vtk()[3].vtkXMLUnstructuredGridWriter()
    writer.SetDataModeToBinary()
    writer.SetHeaderTypeToUInt64()  # 10^7 hexes of order 2 pass 4 GiB
    grid = _grid(elements, point_data, cell_data)
    _add_arrays(grid.GetFieldData(), {"boundary_quads": elements.quads[:, :4], "face_of_quad": elements.face_of_quad},
                _vtk()[4])
    _write(writer, path, grid)


def write_vtk(path, elements, point_data=None, cell_data=None):
    """As write_vtu, legacy format 4.2, binary: the last that every reader takes.

    Its "vtktypeint64" is unknown to many of them, so integers are written as int32."""
    writer = _vtk()[2].vtkUnstructuredGridWriter()
    writer.SetFileTypeToBinary()
    writer.SetFileVersion(42)
    writer.SetHeader("Hex mesh by HexCon")
    _write(writer, path, _grid(elements, point_data, cell_data, np.int32))
