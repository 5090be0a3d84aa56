# SPDX-License-Identifier: LGPL-2.1-or-later
"""Damaged files of every kind that HexCon reads, by seed, and what reading them must never do.

    PYTHONPATH=.:workbench python3 tests/python/mutate_files.py KIND [--count N] [--first SEED]

A case is (kind, seed): a whole file of the kind with one to four damages. Reading it must end in a mesh or in a
HexconError that names the file: no other exception, no death of this process, no hang, no memory beyond reason.
What the product starts a new process for is forked here from one that has the libraries loaded: the same code runs
under the same limits, some hundred times faster.
"""
import argparse
import contextlib
import faulthandler
import io
import json
import os
import pathlib
import random
import re
import resource
import runpy
import signal
import struct
import sys
import tempfile
import time
import traceback
import warnings
import zipfile

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent), str(HERE.parents[1] / "workbench" / "hexcon" / "files" / "workers")]
from hex_grids import block, distorted  # noqa: E402

from hexcon import answers, child, files, gmsh_process  # noqa: E402
from hexcon.errors import FaultCode, HexconError, ToolError  # noqa: E402
from hexcon.femmesh.elements import elements_of  # noqa: E402
from hexcon.files import reading, solid  # noqa: E402
from hexcon.quads import surface_from_file, surface_from_solid  # noqa: E402

SECONDS, MEMORY = 2.0, 2 << 30      # of processor time and address space, for a file of a few kilobytes
PATIENCE = 10                       # times those seconds by the clock: other work may take the processor
IN_PROCESS = ("msh", "inp", "obj", "mesh", "nastran", "off")      # read by Python alone
BASES = 6                           # whole files of each kind, damaged in turn


# ---- whole files ------------------------------------------------------------------------------------------------

def _hexes(number):
    """A small mesh of its own for each number."""
    mesh = block(*((1, 1, 1), (2, 1, 1), (2, 2, 1), (2, 2, 2), (3, 1, 2), (1, 1, 2))[number])
    return distorted(mesh, 0.1, number) if number % 2 else mesh


def _meshio(path, mesh, surface, **options):
    import meshio
    elements = elements_of(mesh)
    surface = surface or options["file_format"] == "obj"
    cells = [("quad", elements.quads)] + ([] if surface else [("hexahedron", elements.hexes)])
    gmsh = "gmsh" in options["file_format"]
    if options["file_format"] == "gmsh":
        cells = cells[-1:]      # meshio writes one kind of cells there
    tags = {"gmsh:physical": [np.ones(len(c[1]), np.int32) for c in cells],
            "gmsh:geometrical": [np.ones(len(c[1]), np.int32) for c in cells]}
    meshio.write(path, meshio.Mesh(elements.points, cells, cell_data=tags if gmsh else None), **options)


def _by_meshio(ending, **options):
    return ending, lambda path, number: _meshio(path, _hexes(number), number % 3 == 0, **options)


def _by_hexcon(ending, name="mesh"):
    def make(path, number):
        files.write(_hexes(number), path, order=2 if number == 5 else 1)
    return ending, make


def _surface_unv(path, number):
    elements = elements_of(_hexes(number))
    lines = ["    -1", "  2411"]
    for k, point in enumerate(elements.points):
        lines += [f"{k + 1:10d}{1:10d}{1:10d}{11:10d}", "".join(f"{x:25.16E}" for x in point)]
    lines += ["    -1", "    -1", "  2412"]
    for k, quad in enumerate(elements.quads):
        lines += ["".join(f"{x:10d}" for x in (k + 1, 44 if number % 2 else 94, 2, 1, 7, 4)),
                  "".join(f"{x + 1:10d}" for x in quad)]
    pathlib.Path(path).write_text("\n".join(lines + ["    -1", ""]), encoding="ascii")


