# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids that are sound, though their files are not exact to the last digit."""
import numpy as np
import pytest
import sound_solids
from quads_solids import Part, Vector

import hexcon
from hexcon.errors import FaultCode, ToolError
from hexcon.quads import surface_from_solid


@pytest.mark.parametrize("cone, size", [(Part.makeCone(5, 0, 10), 2.0), (sound_solids.cone_askew(), 20.0)])
def test_cone_from_a_file(cone, size, tmp_path):
    surface = surface_from_solid(sound_solids.step_of(cone, tmp_path / "cone.step"), size)
    assert surface.method == "blocks" and set(surface.face_of_quad) == {1, 2}
    assert np.abs(surface.points - cone.Vertexes[0].Point).max(axis=1).min() < 1e-9


def test_corners_off_their_faces(tmp_path):
    """Points lie on the CAD's corners, wherever those are: a note says how far off."""
    path = sound_solids.with_corners_moved(sound_solids.notched_block(), tmp_path / "block.step", 5e-6)
    mesh = hexcon.mesh_solid(path, 6.0, surface_method="subdivided-triangles")
    assert mesh.certificate.certified
    assert any("edges and corners are up to 5e-06 off" in note for note in mesh.surface.notes)


def test_layers_with_corners_off_their_faces(tmp_path):
    """Points between two corners lie on the edge or the face, not on the line between the corners."""
    plate = Part.makeBox(12, 12, 15).cut(Part.makeCylinder(3, 20, Vector(6, 6, -1)))
    boss = plate.fuse(Part.makeBox(6, 12, 5, Vector(12, 0, 0))).removeSplitter()
    path = sound_solids.with_corners_moved(boss, tmp_path / "boss.step", 2e-7)
    surface = surface_from_solid(path, 4.0, "layered")
    assert surface.method == "layered" and np.unique(surface.face_of_quad).size == len(boss.Faces)


def test_corners_too_far_off(tmp_path):
    path = sound_solids.with_corners_moved(sound_solids.notched_block(), tmp_path / "block.step", 0.5)
    with pytest.raises(ToolError, match=r"more than 1/20 of the size: Edge1, ") as caught:
        surface_from_solid(path, 6.0)
    assert caught.value.code is FaultCode.OFF_CAD


def test_short_edge_is_a_point():
    """An edge a thousandth of the size: elements that stood on it would be needles."""
    shape = sound_solids.tip_with_short_edge()
    short = min(shape.Edges, key=lambda e: e.Length)
    assert short.Length < 0.0041
    mesh = hexcon.mesh_solid(shape, 3.0, surface_method="subdivided-triangles")
    assert mesh.certificate.certified and mesh.quality.min > 0.1
    ends = [np.abs(mesh.surface.points - v.Point).max(axis=1).min() for v in short.Vertexes]
    assert min(ends) < 1e-9 < 1e-3 < max(ends)
    number = next(k for k, e in enumerate(shape.Edges, 1) if e.isSame(short))
    assert any(f"taken as points: Edge{number} (0.004 long, at (20, 20, " in note for note in mesh.surface.notes)


def test_thin_wall_behind_a_curved_face(wall=0.2):
    """Triangles of the size asked for would reach through to the other side."""
    shape = Part.makeSphere(10).cut(Part.makeSphere(10 - wall))
    mesh = hexcon.mesh_solid(shape, 5.0, surface_method="subdivided-triangles")
    assert mesh.certificate.certified
    assert any("smaller where the solid is curved or narrow" in note for note in mesh.surface.notes)


def test_tip_of_a_pencil():
    """What its tip allows is good enough: the hexes at it share its solid angle."""
    shape = Part.makeCylinder(4, 40).fuse(Part.makeCone(4, 0, 20, Vector(0, 0, 40))).removeSplitter()
    mesh = hexcon.mesh_solid(shape, 3.0)
    assert mesh.certificate.certified and any("good enough" in line for line in mesh.report["log"])
    assert not any(line.startswith(("diced", "cells")) for line in mesh.report["log"])
