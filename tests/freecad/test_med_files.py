# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces in .med files, as Salome and FreeCAD write them: quads with groups, in a file that is called otherwise."""
import pathlib
import shutil
import sys

import numpy as np
import pytest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "python"))
from deck_texts import GRID, OUTER  # noqa: E402
from quad_figures import volume_of  # noqa: E402

from hexcon.quads import surface_from_file  # noqa: E402


@pytest.mark.parametrize("name", ("Mesh_1.med", "another name.med"))
def test_quads_with_groups(freecad, tmp_path, name):
    from hexcon.freecad_compat import fem_module
    mesh = fem_module("Fem").FemMesh()
    for k, place in enumerate(GRID.tolist(), 1):
        mesh.addNode(*place, k)
    for k, quad in enumerate((OUTER + 1).tolist(), 1):
        mesh.addFace(quad, k)
    mesh.addGroupElements(mesh.addGroup("in let", "Face"), [1, 2, 3])
    mesh.addGroupElements(mesh.addGroup("corner", "Node"), [1])
    mesh.write(str(tmp_path / "Mesh_1.med"))
    if name != "Mesh_1.med":
        shutil.move(tmp_path / "Mesh_1.med", tmp_path / name)
    surface = surface_from_file(tmp_path / name)
    assert len(surface.quads) == 24 and np.isclose(volume_of(surface.points, surface.quads), 6000)
    assert {key: len(rows) for key, rows in surface.quad_groups.items()} == {"in let": 3}
    assert surface.points[surface.node_groups["corner"]].tolist() == [[0, 0, 0]]