def _vtk_poly(binary):
    def make(path, number):
        elements = elements_of(_hexes(number))
        head = f"# vtk DataFile Version 3.0\nq\n{'BINARY' if binary else 'ASCII'}\nDATASET POLYDATA\n"
        counted = np.column_stack([np.full(len(elements.quads), 4), elements.quads])
        points, polygons = f"POINTS {len(elements.points)} double\n", f"\nPOLYGONS {len(counted)} {counted.size}\n"
        if binary:
            data = (head.encode() + points.encode() + elements.points.astype(">f8").tobytes() + polygons.encode()
                    + counted.astype(">i4").tobytes() + b"\n")
        else:
            data = (head + points + "\n".join(" ".join(map(repr, p)) for p in elements.points.tolist()) + polygons
                    + "\n".join(" ".join(map(str, q)) for q in counted.tolist()) + "\n").encode()
        pathlib.Path(path).write_bytes(data)
    return ".vtk", make


def _nastran(path, number):
    """Quads, or hexes, in small, long and free fields."""
    elements = elements_of(_hexes(number))
    rows, card = (elements.hexes, "CHEXA") if number % 2 else (elements.quads, "CQUAD4")
    lines = []
    for k, place in enumerate(elements.points.tolist(), 1):
        x, y, z = (f"{value:.9E}" if number % 3 == 1 else f"{value:.4f}" for value in place)
        lines += {0: [f"GRID    {k:>8}        {x:>8}{y:>8}{z:>8}"], 2: [f"GRID,{k},,{x},{y},{z}"],
                  1: [f"GRID*   {k:>16}{'':16}{x:>16}{y:>16}", f"*       {z:>16}"]}[number % 3]
    for k, row in enumerate((rows + 1).tolist(), 1):
        lines += [f"{card},{k},1," + ",".join(map(str, row[:6]))] + ([f",{row[6]},{row[7]}"] if len(row) == 8 else [])
    pathlib.Path(path).write_text("\n".join(["BEGIN BULK", *lines, "ENDDATA", ""]), encoding="ascii")


def _off(path, number):
    elements = elements_of(_hexes(number))
    lines = ["OFF", f"{len(elements.points)} {len(elements.quads)} 0"]
    lines += [" ".join(map(repr, place)) for place in elements.points.tolist()]
    lines += [" ".join(map(str, (4, *row))) for row in elements.quads.tolist()]
    pathlib.Path(path).write_text("\n".join([*lines, ""]), encoding="ascii")


def _ply(path, number):
    import meshio
    elements = elements_of(_hexes(number))
    meshio.write(path, meshio.Mesh(elements.points, [("quad", elements.quads.astype(np.int32))]), binary=number % 2 == 0)


def _vtp(path, number):
    from vtkmodules.vtkIOLegacy import vtkPolyDataReader
    from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
    _vtk_poly(True)[1](str(path) + ".vtk", number)
    reader, writer = vtkPolyDataReader(), vtkXMLPolyDataWriter()
    reader.SetFileName(str(path) + ".vtk")
    writer.SetInputConnection(reader.GetOutputPort())
    writer.SetFileName(str(path))
    (writer.SetDataModeToAscii if number % 2 else writer.SetDataModeToBinary)()
    writer.Write()
    os.remove(str(path) + ".vtk")


def _cgns(path, number):
    import cgns_files
    if number == 5:
        cgns_files.write_structured(path)
    else:
        cgns_files.write(path, list(cgns_files.HEX_SECTIONS.values())[number], zones=1 + number % 2)


def _vtu_by_vtk(mode):
    def make(path, number):
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

        from hexcon.files import vtk
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetFileName(str(path))
        if mode == "ascii":
            writer.SetDataModeToAscii()
        else:
            writer.SetDataModeToAppended()
            writer.SetEncodeAppendedData(mode == "base64")
            if mode == "raw":
                writer.SetCompressorTypeToNone()
        writer.SetInputData(vtk._grid(elements_of(_hexes(number)), None, None))
        writer.Write()
    return ".vtu", make


