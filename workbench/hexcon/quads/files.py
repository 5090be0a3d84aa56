# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quad surfaces from mesh files."""
import contextlib
import io
import os

import numpy as np

from hexcon.errors import FaultCode, ToolError

from .cells import CORNERS, surface_from_cells
from .unv import read_unv

MESH_ENDINGS = (".msh", ".inp", ".unv", ".vtk", ".vtu", ".obj", ".mesh")


def surface_from_file(path):
    """The closed quad surface in a .msh .inp .unv .vtk .vtu .obj or .mesh file, as a QuadSurface ("given").

    The file's quad elements, in the file's order; or, if it has volume elements and no closed set of quads, the
    outer faces of these. Second-order elements give their corners. Unused points are dropped, coincident points
    merged only if the surface is open otherwise; notes tell.
    Raises ToolError FILE_IO, FILE_FORMAT, NOT_ALL_QUAD (says how many triangles), BAD_SHAPE. An odd surface, or one
    of several parts, is returned: that is for the core to judge.
    """
    path = os.fspath(path)
    ending = os.path.splitext(path)[1].lower()
    if not os.path.isfile(path):
        raise ToolError(f"there is no file {path}", FaultCode.FILE_IO)
    if ending not in MESH_ENDINGS:
        raise ToolError(f"{ending or 'no ending'}: a surface is read from {', '.join(MESH_ENDINGS)}",
                        FaultCode.FILE_FORMAT)
    points, cells, second = _read(path, ending)
    notes = ["second-order elements: their mid-side points are dropped"] if second else []
    try:
        return surface_from_cells(points, cells, notes)
    except ValueError as error:     # rows of unequal length, of a damaged file
        raise ToolError(f"cannot read {path} as {ending}: {error}", FaultCode.FILE_FORMAT) from error


def _read(path, ending):
    """(points (P,3), dict kind -> rows, whether second-order elements were cut down)."""
    roads = {".unv": (read_unv,), ".vtk": (_read_meshio, _read_vtk), ".vtu": (_read_meshio, _read_vtk)}
    words = []
    for road in roads.get(ending, (_read_meshio,)):
        try:
            return road(path)
        except OSError as error:
            raise ToolError(f"cannot read {path}: {error}", FaultCode.FILE_IO) from error
        except (Exception, SystemExit) as error:   # readers raise what they like, and meshio exits
            words.append(f"{type(error).__name__}: {error}")
    raise ToolError(f"cannot read {path} as {ending}: " + "; ".join(words), FaultCode.FILE_FORMAT)


def _read_meshio(path):
    import meshio
    said = io.StringIO()
    try:
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            mesh = meshio.read(path)
    except SystemExit:
        raise ValueError(" ".join(said.getvalue().split()) or "meshio gave up") from None
    points = np.zeros((len(mesh.points), 3))
    points[:, :mesh.points.shape[1]] = mesh.points
    parts, second = {}, False
    for block in mesh.cells:
        kind, linear = _linear_kind(block.type)
        if kind:
            second |= not linear
            parts.setdefault(kind, []).append(np.asarray(block.data)[:, :CORNERS[kind]])
    return points, {k: np.concatenate(p) for k, p in parts.items()}, second


def _linear_kind(name):
    """("quad", False) for quad8 and so on; (None, True) for points and lines."""
    for kind in CORNERS:
        if name == kind:
            return kind, True
        if name.startswith(kind) and name[len(kind):].isdigit():
            return kind, False
    return None, True


_VTK_KINDS = {5: "triangle", 9: "quad", 10: "tetra", 12: "hexahedron", 13: "wedge", 14: "pyramid",
              22: "triangle", 23: "quad", 28: "quad", 24: "tetra", 25: "hexahedron", 29: "hexahedron",
              26: "wedge", 27: "pyramid"}


def _read_vtk(path):
    """For what meshio does not know, such as legacy POLYDATA."""
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy
    with open(path, "rb") as stream:
        if b"vtk" not in stream.read(256).lower():      # VTK would write warnings to the terminal
            raise ValueError("not a VTK file")
    reader = vtk.vtkXMLUnstructuredGridReader() if path.lower().endswith(".vtu") else vtk.vtkDataSetReader()
    reader.SetFileName(path)
    reader.GlobalWarningDisplayOff()
    reader.Update()
    data = reader.GetOutput()
    if data is None or not data.GetNumberOfCells():
        raise ValueError("VTK finds no cells in it")
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    parts, second = {}, False
    for (code, count), rows in _rows_by_kind(data, len(points)).items():
        kind = {3: "triangle", 4: "quad"}.get(count, "polygon") if code == 7 else _VTK_KINDS.get(code)
        if kind == "polygon":
            raise ValueError(f"a polygon with {count} sides")
        if kind and count < CORNERS[kind]:
            raise ValueError(f"a {kind} with {count} points")
        if kind:
            second |= code > 20
            parts.setdefault(kind, []).append(rows[:, :CORNERS[kind]])
    return points, {k: np.concatenate(p) for k, p in parts.items()}, second


def _rows_by_kind(data, point_count):
    """{(VTK cell type, points): (k, points) rows}. From the bare arrays, checked: on a damaged file VTK's own
    access by cell reads anywhere."""
    from vtk.util.numpy_support import vtk_to_numpy
    if data.IsA("vtkPolyData"):
        cells, codes = data.GetPolys(), None
    elif data.IsA("vtkUnstructuredGrid"):
        cells, codes = data.GetCells(), vtk_to_numpy(data.GetCellTypesArray())
    else:
        raise ValueError(f"a {data.GetClassName()[3:]}, not an unstructured mesh")
    offsets, ids = (vtk_to_numpy(a).astype(np.int64) for a in (cells.GetOffsetsArray(), cells.GetConnectivityArray()))
    codes = np.full(len(offsets) - 1, 7) if codes is None else codes
    counts = np.diff(offsets)
    if (len(codes) != len(counts) or (counts < 0).any() or offsets[0] != 0 or offsets[-1] > len(ids)
            or ids.min(initial=0) < 0 or ids.max(initial=0) >= point_count):
        raise ValueError("its cells name points that do not exist")
    found = {}
    for code, count in {(int(c), int(n)) for c, n in zip(codes, counts)}:
        starts = offsets[:-1][(codes == code) & (counts == count)]
        found[code, count] = ids[starts[:, None] + np.arange(count)]
    return found
