# SPDX-License-Identifier: LGPL-2.1-or-later
"""The gallery: what the pictures show, by their pixels and by what is handed to the drawing program."""
import json
import pathlib
import sys
from types import SimpleNamespace

import numpy as np
import pytest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from hex_grids import block  # noqa: E402

import hexcon  # noqa: E402
import hexcon_native as hn  # noqa: E402
from hexcon import cli  # noqa: E402
from hexcon.errors import FaultCode, HexconError, ToolError  # noqa: E402
from hexcon.femmesh import elements_of  # noqa: E402
from hexcon.pictures import gallery, palette  # noqa: E402
from hexcon.quads.surface import edge_partners  # noqa: E402

NAMES = ("paired transition", "split layer 1", "split layer 2", "closure")


def pixels(path):
    from matplotlib.image import imread
    return imread(path)[:, :, :3]


def share(image, colour):
    """How much of an image is of a colour, in whatever light."""
    length = np.linalg.norm(image, axis=2)
    likeness = image @ colour / np.linalg.norm(colour) / np.maximum(length, 1e-9)
    return ((likeness > 0.9985) & (length > 0.2)).mean()


def panels(image, rows=1):
    """The halves, or rows of halves, without title and captions."""
    body = image[95:]
    tall = len(body) // rows
    return [part[:int(0.85 * tall)] for k in range(rows)
            for part in (body[k * tall:(k + 1) * tall, :500], body[k * tall:(k + 1) * tall, 500:])]


def nested(surface):
    """Four layers of one hex a quad, ever further in, as the stages of a mesh."""
    points = [scale * surface.points + (1 - scale) * surface.points.mean(axis=0) for scale in (1, 0.8, 0.6, 0.4, 0.2)]
    step = len(surface.points)
    hexes = [np.hstack([surface.quads + (k + 1) * step, surface.quads + k * step]) for k in range(4)]
    return SimpleNamespace(points=np.vstack(points), hexes=np.vstack(hexes), method="pyramid", topological=True,
                           report={"hexes": 4 * len(surface.quads), "hexes per quad": 4.0,
                                   **{f"hexes of {name}": float(len(surface.quads)) for name in NAMES}})


def cube(n):
    """(surface, mesh) of n * n * n hexes."""
    mesh = block(n, n, n)
    used, quads = np.unique(mesh.quads, return_inverse=True)
    return SimpleNamespace(points=mesh.points[used], quads=quads.reshape(-1, 4)), mesh


@pytest.fixture(scope="module")
def drawn(tmp_path_factory):
    """{file name: image} of Schneiders' pyramid and four layers under it."""
    surface = hexcon.example("schneiders")
    folder = tmp_path_factory.mktemp("pictures") / "new" / "folder"
    paths = gallery.stages(surface, nested(surface), folder, name="schneiders")
    assert sorted(path.name for path in folder.iterdir()) == [pathlib.Path(path).name for path in paths]
    return {pathlib.Path(path).stem: pixels(path) for path in paths}


def test_names_sizes_and_white_borders(drawn):
    assert list(drawn) == ["1-surface", "2-pairs", "3-stages", "4-paired-transition", "5-split-layer-1",
                           "6-split-layer-2", "7-closure"]
    for name, image in drawn.items():
        assert image.shape == (980 if name == "3-stages" else 640, 1000, 3)
        assert (image[:5] == 1).all() and (image[:, :5] == 1).all() and (image[:, -5:] == 1).all()
        assert 0.01 < (image[:95] < 0.5).any(axis=2).mean() < 0.2  # the title
        for panel in panels(image, 2 if name == "3-stages" else 1):
            assert 0.02 < (panel < 0.99).any(axis=2).mean() < 0.9


def test_loops_and_crossings_are_seen(drawn):
    for panel in panels(drawn["1-surface"]):
        assert share(panel, palette.LOOP_COLOURS[0]) > 0.005 and share(panel, palette.LOOP_COLOURS[1]) > 0.002
        assert share(panel, palette.LOOP_COLOURS[2]) == 0
        assert (panel.max(axis=2) < 0.12).sum() > 50    # dots; edges of quads are not so dark
    legend = drawn["1-surface"][-36:]
    assert share(legend, palette.LOOP_COLOURS[0]) > 0.005 and share(legend, palette.LOOP_COLOURS[1]) > 0.005


def test_pairs_are_seen(drawn):
    """Eight pairs, eight colours: each on one side at least."""
    shares = np.array([[share(panel, colour) for colour in palette.PAIR_COLOURS[:8]]
                       for panel in panels(drawn["2-pairs"])])
    assert (shares.max(axis=0) > 0.005).all()


def test_stages_are_seen_each_in_its_colour(drawn):
    for k, panel in enumerate(panels(drawn["3-stages"], rows=2)):
        shares = [share(panel, colour) for colour in palette.STAGE_COLOURS[:4]]
        assert shares[k] > 0.005 and sum(shares) == shares[k]
    for k, name in enumerate(("4-paired-transition", "5-split-layer-1", "6-split-layer-2", "7-closure")):
        whole, opened = (share(panel, palette.STAGE_COLOURS[k]) for panel in panels(drawn[name]))
        assert whole > opened > 0.05


