# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that no reader can take: each ends in a ToolError that names it, soon, with little memory, and in this process."""
import os
import pathlib
import resource
import socket
import stat
import struct
import subprocess
import sys
import tempfile
import threading
import time
import zipfile
import zlib

import numpy as np
import pytest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from hex_grids import block  # noqa: E402

from hexcon import files  # noqa: E402
from hexcon.errors import FaultCode, HexconError, ToolError  # noqa: E402
from hexcon.files import archive, reading  # noqa: E402
from hexcon.files.solid import solid_as_brep  # noqa: E402
from hexcon.quads import surface_from_file, surface_from_solid  # noqa: E402
from hexcon_native import ErrorCode  # noqa: E402

READ = {ending: surface_from_file for ending in ("msh", "inp", "unv", "vtk", "vtu", "obj", "mesh")}
HEXES = {ending: files.read_mesh for ending in ("inp", "unv", "med", "msh", "vtu", "vtk", "mesh")}
SOLIDS = {ending: lambda path: surface_from_solid(path, 1.0) for ending in ("step", "stp", "brep", "brp", "FCStd")}
ALL = [(ending, read) for table in (READ, HEXES, SOLIDS) for ending, read in table.items()]


@pytest.fixture(autouse=True)
def nothing_left(tmp_path, monkeypatch):
    """No test leaves a folder or a process behind."""
    folder = tmp_path / "temporary"
    folder.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(folder))
    yield
    assert not list(folder.iterdir())


def refused(read, path, *words, codes=(FaultCode.FILE_FORMAT,)):
    with pytest.raises(HexconError) as caught:
        read(path)
    assert caught.value.code in codes, caught.value
    for word in (os.path.basename(path), *words):
        assert word in str(caught.value)
    return str(caught.value)


@pytest.mark.parametrize("ending, read", ALL)
def test_what_is_no_file(tmp_path, ending, read):
    """A folder, a pipe, a device, a socket, links without end, no permission, nothing: none is waited for."""
    io_codes = (FaultCode.FILE_IO,)
    path = str(tmp_path / f"x.{ending}")
    refused(read, path, codes=io_codes)
    os.mkdir(path)
    refused(read, path, "folder", codes=io_codes)
    os.rmdir(path)
    os.mkfifo(path)
    refused(read, path, "pipe", codes=io_codes)
    os.remove(path)
    os.symlink("/dev/zero", path)
    refused(read, path, "device", codes=io_codes)
    os.remove(path)
    os.symlink(path, path)
    refused(read, path, codes=io_codes)
    os.remove(path)
    here = os.getcwd()
    os.chdir(tmp_path)      # a socket's name may not be long
    try:
        with socket.socket(socket.AF_UNIX) as one:
            one.bind(f"x.{ending}")
            refused(read, path, "socket", codes=io_codes)
    finally:
        os.chdir(here)
    refused(read, path + "/deeper." + ending, codes=io_codes)
    refused(read, f"{tmp_path}/{'n' * 300}.{ending}", codes=io_codes)
    with pytest.raises(ToolError) as caught:
        read(f"{tmp_path}/a\0b.{ending}")
    assert caught.value.code is FaultCode.FILE_IO


def test_no_permission(tmp_path):
    path = tmp_path / "x.unv"
    path.write_text("    -1\n", encoding="ascii")
    path.chmod(0)
    if os.access(path, os.R_OK):
        program = ("import os\nfrom hexcon.errors import ToolError\nfrom hexcon.files.regular import regular_file\n"
                   f"os.setuid(65534)\ntry:\n    regular_file({str(path)!r})\n"
                   "except ToolError as fault:\n    print(fault.code.name, fault)")
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
        assert done.stdout.startswith("FILE_IO cannot read") and "ermission" in done.stdout
        return
    refused(surface_from_file, str(path), codes=(FaultCode.FILE_IO,))


@pytest.mark.parametrize("what", (3, None, 1.5, ["a"], object()))
def test_what_is_no_path(what):
    for read in (surface_from_file, files.read_mesh):
        with pytest.raises(ToolError) as caught:
            read(what)
        assert caught.value.code is FaultCode.BAD_OPTION


