# SPDX-License-Identifier: LGPL-2.1-or-later
"""The template search (hexcon_native/tools): classes, fillings, other fillings, files."""
import argparse
import pathlib
import random
import shutil
import subprocess
import sys

import mesh_checker
import numpy as np
import pytest
import template_files

import hexcon_native as hn

CORE = pathlib.Path(hn.__file__).resolve().parent
sys.path.insert(0, str(CORE / "tools"))
import search_templates  # noqa: E402  (found by the line above)

pytestmark = pytest.mark.skipif(not (shutil.which("cmake") and shutil.which("ninja")),
                                reason="needs cmake and ninja")


@pytest.fixture(scope="module")
def tool(tmp_path_factory):
    """The search tool, built."""
    build = tmp_path_factory.mktemp("build")
    for command in (["cmake", "-S", CORE, "-B", build, "-G", "Ninja", "-DHEXCON_PYTHON=OFF"],
                    ["ninja", "-C", build, "hexcon_template_search"]):
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return build / "hexcon_template_search"


def target(name):
    return search_templates.Target(template_files.FOLDER / f"{name}.txt")


def topology_faults(goal, filling):
    """What certify and the independent checker say, Jacobians aside."""
    proof = hn.certify(filling.points, filling.hexes, goal.quads)
    wanted = ("conforming", "proper", "boundary_exact")
    found = [word for word in wanted if not getattr(proof, word)]
    hexes = filling.hexes.astype(np.int64)
    return (found + mesh_checker.boundary_faults(hexes, goal.quads)
            + mesh_checker.conformity_faults(hexes) + mesh_checker.improper_pairs(hexes))


def test_classes_of_quadrangulations(tool):
    """Three-connected quadrangulations by quads: 1, 0, 1, 1, 3, 11, 58, 451, 4461 for 6, 8 ...
    (OEIS A007022). The limit of quads cuts off ways to a few of the largest. Last, the most hexes that a class of so
    many quads takes, if hexes may meet in two faces."""
    lines = subprocess.run([tool, "classes", "20"], check=True, text=True,
                           stdout=subprocess.PIPE).stdout.splitlines()
    assert [tuple(map(int, line.split())) for line in lines] == [
        (6, 1, 1), (8, 1, 15), (10, 3, 17), (12, 11, 18), (14, 58, 25), (16, 450, 20), (18, 4440, 24), (20, 45908, 26)]


def test_fillings_are_proper(tool):
    """A known hard boundary, Eppstein's cube with 20 quads, from its boundary alone."""
    goal = target("halfcell_diced_41")
    found = search_templates.found_by_beam(tool, goal, quads=20, entries=50000, width=100, noise=0)
    assert min(map(len, found)) <= 47
    for hexes in found:
        filling = search_templates.realised(goal, hexes)
        assert not topology_faults(goal, filling)


def test_a_filling_found_realised_and_certified(tool):
    """From the boundary alone to a Geode as good as the one in resources/templates."""
    goal = target("geode_26")
    found = search_templates.found_by_beam(tool, goal, quads=20, entries=50000, width=100, noise=0)
    best = search_templates.realised(goal, min(found, key=len))
    assert best.count == 26 and best.score > 0.3
    assert hn.certify(best.points, best.hexes, goal.quads).certified
    assert not mesh_checker.faults(best.points, best.hexes, goal.quads, goal.points)


def test_refilled_parts_give_proper_meshes(tool):
    goal = target("halfcell_diced_41")
    old = search_templates.Filling(goal.all_points, goal.hexes)
    refiller = search_templates.Refiller(tool, goal, quads=18, entries=10000, alternatives=4)
    found = [refiller.ask(old, slack=6, most_hexes=60) for _ in range(10)]
    refiller.close()
    found = [answer for answer in found if answer]
    assert found and 0 not in {name for _, name in found}
    for hexes, name in found:
        new = search_templates.settled(goal, old, hexes, name, -1)
        assert new.count <= 47 and not topology_faults(goal, new)
        assert new.points[:len(goal.points)].tobytes() == goal.points.tobytes()


def test_a_search_writes_certified_templates(tool, tmp_path):
    options = argparse.Namespace(
        target=template_files.FOLDER / "geode_26.txt", start=[], scratch=True, output=tmp_path,
        seconds=1, beam_seconds=5, width=50, fillings=5, quads=18, entries=20000, alternatives=2,
        least_hexes=0, most_hexes=40, price=0.01, temperature=0.02, slide=False,
        polish=0, seed=1, tool=tool)
    archive = search_templates.search(options)
    written = sorted(tmp_path.iterdir())
    assert len(written) == len(archive.written) > 0
    for path in written:
        again = search_templates.Target(path)
        assert path.stem == f"geode_{len(again.hexes)}"
        assert hn.certify(again.all_points, again.hexes, again.quads).certified
        assert again.labels == target("geode_26").labels
        assert again.points.tobytes() == target("geode_26").points.tobytes()


def regular_sides(labels):
    """(black corner, white corner, point C, middle E, middle M) of each regular side."""
    for label in labels:
        half, name = label[:label[0] == "b"], label.removeprefix("b")
        if name[0] != "C":
            continue
        black, white = sorted(map(int, name[1:]), key=lambda corner: corner % 2)
        row = [f"{half}O{black}", f"{half}O{white}", label, f"{half}E{name[1:]}", f"{half}M{black}"]
        yield [word if word in labels else word[1:] for word in row]


def sides_seen(labels, points):
    """(sides, 3, 2): where C, E and M lie on each side, seen from its black corner."""
    place, found = dict(zip(labels, points)), []
    for black, white, *side in regular_sides(labels):
        along = place[white] - place[black]
        offsets = np.array([place[label] - place[black] for label in side])
        assert np.abs(np.cross(offsets, along)[:, 2]).max() < 1e-9
        found.append(np.column_stack([offsets @ along, offsets[:, 2]]))
    return np.array(found)


CELLS = [name for name in template_files.names() if name.startswith(("domino", "halfcell"))]


@pytest.mark.parametrize("name", CELLS)
def test_all_sides_are_alike_and_stay_so(name):
    goal = target(name)
    dice = random.Random(1)
    moved = goal.points + sum(dice.uniform(-0.1, 0.1) * way for way in goal.slides)
    before, after = sides_seen(goal.labels, goal.points), sides_seen(goal.labels, moved)
    for found in (before, after):
        assert len(found) == (6 if name.startswith("domino") else 3)
        assert np.ptp(found, axis=0).max() < 1e-9
    assert np.abs(after - before).max() > 0.01


def test_wrong_options_are_refused(tool):
    for words in ([], ["fill"], ["classes", "5"], ["fill", "missing.txt"],
                  ["fill", template_files.FOLDER / "geode_26.txt", "quads"],
                  ["fill", template_files.FOLDER / "geode_26.txt", "quads", "many"],
                  ["fill", template_files.FOLDER / "geode_26.txt", "quads", "99"],
                  ["fill", template_files.FOLDER / "geode_26.txt", "colour", "1"]):
        done = subprocess.run([tool, *words], capture_output=True, text=True)
        assert done.returncode == 1 and done.stderr.startswith("hexcon_template_search: ")
