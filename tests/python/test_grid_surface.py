# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surface method `grid` on .brep files: certified hexes that keep the solid's faces, edges and corners."""
import numpy as np
import pytest
from cell_surfaces import cad_file
from mesh_checker import enclosed, faults

import hexcon
from hexcon.errors import FaultCode, ToolError
from hexcon.quads import surface_from_solid

BOX = "occ.addBox(0, 0, 0, {}, {}, {})"
BLIND = "occ.cut([(3, occ.addBox(0, 0, 0, 6, 6, 4))], [(3, occ.addCylinder(3, 3, 1.5, 0, 0, 3, 1.5))])"
HOLLOW = "occ.cut([(3, occ.addSphere(0, 0, 0, 4))], [(3, occ.addSphere(0.4, 0, 0, 2))])"
TORUS = "occ.addTorus(0, 0, 0, 5, 2)"
WEB = ("occ.cut([(3, occ.addBox(0, 0, 0, 8, 6, 5))], [(3, occ.addBox(1, 1, 1, 6, 2, 4)), "
       "(3, occ.addBox(1, 4, 1, 6, 1, 4))])")

# name: (solid, size, faces, worst scaled Jacobian, mean, volume)
SOLIDS = {"box": (BOX.format(3, 2, 4), 1.0, 6, 0.999, 0.999, 24.0),
          "tray with a web": (WEB, 1.0, 16, 0.999, 0.999, 240 - 48 - 24.0),
          "blind hole": (BLIND, 1.0, 8, 0.35, 0.85, 144 - np.pi * 2.25 * 2.5),
          "hollow ball": (HOLLOW, 1.2, 2, 0.5, 0.75, 4 / 3 * np.pi * (64 - 8)),
          "torus": (TORUS, 1.3, 1, 0.5, 0.75, 2 * np.pi ** 2 * 5 * 4)}


@pytest.mark.parametrize("name", SOLIDS)
def test_solids(tmp_path, name):
    build, size, faces, worst, mean, volume = SOLIDS[name]
    mesh = hexcon.mesh_solid(cad_file(build, tmp_path / "solid.brep"), size, surface_method="grid",
                             volume_error=0.05)
    surface = mesh.surface
    assert mesh.certificate.certified and not faults(mesh.points, mesh.hexes, surface.quads, surface.points)
    assert (mesh.method, surface.method) == ("proposal", "grid")
    assert set(surface.face_of_quad) == set(range(1, faces + 1))
    assert mesh.quality.min > worst and mesh.quality.mean > mean
    assert abs(enclosed(surface) / volume - 1.0) < 0.05
    assert any(note.startswith("grid: ") for note in surface.notes)


def test_corners_and_edges_are_kept(tmp_path):
    """Of a box turned out of the axes, with a corner cut off: every edge is made of edges of the mesh."""
    build = ("occ.rotate(occ.cut([(3, occ.addBox(0, 0, 0, 4, 4, 4))], [(3, occ.addSphere(4, 4, 4, 2.5))])[0], "
             "0, 0, 0, 1, 2, 3, 0.7)")
    surface = surface_from_solid(cad_file(build, tmp_path / "solid.brep"), 1.0, "grid")
    ring = np.stack([surface.quads, np.roll(surface.quads, -1, axis=1)], -1).reshape(-1, 2)
    face = dict(zip(map(tuple, ring.tolist()), np.repeat(surface.face_of_quad, 4).tolist()))
    sharp = [(a, b) for (a, b), f in face.items() if a < b and face[b, a] != f]
    degree = np.bincount(np.array(sharp).ravel(), minlength=len(surface.points))
    assert (degree > 2).sum() == 10 and not (degree == 1).any()


def test_the_mesh_does_not_change(tmp_path):
    path = cad_file(BLIND, tmp_path / "solid.brep")
    one, other = (surface_from_solid(path, 1.5, "grid") for _ in range(2))
    assert np.array_equal(one.points, other.points) and np.array_equal(one.quads, other.quads)
    assert np.array_equal(one.hexes[1], other.hexes[1])


def test_a_wall_much_thinner_than_the_elements_is_refused(tmp_path):
    build = ("occ.cut([(3, occ.addCylinder(0, 0, 0, 3, 2, 1, 5))], [(3, occ.addCylinder(0, 0, 0, 3, 2, 1, 4.98))])")
    with pytest.raises(ToolError) as caught:
        surface_from_solid(cad_file(build, tmp_path / "solid.brep"), 3.0, "grid")
    assert caught.value.code is FaultCode.NOT_GRIDDED and "of the size" in str(caught.value)


def test_it_can_be_cancelled(tmp_path):
    class Stop(Exception):
        pass

    def progress(stage, fraction):
        assert 0.0 <= fraction <= 1.0
        if stage in ("cells", "slide"):
            raise Stop
    with pytest.raises(Stop):
        surface_from_solid(cad_file(BLIND, tmp_path / "solid.brep"), 0.5, "grid", progress=progress)


def test_no_grid_is_tried_again_at_a_smaller_size(tmp_path):
    """It tries parts of the size by itself: auto's next sizes are for the methods after it."""
    build = "occ.cut([(3, occ.addBox(0, 0, 0, 9, 9, 9))], [(3, occ.addSphere(4, 4, 4, 2))])"
    path = cad_file(build, tmp_path / "solid.brep")
    assert surface_from_solid(path, 1.5).method == "grid"
    assert surface_from_solid(path, 1.5, care=1).method == "subdivided-triangles"
    with pytest.raises(ToolError) as caught:
        surface_from_solid(path, 1.5, "grid", care=1)
    assert caught.value.code is FaultCode.NOT_GRIDDED