JUNK = {"empty": b"", "line end": b"\n", "NULs": bytes(4096), "junk": bytes(np.random.default_rng(1).integers(0, 256, 5000, np.uint8)),
        "not UTF-8": "*N\u00d6DE\n1, 0, 0, 0\n".encode("latin-1"), "UTF-16": "*NODE\n1, 0, 0, 0\n".encode("utf-16"),
        "a long line": b"1 " * 500_000, "a long word": b"7" * 1_000_000, "commas": b"*NODE,\n" + b"1,\n" * 100_000,
        "deep XML": b"<VTKFile>" + b"<a>" * 50_000, "brackets": b"[" * 100_000,
        "a picture": b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", "half a link": b"-1\n-1\n-1\n"}


@pytest.mark.parametrize("ending, read", [*READ.items(), *((e, HEXES[e]) for e in ("inp", "unv")), ("FCStd", SOLIDS["FCStd"])])
def test_junk(tmp_path, ending, read):
    path = tmp_path / f"x.{ending}"
    for name in JUNK if ending in ("inp", "unv") else list(JUNK)[:4]:
        path.write_bytes(JUNK[name])
        refused(read, str(path), codes=(FaultCode.FILE_FORMAT, FaultCode.BAD_SHAPE) if ending == "obj" else (FaultCode.FILE_FORMAT,))


def test_another_ending(tmp_path):
    """Every format under every other one's name."""
    for own in ("inp", "msh", "vtu", "unv"):
        files.write(block(1, 1, 1), tmp_path / f"m.{own}")
        for other in {"inp", "unv"} - {own}:
            os.rename(tmp_path / f"m.{own}", tmp_path / f"m.{other}")
            refused(files.read_mesh, str(tmp_path / f"m.{other}"))
            os.rename(tmp_path / f"m.{other}", tmp_path / f"m.{own}")


# ---- loops and sizes in our own readers ---------------------------------------------------------------------------

NODES = "*NODE\n" + "".join(f"{k + 1}, {p[0]}, {p[1]}, {p[2]}\n" for k, p in enumerate(block(1, 1, 1).points.tolist()))
ONE = "".join(f", {k + 1}" for k in block(1, 1, 1).hexes[0])


@pytest.mark.parametrize("last", ("*STEP,", "*STEP,\n", "*STEP ,  ", "*STEP,\n,\n,", "*STEP,\n\n"))
def test_a_last_card_with_a_comma(tmp_path, last):
    path = tmp_path / "x.inp"
    path.write_text(NODES + f"*ELEMENT, TYPE=C3D8\n1{ONE}\n{last}", encoding="ascii")
    assert len(files.read_mesh(path).hexes) == 1


def test_a_card_continued_without_end(tmp_path):
    """200,000 lines, each ending in a comma: no work that grows with their square."""
    path = tmp_path / "x.inp"
    path.write_text("*NODE,\n" + "1,\n" * 200_000, encoding="ascii")
    started = time.process_time()
    refused(files.read_mesh, str(path))
    assert time.process_time() - started < 10


@pytest.mark.parametrize("ids", ((900_000_001, 1), (2 ** 40, 3), (-5, 1), (-900_000_001, 100_000_000)))
def test_large_and_negative_numbers_of_nodes(tmp_path, ids):
    """By their count, not by their size: read in little memory."""
    first, step = ids
    number = {k + 1: first + step * k for k in range(8)}
    deck = "*NODE\n" + "".join(f"{number[k + 1]}, {p[0]}, {p[1]}, {p[2]}\n" for k, p in enumerate(block(1, 1, 1).points.tolist()))
    deck += "*ELEMENT, TYPE=C3D8\n1" + "".join(f", {number[k + 1]}" for k in block(1, 1, 1).hexes[0]) + "\n"
    (tmp_path / "x.inp").write_text(deck, encoding="ascii")
    assert np.array_equal(files.read_mesh(tmp_path / "x.inp").points, block(1, 1, 1).points)
    files.write(block(1, 1, 1), tmp_path / "m.unv")
    if not -10 ** 9 < min(number.values()) <= max(number.values()) < 10 ** 10:
        return
    lines = (tmp_path / "m.unv").read_text(encoding="ascii").splitlines()
    for k in range(2, 18, 2):
        lines[k] = f"{number[int(lines[k][:10])]:10d}" + lines[k][10:]
    for k, line in enumerate(lines):
        if line.split()[1:2] in (["115"], ["94"]):
            lines[k + 1] = "".join(f" {number[int(n)]}" for n in lines[k + 1].split())
    (tmp_path / "n.unv").write_text("\n".join(lines) + "\n", encoding="ascii")
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    assert np.array_equal(files.read_mesh(tmp_path / "n.unv").hexes, block(1, 1, 1).hexes)
    assert len(surface_from_file(tmp_path / "n.unv").quads) == 6
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 50_000


@pytest.mark.parametrize("size", (-1, -8, -80, 0, 10 ** 12, 27, 7))
@pytest.mark.parametrize("read", (files.read_mesh, surface_from_file))
def test_unv_elements_of_any_number_of_nodes(tmp_path, size, read):
    files.write(block(1, 1, 1), tmp_path / "m.unv")
    lines = (tmp_path / "m.unv").read_text(encoding="ascii").splitlines()
    for k, line in enumerate(lines):
        if line.split()[1:2] in (["115"], ["94"]):
            lines[k] = line[:50] + f" {size}"
    (tmp_path / "m.unv").write_text("\n".join(lines), encoding="ascii")
    refused(read, str(tmp_path / "m.unv"))


@pytest.mark.parametrize("count", (-2, -10, 10 ** 12))
def test_unv_groups_that_lie(tmp_path, count):
    files.write(block(1, 1, 1), tmp_path / "m.unv")
    text = (tmp_path / "m.unv").read_text(encoding="ascii")
    head, groups = text.split("  2467\n")
    lines = groups.splitlines()
    lines[0] = lines[0][:-10] + f" {count}"
    (tmp_path / "m.unv").write_text(head + "  2467\n" + "\n".join(lines), encoding="ascii")
    refused(files.read_mesh, str(tmp_path / "m.unv"))


LIES = {"vtk": "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {n} double\n0 0 0\nCELLS {n} {n}\n8 0 0 0 0 0 0 0 0\n",
        "poly.vtk": "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS {n} double\n0 0 0\nPOLYGONS {n} {n}\n4 0 0 0 0\n",
        "binary.vtk": "# vtk DataFile Version 3.0\nx\nBINARY\nDATASET POLYDATA\nPOINTS {n} double\n0 0 0\nPOLYGONS {n} {n}\n4 0 0 0 0\n",
        "vtu": '<VTKFile type="UnstructuredGrid" version="0.1"><UnstructuredGrid><Piece NumberOfPoints="{n}" NumberOfCells="{n}"><Points>'
               '<DataArray type="Float64" NumberOfComponents="3" format="ascii">0 0 0</DataArray></Points><Cells>'
               '<DataArray type="Int64" Name="connectivity" format="ascii">0</DataArray><DataArray type="Int64" Name="offsets" '
               'format="ascii">8</DataArray><DataArray type="UInt8" Name="types" format="ascii">12</DataArray></Cells></Piece>'
               "</UnstructuredGrid></VTKFile>",
        "msh": "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{n}\n1 0 0 0\n$EndNodes\n$Elements\n{n}\n1 5 0 1 1 1 1 1 1 1 1\n$EndElements\n",
        "4.msh": "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n{n} {n} 1 {n}\n2 1 0 {n}\n1\n0 0 0\n$EndNodes\n$Elements\n1 {n} 1 {n}\n"
                 "3 1 5 {n}\n1 1 1 1 1 1 1 1 1\n$EndElements\n",
        "mesh": "MeshVersionFormatted 1\nDimension 3\nVertices\n{n}\n0 0 0 0\nHexahedra\n{n}\n1 1 1 1 1 1 1 1 0\nEnd\n"}


@pytest.mark.parametrize("name", LIES)
@pytest.mark.parametrize("count", (10 ** 12, -1))
def test_counts_that_lie(tmp_path, name, count):
    path = tmp_path / f"x.{name}"
    path.write_text(LIES[name].format(n=count), encoding="ascii")
    refused(surface_from_file, str(path), codes=(FaultCode.FILE_FORMAT, FaultCode.BAD_SHAPE, ErrorCode.EMPTY))


def test_a_truncated_polydata_file(tmp_path):
    """Of it VTK dies; at every length this process does not."""
    whole = (b"# vtk DataFile Version 3.0\nq\nBINARY\nDATASET POLYDATA\nPOINTS 8 double\n" + block(1, 1, 1).points.astype(">f8").tobytes()
             + b"\nPOLYGONS 6 30\n" + np.column_stack([np.full(6, 4), block(1, 1, 1).quads]).astype(">i4").tobytes() + b"\n")
    path = tmp_path / "x.vtk"
    path.write_bytes(whole)
    assert len(surface_from_file(path).quads) == 6
    for cut in range(60, len(whole) - 1, 51):
        path.write_bytes(whole[:cut])
        refused(surface_from_file, str(path), codes=(FaultCode.FILE_FORMAT, FaultCode.BAD_SHAPE, ErrorCode.EMPTY))


CRASHERS = sorted((pathlib.Path(__file__).resolve().parent / "crashers").iterdir())


@pytest.mark.parametrize("name", [path.name for path in CRASHERS])
def test_what_once_killed_or_never_ended(name, tmp_path, monkeypatch):
    """Files made by mutate_files.py, each called after what it did to a reader."""
    path = CRASHERS[0].parent / name
    monkeypatch.setattr(reading, "SECONDS", 2.0)
    with pytest.raises(ToolError) as caught:
        if path.suffix == ".vtk":
            surface_from_file(path)
        else:
            solid_as_brep(path, tmp_path / "x.brep")
    assert name in str(caught.value)


# ---- the process that reads ---------------------------------------------------------------------------------------

def _reader(tmp_path, monkeypatch, body):
    """Let another program than ours read; returns the path of a whole file."""
    script = tmp_path / "start.py"
    script.write_text("import sys, os, json\njob = json.load(open(sys.argv[-1]))\nopen('progress.txt', 'w').write('read 0')\n" + body,
                      encoding="utf-8")
    monkeypatch.setattr(reading, "START", str(script))
    path = tmp_path / "m.ply"
    path.write_text("ply\n", encoding="ascii")
    return str(path)


@pytest.mark.parametrize("body, words", (
    ("os.kill(os.getpid(), 11)", "SIGSEGV"), ("os.abort()", "SIGABRT"), ("os._exit(1)", "status 1"), ("os._exit(0)", "status 0"),
    ("os.remove('progress.txt'); sys.exit('no numpy')", "no numpy"), ("open('fault.json', 'w').write('{')", "fault.json"),
    ("open('result.npz', 'w').write('PK')", "result.npz"),
    ("json.dump({'code': 'BAD_SHAPE', 'message': 'odd', 'elements': []}, open('fault.json', 'w'))", "odd")))
def test_how_a_reader_ends(tmp_path, monkeypatch, body, words):
    path = _reader(tmp_path, monkeypatch, body)
    with pytest.raises(ToolError) as caught:
        surface_from_file(path)
    assert words in str(caught.value) and ("VTK" in str(caught.value) or words == "odd")


def test_a_reader_that_never_ends(tmp_path, monkeypatch):
    path = _reader(tmp_path, monkeypatch, "import time\nwhile True: time.sleep(1)")
    monkeypatch.setattr(reading, "SECONDS", 0.5)
    assert "0.5" in refused(surface_from_file, path, "VTK", codes=(FaultCode.TOOL_TIMEOUT,))


def test_limits_of_the_reader(tmp_path, monkeypatch):
    """It keeps to its time and memory by itself, should the caller be gone."""
    worker = os.path.join(os.path.dirname(reading.START))
    body = (f"sys.path.insert(0, os.path.dirname({worker!r}))\nfrom file_worker import limits\nimport time\n"
            "limits.keep_to(0, 1 << 30)\n")
    path = _reader(tmp_path, monkeypatch, body + "while True: pass")
    monkeypatch.setattr(reading, "SECONDS", 600.0)
    started = time.monotonic()
    refused(surface_from_file, path, codes=(FaultCode.TOOL_TIMEOUT,))
    assert time.monotonic() - started < 500
    monkeypatch.undo()
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "temporary"))
    path = _reader(tmp_path, monkeypatch, body + "x = bytearray(2 << 30)")
    refused(surface_from_file, path, "status 1")