def _document(path, number):
    from hexcon import freecad_compat
    app, part = freecad_compat.freecad(), freecad_compat.freecad_module("Part")
    doc = app.newDocument("Mutated", hidden=True, temp=True)
    try:
        if number == 2:
            files.write(block(1, 1, 1), path, solid=part.makeBox(1, 1, 1))
            return
        made = doc.addObject("Part::Box" if number % 2 else "Part::Feature", "Solid")
        if not number % 2:
            made.Shape = part.makeBox(10, 7, 5).cut(part.makeCylinder(2, 20))
        doc.recompute()
        doc.saveCopy(str(path))
    finally:
        app.closeDocument(doc.Name)


def _shape(path, number):
    from hexcon import freecad_compat
    part = freecad_compat.freecad_module("Part")
    shape = (part.makeBox(10, 7, 5), part.makeCylinder(2, 5), part.makeCone(3, 1, 4), part.makeTorus(5, 1),
             part.makeBox(10, 7, 5).cut(part.makeCylinder(2, 20)), part.makeSphere(3))[number]
    (shape.exportBrep if str(path).endswith("brep") else shape.exportStep)(str(path))


def _answer(path, number):
    quads = elements_of(_hexes(number)).quads
    points = _hexes(number).points
    np.savez(path, points=points, quads=quads, faces=np.ones(len(quads), np.int64), off_cad=np.zeros(len(points)),
             cad_gap=np.zeros(len(points)), tolerance=1e-7, method="sweep", notes=np.array(["one", "two"]))


def _fault(path, number):
    with open(path, "w", encoding="utf-8") as stream:
        json.dump({"code": "BAD_SHAPE", "message": "the solid is not closed", "elements": list(range(number))}, stream)


# kind: (ending, maker(path, number)); how each is read follows.
KINDS = {
    "msh22-ascii": _by_meshio(".msh", file_format="gmsh22", binary=False),
    "msh22-binary": _by_hexcon(".msh"),
    "msh41-ascii": _by_meshio(".msh", file_format="gmsh", binary=False),
    "msh41-binary": _by_meshio(".msh", file_format="gmsh", binary=True),
    "inp-hexes": _by_hexcon(".inp"),
    "inp-quads": _by_meshio(".inp", file_format="abaqus"),
    "unv-hexes": _by_hexcon(".unv"),
    "unv-quads": (".unv", _surface_unv),
    "vtk-ascii": _by_meshio(".vtk", file_format="vtk", binary=False),
    "vtk-binary": _by_hexcon(".vtk"),
    "vtk-binary-51": _by_meshio(".vtk", file_format="vtk", binary=True),
    "vtk-polydata-ascii": _vtk_poly(False),
    "vtk-polydata-binary": _vtk_poly(True),
    "vtu-ascii": _vtu_by_vtk("ascii"),
    "vtu-binary": _by_meshio(".vtu", file_format="vtu", binary=True, compression=None),
    "vtu-compressed": _by_hexcon(".vtu"),
    "vtu-appended-raw": _vtu_by_vtk("raw"),
    "vtu-appended-base64": _vtu_by_vtk("base64"),
    "obj": _by_meshio(".obj", file_format="obj"),
    "mesh": _by_meshio(".mesh", file_format="medit"),
    "nastran": (".bdf", _nastran), "off": (".off", _off), "ply": (".ply", _ply), "vtp": (".vtp", _vtp),
    "exo": _by_hexcon(".exo"), "cgns": (".cgns", _cgns),
    "med": _by_hexcon(".med"),
    "FCStd": (".FCStd", _document),
    "step": (".step", _shape), "brep": (".brep", _shape),
    "step-gmsh": (".step", _shape), "brep-gmsh": (".brep", _shape),
    "npz": (".npz", _answer), "json": (".json", _fault),
}


