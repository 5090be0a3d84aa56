# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tetrahedra by tetgen, which is asked where gmsh finds none."""
import numpy as np
import pytest
from test_cavities import hollow_ball
from test_paper_genus import torus
from test_tetrahedra import SURFACES

import hexcon
from hexcon.errors import FaultCode, ToolError
from hexcon.tetrahedra import fill, tetrahedralise
from hexcon.tetrahedra.check import fault_of


@pytest.fixture(autouse=True)
def without_gmsh(monkeypatch):
    """It gives up at once."""
    def fails(*arguments):
        raise ToolError("gmsh gave up", FaultCode.TOOL_FAILED)
    monkeypatch.setattr(fill, "run_job", fails)


def halved(points, quads):
    return points, np.vstack([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


BODIES = SURFACES | {"cavity": halved(*hollow_ball()), "torus": halved(*torus(12, 6))}


@pytest.mark.parametrize("name", BODIES)
def test_it_fills(name):
    points, triangles = BODIES[name]
    found, tetrahedra = tetrahedralise(points, triangles)
    assert fault_of(found, tetrahedra, np.asarray(points, float), triangles) is None


def test_cells_on_its_tetrahedra():
    points, quads = torus(12, 6)
    mesh = hexcon.mesh_surface(points, quads, "cells")
    assert mesh.certificate.certified and mesh.report["tetrahedra"] > 0


def test_only_if_it_is_wanted(monkeypatch):
    for named, code, words in (("", FaultCode.TOOL_FAILED, "gmsh gave up"),
                               ("/no/such/program", FaultCode.TOOL_MISSING, "HEXCON_TETGEN"),
                               ("true", FaultCode.TOOL_FAILED, "tetgen ended with status 0")):
        monkeypatch.setenv("HEXCON_TETGEN", named)
        with pytest.raises(ToolError) as caught:
            tetrahedralise(*SURFACES["ball"])
        assert caught.value.code is code and words in str(caught.value)


def test_what_crosses_itself_is_refused():
    points, triangles = SURFACES["box"]
    crossed = points.copy()
    crossed[0] = (2.0, 2.0, 2.0)
    with pytest.raises(ToolError) as caught:
        tetrahedralise(crossed, triangles)
    assert caught.value.code is FaultCode.TOOL_FAILED and "tetgen" in str(caught.value)


def test_bodies_side_by_side_are_refused():
    points, triangles = SURFACES["box"]
    with pytest.raises(ToolError) as caught:
        tetrahedralise(np.vstack([points, points + 9.0]), np.vstack([triangles, triangles + len(points)]))
    assert caught.value.code is FaultCode.TOOL_FAILED and "several bodies" in str(caught.value)


@pytest.fixture
def endless(monkeypatch, tmp_path):
    program = tmp_path / "endless"
    program.write_text("#!/bin/sh\nexec sleep 60\n", encoding="ascii")
    program.chmod(0o755)
    monkeypatch.setenv("HEXCON_TETGEN", str(program))


def test_a_cancel_ends_it(endless):
    class Enough(Exception):
        pass

    def progress(stage, fraction):
        raise Enough
    with pytest.raises(Enough):
        tetrahedralise(*SURFACES["ball"], progress=progress)


def test_it_has_as_much_time_as_gmsh(endless):
    with pytest.raises(ToolError) as caught:
        tetrahedralise(*SURFACES["ball"], timeout=0.05)
    assert "tetgen did not finish within 0.05 seconds" in str(caught.value)
