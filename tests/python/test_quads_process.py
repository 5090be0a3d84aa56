# SPDX-License-Identifier: LGPL-2.1-or-later
"""hexcon.quads from CAD files in plain Python: the subprocess, its limits and its faults. No FreeCAD."""
import os
import signal
import subprocess
import sys
import tempfile
import threading

import numpy as np
import pytest

from hexcon import child, gmsh_process, keeper
from hexcon.errors import FaultCode, ToolError
from hexcon.quads import METHODS, surface_from_solid

MAKE = """
import gmsh, sys
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
{body}
gmsh.model.occ.synchronize()
gmsh.write(sys.argv[1])
"""


def _cad(path, body):
    """Write a CAD file with gmsh's own kernel, in another process."""
    subprocess.run([gmsh_process.gmsh_python(), "-c", MAKE.format(body=body), str(path)], check=True)
    return str(path)


@pytest.fixture(scope="module")
def box(tmp_path_factory):
    return _cad(tmp_path_factory.mktemp("cad") / "box.step", "gmsh.model.occ.addBox(0, 0, 0, 10, 7, 5)")


@pytest.fixture(scope="module")
def ball(tmp_path_factory):
    return _cad(tmp_path_factory.mktemp("cad") / "ball.brep", "gmsh.model.occ.addSphere(0, 0, 0, 5)")


@pytest.fixture
def temporary(tmp_path, monkeypatch):
    """A temporary folder of the test's own; empty again afterwards, or the test fails."""
    folder = tmp_path / "temporary"
    folder.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(folder))
    yield folder
    assert not list(folder.iterdir())


def _fault(*arguments, **options):
    with pytest.raises(ToolError) as caught:
        surface_from_solid(*arguments, **options)
    return caught.value


NOT_FOR_BOXES = {"revolved": FaultCode.NOT_REVOLVED, "boxed": FaultCode.NOT_BOXED, "filled": FaultCode.NOT_FILLED}


@pytest.mark.parametrize("method", NOT_FOR_BOXES)
def test_box_by_methods_for_other_solids(box, temporary, method):
    assert _fault(box, 1.9, method).code is NOT_FOR_BOXES[method]


@pytest.mark.parametrize("method", [method for method in METHODS if method not in NOT_FOR_BOXES])
def test_box_by_every_method(box, temporary, method):
    surface = surface_from_solid(box, 1.9, method)
    assert len(surface.quads) % 2 == 0 and set(surface.face_of_quad) == set(range(1, 7))
    assert surface.points.min(axis=0) == pytest.approx([0, 0, 0], abs=1e-7)
    assert surface.points.max(axis=0) == pytest.approx([10, 7, 5], abs=1e-7)
    assert surface.method == {"auto": "sweep"}.get(method, method)
    assert surface.notes


def test_step_in_metres_is_read_in_millimetres(tmp_path, box):
    with open(box, encoding="ascii") as stream:
        text = stream.read()
    assert "SI_UNIT(.MILLI.,.METRE.)" in text
    path = tmp_path / "metres.step"
    path.write_text(text.replace("SI_UNIT(.MILLI.,.METRE.)", "SI_UNIT($,.METRE.)"), encoding="ascii")
    assert surface_from_solid(str(path), 2000.0).points.max() == pytest.approx(10000.0)


STEP_WITHOUT_END = """
import sys
from gmsh_worker.link import Link
link = Link(sys.argv[1], avoid=["the first step"])
link.patience = 0.05
assert not link.risk("the first step") and link.risk("the second step")
link.over()
assert link.risk("a step without end")
while True:
    pass
"""


def test_step_without_end(tmp_path):
    """It ends the worker, is told as what did so, and will be left out."""
    python = gmsh_process.gmsh_python()
    environment = child.python_environment(python, gmsh_process.WORKERS)
    ended = subprocess.run([python, "-c", STEP_WITHOUT_END, str(tmp_path)], env=environment, timeout=60)
    assert ended.returncode == -signal.SIGPROF
    assert gmsh_process._crashed_in(str(tmp_path), ended.returncode) == "a step without end"


def test_time_limit(box, temporary):
    fault = _fault(box, 1.0, timeout=0.01)
    assert fault.code is FaultCode.TOOL_TIMEOUT and "0.01 seconds" in str(fault) and "--timeout" in str(fault)


class Stop(Exception):
    pass


def test_progress_and_cancel(ball, temporary):
    stages = []
    surface_from_solid(ball, 0.5, progress=lambda stage, fraction: stages.append((stage, fraction)))
    assert stages and all(0.0 <= f <= 1.0 for _, f in stages)

    def stop(stage, fraction):
        raise Stop
    with pytest.raises(Stop):
        surface_from_solid(ball, 0.5, progress=stop)


def test_interrupt_ends_the_subprocess(ball, temporary):
    """KeyboardInterrupt comes out, and no process stays but the keeper, which is there already."""
    keeper.hold_folder("/none")
    keeper.let_folder_go("/none")
    before = signal.signal(signal.SIGINT, signal.default_int_handler)   # a background job's shell has it ignored
    started = []
    original = subprocess.Popen

    class Spy(original):
        def __init__(self, *arguments, **options):
            super().__init__(*arguments, **options)
            started.append(self)

    subprocess.Popen = Spy
    try:
        timer = threading.Timer(0.2, lambda: os.kill(os.getpid(), 2))
        timer.start()
        with pytest.raises(KeyboardInterrupt):
            surface_from_solid(ball, 0.02, "blossom")
    finally:
        subprocess.Popen = original
        timer.join()
        signal.signal(signal.SIGINT, before)
    assert started and all(process.poll() is not None for process in started)


