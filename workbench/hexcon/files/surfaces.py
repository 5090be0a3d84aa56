# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of quad surfaces: what hexcon.quads.surface_from_file reads again, bit for bit."""
import os

from hexcon.errors import FaultCode, ToolError

from . import replace_file
from .text import write_rows
from .through_meshio import import_meshio

# Ending -> meshio's name of the format; .obj is written here, so that it needs no meshio.
_MESHIO_FORMATS = {".msh": "gmsh", ".inp": "abaqus", ".vtk": "vtk", ".vtu": "vtu", ".mesh": "medit"}
SURFACE_ENDINGS = (".obj", *_MESHIO_FORMATS)

__all__ = ["SURFACE_ENDINGS", "write_obj", "write_surface"]


def write_surface(surface, path):
    """Write a quad surface; the ending of path decides the format: .obj .msh .inp .vtk .vtu .mesh.

    surface   .points (V,3) float, .quads (n,4) int, 0-based: a quads.QuadSurface
    The file is written beside its place and then put there: never a partial file.
    Raises ToolError: FILE_FORMAT (ending), FILE_IO, TOOL_MISSING (meshio, for all but .obj).
    """
    path = os.fspath(path)
    ending = os.path.splitext(path)[1].lower()
    if ending not in SURFACE_ENDINGS:
        raise ToolError(f"cannot write {path}: a surface is written to one of {', '.join(SURFACE_ENDINGS)}",
                        FaultCode.FILE_FORMAT)
    replace_file(path, lambda beside: _write(surface, beside, ending))


def _write(surface, path, ending):
    if ending == ".obj":
        with open(path, "w", encoding="utf-8") as stream:
            write_obj(stream, surface)
        return
    meshio = import_meshio(path)
    meshio.Mesh(surface.points, [("quad", surface.quads)]).write(path, file_format=_MESHIO_FORMATS[ending])


def write_obj(stream, surface, comments=()):
    """The surface as .obj text: comments, a v line a point, an f line a quad (1-based)."""
    for comment in comments:
        stream.write(f"# {comment}\n")
    write_rows(stream, "v %r %r %r\n", surface.points)
    write_rows(stream, "f %d %d %d %d\n", surface.quads + 1)
