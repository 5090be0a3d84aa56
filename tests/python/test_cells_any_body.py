# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cells in bodies that no point sees whole: notched, with holes, with cavities."""
import mesh_checker
import numpy as np
import pytest
from surfaces import box, permuted, picture, prism, upright
from test_paper_genus import torus

import hexcon
import hexcon_native as hn


def notched():
    return prism(picture("###", "#..", "###"), np.arange(2.0), upright)


def holed():
    return prism(picture("###", "#.#", "###"), np.arange(2.0), upright)


def thin_holed():
    points, quads = holed()
    return points * (1, 1, 0.25), quads


def hollow():
    """A cube of 24 quads around one of 6, which faces its inside."""
    (outer, around), (inner, inside) = box(2, 2, 2), box(1, 1, 1)
    return np.vstack([outer, 0.7 + 0.6 * inner]), np.vstack([around, len(outer) + inside[:, ::-1]])


BODIES = {"notch": (notched, 1), "hole": (holed, 0), "thin plate with a hole": (thin_holed, 0),
          "torus": (lambda: torus(6, 4), 0), "cavity": (hollow, 2)}


@pytest.mark.parametrize("name", BODIES)
def test_certified(name):
    """Each by the core, and by a judge that shares no code with it; euler is 1 - genus + cavities."""
    make, euler = BODIES[name]
    points, quads = permuted(make(), np.random.default_rng(8))
    assert hn.check_surface(points, quads).star_center is None
    mesh = hexcon.mesh_surface(points, quads, "cells", pillow="never")
    assert mesh.method == "cells" and mesh.certificate.certified and mesh.certificate.euler == euler
    assert mesh_checker.faults(mesh.points, mesh.hexes, mesh.quads, points) == []
    assert mesh_checker.euler(mesh.hexes) == euler
    assert {frozenset(quad) for quad in mesh.quads.tolist()} == {frozenset(quad) for quad in quads.tolist()}
    cells = 31 * len(quads) + mesh.report["layers"] * len(quads)
    assert len(mesh.hexes) == cells + 4 * mesh.report["tetrahedra"]
    assert mesh.quality.min > 0.02


def test_tetrahedra_are_needed():
    for make in (notched, holed, hollow):
        with pytest.raises(hn.HexconError) as fault:
            hn.mesh(*make(), "cells", pillow="never")
        assert fault.value.code == hn.ErrorCode.NOT_STAR_SHAPED and "tetrahedra" in str(fault.value)
    with pytest.raises(hn.HexconError) as fault:
        hn.mesh(*notched(), "cells", pillow="never", tetrahedralise=lambda points, triangles: None)
    assert fault.value.code == hn.ErrorCode.NOT_STAR_SHAPED and "no tetrahedra were found" in str(fault.value)


def test_colours_are_needed():
    """Five quads round the tube's inside are odd and bound nothing inside: a hex mesh exists, but none of cells."""
    points, quads = torus(5, 4)
    assert hn.check_surface(points, quads).fillable
    with pytest.raises(hn.HexconError) as fault:
        hexcon.mesh_surface(points, quads, "cells", pillow="never")
    assert fault.value.code == hn.ErrorCode.NOT_BIPARTITE and len(fault.value.elements) == 5
