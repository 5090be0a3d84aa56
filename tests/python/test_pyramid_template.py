# SPDX-License-Identifier: LGPL-2.1-or-later
"""The template of the four-split pyramid: consistent, symmetric, and matching itself across its sides."""
import numpy as np
import pytest
from mesh_checker import boundary_faults, conformity_faults, euler, jacobians
from paper_meshes import GAUSS
from template_files import load_template

import hexcon_native as hn


@pytest.fixture(scope="module")
def pyramid():
    return load_template("topological/pyramid_16")


def test_labels(pyramid):
    """Those of the boundary are unique and lie where they say; the others are inside."""
    base = {"B0": (0, 0), "B1": (1, 0), "B2": (1, 1), "B3": (0, 1), "EB0": (0.5, 0), "EB1": (1, 0.5), "EB2": (0.5, 1),
            "EB3": (0, 0.5), "Bc": (0.5, 0.5)}
    places = dict(zip(pyramid.labels[:pyramid.boundary_count], pyramid.points.tolist()))
    assert len(places) == 14 and set(places) == {*base, "F0", "F1", "F2", "F3", "A"}
    assert places["A"] == [0.5, 0.5, 1]
    for label, place in base.items():
        assert places[label] == [*place, 0]
    for k in range(4):
        assert places[f"F{k}"] == ((np.array(places[f"EB{k}"]) + places["A"]) / 2).tolist()
    # In the cone over the base: towards the apex, everything comes nearer to the axis.
    inside = pyramid.points[pyramid.boundary_count:]
    assert (np.abs(inside[:, :2] - 0.5).max(axis=1) < 0.5 * (1 - inside[:, 2])).all()


def test_every_face_is_met_once_from_each_side(pyramid):
    assert len(pyramid.hexes) == 16 and len(pyramid.quads) == 12
    assert boundary_faults(pyramid.hexes, pyramid.quads) == [] and conformity_faults(pyramid.hexes) == []
    assert euler(pyramid.hexes) == 1 and len(np.unique(pyramid.hexes)) == len(pyramid.points)


def test_volumes(pyramid):
    """All positive; and yet no mesh for solvers, as sides have a quad with three corners on one line."""
    volumes = jacobians(pyramid.points[pyramid.hexes], GAUSS).mean(axis=1)
    assert volumes.min() > 1e-3 and np.isclose(volumes.sum(), 1 / 3)
    proved = hn.certify(pyramid.points, pyramid.hexes, pyramid.quads)
    assert proved.conforming and proved.boundary_exact and not proved.certified


@pytest.mark.parametrize("mirror", ((1, 0), (0, 1), (1, 1)))
def test_symmetry(pyramid, mirror):
    """Two mirror planes through the axis, and so a half turn."""
    places = pyramid.points.copy()
    for axis, turned in enumerate(mirror):
        if turned:
            places[:, axis] = 1 - places[:, axis]
    number = {tuple(place): k for k, place in enumerate(pyramid.points.round(9).tolist())}
    image = np.array([number[tuple(place)] for place in places.round(9).tolist()])
    assert {frozenset(row) for row in image[pyramid.hexes].tolist()} == {frozenset(row) for row in
                                                                         pyramid.hexes.tolist()}


def test_sides_match(pyramid):
    """Each of two quads about the side's middle, alike seen from both ends: whatever meets it there is its mirror
    image."""
    number = {label: k for k, label in enumerate(pyramid.labels[:pyramid.boundary_count])}
    quads = {frozenset(quad) for quad in pyramid.quads.tolist()}
    for k in range(4):
        for corner in (f"B{k}", f"B{(k + 1) % 4}"):
            assert frozenset(number[label] for label in (corner, f"EB{k}", f"F{k}", "A")) in quads
