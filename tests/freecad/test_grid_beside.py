# SPDX-License-Identifier: LGPL-2.1-or-later
"""What sets the grid beside other meshers and elements (scripts/grid_beside) measures what it says."""
import pathlib
import sys

import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "scripts" / "grid_beside"), str(ROOT / "tests" / "python")]

import fit  # noqa: E402
import snappy  # noqa: E402
import static  # noqa: E402
import tetrahedra  # noqa: E402
from grid_bodies import tensor_grid  # noqa: E402
from quads_solids import Part  # noqa: E402

import hexcon_native as hn  # noqa: E402
from hexcon.femmesh.elements import Elements, elements_of  # noqa: E402

PLANES = [np.linspace(0, 8, 9), np.linspace(0, 1, 2), np.linspace(0, 1, 2)]


class Mesh:
    points, hexes = tensor_grid(*PLANES)


def facets(elements: Elements, x):
    return elements.quads[np.isclose(elements.points[elements.quads][:, :, 0], x).all(axis=1)]


@pytest.mark.parametrize("order, kind", [(1, "C3D8"), (2, "C3D20"), (2, "C3D20R")])
def test_a_pulled_bar(order, kind):
    """It grows by F L / (E A), a little less as the held face cannot shrink; twice the energy is F times that."""
    elements = elements_of(Mesh, order)
    model = static.Model(elements.points, elements.hexes, kind, facets(elements, 0), facets(elements, 8))
    compliance, stress = model.solved(np.array([100.0, 0, 0]))
    assert compliance == pytest.approx(100.0 ** 2 * 8 / static.YOUNG, rel=0.03)
    found, inside = model.at(np.array([[6.3, 0.4, 0.6], [6.3, 0.4, 1.2]]), stress)
    assert inside.tolist() == [True, False]
    assert found[0] == pytest.approx([100, 0, 0, 0, 0, 0], abs=0.5)


def test_areas_of_curved_triangles():
    """The shares of straight ones: none at corners, a third at each middle."""
    corners = np.array([[0, 0, 0], [2.0, 0, 0], [0, 3.0, 1]])
    points = np.vstack([corners, (corners + np.roll(corners, -1, axis=0)) / 2])
    area = np.linalg.norm(np.cross(corners[1], corners[2])) / 2
    shares = static._areas(points, np.arange(6)[None])
    assert shares == pytest.approx(np.array([[0, 0, 0, 1, 1, 1]]) * area / 3, abs=1e-12)


def test_inverted_tetrahedra_become_straight():
    corners = np.array([[0, 0, 0], [1.0, 0, 0], [0, 1, 0], [0, 0, 1]])
    points = np.vstack([corners, corners[tetrahedra.EDGES].mean(axis=1)])
    elements = np.arange(10)[None]
    assert tetrahedra.determinants(points, elements) == pytest.approx(np.ones((1, 14)))
    bent = points.copy()
    bent[4] += [0, 0, 0.05]
    mild = bent.copy()
    tetrahedra.straighten(mild, elements)
    assert np.array_equal(mild, bent)
    bent[4] += [0.3, 0, 0]
    tetrahedra.straighten(bent, elements)
    assert np.array_equal(bent, points)


def test_fit_of_a_box_and_of_one_that_is_turned():
    shape = Part.makeBox(8, 1, 1)
    points, hexes = Mesh.points, Mesh.hexes
    edges = np.array([(row[a], row[b]) for row in hexes for a, b in ((0, 1), (1, 2), (0, 3), (0, 4), (4, 5), (3, 7))])
    edges = np.vstack([edges, np.array([(row[a], row[b]) for row in hexes for a, b in ((3, 2), (7, 6), (1, 5), (2, 6),
                                                                                       (5, 6), (4, 7))])])
    assert fit.distances(shape, points).max() < 1e-9
    assert fit.share_of_edges(shape, points, edges, 1.0) == 1.0
    turned = points @ np.array([[1, 0, 0], [0, 0.8, -0.6], [0, 0.6, 0.8]])
    assert fit.distances(shape, turned).max() > 0.2
    assert fit.share_of_edges(shape, turned, edges, 1.0) == pytest.approx(8 / 40, abs=0.03)   # along the turned axis


@pytest.mark.skipif(not snappy.is_installed(), reason="OpenFOAM is not installed")
def test_snappy_on_a_box(tmp_path):
    found = snappy.snappy(Part.makeBox(8, 4, 4), 1.0, str(tmp_path))
    assert found["others"] == 0 and hn.quality(found["points"], found["hexes"]).min > 0
