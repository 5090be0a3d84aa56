# SPDX-License-Identifier: LGPL-2.1-or-later
"""hexcon.answers: what workers hand back, whole and damaged."""
import io
import json
import zipfile

import numpy as np
import pytest

from hexcon.answers import RESULTS, read_arrays, read_fault, read_progress
from hexcon.errors import FaultCode, ToolError

GOOD = {"points": np.arange(12.0).reshape(4, 3), "quads": np.array([[0, 1, 2, 3]], np.uint64), "faces": np.array([1]),
        "off_cad": np.zeros(4), "cad_gap": np.zeros(4), "tolerance": 1e-7, "method": "sweep", "notes": np.array(["a"])}
BAD = {"points of two columns": {"points": np.zeros((4, 2))}, "points of integers": {"points": np.zeros((4, 3), int)},
       "no points": {"points": np.zeros((0, 3)), "off_cad": np.zeros(0), "cad_gap": np.zeros(0)},
       "points not finite": {"points": np.full((4, 3), np.nan)}, "one dimension": {"quads": np.arange(4)},
       "a point that is not there": {"quads": np.array([[0, 1, 2, 4]])}, "below zero": {"quads": np.array([[0, 1, 2, -1]])},
       "beyond int64": {"faces": np.array([2 ** 63], np.uint64)}, "quads of floats": {"quads": np.array([[0.0, 1, 2, 3]])},
       "triangles": {"quads": np.array([[0, 1, 2]])}, "faces too many": {"faces": np.array([1, 1])},
       "face 0": {"faces": np.array([0])}, "text for numbers": {"off_cad": np.array(["a"] * 4)},
       "complex": {"points": np.zeros((4, 3), complex)}, "numbers for text": {"notes": np.array([1])},
       "tolerance nan": {"tolerance": np.nan}, "a table for the method": {"method": np.array(["a"])},
       "objects": {"notes": np.array([None, {}])}}


def _refused(path):
    with pytest.raises(ToolError) as caught:
        read_arrays(path, "gmsh", RESULTS["gmsh_worker"])
    assert caught.value.code is FaultCode.TOOL_FAILED and "gmsh" in str(caught.value)


def test_whole(tmp_path):
    np.savez(tmp_path / "result.npz", **GOOD, more=np.array([{}]))
    found = read_arrays(tmp_path / "result.npz", "gmsh", RESULTS["gmsh_worker"])
    assert found.keys() == GOOD.keys() and found["quads"].dtype == np.int64
    for name, array in GOOD.items():
        assert np.array_equal(found[name], array)
    found["points"][0] = 1.0    # the caller's own


@pytest.mark.parametrize("kind", BAD)
def test_damaged_arrays(tmp_path, kind):
    np.savez(tmp_path / "result.npz", **{**GOOD, **BAD[kind]})
    _refused(tmp_path / "result.npz")


@pytest.mark.parametrize("name", GOOD)
def test_an_array_missing(tmp_path, name):
    np.savez(tmp_path / "result.npz", **{n: a for n, a in GOOD.items() if n != name})
    _refused(tmp_path / "result.npz")


def test_damaged_files(tmp_path):
    path = tmp_path / "result.npz"
    _refused(path)
    for junk in (b"", b"PK", b"\0" * 5000):
        path.write_bytes(junk)
        _refused(path)
    np.savez(path, **GOOD)
    whole = path.read_bytes()
    for cut in range(0, len(whole), 97):
        path.write_bytes(whole[:cut])
        _refused(path)
    np.savez_compressed(path, **GOOD)
    _refused(path)


@pytest.mark.parametrize("shape", ("(10**12, 3)", "(1000000000000, 3)", "(-1, 3)", "(2, 3)", "((((", "(True, 3)"))
def test_a_header_that_lies(tmp_path, shape):
    path = tmp_path / "result.npz"
    np.savez(path, **{n: a for n, a in GOOD.items() if n != "points"})
    head = f"{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}".ljust(117) + "\n"
    lie = io.BytesIO(b"\x93NUMPY\1\0" + len(head).to_bytes(2, "little") + head.encode() + bytes(96)).getvalue()
    with zipfile.ZipFile(path, "a") as archive:
        archive.writestr("points.npy", lie)
    _refused(path)


def test_faults(tmp_path):
    path = tmp_path / "fault.json"
    path.write_text(json.dumps({"code": "BAD_SHAPE", "message": "no", "elements": [3]}), encoding="utf-8")
    fault = read_fault(path, "gmsh")
    assert fault.code is FaultCode.BAD_SHAPE and str(fault) == "no" and fault.elements == [3]
    for bad in ("", "{", "[]", "3", "null", '{"code": "BAD_SHAPE", "message": "no"}', "[" * 100000, "\udcff",
                '{"code": "NONE", "message": "no", "elements": []}', '{"code": 1, "message": "no", "elements": []}',
                '{"code": "BAD_SHAPE", "message": "no", "elements": ["a"]}',
                '{"code": "BAD_SHAPE", "message": "no", "elements": [%d]}' % 10 ** 30):
        path.write_bytes(bad.encode("utf-8", "surrogateescape"))
        with pytest.raises(ToolError) as caught:
            read_fault(path, "gmsh")
        assert caught.value.code is FaultCode.TOOL_FAILED, bad


@pytest.mark.parametrize("text, right", (("load 0.5\n", ("load", 0.5)), ("load 0.2\nmesh 7\n", ("mesh", 1.0)),
                                         ("", ("start", 0.0)), ("load\n", ("start", 0.0)), ("a nan\n", ("start", 0.0)),
                                         ("x" * 100000, ("start", 0.0)), ("a b c\n", ("start", 0.0))))
def test_progress(tmp_path, text, right):
    (tmp_path / "progress.txt").write_text(text, encoding="utf-8")
    assert read_progress(tmp_path / "progress.txt") == right
    assert read_progress(tmp_path / "none.txt") == ("start", 0.0)