def _read(kind, path):
    """Read a file as the product does; several ways where there are several."""
    if kind == "npz":
        return [lambda: answers.read_arrays(path, "gmsh", answers.RESULTS["gmsh_worker"])]
    if kind == "json":
        return [lambda: answers.read_fault(path, "gmsh")]
    if kind.endswith("-gmsh"):
        return [lambda: surface_from_solid(path, 4.0, "sweep", timeout=3 * SECONDS)]
    if kind in ("FCStd", "step", "brep"):
        return [lambda: solid.solid_as_brep(path, path + ".of.brep")]
    if kind in ("med", "exo", "cgns"):
        return [lambda: files.read_mesh(path)]
    if kind in ("obj", "inp-quads", "unv-quads", "off", "ply", "vtp") or "polydata" in kind:
        return [lambda: surface_from_file(path)]
    if kind in ("inp-hexes", "unv-hexes", "mesh", "nastran"):
        surface_too = kind in ("mesh", "nastran")
        return [lambda: files.read_mesh(path)] + ([lambda: surface_from_file(path)] if surface_too else [])
    return [lambda: surface_from_file(path), lambda: files.read_mesh(path)]


# ---- damages ----------------------------------------------------------------------------------------------------

NASTY = [b"-1", b"0", b"1", b"2", b"3", b"-2147483649", b"2147483647", b"4294967295", b"999999999999", b"1000000000000000000000",
         b"900000001", b"-900000001", b"1e308", b"-1e308", b"1e400", b"nan", b"inf", b"-inf", b"", b"x", b"1.5", b"1D+00", b"0x10",
         b"9" * 30, b"1" * 5000, b"-0", b"7.", b"\xff\xfe"]
WORDS = [0, 1, -1, 7, 2 ** 31 - 1, -2 ** 31, 2 ** 31, 2 ** 32 - 1, 2 ** 40, 2 ** 63 - 1, -2 ** 63, 10 ** 12, 900000001]
NUMBER = re.compile(rb"[-+]?\d+(?:\.\d*)?(?:[eEdD][-+]?\d+)?")


def _truncate(rng, data):
    return data[:rng.randrange(len(data))]


def _flip(rng, data):
    data = bytearray(data)
    for _ in range(rng.choice((1, 1, 2, 8, 64))):
        data[rng.randrange(len(data))] = rng.choice((rng.randrange(256), 0, 255, 10, 32))
    return bytes(data)


def _number(rng, data):
    """One number, more often an early one, where the counts are."""
    found = list(NUMBER.finditer(data))
    if not found:
        return _flip(rng, data)
    hit = found[int(len(found) * rng.random() ** rng.choice((1, 4)))]
    return data[:hit.start()] + rng.choice(NASTY) + data[hit.end():]


def _swap_numbers(rng, data):
    found = list(NUMBER.finditer(data))
    if len(found) < 2:
        return _flip(rng, data)
    a, b = sorted(rng.sample(range(len(found)), 2))
    a, b = found[a], found[b]
    return data[:a.start()] + b.group() + data[a.end():b.start()] + a.group() + data[b.end():]


def _lines(rng, data):
    """Lines left out, doubled, exchanged or moved."""
    lines = data.splitlines(keepends=True)
    a, b = (rng.randrange(len(lines)) for _ in range(2))
    first, last = min(a, b), min(max(a, b) + 1, min(a, b) + rng.choice((1, 1, 3, 50)))
    piece = lines[first:last]
    what = rng.randrange(4)
    if what == 0:
        del lines[first:last]
    elif what == 1:
        lines[first:first] = piece * rng.choice((1, 2, 20))
    elif what == 2:
        lines[a], lines[b] = lines[b], lines[a]
    else:
        del lines[first:last]
        place = rng.randrange(len(lines) + 1)
        lines[place:place] = piece
    return b"".join(lines)


def _word(rng, data):
    """A binary word of 4 or 8 bytes overwritten."""
    size = rng.choice((4, 8))
    if len(data) <= size:
        return _flip(rng, data)
    place = rng.randrange(len(data) - size)
    if rng.random() < 0.3:
        word = struct.pack(rng.choice("<>") + ("f" if size == 4 else "d"), rng.choice((0.0, float("nan"), float("inf"), 1e30)))
    else:
        word = (rng.choice(WORDS) % 2 ** (8 * size)).to_bytes(size, rng.choice(("little", "big")))
    return data[:place] + word + data[place + size:]


