# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of a mesh and of its displacements, drawn by VTK without a screen."""
import errno
import os
import shutil
import sys

import numpy as np

import hexcon_native
from hexcon import child, disk
from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh.elements import elements_of
from hexcon.femmesh.hexahedron import FACES, FACES_8
from hexcon.files import replace_file
from hexcon.inspection.cutting import behind_plane, centres_of
from hexcon.inspection.faces import bare_faces, neighbours
from hexcon.inspection.tessellation import pieces_of_face, weights_of_faces
from hexcon.interpreter import python

_FOLDER = os.path.dirname(os.path.abspath(__file__))


def render(mesh, path, *, displacements=None, warp=None, cut="auto", title=None,
           size=None, timeout=300):
    """Write a PNG: left the mesh, cut open between whole hexahedra and coloured by scaled
    Jacobian; right, where displacements are given, the displaced shape. Of order 2 with its curved edges.

    displacements  (P,3) mm, in the mesh's node order; of an order 1 mesh also those
                   of a run at order 2
    warp   factor on the displacements; None: the largest becomes 8 % of the diagonal
    cut    "auto": the half towards the viewer (-y) is taken away;
           None: no cut; or (point (3,), normal (3,)): hexahedra whose centre lies on the
           normal's side are taken away
    size   (width, height) in pixels, (1700, 850) with displacements, else (1000, 850)
    A process of its own draws, under xvfb-run where there is no screen, because Debian's
    VTK ends the whole process without one.
    Raises ToolError: TOOL_MISSING (VTK or xvfb), TOOL_FAILED, TOOL_TIMEOUT, FILE_IO,
    BAD_MESH, BAD_OPTION.
    """
    path = os.fspath(path)
    if not path.lower().endswith(".png"):
        raise ToolError(f"cannot draw {path}: the ending must be .png", FaultCode.FILE_FORMAT)
    draw("scene.py", _job(elements_of(mesh), displacements, warp, cut, title, size), path, timeout)


def draw(program, job, path, timeout=300):
    """Have a program of this folder draw a job, a dict of arrays, to the file path.

    Raises ToolError: TOOL_MISSING, TOOL_FAILED, TOOL_TIMEOUT, FILE_IO.
    """
    with disk.working_folder("hexcon-picture-") as folder:
        arrays = os.path.join(folder, "scene.npz")
        with disk.naming(folder, f"work in {folder}"):
            disk.write_arrays(arrays, job)
        replace_file(path, lambda beside: _draw(program, arrays, beside, timeout))


def _job(elements, displacements, warp, cut, title, size):
    """Plain arrays for scene.py."""
    points, hexes = elements.points, elements.hexes
    job = {"points": points, "quality": hexcon_native.quality(points, hexes).scaled_jacobian, "title": title or ""}
    if displacements is not None:
        displacements = np.asarray(displacements, float)
        if elements.order == 1 and len(displacements) > len(points):
            # of the same mesh at second order: its middle nodes follow the points
            if len(displacements) == len(hexcon_native.raise_order(points, hexes)[0]):
                displacements = displacements[:len(points)]
        if displacements.shape != points.shape or not np.isfinite(displacements).all():
            raise ToolError(f"displacements have shape {displacements.shape}; finite numbers "
                            f"of shape {points.shape} are needed", FaultCode.BAD_OPTION)
        largest = np.linalg.norm(displacements, axis=1).max()
        if warp is None:
            diagonal = np.linalg.norm(np.ptp(points, axis=0))
            warp = _round_factor(0.08 * diagonal / largest) if largest > 0 else 1.0
        job.update(displacements=displacements, warp=float(warp))
    job["size"] = np.array(size or ((1700, 850) if displacements is not None
                                    else (1000, 850)))
    job.update(_faces_to_draw(elements, kept(points, hexes[:, :8], cut)))
    return job


def _faces_to_draw(elements, keep):
    """Arrays for scene.py: the faces of the hexes outside, and of those that are kept, with their rows, and the shape
    functions at the places between which faces are drawn flat."""
    hexes = elements.hexes
    across = neighbours(hexes[:, :8], len(elements.points))
    outside, shown = (bare_faces(across, one) for one in (np.ones(len(hexes), bool), keep))
    nodes = FACES if elements.order == 1 else FACES_8
    weights = weights_of_faces(nodes.shape[1], len(outside[0]))
    pieces, rim = pieces_of_face(len(weights))
    return {"outside": hexes[outside[0][:, None], nodes[outside[1]]],
            "shown": hexes[shown[0][:, None], nodes[shown[1]]],
            "shown_hexes": shown[0], "cut": not keep.all(),
            "weights": weights, "pieces": pieces, "rim": rim}


def _round_factor(factor):
    """1, 2 or 5 times a power of ten, at most the given factor."""
    power = 10.0 ** np.floor(np.log10(factor))
    return float(power * max(m for m in (1, 2, 5) if m <= factor / power * (1 + 1e-9)))


def kept(points, hexes, cut):
    """(H,) bool: hexahedra that stay when the mesh is cut open; cut as of render."""
    if cut is None:
        return np.ones(len(hexes), bool)
    if isinstance(cut, str):
        if cut != "auto":
            raise ToolError(f"cut {cut!r}: \"auto\", None or (point, normal) is possible",
                            FaultCode.BAD_OPTION)
        low, high = points.min(axis=0), points.max(axis=0)
        # the viewer stands at -y (see scene.py)
        point, normal = 0.5 * (low + high), np.array([0.0, -1.0, 0.0])
    else:
        point, normal = (np.asarray(v, float) for v in cut)
    keep = behind_plane(centres_of(points, hexes), point, normal)
    return keep if keep.any() else np.ones(len(hexes), bool)


def _command(program, arrays, path):
    """The drawing program's command line, under xvfb-run where there is no screen."""
    command = [python(), os.path.join(_FOLDER, program), arrays, path]
    if not sys.platform.startswith("linux") or os.environ.get("DISPLAY"):
        return command
    xvfb = shutil.which("xvfb-run")
    if xvfb is None:
        raise ToolError("drawing needs a screen, and there is neither DISPLAY nor xvfb-run "
                        "(Debian: apt install xvfb)", FaultCode.TOOL_MISSING)
    return [xvfb, "-a", "-s", "-screen 0 640x480x24"] + command


def _draw(program, arrays, path, timeout):
    command = _command(program, arrays, path)
    # xvfb-run has a temporary folder of its own
    ended = child.run(command, "the drawing program", timeout=timeout,
                      environment=child.python_environment(python(), [_FOLDER], TMPDIR=os.path.dirname(arrays)))
    if ended.status or not os.path.exists(path):
        if "No module named 'vtk" in ended.output:
            raise ToolError("drawing needs VTK for Python (Debian: apt install python3-vtk9; "
                            "others: pip install vtk)", FaultCode.TOOL_MISSING)
        if "Ran out of disk space" in ended.output:     # and has deleted what it had written: there is space again
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        raise ToolError(f"VTK did not draw the picture, the program {ended.how()}:\n" + ended.last_words(),
                        FaultCode.TOOL_FAILED)
    _check_picture(path)


def _check_picture(path):
    """Raise TOOL_FAILED unless the file begins and ends as a PNG does."""
    with open(path, "rb") as stream:
        begin = stream.read(8)
        stream.seek(max(0, os.path.getsize(path) - 12))
        end = stream.read(12)
    if begin != b"\x89PNG\r\n\x1a\n" or end[4:8] != b"IEND":
        raise ToolError("the drawing program left no whole picture", FaultCode.TOOL_FAILED)