def test_cancelling(tmp_path, monkeypatch):
    path = _reader(tmp_path, monkeypatch, "import time\nwhile True: time.sleep(1)")

    class Stop(Exception):
        pass

    def stop(stage, fraction):
        raise Stop
    with pytest.raises(Stop):
        surface_from_file(path, progress=stop)
    for ending in ("vtk", "inp"):   # read by another process, and by this one
        files.write(block(1, 1, 1), tmp_path / f"m.{ending}")
        with pytest.raises(Stop):
            files.read_hexes(tmp_path / f"m.{ending}", progress=stop)
    told = []

    def stop_later(stage, fraction):
        told.append(stage)
        if len(told) == 3:
            raise Stop
    with pytest.raises(Stop):
        files.read_mesh(tmp_path / "m.vtk", progress=stop_later)
    assert told == ["read"] * 3


def test_a_file_that_goes_away(tmp_path):
    """While another thread takes it away and puts it back again: read whole, or named."""
    path, aside = str(tmp_path / "m.inp"), str(tmp_path / "aside")
    files.write(block(2, 2, 2), path)
    going = threading.Event()

    def move():
        while not going.is_set():
            os.rename(path, aside)
            os.rename(aside, path)
    mover = threading.Thread(target=move)
    mover.start()
    try:
        for _ in range(300):
            try:
                assert len(files.read_mesh(path).hexes) == 8
            except ToolError as fault:
                assert fault.code is FaultCode.FILE_IO
    finally:
        going.set()
        mover.join()