def _insert(rng, data):
    junk = rng.choice((b"\0" * 16, b"\n" * 50, b" " * 100000, bytes(rng.randrange(256) for _ in range(64)), b"*", b"-1\n", b"    -1\n",
                       b",", b"<", b"$", b"<!DOCTYPE a [<!ENTITY b 'c'>]>", b"\xff" * 8, b"<a>" * 20000, b"[" * 20000))
    place = rng.choice((0, len(data), rng.randrange(len(data) + 1)))
    return data[:place] + junk + data[place:]


def _repeat(rng, data):
    a, b = sorted(rng.randrange(len(data) + 1) for _ in range(2))
    return data[:b] + data[a:b] * rng.choice((1, 1, 5)) + data[b:]


def _cut(rng, data):
    a = rng.randrange(len(data))
    return data[:a] + data[a + rng.choice((1, 2, 4, 8, 100, len(data))):]


DAMAGES = [_truncate, _flip, _flip, _number, _number, _number, _swap_numbers, _lines, _lines, _word, _word, _insert, _repeat, _cut]
ZIPPED = ("FCStd", "npz")


def damaged(rng, kind, data, other):
    """The bytes with one to four damages; of archives also of a member that is packed again with a right checksum."""
    if kind in ZIPPED and rng.random() < 0.7:
        return _member(rng, data, zipfile.ZIP_DEFLATED if kind == "FCStd" else zipfile.ZIP_STORED)
    if rng.random() < 0.1 and other:
        cut = rng.randrange(len(data))
        data = data[:cut] + other[rng.randrange(len(other)):]
    for _ in range(rng.choice((1, 1, 1, 2, 3, 4))):
        data = rng.choice(DAMAGES)(rng, data) or b"\n"
    return data


def _member(rng, data, method):
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        members = {name: archive.read(name) for name in archive.namelist()}
    names = [n for n in members if not n.endswith("Thumbnail.png")]
    name = rng.choice(names + [n for n in names if n == "Document.xml"])
    members[name] = damaged(rng, "", members[name], b"")
    if rng.random() < 0.1:
        del members[name]
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", method) as archive, warnings.catch_warnings():
        for name, content in members.items():
            archive.writestr(name, content)
    return made.getvalue()


# ---- reading under watch ------------------------------------------------------------------------------------------

class Hang(BaseException):
    """The caller's own part took too much processor time."""


def _hang(*_):
    raise Hang


