# SPDX-License-Identifier: LGPL-2.1-or-later
"""How well quads fit their solid: against figures worked out by hand, and what is done where chords cut too much."""
import numpy as np
import pytest
from cell_surfaces import cad_file

import hexcon
from hexcon.errors import FaultCode, ToolError
from hexcon.quads import surface_from_solid
from hexcon.quads.fit import Fit, fit_of
from hexcon.quads.gmsh_worker.cad_fit import volume_and_area

BOX = "occ.addBox(0, 0, 0, 3, 2, 4)"
CYLINDER = "occ.addCylinder(0, 0, 0, 0, 0, 6, 3)"


def test_volume_and_area_of_quads():
    """A cube, and one with a corner moved: its three quads are bilinear patches."""
    p = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
    quads = np.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])
    assert volume_and_area(p[quads]) == pytest.approx((1.0, 6.0))
    assert volume_and_area((p + 5.0)[quads]) == pytest.approx((1.0, 6.0))
    p[7] += 0.3     # the trilinear map's volume: that of the cube and 3 * 0.3 / 4, + ..., by Gauss's rule below
    g = (1 + np.array([-1, 1]) / np.sqrt(3)) / 2
    volume = 0.0
    for u, v, w in np.array(np.meshgrid(g, g, g)).reshape(3, -1).T:
        a, b, c = np.array([1 - u, u]), np.array([1 - v, v]), np.array([1 - w, w])
        d, corners = np.array([-1.0, 1.0]), p.reshape(2, 2, 2, 3)
        jacobian = [np.einsum("k,j,i,kjin->n", *way, corners) for way in ((c, b, d), (c, d, a), (d, b, a))]
        volume += np.linalg.det(jacobian) / 8
    assert volume_and_area(p[quads])[0] == pytest.approx(volume)


def test_a_box_fits(tmp_path):
    mesh = hexcon.mesh_solid(cad_file(BOX, tmp_path / "solid.brep"), 1.0)
    fit = mesh.surface.fit
    assert (fit.cad_volume, fit.cad_area) == pytest.approx((24.0, 52.0))
    assert max(map(abs, (fit.volume, fit.area, fit.chord, fit.edge_chord))) < 1e-6
    assert fit.lost_faces == fit.lost_edges == () and mesh.report["fit"] == fit.as_dict()


def test_a_coarse_cylinder(tmp_path):
    """n quads round cut 1 - sin(a) / a of the volume, a being the angle of one, and leave the rim by a sagitta."""
    path = cad_file(CYLINDER, tmp_path / "solid.brep")
    surface = surface_from_solid(path, 2.0, "sweep")
    rim = np.unique(np.round(surface.points[np.hypot(*surface.points[:, :2].T) > 2.999], 6)[:, :2], axis=0)
    angle = 2 * np.pi / len(rim)
    assert surface.fit.volume == pytest.approx(np.sin(angle) / angle - 1, rel=1e-6)
    assert surface.fit.chord == pytest.approx(3 * (1 - np.cos(angle / 2)), rel=1e-6)
    assert surface.fit.edge_chord == pytest.approx(3 * (1 - np.cos(angle / 2)), rel=0.05)
    assert any("more than 1 %" in note for note in surface.notes)
    finer = surface_from_solid(path, 2.0, "sweep", volume_error=0.01)
    assert abs(finer.fit.volume) <= 0.011 and any("as chords cut" in note for note in finer.notes)
    with pytest.raises(ToolError, match="volume_error") as caught:
        surface_from_solid(path, 2.0, volume_error=-1.0)
    assert caught.value.code is FaultCode.BAD_OPTION


def test_a_grid_takes_more_quads_on_round_faces(tmp_path):
    path = cad_file(CYLINDER, tmp_path / "solid.brep")
    coarse, fine = (surface_from_solid(path, 3.0, "grid", volume_error=most) for most in (1.0, 0.01))
    assert abs(fine.fit.volume) < 0.9 * abs(coarse.fit.volume) and len(fine.quads) > len(coarse.quads)
    assert any("as chords cut" in note for note in fine.notes)


def test_what_is_lost_is_named():
    fit = Fit(1.0, 6.0, -0.031, 0.0, 0.1, 0.1, (3, 7), (2,))
    assert [note for note in fit.notes(0.01) if "Face3, Face7" in note or "Edge2" in note or "-3.1 %" in note] == \
        fit.notes(0.01) and len(fit.notes(0.01)) == 3 and len(fit.notes(0.05)) == 2
    found = {"fit": np.arange(6.0), "lost_faces": np.array([2]), "lost_edges": np.array([5])}
    assert fit_of(found, [4, 9]).lost_faces == (9,) and fit_of(found).lost_faces == (2,) and fit_of({}) is None