def test_names_of_any_bytes(tmp_path):
    """A name that is no UTF-8 goes through the job and back."""
    path = os.fsencode(tmp_path) + b"/\xff \xe4'\".vtk"
    files.write(block(1, 1, 1), tmp_path / "m.vtk")
    os.rename(tmp_path / "m.vtk", path)
    assert len(surface_from_file(path).quads) == 6 and len(files.read_mesh(path).hexes) == 1


# ---- archives -----------------------------------------------------------------------------------------------------

XML = b"<?xml version='1.0' encoding='utf-8'?>\n<Document SchemaVersion='4'/>\n"


def _zip(path, entries, **options):
    """entries: [(name or ZipInfo, bytes), ...]"""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, **options) as made:
        for name, data in entries:
            made.writestr(name, data)


def _entry(name, **facts):
    entry = zipfile.ZipInfo(name)
    entry.compress_type = zipfile.ZIP_DEFLATED
    for key, value in facts.items():
        setattr(entry, key, value)
    return entry


def _patched(path, data, old, new, which=0):
    at = [k for k in range(len(data)) if data.startswith(old, k)][which]
    path.write_bytes(data[:at] + new + data[at + len(old):])


def test_a_whole_archive(tmp_path):
    _zip(tmp_path / "x.FCStd", [("Document.xml", XML), ("a/b.brp", b"DBRep" * 100), ("<!x.brp", b"<!DOCTYPE")])
    assert archive.check_document(tmp_path / "x.FCStd") == len(XML) + 509
    with open(tmp_path / "y.FCStd", "wb") as stream, zipfile.ZipFile(_Streaming(stream), "w", zipfile.ZIP_DEFLATED) as made:
        made.writestr("Document.xml", XML)      # lengths behind the entry
    assert archive.check_document(tmp_path / "y.FCStd") == len(XML)


