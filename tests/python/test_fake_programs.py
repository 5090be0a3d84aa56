# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs that are not what they seem: in place of gmsh, tetgen, CalculiX, FreeCAD and the drawing program stand fakes
that die, hang, print rubbish or hand back wrong meshes. Each is told by name, within its limits, and leaves nothing.

A fake is a shell script. What it hands back was prepared before, beside it, as $here/result.npz and so on.
"""
import json
import os
import pathlib
import pickle
import sys
import tempfile
import uuid
import zipfile

import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))
from hex_grids import block  # noqa: E402
from test_signals import processes_with, wait_for  # noqa: E402

import hexcon  # noqa: E402
import hexcon_native  # noqa: E402
from hexcon import answers, calculix, child, gmsh_process, keeper  # noqa: E402
from hexcon.cli import in_freecad  # noqa: E402
from hexcon.errors import FaultCode, HexconError, ToolError  # noqa: E402
from hexcon.pictures import render  # noqa: E402
from hexcon.quads import surface_from_solid  # noqa: E402
from hexcon.tetrahedra import tetrahedralise  # noqa: E402

WEDGE = str(ROOT / "resources" / "examples" / "wedge.step")
LIMIT = 0.4             # seconds for a program that hangs
MOST_OUTPUT = 1 << 20   # bytes, lowered for the tests

# The least box, as a quad surface, as triangles, and with one inner point as tetrahedra; and as a hex mesh.
CORNERS = np.array([(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
QUADS = np.array([(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)])
TRIANGLES = np.concatenate([QUADS[:, [0, 1, 2]], QUADS[:, [0, 2, 3]]])
WITH_MIDDLE = np.vstack([CORNERS, (0.5, 0.5, 0.5)])
TETRAHEDRA = np.column_stack([TRIANGLES[:, [0, 2, 1]], np.full(12, 8)])
SURFACE = {"points": CORNERS, "quads": QUADS, "faces": np.arange(1, 7), "off_cad": np.zeros(8), "cad_gap": np.zeros(8),
           "tolerance": np.float64(1e-7), "method": np.array("subdivided"), "notes": np.array(["made by hand"])}
FILLING = {"Delaunay_points": WITH_MIDDLE, "Delaunay_tetrahedra": TETRAHEDRA, "HXT_fault": np.array("not tried")}

DIES, HANGS = "exit 3", "sleep 600 & wait"
# What any program can do: (shell, code, words); {} is how the program is called in words.
ANY = {
    "dies at once": (DIES, "TOOL_FAILED", "status 3"),
    "is killed": ("kill -SEGV $$", "TOOL_FAILED", "signal 11"),
    "does nothing": (":", "TOOL_FAILED", ""),
    "hangs": (HANGS, "TOOL_TIMEOUT", "did not"),
    "hangs and will not end": ("trap '' TERM INT; while :; do sleep 1; done", "TOOL_TIMEOUT", "did not"),
    "prints without end": ("exec yes rubbish", "TOOL_FAILED", "printed more than"),
    "prints rubbish and dies": ("head -c 300000 /dev/urandom; exit 3", "TOOL_FAILED", "status 3"),
    "leaves a process behind": ("sleep 600 & exit 3", "TOOL_FAILED", "status 3"),
}


def changed(of, **arrays):
    """The arrays with some changed, or without those that are None."""
    return {name: array for name, array in {**of, **arrays}.items() if array is not None}


def put(array, row, value):
    array = np.array(array)
    array[row] = value
    return array


def npz(arrays):
    return lambda folder: np.savez(folder / "result.npz", **arrays)


def text(name, words):
    return lambda folder: (folder / name).write_bytes(words if isinstance(words, bytes) else words.encode())


def half(arrays):
    def write(folder):
        np.savez(folder / "whole.npz", **arrays)
        (folder / "result.npz").write_bytes((folder / "whole.npz").read_bytes()[:700])
    return write


def bomb(folder):
    """A gigabyte of zeros, packed."""
    with zipfile.ZipFile(folder / "result.npz", "w", zipfile.ZIP_DEFLATED) as archive, archive.open("points.npy", "w") as stream:
        np.lib.format.write_array_header_1_0(stream, {"descr": "<f8", "fortran_order": False, "shape": (40_000_000, 3)})
        for _ in range(4):
            stream.write(bytes(1 << 20))


def pickled(folder):
    """An array that would run a program when it is read."""
    class Runs:
        def __reduce__(self):
            return os.system, (f"touch {folder}/was-run",)
    assert pickle.dumps(Runs())
    np.savez(folder / "result.npz", **changed(SURFACE, notes=np.array([Runs()], object)))


# gmsh's worker: `python -m gmsh_worker $folder/job.json`. case: (what is prepared, shell, code or None, words)
HAND_OVER = 'cp "$here"/* "$folder"/'
GMSH = {
    "a good surface": (npz(SURFACE), HAND_OVER, None, ""),
    "its best until then, and hangs": (npz(SURFACE), 'cp "$here"/result.npz "$folder"/best.npz; ' + HANGS, None, ""),
    "half its best, and hangs": (half(SURFACE), 'cp "$here"/result.npz "$folder"/best.npz; ' + HANGS, "TOOL_FAILED",
                                 "damaged"),
    "half a file": (half(SURFACE), HAND_OVER, "TOOL_FAILED", "damaged"),
    "an empty file": (text("result.npz", ""), HAND_OVER, "TOOL_FAILED", "damaged"),
    "rubbish": (text("result.npz", bytes(range(256)) * 40), HAND_OVER, "TOOL_FAILED", "damaged"),
    "a good surface and dies": (npz(SURFACE), HAND_OVER + "; exit 3", "TOOL_FAILED", "status 3"),
    "its last words": (None, 'echo fine; echo "Error   : out of luck"; echo fine; exit 1', "TOOL_FAILED", "out of luck"),
    "crash after crash": (None, 'echo $$ > "$folder"/risk.txt; kill -SEGV $$', "TOOL_FAILED", "signal 11"),
    "rubbish as its risk": (None, 'head -c 9999 /dev/urandom > "$folder"/risk.txt; exit 3', "TOOL_FAILED", "status 3"),
    "rubbish as progress": (npz(SURFACE), 'head -c 9999 /dev/urandom > "$folder"/progress.txt; sleep 0.2; ' + HAND_OVER,
                            None, ""),
    "progress nan": (npz(SURFACE), 'echo "x nan" > "$folder"/progress.txt; sleep 0.2; ' + HAND_OVER, None, ""),
    "writes without end": (None, 'exec yes rubbish > "$folder"/result.npz', "TOOL_FAILED", "wrote more than"),
    "the folder is gone": (None, 'rm -r "$folder"', "TOOL_FAILED", "status 0"),
    "a folder as its result": (None, 'mkdir "$folder"/result.npz', "TOOL_FAILED", "damaged"),
    "a fault": (text("fault.json", json.dumps({"code": "NOT_BLOCKS", "message": "so it is", "elements": [3]})), HAND_OVER,
                "NOT_BLOCKS", "so it is"),
    "half a fault": (text("fault.json", '{"code": "NOT_BL'), HAND_OVER, "TOOL_FAILED", "damaged"),
    "a fault of no name": (text("fault.json", json.dumps({"code": "LUCK", "message": "m", "elements": []})), HAND_OVER,
                           "TOOL_FAILED", "LUCK"),
    "a fault that is a list": (text("fault.json", "[1, 2]"), HAND_OVER, "TOOL_FAILED", "no object"),
    "an open surface": (npz(changed(SURFACE, quads=QUADS[1:], faces=np.arange(1, 6))), HAND_OVER, "NOT_CLOSED", "not closed"),
    "an odd surface": (npz(changed(
        SURFACE, points=np.vstack([CORNERS, (0.4, 0.4, 0)]), off_cad=np.zeros(9), cad_gap=np.zeros(9), faces=np.arange(7),
        quads=np.array([(0, 2, 3, 8), (0, 8, 3, 1), *QUADS[1:].tolist()]))), HAND_OVER, "TOOL_FAILED", "faces"),
    "an odd surface, well numbered": (npz(changed(
        SURFACE, points=np.vstack([CORNERS, (0.4, 0.4, 0)]), off_cad=np.zeros(9), cad_gap=np.zeros(9),
        faces=np.arange(1, 8), quads=np.array([(0, 2, 3, 8), (0, 8, 3, 1), *QUADS[1:].tolist()]))), HAND_OVER,
        "ODD_SURFACE", "odd"),
    "inside out": (npz(changed(SURFACE, quads=QUADS[:, ::-1])), HAND_OVER, None, ""),
    "two bodies": (npz(changed(SURFACE, points=np.vstack([CORNERS, CORNERS + 5]), quads=np.vstack([QUADS, QUADS + 8]),
                               faces=np.arange(1, 13), off_cad=np.zeros(16), cad_gap=np.zeros(16))), HAND_OVER,
                   "BAD_SHAPE", "2 separate bodies"),
    "a point twice in a quad": (npz(changed(SURFACE, quads=put(QUADS, 0, (0, 0, 3, 1)))), HAND_OVER, "REPEATED_VERTEX", "twice"),
    "off the CAD": (npz(changed(SURFACE, off_cad=put(np.zeros(8), 5, 0.1))), HAND_OVER, "OFF_CAD", "1 points are off"),
    "NaN off the CAD": (npz(changed(SURFACE, off_cad=put(np.zeros(8), 5, np.nan))), HAND_OVER, "OFF_CAD", "1 points"),
    "NaN everywhere off the CAD": (npz(changed(SURFACE, off_cad=np.full(8, np.nan))), HAND_OVER, "OFF_CAD", "8 points"),
    "a NaN point": (npz(changed(SURFACE, points=put(CORNERS, 2, np.nan))), HAND_OVER, "TOOL_FAILED", "not finite"),
    "an id out of range": (npz(changed(SURFACE, quads=put(QUADS, 0, (0, 2, 3, 8)))), HAND_OVER, "TOOL_FAILED", "0 to 8"),
    "an id below zero": (npz(changed(SURFACE, quads=put(QUADS, 0, (0, 2, 3, -1)))), HAND_OVER, "TOOL_FAILED", "-1 to"),
    "quads of numbers": (npz(changed(SURFACE, quads=QUADS + 0.5)), HAND_OVER, "TOOL_FAILED", "integers"),
    "points of text": (npz(changed(SURFACE, points=CORNERS.astype(str))), HAND_OVER, "TOOL_FAILED", "numbers"),
    "triangles as quads": (npz(changed(SURFACE, quads=QUADS[:, :3])), HAND_OVER, "TOOL_FAILED", "shape"),
    "no points": (npz(changed(SURFACE, points=None)), HAND_OVER, "TOOL_FAILED", "damaged"),
    "no quads at all": (npz(changed(SURFACE, quads=np.empty((0, 4), int), faces=np.empty(0, int))), HAND_OVER, "EMPTY",
                        "no quads"),
    "too few faces": (npz(changed(SURFACE, faces=np.arange(1, 4))), HAND_OVER, "TOOL_FAILED", "shape"),
    "Python objects": (pickled, HAND_OVER, "TOOL_FAILED", "objects"),
    "a bomb": (bomb, HAND_OVER, "TOOL_FAILED", "compressed"),
}

# The tetrahedra's worker, and no tetgen.
FILL = {
    "good tetrahedra": (npz(FILLING), HAND_OVER, None, ""),
    "inside out": (npz(changed(FILLING, Delaunay_tetrahedra=TETRAHEDRA[:, [1, 0, 2, 3]])), HAND_OVER, None, ""),
    "faults alone": (npz({"Delaunay_fault": np.array("too hard"), "HXT_fault": np.array("much too hard")}), HAND_OVER,
                     "TOOL_FAILED", "much too hard"),
    "nothing": (npz({"other": np.zeros(3)}), HAND_OVER, "TOOL_FAILED", "not tried"),
    "too few": (npz(changed(FILLING, Delaunay_tetrahedra=TETRAHEDRA[1:])), HAND_OVER, "TOOL_FAILED", "boundary"),
    "none": (npz(changed(FILLING, Delaunay_tetrahedra=np.empty((0, 4), int))), HAND_OVER, "TOOL_FAILED", "no tetrahedra"),
    "one twice": (npz(changed(FILLING, Delaunay_tetrahedra=np.vstack([TETRAHEDRA, TETRAHEDRA[:1]]))), HAND_OVER,
                  "TOOL_FAILED", "more than two"),
    "one inside out": (npz(changed(FILLING, Delaunay_tetrahedra=put(TETRAHEDRA, 0, TETRAHEDRA[0, [1, 0, 2, 3]]))),
                       HAND_OVER, "TOOL_FAILED", "boundary"),
    "other diagonals": (npz(changed(FILLING, Delaunay_tetrahedra=np.column_stack(
        [np.concatenate([QUADS[:, [0, 3, 1]], QUADS[:, [1, 3, 2]]]), np.full(12, 8)]))), HAND_OVER, "TOOL_FAILED",
        "not the given triangles"),
    "a moved point": (npz(changed(FILLING, Delaunay_points=put(WITH_MIDDLE, 0, -1e-9))), HAND_OVER, "TOOL_FAILED", "moved"),
    "a NaN inside": (npz(changed(FILLING, Delaunay_points=put(WITH_MIDDLE, 8, np.nan))), HAND_OVER, "TOOL_FAILED",
                     "not finite"),
    "a point outside": (npz(changed(FILLING, Delaunay_points=put(WITH_MIDDLE, 8, 7.0))), HAND_OVER, "TOOL_FAILED",
                        "flat or inside out"),
    "an id out of range": (npz(changed(FILLING, Delaunay_tetrahedra=put(TETRAHEDRA, 0, 9))), HAND_OVER, "TOOL_FAILED",
                           "0 to 9"),
    "tetrahedra of numbers": (npz(changed(FILLING, Delaunay_tetrahedra=TETRAHEDRA + 0.0)), HAND_OVER, "TOOL_FAILED",
                              "integers"),
    "points and no tetrahedra": (npz({"Delaunay_points": WITH_MIDDLE}), HAND_OVER, "TOOL_FAILED", "not tried"),
    "tetrahedra and no points": (npz({"Delaunay_tetrahedra": TETRAHEDRA}), HAND_OVER, "TOOL_FAILED", ""),
}


def table(rows, attributes=""):
    rows = np.asarray(rows)
    lines = [" ".join(map(str, [k, *row])) for k, row in enumerate(rows.tolist())]
    return "\n".join([f"{len(rows)} {attributes}", *lines, "# made by hand"]) + "\n"


def tetgen(node=table(WITH_MIDDLE, "3 0 0"), ele=table(TETRAHEDRA, "4 0")):
    def write(folder):
        for name, words in (("surface.1.node", node), ("surface.1.ele", ele)):
            if words is not None:
                text(name, words)(folder)
    return write


# tetgen, after a gmsh that found nothing: it works in its working folder.
FROM_TETGEN = 'cp "$here"/* .'
TETGEN = {
    "good tetrahedra": (tetgen(), FROM_TETGEN, None, ""),
    "and dies": (tetgen(), FROM_TETGEN + "; exit 2", "TOOL_FAILED", "status 2"),
    "no elements": (tetgen(ele=None), FROM_TETGEN, "TOOL_FAILED", "tetgen ended with status 0"),
    "half the points": (tetgen(node=table(WITH_MIDDLE, "3 0 0")[:60]), FROM_TETGEN, "TOOL_FAILED", "tetgen"),
    "rubbish": (tetgen(node=bytes(range(256))), FROM_TETGEN, "TOOL_FAILED", "tetgen"),
    "a NaN": (tetgen(node=table(put(WITH_MIDDLE, 8, np.nan), "3 0 0")), FROM_TETGEN, "TOOL_FAILED", "tetgen"),
    "too few points": (tetgen(node=table(CORNERS[:7], "3 0 0")), FROM_TETGEN, "TOOL_FAILED", "points are missing"),
    "an id out of range": (tetgen(ele=table(put(TETRAHEDRA, 0, 9), "4 0")), FROM_TETGEN, "TOOL_FAILED", "does not exist"),
    "a huge id": (tetgen(ele=table(put(TETRAHEDRA + 0.0, 0, 1e300), "4 0")), FROM_TETGEN, "TOOL_FAILED", "does not exist"),
    "too few": (tetgen(ele=table(TETRAHEDRA[1:], "4 0")), FROM_TETGEN, "TOOL_FAILED", "boundary"),
    "empty files": (tetgen("", ""), FROM_TETGEN, "TOOL_FAILED", "tetgen"),
    "a count of 10^18": (tetgen(node="1000000000000000000 3 0 0\n0 0 0 0\n"), FROM_TETGEN, "TOOL_FAILED", "tetgen"),
}


def row(k, *values):
    return " -1%10d%s\n" % (k, "".join(value if isinstance(value, str) else f"{value:12.5E}" for value in values))


def block_of(name, rows, count=None):
    head = f"  100CL  101 1.000000000{len(rows) if count is None else count:12d}                     0    1           1\n"
    return head + f" -4  {name:8}    4    1\n" + "".join(rows) + " -3\n"


DISPLACED = [row(k, 0.0, 1e-3, 0.0) for k in range(1, 9)]
STRESSED = [row(k, 1, 0, 0, 0, 0, 0) for k in range(1, 9)]


def frd(disp=DISPLACED, stress=STRESSED, end=" 9999\n", count=None):
    """A file of results, of the box as one hex."""
    words = "    1C\n" + (block_of("DISP", disp, count) if disp is not None else "")
    words += block_of("STRESS", stress) if stress is not None else ""
    return text("deck.frd", words + end)


def at_points(line):
    """Good results, and a line of stresses at an integration point beside them."""
    def write(folder):
        frd()(folder)
        text("deck.dat", f"x\n\n stresses (elem) for set\n\n {line}\n")(folder)
    return write


# CalculiX: `ccx -i deck`, in the folder of the deck.
CCX = {
    "good results": (frd(), FROM_TETGEN, None, ""),
    "no stresses": (frd(stress=None), FROM_TETGEN, None, ""),
    "an error and status 0": (frd(), FROM_TETGEN + "; echo ' *ERROR reading *STEP:'; echo '   out of luck'", "TOOL_FAILED",
                              "out of luck"),
    "status 201": (frd(), FROM_TETGEN + "; exit 201", "TOOL_FAILED", "status 201"),
    "an element": (None, "echo ' *ERROR in e_c3d: nonpositive jacobian determinant in element 1'; exit 201", "TOOL_FAILED",
                   "nonpositive"),
    "a huge element": (None, f"echo ' *ERROR in element {10 ** 40}'; exit 201", "TOOL_FAILED", "ERROR"),
    "NaN": (frd(DISPLACED[:3] + [row(4, "         NaN", 0, 0)] + DISPLACED[4:]), FROM_TETGEN, "TOOL_FAILED",
            "displacements of 1 nodes are no finite numbers, numbers 4"),
    "infinity": (frd(DISPLACED[:3] + [row(4, "    Infinity", 0, 0)] + DISPLACED[4:]), FROM_TETGEN, "TOOL_FAILED", "finite"),
    "NaN beside a long exponent": (frd([row(1, "1.00000E-101", 0, 0), row(2, "         NaN", 0, 0), *DISPLACED[2:]]),
                                   FROM_TETGEN, "TOOL_FAILED", "finite"),
    "NaN stresses": (frd(stress=[row(k, *["         NaN"] * 6) for k in range(1, 9)]), FROM_TETGEN, "TOOL_FAILED",
                     "stress of 8 nodes"),
    "stars": (frd(DISPLACED[:7] + [row(8, "*" * 12, 0, 0)]), FROM_TETGEN, "TOOL_FAILED", "damaged"),
    "a node missing": (frd(DISPLACED[:7], STRESSED[:7]), FROM_TETGEN, "TOOL_FAILED", "no results of 1 nodes, numbers 8"),
    "a strange node": (frd(DISPLACED + [row(9, 0, 0, 0)], STRESSED + [row(9, 0, 0, 0, 0, 0, 0)]), FROM_TETGEN,
                       "TOOL_FAILED", "not in the model, numbers 9"),
    "a node twice": (frd(DISPLACED[:7] + DISPLACED[:1]), FROM_TETGEN, "TOOL_FAILED", "twice"),
    "fewer than announced": (frd(DISPLACED[:7], count=8), FROM_TETGEN, "TOOL_FAILED", "announced"),
    "stresses of half the nodes": (frd(stress=STRESSED[:4]), FROM_TETGEN, "TOOL_FAILED", "no stresses"),
    "no displacements": (frd(disp=None), FROM_TETGEN, "TOOL_FAILED", "hold no displacements"),
    "no nodes": (frd(disp=[], stress=None), FROM_TETGEN, "TOOL_FAILED", "hold no displacements"),
    "cut short": (frd(end=""), FROM_TETGEN, "TOOL_FAILED", "end before their time"),
    "an empty file": (text("deck.frd", ""), FROM_TETGEN, "TOOL_FAILED", "end before their time"),
    "rubbish": (text("deck.frd", b"\n -4  DISP    " + bytes(range(256)) + b" 9999\n"), FROM_TETGEN, "TOOL_FAILED", ""),
    "old results": (frd(), FROM_TETGEN + "; touch -d 2001-01-01 deck.frd", "TOOL_FAILED", "older than the deck"),
    "rubbish at the points": (at_points("1 1 1 1 1 1 1 x"), FROM_TETGEN, "TOOL_FAILED", "deck.dat is damaged"),
    "NaN at the points": (at_points("1 1 NaN 1 1 1 1 1"), FROM_TETGEN, "TOOL_FAILED", "not finite"),
}

# freecadcmd: `freecadcmd in_freecad.py -- $folder mesh ...`
FREECAD = {
    "an answer": (text("answer.json", json.dumps({"status": 3, "output": "said", "errors": ""})), HAND_OVER, None, ""),
    "an answer and dies": (text("answer.json", json.dumps({"status": 0, "output": "", "errors": ""})),
                           HAND_OVER + "; kill -SEGV $$", "TOOL_FAILED", "signal 11"),
    "half an answer": (text("answer.json", '{"status": 0, "outp'), HAND_OVER, "TOOL_FAILED", "damaged"),
    "a status that is text": (text("answer.json", json.dumps({"status": "0", "output": "", "errors": ""})), HAND_OVER,
                              "TOOL_FAILED", "no status"),
    "a long answer": (None, 'truncate -s 16G "$folder"/answer.json', "TOOL_FAILED", "bytes long"),
    "half an answer beside": (text("answer.json.part", "{"), HAND_OVER, "TOOL_FAILED", "did not come to an answer"),
}

# The drawing program: it is given the picture's path last.
PICTURE = {
    "no picture": (None, ':', "TOOL_FAILED", "did not draw"),
    "half a picture": (None, 'printf "\\211PNG\\r\\n\\032\\nhalf" > "$last"', "TOOL_FAILED", "no whole picture"),
    "an empty picture": (None, ': > "$last"', "TOOL_FAILED", "no whole picture"),
    "no VTK": (None, "echo \"ModuleNotFoundError: No module named 'vtkmodules'\"; exit 1", "TOOL_MISSING", "python3-vtk9"),
}


def by_gmsh(program, monkeypatch, timeout):
    monkeypatch.setenv("HEXCON_GMSH_PYTHON", program)
    surface = surface_from_solid(WEDGE, 1.0, "subdivided", timeout=timeout, progress=lambda stage, fraction: None)
    report = hexcon_native.check_surface(surface.points, surface.quads)
    assert report.n == 6 and report.oriented and report.volume == 1.0


def by_filling(program, monkeypatch, timeout):
    monkeypatch.setenv("HEXCON_GMSH_PYTHON", program)
    monkeypatch.setenv("HEXCON_TETGEN", "")
    points, tetrahedra = tetrahedralise(CORNERS, TRIANGLES, timeout=timeout)
    assert len(points) == 9 and len(tetrahedra) == 12


def by_tetgen(program, monkeypatch, timeout):
    monkeypatch.setenv("HEXCON_GMSH_PYTHON", "no-such-python")
    monkeypatch.setenv("HEXCON_TETGEN", program)
    points, tetrahedra = tetrahedralise(CORNERS, TRIANGLES, timeout=timeout)
    assert len(points) == 9 and len(tetrahedra) == 12


def by_ccx(program, monkeypatch, timeout):
    deck = calculix.static_deck(block(1, 1, 1), force={"Face2": (1.0, 0.0, 0.0)})
    found = calculix.solve_inp(deck, ccx=program, timeout=timeout, nodes=np.arange(1, 9))
    assert found.max_displacement == 1e-3


def by_freecad(program, monkeypatch, timeout):
    monkeypatch.setenv("FREECADCMD", program)
    monkeypatch.setattr(in_freecad, "STARTING", timeout)
    assert in_freecad.rerun(["mesh"]) == 3


def by_drawing(program, monkeypatch, timeout):
    monkeypatch.setenv("HEXCON_PYTHON", program)
    monkeypatch.setenv("DISPLAY", ":none")      # no xvfb-run
    render(block(1, 1, 1), os.path.join(os.path.dirname(program), "out", "x.png"), timeout=timeout)


# road: (how it is called, what the script says first, its cases)
PROBE = '[ "$1" = -c ] && exit 0; folder=$(dirname "$3")\n'
ROADS = {"gmsh": (by_gmsh, PROBE, GMSH), "tetrahedra": (by_filling, PROBE, FILL), "tetgen": (by_tetgen, "", TETGEN),
         "ccx": (by_ccx, "", CCX), "freecadcmd": (by_freecad, "folder=$3\n", FREECAD),
         "drawing": (by_drawing, 'for last; do :; done\n', PICTURE)}
CASES = [(road, name) for road, (_, _, cases) in ROADS.items() for name in (*ANY, *cases)]
IN_TIME = 60.0


@pytest.fixture(scope="module", autouse=True)
def kept():
    """The keeper is there before the first test, whose token it would have."""
    keeper.hold_folder("/none")
    keeper.let_folder_go("/none")


@pytest.fixture
def temporary(tmp_path, monkeypatch):
    """Folders for temporary files and for output: both empty again afterwards, and no process left, or the test fails."""
    for name in ("temporary", "out", "here"):
        (tmp_path / name).mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "temporary"))
    monkeypatch.setattr(child, "MOST_OUTPUT", MOST_OUTPUT)
    monkeypatch.setattr(gmsh_process, "MOST_FILES", MOST_OUTPUT)
    token = uuid.uuid4().hex
    monkeypatch.setenv("HEXCON_TEST", token)
    gmsh_process.gmsh_python.cache_clear()
    yield tmp_path
    assert not list((tmp_path / "temporary").iterdir()) and not list((tmp_path / "out").iterdir())
    assert wait_for(lambda: not processes_with(f"HEXCON_TEST={token}"))
    assert not (tmp_path / "here" / "was-run").exists()
    gmsh_process.gmsh_python.cache_clear()


@pytest.mark.parametrize("road,name", CASES, ids=lambda word: word.replace(" ", "-"))
def test_fake(temporary, monkeypatch, road, name):
    call, first, cases = ROADS[road]
    prepare, shell, code, words = cases[name] if name in cases else (None, *ANY[name])
    if prepare is not None:
        prepare(temporary / "here")
    program = temporary / "program"
    program.write_text(f'#!/bin/sh\nhere="{temporary}/here"\n{first}{shell}\n')
    program.chmod(0o755)
    timeout = LIMIT if code == "TOOL_TIMEOUT" else IN_TIME
    if code is None:
        call(str(program), monkeypatch, timeout)
        return
    with pytest.raises(HexconError) as caught:
        call(str(program), monkeypatch, timeout)
    fault = caught.value
    if road == "tetgen":    # tetgen's faults are among the reasons of one
        code = "TOOL_FAILED"
    assert fault.code.name == code and words in str(fault) and len(str(fault)) < 3000
    json.dumps({"error": str(fault), "elements": fault.elements})


@pytest.mark.parametrize("road", ROADS)
def test_no_program(temporary, monkeypatch, road):
    """A path that leads nowhere, and a file that is no program."""
    (temporary / "rubbish").write_bytes(b"\x7fELF rubbish")
    (temporary / "rubbish").chmod(0o755)
    for name in ("none", "rubbish"):
        if (road, name) == ("freecadcmd", "none"):      # then there is no such road
            continue
        with pytest.raises(ToolError) as caught:
            ROADS[road][0](str(temporary / name), monkeypatch, IN_TIME)
        assert caught.value.code in (FaultCode.TOOL_MISSING, FaultCode.TOOL_FAILED) and name in str(caught.value)


def test_an_interpreter_that_hangs_when_it_is_asked(temporary, monkeypatch):
    program = temporary / "program"
    program.write_text("#!/bin/sh\n" + HANGS)
    program.chmod(0o755)
    monkeypatch.setattr(gmsh_process, "ASKING", LIMIT)
    with pytest.raises(ToolError) as caught:
        by_gmsh(str(program), monkeypatch, IN_TIME)
    assert caught.value.code is FaultCode.TOOL_MISSING and "cannot import gmsh" in str(caught.value)


def test_meshing_goes_on_without_tetrahedra(temporary, monkeypatch):
    """cells asks gmsh for tetrahedra; what a fake says is among the mesh's facts, and the mesh is as good as without."""
    program = temporary / "program"
    npz(changed(FILLING, Delaunay_tetrahedra=TETRAHEDRA[1:]))(temporary / "here")
    program.write_text(f'#!/bin/sh\nhere="{temporary}/here"\n{PROBE}{HAND_OVER}\n')
    program.chmod(0o755)
    monkeypatch.setenv("HEXCON_GMSH_PYTHON", str(program))
    monkeypatch.setenv("HEXCON_TETGEN", "")
    from surfaces import box
    mesh = hexcon.mesh_surface(*box(2, 2, 2), "cells")
    assert mesh.certificate.certified
    assert answers.RESULTS["tetrahedra_worker"]["Delaunay_points"].optional
