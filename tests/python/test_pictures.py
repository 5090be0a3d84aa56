# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rendered picture: drawn without a screen, not empty, nothing left on failure."""
import pathlib
import sys
from types import SimpleNamespace

import numpy as np
import pytest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from hex_grids import block, distorted  # noqa: E402

import hexcon_native as hn  # noqa: E402
from hexcon import pictures  # noqa: E402
from hexcon.errors import FaultCode, ToolError  # noqa: E402


def pixels(path):
    from matplotlib.image import imread
    return imread(path)[:, :, :3]


def test_mesh_and_displacement(tmp_path, monkeypatch):
    monkeypatch.delenv("DISPLAY", raising=False)
    mesh = distorted(block(6, 4, 4, (3.0, 2.0, 2.0)), 0.08)
    shift = np.zeros_like(mesh.points)
    shift[:, 2] = -0.01 * mesh.points[:, 0] ** 2
    path = tmp_path / "both.png"
    pictures.render(mesh, path, displacements=shift, title="A test")
    image = pixels(path)
    assert image.shape == (850, 1700, 3)
    assert (image[:5] == 1).all() and (image[:, :5] == 1).all()  # white, nothing clipped
    assert (image[-5:] == 1).all() and (image[:, -5:] == 1).all()
    left, right = image[150:650, :850], image[150:650, 850:]
    for half in (left, right):
        coloured = (half.max(axis=2) - half.min(axis=2)) > 0.1
        assert 0.05 < coloured.mean() < 0.9
    # viridis on the right reaches from violet to yellow; the left has neither
    assert (right[..., 0] > 0.6)[(right[..., 2] < 0.35)].any()
    assert not ((left[..., 0] < 0.25) & (left[..., 1] < 0.02)
                & (left[..., 2] > 0.25)).any()


def test_displacements_of_second_order_and_without_any(tmp_path):
    from hexcon.femmesh import elements_of
    mesh = block(2, 2, 2)
    second = elements_of(mesh, 2)
    for drawn in (mesh, second):
        pictures.render(drawn, tmp_path / "p.png", displacements=0.01 * second.points)
        assert pixels(tmp_path / "p.png").shape == (850, 1700, 3)
    pictures.render(mesh, tmp_path / "p.png", displacements=0 * mesh.points)
    pictures.render(mesh, tmp_path / "p.png", size=(400, 300))
    assert pixels(tmp_path / "p.png").shape == (300, 400, 3)


def test_curved_hexes_are_drawn_and_judged_as_they_are(tmp_path, monkeypatch):
    """A hex whose upper edges sag covers less of the picture; its figures are those that hn.quality has of it."""
    mesh = block(1, 1, 1)
    points, hexes = hn.raise_order(mesh.points, mesh.hexes)
    sagging = points.copy()
    sagging[hexes[0, 12:16], 2] -= 0.2
    covered, jobs = [], []
    for one in (points, sagging):
        pictures.render(SimpleNamespace(points=one, hexes=hexes), tmp_path / "p.png")
        covered.append((pixels(tmp_path / "p.png")[150:650].min(axis=2) < 0.95).sum())
    assert 0.8 * covered[0] < covered[1] < 0.97 * covered[0]
    monkeypatch.setattr(pictures, "draw", lambda program, job, *_: jobs.append(job))
    pictures.render(SimpleNamespace(points=sagging, hexes=hexes), tmp_path / "p.png")
    assert jobs[0]["quality"].tolist() == hn.quality(sagging, hexes).scaled_jacobian.tolist()
    assert jobs[0]["quality"][0] < 0.95 and hn.quality(sagging, hexes[:, :8]).min == 1.0


def test_cut_shows_inner_hexes(tmp_path):
    """The only bad hex lies inside: red shows with the cut and not without it."""
    mesh = block(4, 4, 4)
    centre = mesh.points[mesh.hexes].mean(axis=1)
    nodes = mesh.hexes[np.argmin(np.linalg.norm(centre - [0.375, 0.625, 0.375], axis=1))]
    mesh.points[nodes[6]] = mesh.points[nodes[[2, 5, 7]]].mean(axis=0) + 0.001

    def red(**options):
        pictures.render(mesh, tmp_path / "cut.png", **options)
        image = pixels(tmp_path / "cut.png")[150:650]
        return ((image[..., 0] > 0.5) & (image[..., 2] < 0.35)).sum()
    assert red(cut=None) == 0
    assert red() > 200
    assert red(cut=((0.5, 0.45, 0.5), (0, -1, 0))) > 200


def test_faults(tmp_path, monkeypatch):
    mesh = block(1, 1, 1)
    with pytest.raises(ToolError) as raised:
        pictures.render(mesh, tmp_path / "p.jpg")
    assert raised.value.code is FaultCode.FILE_FORMAT
    with pytest.raises(ToolError) as raised:
        pictures.render(mesh, tmp_path / "p.png", displacements=np.zeros((3, 3)))
    assert raised.value.code is FaultCode.BAD_OPTION
    with pytest.raises(ToolError) as raised:
        pictures.render(mesh, tmp_path / "no" / "p.png")
    assert raised.value.code is FaultCode.FILE_IO
    monkeypatch.setenv("HEXCON_PYTHON", "false")
    with pytest.raises(ToolError) as raised:
        pictures.render(mesh, tmp_path / "p.png")
    assert raised.value.code is FaultCode.TOOL_FAILED
    sleeper = tmp_path / "sleeper"
    sleeper.write_text("#!/bin/sh\nexec sleep 600\n")
    sleeper.chmod(0o755)
    monkeypatch.setenv("HEXCON_PYTHON", str(sleeper))
    with pytest.raises(ToolError) as raised:
        pictures.render(mesh, tmp_path / "p.png", timeout=0.5)
    assert raised.value.code is FaultCode.TOOL_TIMEOUT
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(ToolError, match="apt install xvfb") as raised:
        pictures.render(mesh, tmp_path / "p.png")
    assert raised.value.code is FaultCode.TOOL_MISSING
    assert [p.name for p in tmp_path.iterdir()] == ["sleeper"]