class _Streaming:
    """A file that cannot be rewound."""

    def __init__(self, stream):
        self._stream = stream

    def write(self, data):
        return self._stream.write(data)

    def flush(self):
        self._stream.flush()


BOMBS = {
    "3 GB of zeros": lambda path: _zip_zeros(path, 3 << 30), "200 MB from 200 kB": lambda path: _zip_zeros(path, 200 << 20),
    "entities": lambda path: _zip(path, [("Document.xml", b"<?xml version='1.0'?><!DOCTYPE a [<!ENTITY b 'cc'>"
                                          b"<!ENTITY d '&b;&b;'>]><Document>&d;</Document>")]),
    "entities over a seam": lambda path: _zip(path, [("Document.xml", b"<a>" + b" " * (archive._PIECE - 5) + b"<!ENTITY b 'c'></a>")]),
    "entities in UTF-16": lambda path: _zip(path, [("Document.xml", "<?xml version='1.0'?><!DOCTYPE a []><a/>".encode("utf-16"))]),
    "entities in EBCDIC": lambda path: _zip(path, [("Document.xml", "<?xml version='1.0'?><!DOCTYPE a []><a/>".encode("cp500"))]),
    "an encoding far off": lambda path: _zip(path, [("Document.xml", b"<?xml version='1.0'" + b" " * 2000 + b"encoding='utf-7'?><a/>")]),
    "no XML": lambda path: _zip(path, [("Document.xml", b"a" * 9 + XML)]),
    "another encoding": lambda path: _zip(path, [("Document.xml", b"<?xml version='1.0' encoding='utf-7'?><a/>")]),
    "out of the folder": lambda path: _zip(path, [("Document.xml", XML), ("../../x.brp", b"x")]),
    "from the root": lambda path: _zip(path, [("Document.xml", XML), ("/etc/x.brp", b"x")]),
    "of a drive": lambda path: _zip(path, [("Document.xml", XML), ("C:\\x.brp", b"x")]),
    "a link": lambda path: _zip(path, [("Document.xml", XML), (_entry("x.brp", external_attr=(stat.S_IFLNK | 0o777) << 16), b"/etc")]),
    "none": lambda path: _zip(path, []),
    "packed otherwise": lambda path: _zip(path, [("Document.xml", XML), (_entry("x", compress_type=zipfile.ZIP_LZMA), b"x" * 99)]),
    "junk in front": lambda path: (_zip(path, [("Document.xml", XML)]), path.write_bytes(b"#!" * 50 + path.read_bytes()))}