def _fork(work, folder, seconds):
    """(status, seconds, MiB) of work(), in a child of this process whose output goes to log.txt."""
    sys.stdout.flush()
    sys.stderr.flush()
    started = time.monotonic()
    pid = os.fork()
    if pid == 0:
        status = 1
        try:
            signal.setitimer(signal.ITIMER_PROF, 0)
            log = os.open(os.path.join(folder, "log.txt"), os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
            os.dup2(log, 1)
            os.dup2(log, 2)
            faulthandler.disable()
            os.chdir(folder)
            status = work()
        except SystemExit as stop:
            status = stop.code or 0
        except BaseException:
            traceback.print_exc()
        finally:
            os._exit(status)
    killed = False
    while True:
        done, status, used = os.wait4(pid, os.WNOHANG)
        if done:
            break
        if not killed and time.monotonic() - started > PATIENCE * seconds:
            os.kill(pid, signal.SIGKILL)
            killed = True
        time.sleep(0.001)
    return os.waitstatus_to_exitcode(status), time.monotonic() - started, used.ru_maxrss / 1024, killed


def _here(work):
    """The same of a reader in Python, in this process: it can be stopped, and kept to its memory, without a fork."""
    from file_worker import limits
    kept, limits.keep_to = limits.keep_to, lambda *_: None
    started, before = time.monotonic(), resource.getrlimit(resource.RLIMIT_AS)
    resource.setrlimit(resource.RLIMIT_AS, (_address_space() + MEMORY, before[1]))
    signal.setitimer(signal.ITIMER_PROF, SECONDS)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")     # in the product they go to the worker's log
            status = work()
    except Hang:
        status = -signal.SIGXCPU
    finally:
        signal.setitimer(signal.ITIMER_PROF, PATIENCE)
        resource.setrlimit(resource.RLIMIT_AS, before)
        limits.keep_to = kept
    return status, time.monotonic() - started, 0.0


def _address_space():
    with open("/proc/self/statm", encoding="ascii") as stream:
        return int(stream.read().split()[0]) * resource.getpagesize()


class Watched:
    """Inside, the product's processes are forked; .deaths (signal -> count), .seconds, .megabytes: the most of any."""

    def __init__(self, kind):
        self._in_process = kind.startswith(IN_PROCESS)
        self.deaths, self.timeouts, self.seconds, self.megabytes = {}, 0, 0.0, 0.0

    def _done(self, folder, status, seconds, megabytes, _):
        self.seconds, self.megabytes = max(self.seconds, seconds), max(self.megabytes, megabytes)
        late = status == -signal.SIGXCPU
        self.timeouts += late
        if status < 0 and not late:
            name = signal.Signals(-status).name
            self.deaths[name] = self.deaths.get(name, 0) + 1
        if self._in_process:
            return child.Ended(status, "")
        with open(os.path.join(folder, "log.txt"), encoding="utf-8", errors="replace") as log:
            return child.Ended(status, log.read())

    def _file_worker(self, command, folder, job, program, progress):
        from file_worker import start
        if self._in_process:
            ended = self._done(folder, *_here(lambda: start._main(os.path.join(folder, "job.json"))), False)
            return reading._check_end(ended, folder, job, program)
        result = _fork(lambda: start.guarded(os.path.join(folder, "job.json")), folder, job["seconds"])
        if result[3]:
            self.timeouts += 1
            raise ToolError(f"reading {job['file']} with {program} did not finish", FaultCode.TOOL_TIMEOUT)
        reading._check_end(self._done(folder, *result), folder, job, program)

    def _gmsh(self, python, job_path, folder, worker, limit, timeout, progress):
        def work():
            sys.argv = [worker, job_path]
            runpy.run_module(worker, run_name="__main__", alter_sys=False)
            return 0
        result = _fork(work, folder, timeout)
        if result[3]:
            self.timeouts += 1
            raise ToolError("gmsh did not finish", FaultCode.TOOL_TIMEOUT)
        return self._done(folder, *result)

    @contextlib.contextmanager
    def watching(self):
        kept = reading._run, gmsh_process._run, reading.SECONDS, reading.MEMORY
        reading._run, gmsh_process._run, reading.SECONDS, reading.MEMORY = self._file_worker, self._gmsh, SECONDS, MEMORY
        before = signal.signal(signal.SIGPROF, _hang)
        try:
            yield self
        finally:
            signal.signal(signal.SIGPROF, before)
            reading._run, gmsh_process._run, reading.SECONDS, reading.MEMORY = kept


def load(kind):
    """Load what the worker of that kind will need, before it is forked."""
    import meshio  # noqa: F401
    from file_worker import with_meshio, with_vtk, with_vtk_blocks  # noqa: F401
    from vtkmodules import vtkIOCGNSReader, vtkIOExodus, vtkIOLegacy, vtkIOPLY, vtkIOXML  # noqa: F401
    if kind in ("med", "FCStd", "step", "brep"):
        from file_worker import with_freecad  # noqa: F401

        from hexcon import freecad_compat
        freecad_compat.freecad_module("Part")
        freecad_compat.fem_module("Fem")
    if kind.endswith("-gmsh"):
        sys.path[:0] = gmsh_process.WORKERS
        from gmsh_worker import cad, session  # noqa: F401


def whole_files(kind, folder):
    """The bytes of BASES whole files."""
    ending, make = KINDS[kind]
    made = []
    for number in range(BASES):
        path = os.path.join(folder, f"whole{number}{ending}")
        make(path, number)
        with open(path, "rb") as stream:
            made.append(stream.read())
        if kind not in ("med",):
            os.remove(path)
    return made


def case(kind, seed, wholes):
    """The bytes of a damaged file."""
    rng = random.Random(f"{kind} {seed}")
    number = rng.randrange(len(wholes))
    return number, damaged(rng, kind, wholes[number], wholes[rng.randrange(len(wholes))])


def judge(kind, path, watched, way=None):
    """way: which of the ways of reading, None: all. [(outcome, words), ...]: "read", a FaultCode's name, or "TRACEBACK", "HANG", "WARNING", "MEMORY"."""
    outcomes = []
    ways = _read(kind, path)
    for read in ways if way is None else [ways[way % len(ways)]]:
        with warnings.catch_warnings(record=True) as told, watched.watching():
            warnings.simplefilter("always")
            signal.setitimer(signal.ITIMER_PROF, PATIENCE)
            try:
                found = read()
                outcomes.append(("read", "") if not isinstance(found, HexconError) else (found.code.name, str(found)))
            except HexconError as fault:
                words = str(fault)
                outcomes.append(("MEMORY" if "too little memory" in words else fault.code.name, words))
            except Hang:
                outcomes.append(("HANG", ""))
            except BaseException as error:
                if isinstance(error, KeyboardInterrupt):
                    raise
                outcomes.append(("TRACEBACK", traceback.format_exc(limit=-4)))
            finally:
                signal.setitimer(signal.ITIMER_PROF, 0)
        outcomes += [("WARNING", f"{w.filename}:{w.lineno}: {w.message}") for w in told if issubclass(w.category, RuntimeWarning)]
    return outcomes


FINDINGS = ("TRACEBACK", "HANG", "WARNING", "MEMORY")


def run(kind, seeds, keep=None, tell=None):
    """Read the cases; {"counts", "findings": [(seed, outcome, words)], "deaths", ...}. keep: where found files are put."""
    watched, counts, findings = Watched(kind), {}, []
    load(kind)
    with tempfile.TemporaryDirectory(prefix="mutated-") as folder:
        wholes = whole_files(kind, folder)
        for seed in seeds:
            number, data = case(kind, seed, wholes)
            # SMESH looks for a mesh that is called like the file
            name = f"whole{number}" if kind == "med" else "case"
            path = os.path.join(folder, name + KINDS[kind][0])
            with open(path, "wb") as stream:
                stream.write(data)
            before, slow = dict(watched.deaths), watched.timeouts
            outcomes = judge(kind, path, watched, seed)
            for outcome, _ in outcomes:
                counts[outcome] = counts.get(outcome, 0) + 1
            died = [s for s in watched.deaths if watched.deaths[s] != before.get(s)]
            told = [(seed, o, w) for o, w in outcomes if o in FINDINGS]
            findings += told
            if keep and (told or died or watched.timeouts > slow):
                word = (died or [o for _, o, _ in told] or ["TIMEOUT"])[0]
                with open(os.path.join(keep, f"{kind}-{seed}-{word}{KINDS[kind][0]}"), "wb") as stream:
                    stream.write(data)
            for one in told:
                if tell:
                    tell(*one)
    own = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    return {"kind": kind, "files": len(seeds), "counts": counts, "findings": findings, "deaths in workers": watched.deaths,
            "timeouts in workers": watched.timeouts, "longest s": round(watched.seconds, 2),
            "worker MiB": round(watched.megabytes), "caller MiB": round(own)}


def _main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("kinds", nargs="+", choices=[*KINDS, "all"])
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--keep", help="folder for the files that killed a worker or were findings")
    options = parser.parse_args()
    for kind in KINDS if "all" in options.kinds else options.kinds:
        found = run(kind, range(options.first, options.first + options.count), options.keep,
                    lambda seed, outcome, words: print(f"{outcome} {seed}: {words[-700:]}", file=sys.stderr, flush=True))
        found["findings"] = len(found["findings"])
        print(json.dumps(found), flush=True)


if __name__ == "__main__":
    _main()
