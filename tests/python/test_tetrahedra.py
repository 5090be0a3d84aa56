# SPDX-License-Identifier: LGPL-2.1-or-later
"""hexcon.tetrahedra: what it keeps, what it makes, and its faults."""
import os
import tempfile

import numpy as np
import pytest
from scipy.spatial import ConvexHull
from surfaces import box

from hexcon import child, gmsh_process
from hexcon.errors import FaultCode, ToolError
from hexcon.tetrahedra import tetrahedralise
from hexcon.tetrahedra.check import fault_of, positive
from hexcon.tetrahedra.quality import diced_quality
from hexcon.tetrahedra.split import GOOD, split_doubles


def hull(count, seed, axes=(1, 1, 1)):
    """A ball of random points, scaled along the axes."""
    points = np.random.default_rng(seed).normal(size=(count, 3))
    points /= np.linalg.norm(points, axis=1)[:, None]
    triangles = ConvexHull(points).simplices
    inward = np.linalg.det(points[triangles]) < 0
    triangles[inward] = triangles[inward][:, [0, 2, 1]]
    return points * axes, triangles


def block(*counts, size=(1, 1, 1), shake=0.0):
    """A box of quads, each cut along one diagonal."""
    points, quads = box(*counts)
    points = points + np.random.default_rng(0).uniform(-shake, shake, points.shape)
    return points / counts * size, np.vstack([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


SURFACES = {
    "box of 12": block(1, 1, 1),
    "box": block(6, 5, 4, shake=0.15),
    "plate": block(8, 8, 1, size=(8, 8, 0.5), shake=0.1),
    "needle": block(1, 1, 20, size=(1, 1, 20), shake=0.1),
    "ball": hull(80, 1),
    "lens": hull(150, 2, (1, 1, 0.3)),
    "tetrahedron": (np.vstack([np.zeros(3), np.eye(3)]), np.array([[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]])),
}


@pytest.fixture(autouse=True)
def without_tetgen(monkeypatch):
    """What is tested here is gmsh's."""
    monkeypatch.setenv("HEXCON_TETGEN", "")


@pytest.fixture
def temporary(tmp_path, monkeypatch):
    """A temporary folder of the test's own; empty again afterwards, or the test fails."""
    folder = tmp_path / "temporary"
    folder.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(folder))
    yield folder
    assert not list(folder.iterdir())


def _fault(surface, **options):
    with pytest.raises(ToolError) as caught:
        tetrahedralise(*surface, **options)
    return caught.value


def _faces(tetrahedra):
    """Boundary faces, as sets of an owner and its three corners."""
    owners = {}
    for k, (a, b, c, d) in enumerate(tetrahedra.tolist()):
        for face in ((b, c, d), (a, d, c), (a, b, d), (a, c, b)):
            owners.setdefault(frozenset(face), []).append((k, face))
    assert max(len(found) for found in owners.values()) <= 2
    return [found[0] for found in owners.values() if len(found) == 1]


def _turned(triangle):
    first = int(np.argmin(triangle))
    return tuple(int(triangle[(first + i) % 3]) for i in range(3))


@pytest.mark.parametrize("name", SURFACES)
def test_fills_and_keeps_the_surface(name, temporary):
    points, triangles = SURFACES[name]
    made, tetrahedra = tetrahedralise(points, triangles)
    assert made.dtype == np.float64 and tetrahedra.dtype == np.int32
    assert made[:len(points)].tobytes() == np.ascontiguousarray(points, float).tobytes()
    assert (np.bincount(tetrahedra.ravel(), minlength=len(made)) > 0).all()
    assert (np.linalg.det(made[tetrahedra[:, 1:]] - made[tetrahedra[:, :1]]) > 0).all()
    outer = _faces(tetrahedra)
    assert sorted(_turned(face) for _, face in outer) == sorted(map(_turned, triangles))
    doubles = np.flatnonzero(np.bincount([k for k, _ in outer]) >= 2)      # these are good as they are
    assert (diced_quality(made, tetrahedra[doubles]) >= GOOD).all()
    assert diced_quality(made, tetrahedra).min() > 0
    assert len(tetrahedra) < 8 * len(triangles)


def test_coarsening():
    surface = hull(400, 5)
    fine, coarse = (tetrahedralise(*surface, coarsening=c) for c in (0.2, 2.0))
    assert len(fine[1]) > 1.3 * len(coarse[1])


def test_place_and_scale_do_not_matter():
    points, triangles = SURFACES["box"]
    for scale, shift in ((1e-3, 5.0), (1e3, -1e4)):
        made, tetrahedra = tetrahedralise(points * scale + shift, triangles)
        assert positive(made, tetrahedra).all()


def test_cavities():
    """Two in one block, and a tetrahedron's: all triangles are kept, and what is filled is what lies between."""
    points, triangles = block(3, 3, 3, size=(3, 3, 3))
    inner, inner_triangles = SURFACES["tetrahedron"]
    both = (np.vstack([inner * 0.7 + 1.7, points, points / 6 + 0.6]),
            np.vstack([inner_triangles[:, ::-1], triangles + len(inner), triangles[:, ::-1] + len(inner) + len(points)]))
    made, tetrahedra = tetrahedralise(*both)
    assert fault_of(made, tetrahedra.astype(np.int64), *both) is None
    volume = np.linalg.det(made[tetrahedra[:, 1:]] - made[tetrahedra[:, :1]]).sum() / 6
    assert volume == pytest.approx(27 - 0.125 - 0.7 ** 3 / 6)


def test_bodies_side_by_side_are_refused():
    """One volume is not to have two outer shells; what gmsh makes of them is not passed on."""
    points, triangles = block(3, 3, 3, size=(3, 3, 3))
    both = np.vstack([points, points / 3 + 7]), np.vstack([triangles, triangles[:, ::-1] + len(points)])
    fault = _fault(both)
    assert fault.code is FaultCode.TOOL_FAILED and "could not be filled" in str(fault)


def test_bad_triangles():
    points, triangles = block(2, 2, 2)
    for bad, words in ((triangles[1:], "not closed"), (triangles[:, ::-1], "outward"), (triangles + 1, "whole numbers"),
                       (triangles.astype(float), "whole numbers"), (triangles[:0], "no triangles"),
                       (np.vstack([triangles, triangles[:1]]), "not closed")):
        fault = _fault((points, bad))
        assert fault.code is FaultCode.BAD_TRIANGLES and words in str(fault)
    for bad, words in ((np.vstack([points, [[9, 9, 9]]]), "no triangle"), (points * np.nan, "finite"),
                       (points[:, :2], "(P, 3)")):
        fault = _fault((bad, triangles))
        assert fault.code is FaultCode.BAD_TRIANGLES and words in str(fault)


def test_surface_that_crosses_itself(temporary):
    points, triangles = block(3, 3, 3)
    points = points.copy()
    inside = np.flatnonzero((np.abs(points - [1 / 3, 1 / 3, 1]) < 1e-9).all(axis=1))
    points[inside] = [0.4, 0.45, -0.5]      # a spike through the far side
    fault = _fault((points, triangles))
    assert fault.code is FaultCode.TOOL_FAILED and "Delaunay: " in str(fault) and "HXT: " in str(fault)


@pytest.mark.parametrize("options", ({"timeout": 0}, {"timeout": "long"}, {"coarsening": -1}, {"coarsening": None},
                                     {"coarsening": float("nan")}))
def test_bad_options(options):
    assert _fault(SURFACES["box of 12"], **options).code is FaultCode.BAD_OPTION


def test_time_limit(temporary):
    fault = _fault(SURFACES["ball"], timeout=0.01)
    assert fault.code is FaultCode.TOOL_TIMEOUT and "0.01" in str(fault)


class Stop(Exception):
    pass


def test_progress_and_cancel(temporary):
    stages = []
    tetrahedralise(*SURFACES["ball"], progress=lambda stage, fraction: stages.append((stage, fraction)))
    assert stages and all(0.0 <= f <= 1.0 for _, f in stages)
    assert list(dict.fromkeys(stage for stage, _ in stages))[-2:] == ["check", "relax"]

    def stop(stage, fraction):
        raise Stop
    with pytest.raises(Stop):
        tetrahedralise(*SURFACES["ball"], progress=stop)


def test_crash_of_one_algorithm_leaves_the_other(monkeypatch):
    """A run that died in one algorithm is started again without it."""
    real, runs = gmsh_process._run, []

    def run(python, job_path, folder, *rest):
        ended = real(python, job_path, folder, *rest)
        runs.append(ended)
        if len(runs) == 1:
            os.remove(os.path.join(folder, "result.npz"))
            return child.Ended(-11, "")
        return ended
    monkeypatch.setattr(gmsh_process, "_run", run)
    assert len(tetrahedralise(*SURFACES["ball"])[1])
    assert len(runs) == 2


def test_crash_is_survived(monkeypatch, tmp_path):
    script = tmp_path / "python-dies"
    script.write_text('#!/bin/sh\n[ "$1" = "-c" ] && exit 0\necho "Error   : out of luck"\nkill -SEGV $$\n',
                      encoding="ascii")
    script.chmod(0o755)
    monkeypatch.setenv("HEXCON_GMSH_PYTHON", str(script))
    fault = _fault(SURFACES["ball"])
    assert fault.code is FaultCode.TOOL_FAILED and "out of luck" in str(fault) and "signal 11" in str(fault)


def test_check_sees_every_fault():
    """Its own judge: what gmsh might do wrong is found."""
    points, triangles = SURFACES["ball"]
    made, tetrahedra = tetrahedralise(points, triangles)
    assert fault_of(made, tetrahedra, points, triangles) is None
    for bad_points, bad, words in ((made + 1e-16 + np.eye(len(made), 3) * 1e-9, tetrahedra, "moved"),
                                   (made, tetrahedra[1:], "boundary"), (made, tetrahedra[:, [1, 0, 2, 3]], "boundary"),
                                   (made, np.vstack([tetrahedra, tetrahedra[:1]]), "more than two"),
                                   (made, tetrahedra[:0], "no tetrahedra"), (made, tetrahedra + 1, "exist")):
        assert words in fault_of(bad_points, bad, points, triangles)
    moved = made.copy()
    moved[-1] += 10
    assert "inside out" in fault_of(moved, tetrahedra, points, triangles)


def test_positive_is_exact():
    """Where rounding would decide: four points nearly, or exactly, in a plane far from the origin."""
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.3, 0.3, 0]]) + 1e6
    assert not positive(points, np.array([[0, 1, 2, 3]])).any()
    points[3, 2] = np.nextafter(1e6, 2e6)
    assert positive(points, np.array([[0, 1, 2, 3], [0, 2, 1, 3]])).tolist() == [True, False]


def test_split_of_doubles():
    """Two tetrahedra on a common face have three outer faces each; an octahedron's four have two each."""
    pair = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1.0]])
    octahedron = np.array([[0, 0, -1], [0, 0, 1], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0.0]])
    around = np.array([[0, 1, 2, 3], [0, 1, 3, 4], [0, 1, 4, 5], [0, 1, 5, 2]])
    for points, tetrahedra, count in ((pair, np.array([[0, 1, 2, 3], [4, 2, 1, 3]]), 8), (octahedron, around, 8)):
        assert np.array_equal(split_doubles(points, tetrahedra)[1], tetrahedra)     # good ones stay
        points = points * [1, 1, 0.1]
        assert (diced_quality(points, tetrahedra) < GOOD).all()
        made, parts = split_doubles(points, tetrahedra)
        outer = _faces(parts)
        assert len(parts) == count and positive(made, parts).all() and len({k for k, _ in outer}) == len(outer)
        assert {frozenset(f) for _, f in outer} == {frozenset(f) for _, f in _faces(tetrahedra)}