def _zip_zeros(path, size):
    """An archive that unpacks to size zeros: one packed MiB in as many entries as it takes."""
    piece = bytes(1 << 20)
    packer = zlib.compressobj(9, zlib.DEFLATED, -zlib.MAX_WBITS)
    packed = packer.compress(piece) + packer.flush()
    facts = struct.pack("<3L2H", zlib.crc32(piece), len(packed), len(piece), 9, 0)
    front, back, place = b"", b"", 0
    for k in range(size >> 20):
        name = b"x%08d" % k
        local = struct.pack("<4s5H", b"PK\3\4", 20, 0, 8, 0, 0) + facts + name + packed
        back += struct.pack("<4s6H", b"PK\1\2", 20, 20, 0, 8, 0, 0) + facts + struct.pack("<3H2L", 0, 0, 0, 0, place) + name
        front += local
        place += len(local)
    path.write_bytes(front + back + struct.pack("<4s4H2LH", b"PK\5\6", 0, 0, size >> 20, size >> 20, len(back), place, 0))


@pytest.mark.parametrize("kind", BOMBS)
def test_archives_that_are_refused(tmp_path, kind):
    path = tmp_path / "x.FCStd"
    BOMBS[kind](path)
    started = time.process_time()
    with pytest.raises(ToolError) as caught:
        archive.check_document(path)
    assert caught.value.code is FaultCode.FILE_FORMAT and "x.FCStd" in str(caught.value)
    assert time.process_time() - started < 2


def test_archives_whose_headers_lie(tmp_path):
    path, brep = tmp_path / "x.FCStd", b"DBRep" * 100
    _zip(path, [("Document.xml", XML), ("x.brp", brep)])
    whole = path.read_bytes()
    size, small = len(brep).to_bytes(4, "little"), (7).to_bytes(4, "little")
    lies = {"two headers": [(size, small, 0)], "length": [(size, small, 0), (size, small, 0)],
            "name": [(b"x.brp", b"y.brp", 0)], "an entry twice": [(b"x.brp", b"Document.xml"[:5], 1)]}
    for changes in lies.values():
        data = whole
        for change in changes:
            _patched(path, data, *change)
            data = path.read_bytes()
        refused(archive.check_document, path)
    with zipfile.ZipFile(path, "w") as made, pytest.warns(UserWarning):
        made.writestr("Document.xml", XML)
        made.writestr("Document.xml", XML)
    refused(archive.check_document, path, "twice")
    # encrypted: both headers say so
    _zip(path, [("Document.xml", XML)])
    data = bytearray(path.read_bytes())
    for signature, place in ((b"PK\3\4", 6), (b"PK\1\2", 8)):
        data[data.index(signature) + place] |= 1
    path.write_bytes(data)
    refused(archive.check_document, path, "encrypted")
    # every truncation
    for cut in range(0, len(whole) - 1, 13):
        path.write_bytes(whole[:cut])
        refused(archive.check_document, path)


def test_overlapping_entries(tmp_path):
    """A hundred names for one entry (Fifield 2019)."""
    path = tmp_path / "x.FCStd"
    _zip(path, [("Document.xml", XML), ("x.brp", bytes(1 << 20))])
    data = path.read_bytes()
    start = data.rindex(b"PK\1\2")
    end = data.rindex(b"PK\5\6")
    central = data[start:end]
    more = b"".join(central.replace(b"x.brp", b"%05d" % k) for k in range(50))
    tail = bytearray(data[end:])
    tail[8:12] = (52).to_bytes(2, "little") * 2
    tail[12:16] = (int.from_bytes(tail[12:16], "little") + len(more)).to_bytes(4, "little")
    path.write_bytes(data[:end] + more + tail)
    refused(archive.check_document, path)


def test_a_bomb_through_the_front_door(tmp_path):
    """surface_from_solid refuses it by name, soon, and this process grows by little."""
    path = tmp_path / "x.FCStd"
    BOMBS["entities"](path)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    refused(lambda p: surface_from_solid(p, 1.0), str(path), "entities")
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 20_000
