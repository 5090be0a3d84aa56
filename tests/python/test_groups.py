# SPDX-License-Identifier: LGPL-2.1-or-later
"""Named groups of a given surface stay on the hex mesh, in every writer, by readers of other people, and carry
loads."""
import pathlib
import sys

import gmsh
import meshio
import numpy as np
import pytest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from deck_texts import GRID, OUTER, SHELL
from hex_grids import block
from quad_figures import volume_of

from hexcon import files
from hexcon.calculix import solve_inp, static_deck
from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh import elements_of
from hexcon.files import abaqus
from hexcon.meshing import mesh_quad_surface
from hexcon.quads import surface_from_file

LOW = np.flatnonzero((GRID[OUTER][..., 2] == 0).all(axis=1))
TOP = np.flatnonzero((GRID[OUTER][..., 2] == 30).all(axis=1))
SIDE = np.flatnonzero((GRID[OUTER][..., 0] == 10).all(axis=1))
ENDINGS = ("inp", "msh", "vtu", "vtk", "unv", "med", "exo", "FCStd")


@pytest.fixture
def mesh(tmp_path):
    """Hexes of a shell whose sets overlap: "hold" (low), "load" (top and a side), "rim" (nodes)."""
    def of(rows):
        return ", ".join(str(row + 1) for row in rows)
    sets = (f"*ELSET, ELSET=hold\n{of(LOW)}\n*ELSET, ELSET=load\n{of(TOP)},\n{of(SIDE)}\n*ELSET, ELSET=top "
            f"only\n{of(TOP)}\n"
            "*NSET, NSET=rim, GENERATE\n19, 21, 1\n")
    (tmp_path / "given.inp").write_text(SHELL + sets, encoding="ascii")
    return mesh_quad_surface(surface_from_file(tmp_path / "given.inp"))


def places(mesh, rows):
    """The places of quads, whatever their numbering: sets of corners."""
    return {frozenset(map(tuple, mesh.points[quad[:4]].round(9).tolist())) for quad in mesh.quads[rows]}


@pytest.mark.parametrize("order", (1, 2))
@pytest.mark.parametrize("ending", ENDINGS)
def test_groups_come_back(tmp_path, mesh, ending, order):
    files.write(mesh, tmp_path / f"m.{ending}", order=order)
    back = files.read_mesh(tmp_path / f"m.{ending}")
    wanted = {"hold": LOW, "load": np.union1d(TOP, SIDE), "top only": TOP}
    if ending == "inp":
        wanted["top_only"] = wanted.pop("top only")     # a name in a deck has no blank
    found = {name: places(back, rows) for name, rows in back.quad_groups.items() if name != "Boundary"}
    assert found == {name: places(mesh, rows) for name, rows in wanted.items()}
    rim = {tuple(place) for place in back.points[back.node_groups["rim"]].round(9).tolist()}
    corners = {(0.0, 0.0, 30.0), (5.0, 0.0, 30.0), (10.0, 0.0, 30.0)}
    assert corners <= rim and len(rim) == (3 if order == 1 else 5)
    assert back.order == order and np.isclose(volume_of(back.points, back.quads), 6000)


