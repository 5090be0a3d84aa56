# SPDX-License-Identifier: LGPL-2.1-or-later
"""hexcon.mesh_solid and mesh_surface from plain Python: results, cancelling, faults, limits."""
import functools
import pathlib
import sys
import tempfile

import numpy as np
import pytest
from test_quads_process import _cad as cad_file

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))
from hex_grids import block  # noqa: E402

import hexcon  # noqa: E402
import hexcon_native  # noqa: E402
from hexcon.errors import FaultCode  # noqa: E402
from hexcon.meshing import mesh_quad_surface  # noqa: E402
from hexcon.quads import QuadSurface, surface_from_solid  # noqa: E402
from hexcon_native import ErrorCode  # noqa: E402

WEDGE = str(ROOT / "resources" / "examples" / "wedge.step")


@pytest.fixture(scope="module")
def ball(tmp_path_factory):
    """A solid that is no sweep."""
    path = tmp_path_factory.mktemp("cad") / "ball.brep"
    return cad_file(path, "gmsh.model.occ.addSphere(0, 0, 0, 5)")


@pytest.fixture(autouse=True)
def nothing_is_left(tmp_path, monkeypatch):
    """A temporary folder of the test's own; empty again afterwards, or the test fails."""
    folder = tmp_path / "temporary"
    folder.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(folder))
    yield
    assert not list(folder.iterdir())


def fault(call, *arguments, **options):
    with pytest.raises(hexcon.HexconError) as caught:
        call(*arguments, **options)
    return caught.value


@pytest.mark.parametrize("order", [1, 2])
def test_mesh_of_a_file(order):
    mesh = hexcon.mesh_solid(WEDGE, 8.0, order=order)
    assert mesh.certificate.certified and mesh.order == order
    assert mesh.hexes.shape == (64, 20 if order == 2 else 8)
    assert mesh.solid == WEDGE and mesh.surface.method == "sweep"
    assert np.array_equal(mesh.points[:len(mesh.surface.points)], mesh.surface.points)
    assert np.array_equal(mesh.quads, mesh.surface.quads)
    assert set(mesh.face_of_quad) == set(range(1, 7))
    assert mesh.report["surface method"] == "sweep" and mesh.report["surface notes"]
    assert mesh.report["seconds surface"] > 0


def test_surface_method_is_kept(ball):
    """Quads made of triangles are no sweep, though the solid is."""
    mesh = hexcon.mesh_solid(WEDGE, 8.0, surface_method="transfinite")
    assert mesh.surface.method == mesh.report["surface method"] == "transfinite"
    told = fault(hexcon.mesh_solid, WEDGE, 8.0, surface_method="subdivided-triangles",
                 method="swept")
    assert told.code is ErrorCode.NOT_SWEPT
    told = fault(hexcon.mesh_solid, ball, 4.0, surface_method="sweep")
    assert told.code is FaultCode.NOT_SWEEPABLE


def test_surfaces_of_no_solid():
    mesh = block(3, 2, 2)
    used, quads = np.unique(mesh.quads, return_inverse=True)
    points, quads = mesh.points[used], quads.reshape(-1, 4)
    made = hexcon.mesh_surface(points, quads)
    assert made.certificate.certified and len(made.hexes) == 12
    given = QuadSurface(points, quads, mesh.face_of_quad, "given", ["from a test"])
    again = mesh_quad_surface(given, "swept", order=2)
    assert again.surface is given and again.report["surface notes"] == ["from a test"]
    assert np.array_equal(again.face_of_quad, mesh.face_of_quad)
    assert fault(hexcon.mesh_surface, points, quads[1:]).code is ErrorCode.NOT_CLOSED


