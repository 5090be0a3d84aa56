# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh files: the ending decides. All but .FCStd and .med work without FreeCAD."""
import inspect
import os

from hexcon import disk
from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh.elements import elements_of
from hexcon.topological import BY_KEYWORD, refuse_topological, refuse_topological_method

from . import abaqus, exodus, freecad, gmsh, nek5000, specfem3d, unv, vtk
from .hex_contents import hexes_of, mesh_of
from .readers import READERS, read_contents
from .regular import naming_faults, regular_file

WRITERS = {".inp": abaqus.write, ".msh": gmsh.write, ".vtu": vtk.write_vtu,
           ".vtk": vtk.write_vtk, ".unv": unv.write, ".med": freecad.write_med,
           ".fcstd": freecad.write_fcstd, ".re2": nek5000.write, ".exo": exodus.write,
           ".specfem3d": specfem3d.write}

# What a solver takes as it is: a deck with a material, a document with a FEM mesh object, the own formats of solvers. The
# others, .med among them, hold a bare mesh, which to look at is what topology is for.
SOLVER_ENDINGS = (".inp", ".fcstd", ".re2", ".exo", ".specfem3d")

_OWN_FILES = {specfem3d.write: specfem3d.is_own}    # of writers of folders: what an older one may lose

__all__ = ["READERS", "SOLVER_ENDINGS", "WRITERS", "check_method_for", "ending_of", "read_hexes", "read_mesh",
           "shown", "write"]


def ending_of(path):
    """The ending that decides the format, in small letters: of part.specfem3d/ it is .specfem3d."""
    return os.path.splitext(os.path.normpath(path))[1].lower()


def shown(endings):
    """Endings of a table as people write them, one after the other."""
    return [".FCStd" if ending == ".fcstd" else ending for ending in endings]


def _by_ending(path, table, verb):
    ending = ending_of(path)
    if ending not in table:
        raise ToolError(f"cannot {verb} {path}: ending {ending or '(none)'} is unknown; "
                        f"one of {', '.join(shown(table))} is possible", FaultCode.FILE_FORMAT)
    return table[ending]


def _is_for_solvers(path):
    return ending_of(path) in SOLVER_ENDINGS


def check_method_for(paths, method, allow_topological=False, override=BY_KEYWORD):
    """Raise the TOPOLOGICAL_MESH that write would raise for a mesh of this method: for callers
    with work to do before. override: how it can be allowed, for the words."""
    if any(map(_is_for_solvers, paths)):
        refuse_topological_method(method, allow_topological, override)


def write(mesh, path, *, order=None, allow_topological=False, **options):
    """Write a hex mesh; the ending of path decides the format.

    mesh     .points, .hexes, .quads, .face_of_quad (see femmesh.elements.elements_of)
    order    1, 2 (of a mesh of order 1: with straight edges) or None for the mesh's own
    allow_topological  write a mesh of topology only even to SOLVER_ENDINGS, which solvers take; .inp and
             .FCStd say that it is topological. The other formats, .med too, take it without
    options  .vtu and .vtk: point_data, cell_data (dicts of arrays); .FCStd: solid, a shape or a
             path; the default is mesh.solid, where mesh_solid has put it; .inp: element, C3D8, C3D8R, C3D20 or C3D20R
    The file, of .specfem3d the folder, is written beside its place and then put there: never a partial one.
    Raises ToolError: FILE_FORMAT (ending), FILE_IO (no permission, disk full, no folder),
    FREECAD_MISSING, BAD_MESH, BAD_OPTION, TOPOLOGICAL_MESH.
    """
    path = os.fspath(path)
    writer = _by_ending(path, WRITERS, "write")
    if _is_for_solvers(path):
        refuse_topological(mesh, allow_topological)
    unknown = set(options) - set(inspect.signature(writer).parameters)
    if unknown:
        raise ToolError(f"{', '.join(sorted(unknown))} cannot be put into {path}",
                        FaultCode.BAD_OPTION)
    if writer is freecad.write_fcstd:
        options.setdefault("solid", getattr(mesh, "solid", None))
    elements = elements_of(mesh, order)
    replace_file(path, lambda beside: writer(beside, elements, **options), _OWN_FILES.get(writer))


def replace_file(path, write_to, is_own=None):
    """Call write_to(name beside path), then move that file, or folder, to path, or leave no trace. is_own: see
    disk.put_in_place.

    OSError becomes ToolError(FILE_IO), and so does any fault of a program on a full disk."""
    folder, base = os.path.split(os.path.abspath(path))
    # a folder of its own: some writers (FreeCAD) put files of their own beside theirs
    with disk.naming(folder, f"write {path}"), disk.working_folder(".hexcon-", folder) as beside:
        with disk.naming(folder, f"write {path}"):  # what was written still is there, so the disk is full
            write_to(os.path.join(beside, base))
        disk.put_in_place(os.path.join(beside, base), os.path.abspath(path), is_own)


def read_hexes(path, *, progress=None, **lengths):
    """(points (P,3) float64, hexes (H,8|20) int64, 0-based, VTK order) of a mesh file.

    Endings: READERS. Shells, beams and points are passed over;
    other solids (tetrahedra ...) are an error, for a check must not skip them.
    progress  callable(stage, fraction), called before and while a library reads: what it raises cancels and comes out here
    lengths   scale, unit: see readers.read_contents
    Raises ToolError: FILE_FORMAT, FILE_IO, TOOL_MISSING, BAD_OPTION, FREECAD_MISSING (.med, .FCStd).
    """
    path = regular_file(path)
    found = read_contents(path, progress, **lengths)
    with naming_faults(path):
        return found.points, hexes_of(path, found)


def read_mesh(path, *, progress=None, **lengths):
    """As read_hexes, as a mesh: .points, .hexes, .order, .quads, .face_of_quad, .quad_groups, .node_groups, .notes, .counts.

    quads (n,4) is the whole boundary, outward; face_of_quad (n,) the CAD face numbers that
    write() put into .inp, .msh, .vtu, .unv and .med (surfaces and groups Face1, Face2 ...),
    0 where there are none; groups and node_groups what else the file names: see hex_contents.mesh_of. So a file can be
    given loads by face, and by name. counts {name of a kind of elements in the file: how many}, where the reader knows.
    """
    path = regular_file(path)
    found = read_contents(path, progress, **lengths)
    with naming_faults(path):
        mesh = mesh_of(found.points, hexes_of(path, found), found)
    mesh.counts = found.counts
    return mesh