def test_gmsh_and_meshio_see_the_groups(tmp_path, mesh):
    files.write(mesh, tmp_path / "m.msh")
    gmsh.initialize(readConfigFiles=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.open(str(tmp_path / "m.msh"))
        names = {gmsh.model.getPhysicalName(d, n): (d, n) for d, n in gmsh.model.getPhysicalGroups()}
        assert set(names) == {"hold", "load", "top only", "rim", "Boundary", "Solid"}
        assert len(gmsh.model.mesh.getNodesForPhysicalGroup(*names["hold"])[0]) == 9
        assert len(gmsh.model.mesh.getNodesForPhysicalGroup(*names["load"])[0]) == 15
    finally:
        gmsh.finalize()
    files.write(mesh, tmp_path / "m.vtk")
    sides = meshio.read(tmp_path / "m.vtk").cell_data["load"][0]
    assert sides.shape == (8, 6) and sides.sum() == 8


@pytest.mark.parametrize("ending", ("vtk", "vtu"))
def test_gmsh_and_meshio_open_what_is_written(tmp_path, mesh, ending):
    """Gmsh wants the points first; its cells and places are ours."""
    files.write(mesh, tmp_path / f"m.{ending}")
    read = meshio.read(tmp_path / f"m.{ending}")
    assert np.array_equal(read.points, mesh.points) and np.array_equal(read.cells_dict["hexahedron"], mesh.hexes)
    if ending == "vtk":
        gmsh.initialize(readConfigFiles=False)
        try:
            gmsh.option.setNumber("General.Terminal", 0)
            if not _gmsh_opens_its_own(tmp_path / "own.vtk"):
                pytest.skip(f"gmsh {gmsh.GMSH_API_VERSION} opens no binary .vtk, its own neither")
            gmsh.open(str(tmp_path / "m.vtk"))
            kinds, ids, _ = gmsh.model.mesh.getElements(3)
            assert kinds.tolist() == [5] and len(ids[0]) == 8
        finally:
            gmsh.finalize()


def _gmsh_opens_its_own(path):
    """Whether gmsh opens the binary file of a box that it has written; 4.15 reads the line's end as a first byte."""
    gmsh.model.occ.addBox(0, 0, 0, 1, 1, 1)
    gmsh.model.occ.synchronize()
    gmsh.model.mesh.generate(3)
    gmsh.option.setNumber("Mesh.Binary", 1)
    gmsh.write(str(path))
    gmsh.clear()
    try:
        gmsh.open(str(path))
    except Exception:
        return False
    finally:
        gmsh.clear()
    return True


def test_groups_carry_loads(tmp_path, mesh):
    """Stretched from face to face, held and pulled by name: as the bar of the same faces by number."""
    files.write(mesh, tmp_path / "m.unv")
    back = files.read_mesh(tmp_path / "m.unv")
    found = solve_inp(static_deck(back, fixed=["HOLD"], force={"top only": (0.0, 0.0, 200.0)}))
    numbered = files.read_mesh(tmp_path / "m.unv")
    numbered.face_of_quad[numbered.quad_groups["hold"]], numbered.face_of_quad[numbered.quad_groups["top only"]] = 1, 2
    numbered.quad_groups = {}
    right = solve_inp(static_deck(numbered, fixed=["Face1"], force={"Face2": (0.0, 0.0, 200.0)}))
    assert np.array_equal(found.displacements, right.displacements) and found.max_displacement > 1e-5
    at_nodes = solve_inp(static_deck(back, fixed=["hold"], force={"rim": (0.0, 0.0, 200.0)}))
    assert at_nodes.max_displacement > found.max_displacement
    with pytest.raises(ToolError, match="hold, load, top only, rim") as caught:
        static_deck(back, fixed=["nothing"], force={"load": (1, 0, 0)})
    assert caught.value.code is FaultCode.BAD_OPTION
    for mesh_of_it in (back, numbered):     # quads on no CAD face have the number 0, which is no name of them
        with pytest.raises(ToolError, match="'Face0' names no group") as caught:
            static_deck(mesh_of_it, fixed=["Face0"], force={"load": (1, 0, 0)})
        assert caught.value.code is FaultCode.BAD_OPTION
    with pytest.raises(ToolError, match="no quads"):
        static_deck(back, fixed=["hold"], pressure={"rim": 1.0})


def test_middle_nodes_of_a_held_node_set():
    """At order 2 a set of corners that covers faces holds the nodes between them, too."""
    box = block(2, 2, 2)
    box.node_groups = {"low": np.flatnonzero(box.points[:, 2] == 0), "edge": np.flatnonzero((box.points[:,
        :2] == 0).all(axis=1))}
    elements = elements_of(box, 2)
    assert (elements.points[elements.nodes_of("low")][:, 2] == 0).all() and len(elements.nodes_of("low")) == 9 + 12
    assert len(elements.nodes_of("edge")) == 5


def test_a_deck_advises_only_what_is_there(tmp_path, mesh):
    files.write(mesh, tmp_path / "m.inp")
    text = (tmp_path / "m.inp").read_text(encoding="ascii")
    assert "** hold_NODES, 1, 3, 0" in text and "** load, P, 1.0" in text and "FACE1" not in text
    mesh.quad_groups, mesh.node_groups = {}, {}
    files.write(mesh, tmp_path / "m.inp")
    text = (tmp_path / "m.inp").read_text(encoding="ascii")
    assert "No faces are named" in text and "*BOUNDARY" not in text


def test_names_that_a_deck_can_hold():
    assert abaqus.deck_names(["Face3", "in let", "IN_LET", "3rd", "\u00e4"]) == ["FACE3", "in_let", "IN_LET_2",
        "G3rd", "G_"]


def test_node_sets_that_only_look_like_those_of_a_group(tmp_path, mesh):
    """NAME_NODES repeats a group NAME where there is one, as HexCon writes it; without one it is a set of its own."""
    sets = f"*ELSET, ELSET=hold\n{', '.join(str(row + 1) for row in LOW)}\n"
    sets += "".join(f"*NSET, NSET={name}\n1, 2\n" for name in ("hold_NODES", "N_NODES", "e_nodes", "NALL"))
    (tmp_path / "named.inp").write_text(SHELL + sets, encoding="ascii")
    assert set(surface_from_file(tmp_path / "named.inp").node_groups) == {"N_NODES", "e_nodes"}
