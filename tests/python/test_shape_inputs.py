# SPDX-License-Identifier: LGPL-2.1-or-later
"""The inputs on which untangling and optimisation are measured are what they say they are."""
import numpy as np
import pytest
from cell_meshes import build_cells, flat_pairing
from cell_surfaces import cad_surface, plain_surfaces
from deformed_boxes import BINS, corner_rows, deformed_cells, image, measure
from mesh_checker import euler, faults, nonpositive
from scrambled import boundary_quads, on_boundary, scramble, swept_meshes
from template_files import load_template, names

import hexcon_native as hn

SURFACES = {name: (points, quads) for name, points, quads in plain_surfaces()}
FITTED = ("domino_62", "halfcell_diced_41", "halfcell_2x2_46", "geode_26", "schneiders_pyramid_36")


@pytest.mark.parametrize("name", names())
def test_template(name):
    """Certified, its boundary first."""
    template = load_template(name)
    surface = template.points[template.fixed]
    assert faults(template.points, template.hexes, template.quads, surface) == []
    assert euler(template.hexes) == 1
    assert np.array_equal(np.unique(template.quads), np.arange(template.boundary_count))
    assert len(set(template.labels[:template.boundary_count])) == template.boundary_count


@pytest.mark.parametrize("name", FITTED)
def test_deformed_cells(name):
    """Start valid, bins equally full; undeformed corners give the template back."""
    template = load_template(name)
    corners = template.points[corner_rows(template)]
    assert np.allclose(image(template, corners), template.points, atol=1e-14)
    assert measure(corners) == pytest.approx(1)
    cells = list(deformed_cells(name, 16, seed=5))
    for start, target, value in cells:
        assert not len(nonpositive(start, template.hexes))
        assert measure(target[corner_rows(template)]) == value
    assert (np.histogram([value for *_, value in cells], BINS)[0] == 2).all()
    again = list(deformed_cells(name, 1, seed=5))[0]
    assert again[1].tobytes() == cells[0][1].tobytes()


@pytest.mark.parametrize("kind, count", [("domino", 39), ("halfcell", 49)])
@pytest.mark.parametrize("name", ["sphere_2", "zonohedron_4", "merged_hull_10", "shaken_2"])
def test_cells(name, kind, count):
    """Right in all but shape."""
    points, quads = SURFACES[name]
    placed, hexes, fixed = build_cells(points, quads, kind)
    assert len(hexes) == count * len(quads) and euler(hexes) == 1
    assert np.array_equal(np.flatnonzero(fixed), np.arange(len(points)))
    wrong = faults(placed, hexes, quads, points)
    assert [fault for fault in wrong if "positive" not in fault] == []
    # Wrong way round nearly all would be negative.
    assert len(nonpositive(placed, hexes)) < 0.1 * len(hexes)


@pytest.mark.parametrize("name", SURFACES)
def test_plain_surfaces(name):
    """Closed, even, outward; every quad in one pair."""
    points, quads = SURFACES[name]
    report = hn.check_surface(points, quads)
    assert report.even and report.bipartite and report.oriented and report.genus == 0
    assert report.star_margin > 0
    pairs = flat_pairing(points, quads)[:, :2]
    assert np.array_equal(np.sort(pairs.ravel()), np.arange(len(quads)))


def test_cad_surface(tmp_path):
    report = hn.check_surface(*cad_surface("ball", tmp_path))
    assert report.even and report.oriented and report.bipartite


@pytest.mark.parametrize("name, mesh", swept_meshes(700))
def test_swept_and_scrambled(name, mesh):
    """Certified as made; scrambling moves free points alone, as far as told."""
    points, hexes, fixed = mesh
    assert faults(points, hexes, boundary_quads(hexes), points) == []
    assert np.array_equal(fixed, on_boundary(hexes)) and 300 < len(hexes) < 1500, name
    moved = scramble(points, hexes, fixed, 0.5, seed=2)
    assert moved[fixed].tobytes() == points[fixed].tobytes()
    assert (moved[~fixed] != points[~fixed]).any(axis=1).all()
    assert moved.tobytes() == scramble(points, hexes, fixed, 0.5, seed=2).tobytes()
    assert len(nonpositive(scramble(points, hexes, fixed, 1.0, seed=2), hexes)) > len(hexes) / 3
