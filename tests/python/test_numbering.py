# SPDX-License-Identifier: LGPL-2.1-or-later
"""One verdict, and one mesh, however a surface is numbered."""
import numpy as np
import pytest
from polyhedra import random_polyhedron
from surfaces import annulus, box, canonical, grid, o_grid, permuted, prism, schneiders_pyramid, upright

import hexcon
import hexcon_native as hn

Code = hn.ErrorCode


def example(name):
    surface = hexcon.example(name)
    return surface.points, surface.quads


def polyhedron(seed, count):
    return random_polyhedron(np.random.default_rng(seed), count, 1.0)


CORNER = np.ones((4, 4), bool)
CORNER[2:, 2:] = False
SURFACES = {"box": box(2, 3, 2),                           # symmetric: only its coordinates tell points apart
            "l-shape": prism(grid(4, 4, keep=CORNER), np.arange(4.0), upright),
            "cylinder": prism(o_grid(2, 1), np.arange(3.0), upright),
            "schneiders": schneiders_pyramid(),
            **{f"eppstein-{n}": example(f"eppstein-{n}") for n in (16, 18, 20, 22)},
            "polyhedron 12": polyhedron(1, 12),
            "polyhedron 20": polyhedron(2, 20)}
QUICK = ("auto", "swept", "sheets", "diced", "smallest", "shelling", "four-split", "pyramid", "geode-alt", "pillowed")


def places(points, rows):
    """What rows of points are, wherever they are numbered: sorted bytes of the points of each, from the lowest on."""
    return sorted(b"".join(sorted(points[v].tobytes() for v in row)) for row in rows)


def outcome(points, quads, method):
    """Of one call: the fault, or the mesh, in terms that no numbering has a part in."""
    try:
        mesh = hn.mesh(points, quads, method)
    except hn.HexconError as fault:
        if fault.code in (Code.NOT_CERTIFIED, Code.NOT_BIPARTITE, Code.NO_SIDES):
            return fault.code, len(fault.elements)
        return fault.code, places(points, quads[fault.elements])
    assert mesh.points[:len(points)].tobytes() == points.tobytes() and mesh.quads[:len(quads)].tolist() == quads.tolist()
    return mesh.method, mesh.certificate.certified, mesh.quality.min, places(mesh.points, mesh.hexes)


@pytest.mark.parametrize("method", QUICK)
@pytest.mark.parametrize("name", SURFACES)
def test_any_numbering(name, method):
    points, quads = SURFACES[name]
    first = outcome(points, quads, method)
    for seed in range(2):
        assert outcome(*permuted((points, quads), np.random.default_rng(seed)), method) == first


def test_any_numbering_of_cells():
    surface = polyhedron(1, 8)
    first = outcome(*surface, "cells")
    assert first == outcome(*permuted(surface, np.random.default_rng(3)), "cells")


def test_the_order_is_the_documented_one():
    """Of a surface numbered so already, hexes have the ids in which they were made."""
    points, quads = canonical(box(2, 2, 1))
    layers = hn.mesh(points, quads, "four-split", pairing="none")
    assert canonical((points, quads))[1].tolist() == quads.tolist()
    again = hn.mesh(*permuted((points, quads), np.random.default_rng(1)), "four-split", pairing="none")
    assert again.points[len(points):].tobytes() == layers.points[len(points):].tobytes()


def test_given_pairs_and_faults_are_the_callers():
    points, quads = permuted(box(2, 2, 2), np.random.default_rng(4))
    pairs = hn.pairing(quads)
    assert len(hn.mesh(points, quads, "pyramid", pairing=pairs).hexes) == 76 * len(quads)
    wrong = pairs.copy()
    wrong[3] = wrong[5]
    with pytest.raises(hn.HexconError) as fault:
        hn.mesh(points, quads, "pyramid", pairing=wrong)
    assert fault.value.code == Code.BAD_PAIRING and fault.value.elements == wrong[5].tolist()
    with pytest.raises(hn.HexconError) as fault:
        hn.mesh(points, quads, "pyramid", pairing=[[0, 10 ** 6]])
    assert fault.value.code == Code.BAD_PAIRING and fault.value.elements == [0, 10 ** 6]


def test_odd_paths_are_the_callers():
    """Round the hole of a ring of 5 quads: each step is an edge, and there are an odd number."""
    points, quads = permuted(prism(annulus(5, 2), np.arange(3.0), upright), np.random.default_rng(7))
    with pytest.raises(hn.HexconError) as fault:
        hn.mesh(points, quads, "cells", tetrahedralise=lambda points, triangles: None)
    path = fault.value.elements
    edges = {frozenset(edge) for k in range(4) for edge in zip(quads[:, k], quads[:, (k + 1) % 4])}
    assert fault.value.code == Code.NOT_BIPARTITE and len(path) % 2
    assert all(frozenset(step) in edges for step in zip(path, np.roll(path, 1)))


def test_words_name_the_callers_quads():
    points, quads = prism(grid(2, 2), np.arange(3.0), upright)
    points = points.copy()
    top = np.flatnonzero(np.isclose(points, [0, 0, 2]).all(axis=1))[0]
    inside = np.flatnonzero(np.isclose(points, [1, 1, 2]).all(axis=1))[0]
    points[top] = points[inside] - [0.4, 0.4, 0]           # a corner of its quad is reflex now
    surface = permuted((points, quads), np.random.default_rng(2))
    with pytest.raises(hn.HexconError) as fault:
        hn.mesh(*surface, "cells")
    assert fault.value.code == Code.UNFILLABLE_QUAD and fault.value.elements == sorted(fault.value.elements)
    assert all(f"quad {q}:" in str(fault.value) for q in fault.value.elements[:4])


def test_points_that_coincide():
    """They tie: nothing is promised but a mesh of the same kind."""
    points, quads = box(1, 1, 2)
    flat = np.zeros_like(points)
    mesh = hn.mesh(flat, quads, "pyramid", allow_topological=True)
    assert len(mesh.hexes) == 76 * len(quads) and mesh.certificate.conforming
    assert len(hn.mesh(-flat, quads, "pyramid", allow_topological=True).hexes) == len(mesh.hexes)


def test_second_order():
    points, quads = SURFACES["l-shape"]
    mesh = hn.mesh(*permuted((points, quads), np.random.default_rng(5)), order=2)
    plain = hn.mesh(points, quads, order=2)
    assert places(mesh.points, mesh.hexes) == places(plain.points, plain.hexes) and mesh.certificate.certified
