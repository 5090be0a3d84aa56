# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surface method `boxed` on .brep files: features across layers in boxes of their own, all one certified mesh."""
import numpy as np
import pytest
from cell_surfaces import cad_file
from mesh_checker import enclosed, faults

import hexcon
from hexcon.errors import FaultCode, ToolError
from hexcon.inspection.stages import stages_of
from hexcon.quads import surface_from_solid
from hexcon.quads.gmsh_worker.boxed import whole
from hexcon.quads.gmsh_worker.boxed.box import intervals
from hexcon.quads.gmsh_worker.layered.fault import NotLayered

STEPPED = "occ.cut([(3, occ.addBox(0, 0, 0, 60, 30, 20))], [(3, occ.addBox(40, 0, 12, 20, 30, 8))])"
ELL = "occ.fuse([(3, occ.addBox(0, 0, 0, 40, 30, 8))], [(3, occ.addBox(0, 0, 0, 8, 30, 40))])"
FORK = ("occ.fuse([(3, occ.addBox(0, 0, 0, 40, 30, 8))], [(3, occ.addBox(0, 0, 0, 16, 6, 30)), "
        "(3, occ.addBox(0, 24, 0, 16, 6, 30))])")


def bore(x, z, radius, length=30.0, start=0.0):
    return f"(3, occ.addCylinder({x}, {start}, {z}, 0, {length}, 0, {radius}))"


def cut(body, *tools):
    return f"occ.cut({body}[0], [{', '.join(tools)}])"


# name: (solid, faces, direction, worst scaled Jacobian, mean, volume)
SOLIDS = {
    "counterbore and drill point": (
        cut(STEPPED, bore(20, 10, 5, 8), bore(20, 10, 3, 20), "(3, occ.addCone(20, 20, 10, 0, 1.8, 0, 3, 0))"), 12, "z",
        0.6, 0.9, 31200 - np.pi * (25 * 8 + 9 * (12 + 0.6))),
    "two in one box": (cut(STEPPED, bore(14, 10, 3), bore(22, 12, 2)), 10, None, 0.5, 0.85, 31200 - np.pi * 13 * 30),
    "boss": (f"occ.fuse({STEPPED}[0], [{bore(20, 10, 5, -12)}])", 10, "z", 0.6, 0.9, 31200 + np.pi * 25 * 12),
    "holes in both legs": (cut(ELL, "(3, occ.addCylinder(26, 15, 0, 0, 0, 8, 4))",
                               "(3, occ.addCylinder(0, 15, 26, 8, 0, 0, 4))"), 10, "z", 0.6, 0.9,
                           9600 + 7680 - 2 * np.pi * 16 * 8),
    "clevis": (cut(FORK, bore(8, 20, 4), "(3, occ.addCylinder(30, 15, 0, 0, 0, 8, 3))"), 15, None, 0.5, 0.85,
               9600 + 2 * 16 * 6 * 22 - np.pi * 16 * 12 - np.pi * 9 * 8),
    "pin": ("occ.cut([(3, occ.addCylinder(0, 0, 0, 0, 0, 40, 10))], [(3, occ.addCylinder(-20, 0, 20, 40, 0, 0, 3))])",
            4, "z", 0.4, 0.8, None)}


@pytest.mark.parametrize("name", SOLIDS)
def test_solids(tmp_path, name):
    build, faces, direction, worst, mean, exact = SOLIDS[name]
    mesh = hexcon.mesh_solid(cad_file(build, tmp_path / "solid.brep"), 4.0, surface_method="boxed")
    surface = mesh.surface
    assert mesh.method == "proposal" and mesh.certificate.certified
    assert not faults(mesh.points, mesh.hexes, surface.quads, surface.points)
    assert set(surface.face_of_quad) == set(range(1, faces + 1))
    assert mesh.quality.min > worst and mesh.quality.mean > mean
    assert exact is None or abs(enclosed(surface) / exact - 1.0) < 0.01
    assert any(note.startswith(f"boxed along {direction or ''}") and " 1 box" in note for note in surface.notes)
    (layers, _), (box, in_box) = stages_of(mesh)
    assert (layers, box) == ("layers round the boxes", "box 1")
    places = mesh.points[mesh.hexes]
    low, high = places[in_box].min(axis=(0, 1)), places[in_box].max(axis=(0, 1))
    others = np.delete(places.mean(axis=1), in_box, axis=0)
    assert ((others > low) & (others < high)).all(axis=1).mean() < 0.05     # the seam is bent a little


def test_auto_takes_boxes_before_the_grid(tmp_path):
    assert surface_from_solid(cad_file(SOLIDS["holes in both legs"][0], tmp_path / "solid.brep"), 4.0).method == "boxed"


@pytest.mark.parametrize("build, words", [
    (cut(STEPPED, bore(28, 10, 3), "(3, occ.addCylinder(0, 15, 10, 30, 0, 0, 3))"), "box"),     # meeting bores
    (cut(STEPPED, "(3, occ.addCylinder(5, 0, 3, 10, 30, 8, 3))"), "hangs over"),                # oblique
    ("[(3, occ.addBox(0, 0, 0, 4, 3, 2))]", "none lies across")])
def test_refusals(tmp_path, build, words):
    with pytest.raises(ToolError) as caught:
        surface_from_solid(cad_file(build, tmp_path / "solid.brep"), 4.0, "boxed", timeout=40)
    assert caught.value.code is FaultCode.NOT_BOXED and words in str(caught.value)


def test_lines_of_one_length_are_divided_alike():
    assert intervals(6.0, 4.0) == intervals(6.0 + 1e-12, 4.0) == intervals(6.0 - 1e-12, 4.0)
    assert [intervals(length, 1.0) for length in (0.1, 1.4, 1.6, 10.0)] == [1, 1, 2, 10]


def test_points_are_matched_one_to_one():
    """Shifted by more than half of their distance, and in another order."""
    others = np.array([[x, 0.0, z] for x in range(5) for z in range(4)])
    order = np.random.default_rng(3).permutation(len(others))
    assert (whole._matched(others[order], others, 1e-9) == order).all()
    assert (whole._matched(others[order] + [0.6, 0.0, 0.1], others, 1e-9) == order).all()
    with pytest.raises(NotLayered):
        whole._matched(others, others[1:], 1e-9)


def test_a_box_that_takes_all_of_the_solid_is_refused(tmp_path):
    """A square bar bored along."""
    bar = cut("([(3, occ.addBox(0, 0, 0, 30, 8, 8))],)", "(3, occ.addCylinder(0, 4, 4, 30, 0, 0, 3))")
    with pytest.raises(ToolError) as caught:
        surface_from_solid(cad_file(bar, tmp_path / "solid.brep"), 4.0, "boxed")
    assert caught.value.code is FaultCode.NOT_BOXED and "all of the solid" in str(caught.value)