def test_no_sweep_says_why_twice(tmp_path):
    """Why the surface is no sweep, and why the quads on it are none."""
    octant = cad_file(tmp_path / "octant.brep",
                      "gmsh.model.occ.addSphere(0, 0, 0, 5, angle1=0, angle3=1.5707963267948966)")
    told = fault(hexcon.mesh_solid, octant, 3.0, method="swept")
    assert told.code is ErrorCode.NOT_SWEPT and told.elements
    assert "auto: not swept: " in str(told) and "the surface: " in str(told)
    whole = surface_from_solid(octant, 3.0)
    core = fault(hexcon_native.mesh, whole.points, whole.quads, "swept")
    assert str(core) in str(told) and all(note in str(told) for note in whole.notes)
    assert core.elements == told.elements and max(told.elements) < len(whole.quads)


class Stop(Exception):
    """Nothing that HexCon knows."""


def assert_cancels(call, stage):
    """By False and by any exception, at the first report of a stage."""
    told = fault(call, progress=lambda at, _: not at.startswith(stage))
    assert told.code is ErrorCode.CANCELLED

    def stop(at, _):
        if at.startswith(stage):
            raise Stop(stage)
    with pytest.raises(Stop, match=stage):
        call(progress=stop)


@pytest.mark.parametrize("stage", ["start", "placement"])
def test_a_solid_is_cancelled(stage):
    """While gmsh works (its first report), and while the core does."""
    assert_cancels(functools.partial(hexcon.mesh_solid, WEDGE, 4.0), stage)


def test_a_surface_is_cancelled_in_every_stage():
    surface, seen = surface_from_solid(WEDGE, 2.0), []
    call = functools.partial(hexcon.mesh_surface, surface.points, surface.quads)
    call(progress=lambda stage, part: seen.append((stage, part)))
    assert all(0.0 <= part <= 1.0 for _, part in seen)
    stages = dict(seen)
    assert len(stages) >= 4 and any(stage.startswith("placement, ") for stage in stages)
    for stage in stages:
        assert_cancels(call, stage)


def test_progress_that_returns_nothing_goes_on():
    assert len(hexcon.mesh_solid(WEDGE, 8.0, progress=lambda *_: None).hexes) == 64


def test_time_limit():
    told = fault(hexcon.mesh_solid, WEDGE, 1.0, timeout=0.01)
    assert told.code is FaultCode.TOOL_TIMEOUT and "0.01" in str(told)


@pytest.mark.parametrize("options,code", [
    ({"size": 0.0}, FaultCode.BAD_OPTION), ({"size": float("nan")}, FaultCode.BAD_OPTION),
    ({"size": "big"}, FaultCode.BAD_OPTION), ({"timeout": 0}, FaultCode.BAD_OPTION),
    ({"surface_method": "magic"}, FaultCode.BAD_OPTION),
    ({"method": "magic"}, ErrorCode.BAD_ARGUMENT), ({"order": 3}, ErrorCode.BAD_ARGUMENT),
    ({"threads": -1}, ErrorCode.BAD_ARGUMENT), ({"shape_or_file": 7}, FaultCode.BAD_OPTION),
    ({"shape_or_file": "none.step"}, FaultCode.FILE_IO),
    ({"shape_or_file": str(ROOT / "LICENSE")}, FaultCode.FILE_FORMAT)])
def test_bad_options(options, code):
    told = fault(hexcon.mesh_solid, **{"shape_or_file": WEDGE, "size": 20.0, **options})
    assert told.code is code and str(told)


def test_size_larger_than_the_solid():
    mesh = hexcon.mesh_solid(WEDGE, 1e6)
    assert mesh.certificate.certified and len(mesh.hexes) >= 1


def test_progress_tells_hexes_and_the_worst():
    """From where they are known on; the certificate's are those of the mesh that is returned."""
    seen = []
    made = hexcon.mesh_solid(WEDGE, 4.0, progress=lambda stage, _: seen.append(stage))
    figures = dict(stage.partition(", ")[::2] for stage in seen)
    assert figures["placement"] == f"{len(made.hexes)} hexes" and figures["start"] == ""
    assert figures["certificate: links"] == \
        f"{len(made.hexes)} hexes, worst scaled Jacobian {made.quality.min:.3f}"