def test_other_interpreter(ball, monkeypatch):
    monkeypatch.setenv("HEXCON_GMSH_PYTHON", os.path.join(os.path.dirname(__file__), "no-such-python"))
    assert _fault(ball, 2.0).code is FaultCode.TOOL_MISSING
    monkeypatch.setenv("HEXCON_GMSH_PYTHON", sys.executable)
    assert len(surface_from_solid(ball, 2.0).quads)


def test_crash_is_survived(ball, monkeypatch, tmp_path):
    """An interpreter that dies gives TOOL_FAILED with its last words."""
    script = tmp_path / "python-dies"
    script.write_text('#!/bin/sh\n[ "$1" = "-c" ] && exit 0\necho "Error   : out of luck"\nkill -SEGV $$\n',
                      encoding="ascii")
    script.chmod(0o755)
    monkeypatch.setenv("HEXCON_GMSH_PYTHON", str(script))
    fault = _fault(ball, 2.0)
    assert fault.code is FaultCode.TOOL_FAILED and "out of luck" in str(fault) and "signal 11" in str(fault)


@pytest.mark.parametrize("size", (0, -1.0, float("nan"), float("inf"), "big", None))
def test_bad_size(box, size):
    assert _fault(box, size).code is FaultCode.BAD_OPTION


def test_absurd_size(box):
    fault = _fault(box, 1e-6)
    assert fault.code is FaultCode.BAD_OPTION and "quads" in str(fault)


def test_bad_options(box):
    assert _fault(box, 1.0, "magic").code is FaultCode.BAD_OPTION
    assert _fault(box, 1.0, timeout=-1).code is FaultCode.BAD_OPTION
    assert _fault(3.14, 1.0).code is FaultCode.BAD_OPTION


def test_bad_files(tmp_path):
    assert _fault(str(tmp_path / "none.step"), 1.0).code is FaultCode.FILE_IO
    (tmp_path / "s.iges").write_text("", encoding="ascii")
    assert _fault(tmp_path / "s.iges", 1.0).code is FaultCode.FILE_FORMAT
    for ending in ("step", "brep"):
        path = tmp_path / f"bad.{ending}"
        path.write_text("this is no CAD file\n", encoding="ascii")
        assert _fault(path, 1.0).code in (FaultCode.FILE_FORMAT, FaultCode.BAD_SHAPE)


def test_two_solids_and_none(tmp_path):
    two = _cad(tmp_path / "two.brep", "gmsh.model.occ.addBox(0,0,0,1,1,1); gmsh.model.occ.addBox(3,0,0,1,1,1)")
    assert "2 solids" in str(_fault(two, 1.0)) and _fault(two, 1.0).code is FaultCode.BAD_SHAPE
    none = _cad(tmp_path / "none.brep", "gmsh.model.occ.addRectangle(0,0,0,1,1)")
    assert "0 solids" in str(_fault(none, 1.0))


def test_crashed_step_is_left_out(ball, monkeypatch):
    """A job that died in one step is started again without it, and a note says so."""
    real, runs = gmsh_process._run, []

    def run(python, job_path, folder, *rest):
        ended = real(python, job_path, folder, *rest)
        runs.append(ended)
        if len(runs) == 1:
            os.remove(os.path.join(folder, "result.npz"))
            with open(os.path.join(folder, "risk.txt"), "w", encoding="utf-8") as stream:
                stream.write("subdivided by factor 1, algorithm 6")
            return child.Ended(-11, "")
        return ended
    monkeypatch.setattr(gmsh_process, "_run", run)
    surface = surface_from_solid(ball, 2.0, "subdivided")
    assert len(runs) == 2 and any("1.94" in note for note in surface.notes)


def test_blossom_on_plane_triangles(tmp_path):
    """gmsh's frontal algorithm leaves triangles at the corners of these, at every size: another one does not."""
    prism = _cad(tmp_path / "prism.brep", "occ = gmsh.model.occ\n"
                 "ring = [occ.addPoint(*p, 0) for p in ((2, 0), (-1, 1.7), (-1, -1.7))]\n"
                 "lines = [occ.addLine(ring[k - 1], ring[k]) for k in range(3)]\n"
                 "occ.extrude([(2, occ.addPlaneSurface([occ.addCurveLoop(lines)]))], 0, 0, 2)")
    surface = surface_from_solid(prism, 0.6, "blossom")
    assert len(surface.quads) % 2 == 0 and set(surface.face_of_quad) == set(range(1, 6))
    assert any("algorithm 5" in note for note in surface.notes)


def test_large_surface_is_quick_enough_to_try(box):
    surface = surface_from_solid(box, 0.1, "sweep")
    assert len(surface.quads) == 2 * (100 * 70 + 100 * 50 + 70 * 50) and np.isfinite(surface.points).all()