def test_inner_hexes_show_in_their_stage(tmp_path):
    """The middle of a cube is a stage of its own: large in its picture, hidden by nothing in that of all."""
    surface, mesh = cube(4)
    depth = np.abs(mesh.points[mesh.hexes].mean(axis=1) - 0.5).max(axis=1)
    mesh.hexes = mesh.hexes[np.argsort(-depth, kind="stable")]
    mesh.report = {"hexes of split layer 1": 56.0, "hexes of split layer 2": 0.0, "hexes of closure": 8.0}
    paths = gallery.stages(surface, mesh, tmp_path)
    assert [pathlib.Path(path).name for path in paths[2:]] == ["3-stages.png", "4-split-layer-1.png", "5-closure.png"]
    image = pixels(paths[4])
    assert share(image, palette.STAGE_COLOURS[1]) > 0.2 and share(image, palette.STAGE_COLOURS[0]) == 0
    assert all(share(panel, colour) > 0.02 for panel, colour in zip(panels(pixels(paths[2])), palette.STAGE_COLOURS))


@pytest.mark.parametrize("order", [1, 2])
def test_a_mesh_without_stages_is_one(tmp_path, order):
    surface, mesh = cube(2)
    mesh.hexes, mesh.points = elements_of(mesh, order).hexes, elements_of(mesh, order).points
    mesh.report = {"hexes": 8, "hexes per quad": 1 / 3}
    paths = gallery.stages(surface, mesh, tmp_path)
    assert [pathlib.Path(path).name for path in paths] == ["1-surface.png", "2-pairs.png", "3-all-hexes.png"]
    assert share(pixels(paths[2]), palette.STAGE_COLOURS[0]) > 0.1
    assert (panels(pixels(paths[0]))[0].max(axis=2) < 0.12).sum() == 0  # no loop crosses itself


@pytest.fixture
def jobs(monkeypatch):
    """What would be drawn, by file name."""
    found = {}

    def draw(program, job, path):
        found[pathlib.Path(path).stem] = job
        pathlib.Path(path).touch()
    monkeypatch.setattr(gallery, "draw", draw)
    return found


@pytest.mark.parametrize("name", hexcon.example_names())
def test_loops_drawn_are_the_cores(jobs, tmp_path, name):
    surface = hexcon.example(name)
    gallery.stages(surface, None, tmp_path)
    job, report = jobs["1-surface"], hn.check_surface(surface.points, surface.quads)
    lengths = np.diff(job["0 tube_starts"]) - 1     # the first point again: closed
    assert sorted(lengths) == sorted(report.loops.lengths)
    assert len(job["0 ball_points"]) == report.loops.self_crossings.sum()
    for start, end in zip(job["0 tube_starts"], job["0 tube_starts"][1:]):
        assert np.array_equal(job["0 tube_points"][start], job["0 tube_points"][end - 1])
    assert list(jobs) == ["1-surface", "2-pairs"]


def test_a_pair_has_one_colour_and_its_neighbours_have_others(jobs, tmp_path):
    surface, _ = cube(6)
    gallery.stages(surface, None, tmp_path)
    pairs, colours = hn.pairing(surface.quads, surface.points), jobs["2-pairs"]["0 face_colours"]
    pair_of = np.zeros(len(surface.quads), int)
    pair_of[pairs] = np.arange(len(pairs))[:, None]
    for one, two in zip(np.arange(4 * len(pair_of)) // 4, edge_partners(surface.quads) // 4):
        assert (pair_of[one] == pair_of[two]) == np.array_equal(colours[one], colours[two])
    bars = jobs["2-pairs"]["0 tube_points"].reshape(-1, 3, 3)
    assert np.allclose(bars[:, 0], surface.points[surface.quads[pairs[:, 0]]].mean(axis=1))
    # on flat pairs of squares the middle of the bar is the middle of the common edge
    assert np.isclose(bars[:, 1], (bars[:, 0] + bars[:, 2]) / 2).all(axis=1).sum() > len(pairs) // 2


def test_many_loops_are_not_all_in_the_legend(jobs, tmp_path):
    gallery.stages(cube(6)[0], None, tmp_path)
    assert jobs["1-surface"]["legend"].tolist()[-1] == "and 13 more" and len(jobs["1-surface"]["legend"]) == 6


def test_faults(tmp_path, jobs):
    surface, mesh = cube(2)
    mesh.report = {"hexes of paired transition": 3.0, "hexes of closure": 4.0}
    with pytest.raises(ToolError, match="7 hexes in all, and the mesh 8") as raised:
        gallery.stages(surface, mesh, tmp_path / "a")
    assert raised.value.code is FaultCode.BAD_MESH
    (tmp_path / "file").write_text("no folder\n")
    with pytest.raises(ToolError, match="cannot make the folder") as raised:
        gallery.stages(surface, None, tmp_path / "file")
    assert raised.value.code is FaultCode.FILE_IO
    odd = SimpleNamespace(points=surface.points, quads=np.vstack([surface.quads[1:]]))
    with pytest.raises(HexconError):
        gallery.stages(odd, None, tmp_path / "b")
    assert not jobs and [path.name for path in tmp_path.iterdir()] == ["file"]


def test_command_line(capsys, tmp_path):
    for method, count in ((), 2), (("--method", "cells"), 6):  # and all stages, then each of three
        folder = tmp_path / str(count)
        assert cli.main(["example", "octahedron", "--gallery", str(folder), "--json", *method]) == 0
        told = json.loads(capsys.readouterr().out)
        assert told["pictures"] == sorted(map(str, folder.iterdir())) and len(told["pictures"]) == count
        assert told["written"] == []
