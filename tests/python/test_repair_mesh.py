# SPDX-License-Identifier: LGPL-2.1-or-later
"""Repair of meshes of others: node orders, unused and doubled points, folded hexes; the boundary and its groups
stay."""
import json

import numpy as np
import pytest
from deck_texts import BOX, GRID, HEXES, elements, nodes
from quad_figures import volume_of

from hexcon.cli import main
from hexcon.errors import FaultCode, ToolError
from hexcon.files import read_mesh
from hexcon.judging.repair import REVERSED, repair_mesh, reversed_hexes

_SETS = "*SURFACE, NAME=Low\n1, S1\n2, S1\n*NSET, NSET=rim, GENERATE\n19, 21\n"


def turned(rows):
    hexes = HEXES.copy()
    hexes[rows] = hexes[rows][:, REVERSED]
    return hexes


def read(tmp_path, text):
    (tmp_path / "m.inp").write_text(text, encoding="ascii")
    return read_mesh(tmp_path / "m.inp")


@pytest.mark.parametrize("rows", (list(range(8)), [0], [3, 5], [0, 1, 2, 4, 6, 7]))
def test_reversed_hexes_are_found_and_turned(tmp_path, rows):
    found = read(tmp_path, nodes() + elements(turned(rows)))
    assert reversed_hexes(found.points, found.hexes).tolist() == rows
    done = repair_mesh(found)
    assert done.turned.tolist() == rows and f"{len(rows)} of 8 hexes" in done.notes[-1]
    assert np.isclose(volume_of(done.mesh.points, done.mesh.quads), 6000)
    outer = np.unique(done.mesh.quads)
    assert {tuple(p) for p in done.mesh.points[outer].tolist()} == {tuple(p) for p in np.delete(GRID, 13, 0).tolist()}


def test_groups_unused_and_doubled_points(tmp_path):
    """Two halves with a wall of doubled points between them; a point that nothing uses."""
    halves = np.vstack([GRID, GRID[9:18] + 1e-6, [[99.0, 0, 0]]])
    hexes = HEXES.copy()
    hexes[4:][hexes[4:] < 18] += 18
    found = read(tmp_path, nodes(halves) + elements(hexes) + _SETS)
    done = repair_mesh(found)
    assert len(done.mesh.points) == 36 and len(done.mesh.quads) == 32 and "1 points that no hex uses" in done.notes[0]
    done = repair_mesh(read(tmp_path, nodes(halves) + elements(hexes) + _SETS), merge_tolerance=1e-4)
    assert len(done.mesh.points) == 27 and len(done.mesh.quads) == 24 and "9 points merged" in done.notes[0]
    assert len(done.mesh.quad_groups["Low"]) == 2 and len(done.mesh.node_groups["rim"]) == 3
    assert (done.mesh.points[done.mesh.quads[done.mesh.quad_groups["Low"]]][..., 2] == 0).all()
    with pytest.raises(ToolError, match="merge corners of 8 hexes") as caught:
        repair_mesh(found, merge_tolerance=6.0)
    assert caught.value.code is FaultCode.BAD_OPTION


def test_the_command_tells_before_and_after(tmp_path, capsys):
    """A point inside out of place, and all in reversed order."""
    places = GRID.copy()
    places[13] = (9.5, 25, 31)
    (tmp_path / "m.inp").write_text(nodes(places) + elements(turned(list(range(8)))) + _SETS, encoding="ascii")
    assert main(["check", str(tmp_path / "m.inp")]) == 3
    assert "hexes are inverted: their node order is reversed; `hexcon repair` turns them" in capsys.readouterr().out
    assert main(["repair", str(tmp_path / "m.inp"), "-o", str(tmp_path / "good.vtk"), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["certified"] and not told["before"]["certified"] and told["turned"] == 8
    good = read_mesh(tmp_path / "good.vtk")
    assert np.isclose(volume_of(good.points, good.quads), 6000) and set(good.quad_groups) == {"Low"}
    assert main(["solve", str(tmp_path / "good.vtk"), "--fixed", "low", "--force", "rim=0,0,9"]) == 0


def test_info_and_check_tell_groups_units_and_elements(tmp_path, capsys):
    (tmp_path / "m.inp").write_text(BOX + _SETS + "*ELEMENT, TYPE=T3D2\n99, 1, 2\n", encoding="ascii")
    assert main(["check", str(tmp_path / "m.inp"), "--scale", "1e-3", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["elements_in_file"] == {"C3D8": 8, "T3D2": 1} and any("--unit m" in note for note in told["notes"])
    assert told["groups"] == {"rim": {"nodes": 3}, "Low": {"quads": 2}}
    assert main(["check", str(tmp_path / "m.inp")]) == 0
    said = capsys.readouterr().out
    assert "8 C3D8, 1 T3D2: 8 of 9 elements are hexes, and judged" in said and "Low (2 quads)" in said
