# SPDX-License-Identifier: LGPL-2.1-or-later
"""CGNS and Exodus II as other programs write them: read whole by VTK, or refused; not made by writers of HexCon."""
import cgns_files
import exodus_files
import numpy as np
import pytest
from deck_texts import HEXES, OUTER
from quad_figures import volume_of

from hexcon.errors import FaultCode, ToolError
from hexcon.files import read_mesh
from hexcon.quads import surface_from_file


@pytest.mark.parametrize("zones", (1, 2))
@pytest.mark.parametrize("name", cgns_files.HEX_SECTIONS)
def test_hexes_of_cgns(tmp_path, name, zones):
    cgns_files.write(tmp_path / "m.cgns", cgns_files.HEX_SECTIONS[name], zones)
    found = read_mesh(tmp_path / "m.cgns")
    assert len(found.hexes) == 8 * zones and np.isclose(volume_of(found.points, found.quads), 6000 * zones)


def test_structured_cgns(tmp_path):
    cgns_files.write_structured(tmp_path / "m.cgns")
    found = read_mesh(tmp_path / "m.cgns")
    assert len(found.hexes) == 8 and np.isclose(volume_of(found.points, found.quads), 6000)


def test_quads_of_cgns(tmp_path):
    cgns_files.write(tmp_path / "m.cgns", [(cgns_files.QUAD_4, OUTER[:5]), (cgns_files.QUAD_4, OUTER[5:])], dimension=2)
    surface = surface_from_file(tmp_path / "m.cgns")
    assert len(surface.quads) == 24 and np.isclose(volume_of(surface.points, surface.quads), 6000)


def test_exodus_of_others(tmp_path):
    """Two blocks, a side set and a node set; sides of a hex as the format numbers them: 5 is the bottom, 6 the top."""
    exodus_files.write(tmp_path / "m.exo", [("HEX8", HEXES[:3]), ("HEX", HEXES[3:])],
                       [("low", [1, 2, 3, 4], [5, 5, 5, 5]), ("top", [8], [6])], [("corner", [1])])
    found = read_mesh(tmp_path / "m.exo")
    assert len(found.hexes) == 8 and np.isclose(volume_of(found.points, found.quads), 6000)
    assert {name: len(rows) for name, rows in found.quad_groups.items()} == {"low": 4, "top": 1}
    assert (found.points[found.quads[found.quad_groups["low"]]][..., 2] == 0).all()
    assert found.points[found.node_groups["corner"]].tolist() == [[0, 0, 0]]


def test_quads_of_exodus(tmp_path):
    exodus_files.write(tmp_path / "m.e", [("SHELL4", OUTER[:10]), ("QUAD4", OUTER[10:])])
    surface = surface_from_file(tmp_path / "m.e")
    assert len(surface.quads) == 24 and np.isclose(volume_of(surface.points, surface.quads), 6000)


@pytest.mark.parametrize("name, make", (
    ("nodes.cgns", lambda path: cgns_files.write(path, [(cgns_files.NODE, np.arange(8)[:, None])])),
    ("empty.cgns", lambda path: cgns_files.write(path, [])), ("text.cgns", lambda path: path.write_text("CGNS")),
    ("tetra.exo", lambda path: exodus_files.write(path, [("HEX8", HEXES), ("TETRA", HEXES[:1, :4])])),
    ("text.exo", lambda path: path.write_text("CDF"))))
def test_refused(tmp_path, name, make):
    make(tmp_path / name)
    with pytest.raises(ToolError, match=name) as caught:
        read_mesh(tmp_path / name)
    assert caught.value.code is FaultCode.FILE_FORMAT


@pytest.mark.parametrize("ending, make", (("cgns", lambda path: cgns_files.write(path, [(cgns_files.HEXA_8, HEXES)])),
                                          ("exo", lambda path: exodus_files.write(path, [("HEX8", HEXES)]))))
def test_cut_short(tmp_path, ending, make):
    make(tmp_path / f"whole.{ending}")
    whole = (tmp_path / f"whole.{ending}").read_bytes()
    (tmp_path / f"m.{ending}").write_bytes(whole[:len(whole) * 3 // 4])
    with pytest.raises(ToolError, match=f"m.{ending}") as caught:
        read_mesh(tmp_path / f"m.{ending}")
    assert caught.value.code in (FaultCode.FILE_FORMAT, FaultCode.TOOL_TIMEOUT), caught.value
