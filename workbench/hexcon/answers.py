# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a program or a process of ours hands back in files, read without trust in it.

A worker may have died while it wrote, or be another program than it seems. So nothing is unpickled, no size is
believed that the file is too small for, and shapes, kinds, ranges and dimensions are those of a table here.
"""
import json
import math
import os
import zipfile
from dataclasses import dataclass

import numpy as np

from .errors import FaultCode, ToolError

_KINDS = {"f": ("f",), "i": ("i", "u"), "s": ("U",)}    # ours -> numpy's
_WORDS = {"f": "numbers", "i": "integers", "s": "text"}
_LONGEST_JSON = 16 << 20    # bytes; a fault with 1,000 ids takes 10,000


@dataclass(frozen=True)
class Array:
    """What one array must be.

    kind    "f" float64, "i" int64, "s" text
    shape   a number, or a name: any length, and the same wherever the name stands
    least, below   limits of the entries (least <= entry < below), numbers, or the name of a dimension
    finite  whether NaN and infinity are refused
    optional  whether it may be missing
    """
    kind: str
    shape: tuple = ()
    least: int | None = None
    below: int | str | None = None
    finite: bool = True
    optional: bool = False


def _tetrahedra_of(name):
    return {name + "_points": Array("f", (f"points of {name}", 3), optional=True),
            name + "_tetrahedra": Array("i", (f"tetrahedra of {name}", 4), 0, f"points of {name}", optional=True),
            name + "_fault": Array("s", optional=True)}


# The arrays of result.npz, by worker.
RESULTS = {
    "gmsh_worker": {
        "points": Array("f", ("points", 3)), "quads": Array("i", ("quads", 4), 0, "points"),
        "faces": Array("i", ("quads",), 1), "off_cad": Array("f", ("points",), finite=False),
        "cad_gap": Array("f", ("points",)), "tolerance": Array("f", (), 0), "method": Array("s"),
        "notes": Array("s", ("notes",)), "hexes": Array("i", ("hexes", 8), 0, optional=True),
        "piece_names": Array("s", ("pieces",), optional=True),
        "piece_hexes": Array("i", ("pieces",), 0, optional=True),
        "fit": Array("f", (6,), optional=True), "lost_faces": Array("i", ("lost faces",), 1, optional=True),
        "lost_edges": Array("i", ("lost edges",), 1, optional=True)},
    "smoothing_worker": {
        "points": Array("f", ("points", 3)), "faces": Array("i", ("quads",), 1),
        "dimension": Array("i", ("points",), 0, 4), "off": Array("f", ("points",), 0),
        "kept": Array("i", ("kept",), 0, "points"), "notes": Array("s", ("notes",))},
    "curving_worker": {
        "points": Array("f", ("points", 3)), "on": Array("i", ("edges",), 0, 3), "factor": Array("f", ("hexes",), 0),
        "inner": Array("i", (), 0), "moved": Array("i", (), 0), "volume": Array("f"), "area": Array("f"),
        "cad_volume": Array("f"), "cad_area": Array("f"), "chord": Array("f", (), 0)},
    "tetrahedra_worker": {**_tetrahedra_of("Delaunay"), **_tetrahedra_of("HXT")}}


def read_arrays(path, program, table):
    """The arrays of an .npz file, checked: dict of name -> array (float64, int64 or text).

    program  who wrote it, for words;  table  {name: Array}, as of RESULTS
    Raises ToolError TOOL_FAILED: not such a file, an array missing or other than the table says. Memory: no more
    than the file is long, whatever it claims.
    """
    try:
        with zipfile.ZipFile(path) as archive:
            found = {name: _member(archive, name + ".npy") for name in table
                     if not table[name].optional or name + ".npy" in archive.NameToInfo}
    except Exception as error:    # zipfile and numpy raise what they like
        raise damaged(program, f"{_file(path)}: {type(error).__name__}: {error}") from error
    lengths = {}
    return {name: _checked(name, array, table[name], lengths, program) for name, array in found.items()}


def _file(path):
    return os.path.basename(path)


def damaged(program, what):
    """ToolError TOOL_FAILED: what a program handed back is not what it should be."""
    return ToolError(f"what {program} handed back is damaged: {what}", FaultCode.TOOL_FAILED)


def _member(archive, name):
    """One array of a stored archive, whose header must agree with its length."""
    entry = archive.getinfo(name)
    if entry.compress_type != zipfile.ZIP_STORED or entry.compress_size != entry.file_size:
        raise ValueError(f"{name} is compressed")
    with archive.open(entry) as stream:
        version = np.lib.format.read_magic(stream)
        header = {(1, 0): np.lib.format.read_array_header_1_0, (2, 0): np.lib.format.read_array_header_2_0}[version]
        shape, fortran, dtype = header(stream)
        if dtype.hasobject:
            raise ValueError(f"{name} holds Python objects")
        size = math.prod(shape) * dtype.itemsize
        data = stream.read()
    if min(shape, default=0) < 0 or len(data) != size or not dtype.itemsize:
        raise ValueError(f"{name}: shape {shape} of {dtype} needs {size} bytes, there are {len(data)}")
    return np.frombuffer(data, dtype).reshape(shape, order="F" if fortran else "C").copy()


def _checked(name, array, wanted, lengths, program):
    """The array in its kind; dimensions seen for the first time are put into lengths."""
    if array.dtype.kind not in _KINDS[wanted.kind]:
        raise damaged(program, f"{name} is of type {array.dtype}, not {_WORDS[wanted.kind]}")
    expected = tuple(lengths.get(n, n) if isinstance(n, str) else n for n in wanted.shape)
    fits = array.ndim == len(expected) and all(isinstance(e, str) or e == n for e, n in zip(expected, array.shape))
    if not fits:
        raise damaged(program, f"{name} has shape {array.shape}, not ({', '.join(map(str, expected))})")
    lengths.update((e, n) for e, n in zip(expected, array.shape) if isinstance(e, str))
    if wanted.kind == "s" or not array.size:
        return array if wanted.kind == "s" else array.astype({"f": np.float64, "i": np.int64}[wanted.kind])
    if wanted.kind == "f" and wanted.finite and not np.isfinite(array).all():
        raise damaged(program, f"{name} holds numbers that are not finite")
    _check_range(name, array, wanted.least, lengths.get(wanted.below, wanted.below), program)
    return array.astype({"f": np.float64, "i": np.int64}[wanted.kind])


def _check_range(name, array, least, below, program):
    low, high = array.min().item(), array.max().item()
    if array.dtype.kind in "iu" and high >= 2 ** 63:
        raise damaged(program, f"{name} holds {high}")
    if isinstance(below, str):
        raise damaged(program, f"{name} names {below}, of which there are none")
    if (least is not None and low < least) or (below is not None and high >= below):
        raise damaged(program, f"{name} has entries {low} to {high}, where {'any' if least is None else least} to "
                      f"{'any' if below is None else below - 1} are possible")


def read_json(path, program, table):
    """The object in a .json file, whose members are of the given types: {name: type or tuple of types}.

    Others are left out. Raises ToolError TOOL_FAILED."""
    try:
        if os.path.getsize(path) > _LONGEST_JSON:
            raise ValueError(f"{os.path.getsize(path)} bytes long")
        with open(path, encoding="utf-8") as stream:
            found = json.load(stream)
    except (OSError, ValueError, RecursionError) as error:
        raise damaged(program, f"{_file(path)}: {error}") from error
    if not isinstance(found, dict):
        raise damaged(program, f"{_file(path)} holds no object")
    for name, kind in table.items():
        if name not in found or not isinstance(found[name], kind):
            raise damaged(program, f"{_file(path)} has no {name}, or of the wrong kind")
    return {name: found[name] for name in table}


def read_fault(path, program):
    """The ToolError that a worker wrote to fault.json: {"code", "message", "elements"}, returned, not raised.

    Raises ToolError TOOL_FAILED where the file is damaged."""
    found = read_json(path, program, {"code": str, "message": str, "elements": list})
    known = found["code"] in FaultCode.__members__
    if not known or not all(isinstance(e, int) and abs(e) < 2 ** 63 for e in found["elements"]):
        raise damaged(program, f"{_file(path)} names an unknown fault ({found['code'][:40]!r}), or no ids")
    return ToolError(found["message"], FaultCode[found["code"]], found["elements"])


def read_progress(path):
    """(stage, fraction in 0..1) of the last whole line "stage fraction" of a file; ("start", 0.0) without one."""
    try:
        with open(path, "rb") as stream:
            stream.seek(max(0, os.path.getsize(path) - 4096))
            lines = stream.read().decode("utf-8", "replace").splitlines()
        stage, fraction = lines[-1].split()
        fraction = float(fraction)
    except (OSError, ValueError, IndexError):
        return "start", 0.0
    return (stage, min(max(fraction, 0.0), 1.0)) if fraction == fraction else ("start", 0.0)
