# SPDX-License-Identifier: LGPL-2.1-or-later
"""Method `blocks` on .brep files: no FreeCAD needed. tests/freecad/test_quads_blocks.py looks at points and faces."""
import numpy as np
import pytest
from blossom_surfaces import BODIES
from cell_surfaces import SOLIDS, cad_file

import hexcon_native as hn
from hexcon.errors import FaultCode, ToolError
from hexcon.quads import surface_from_solid

OF_BLOCKS = {name: BODIES[name] for name in ("box", "cylinder", "frustum", "hexagonal_prism", "triangular_prism",
                                             "ball", "half_ball", "lens", "cut_8")}
OF_BLOCKS.update({name: SOLIDS[name][0] for name in ("wedge", "quarter_cylinder", "skew_tetrahedron")})
OTHERS = {"hull_10": BODIES["hull_10"], "filleted": BODIES["filleted"],
          "chamfered": BODIES["chamfered"], "torus": "occ.addTorus(0, 0, 0, 2, 0.5)"}

OTHERWISE = {"chamfered": "sweep", "filleted": "layered", "torus": "revolved"}     # chamfered: from top to bottom


@pytest.mark.parametrize("name", OF_BLOCKS)
def test_no_loop_crosses_itself(tmp_path, name):
    surface = surface_from_solid(cad_file(OF_BLOCKS[name], tmp_path / "solid.brep"), 0.3, "blocks")
    report = hn.check_surface(surface.points, surface.quads)
    assert report.even and report.oriented and report.genus == 0
    assert not np.any(report.loops.self_crossings)
    valence = np.bincount(surface.quads.ravel())
    assert valence.min() == 3
    assert any(note.startswith("blocks: ") for note in surface.notes)


@pytest.mark.parametrize("name", OTHERS)
def test_others_are_refused(tmp_path, name):
    path = cad_file(OTHERS[name], tmp_path / "solid.brep")
    with pytest.raises(ToolError, match=r"Vertex\d+ has|Face\d+ has") as caught:
        surface_from_solid(path, 0.3, "blocks")
    assert caught.value.code is FaultCode.NOT_BLOCKS and caught.value.elements is not None
    assert surface_from_solid(path, 0.3, "auto").method == OTHERWISE.get(name, "grid")


def test_size_does_not_change_the_kind(tmp_path):
    """However coarse: the fewest quads are one block per corner with one hex each; a ball has four times six."""
    tetrahedron = cad_file(OF_BLOCKS["skew_tetrahedron"], tmp_path / "tetrahedron.brep")
    assert len(surface_from_solid(tetrahedron, 100.0, "blocks").quads) == 12
    ball = cad_file(OF_BLOCKS["ball"], tmp_path / "ball.brep")
    assert len(surface_from_solid(ball, 100.0, "blocks").quads) == 24
