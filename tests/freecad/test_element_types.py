# SPDX-License-Identifier: LGPL-2.1-or-later
"""C3D8, C3D8R, C3D20 and C3D20R to choose from; decks that load nothing do not reach CalculiX."""
import numpy as np
import pytest
from hex_grids import block
from test_calculix_deck import GRADIENT, exact_stress

import hexcon
import hexcon_native
from hexcon import calculix, files
from hexcon.calculix.deck_loads import check_deck
from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh import add_to_document, elements_of
from hexcon.femmesh.element_types import CHOICES, ELEMENT_TYPES
from hexcon.files import read_mesh

SIZE = (10.0, 1.0, 1.0)
PULL = {"Face2": (0.0, 0.0, -1.0)}


def types_in(text):
    return {line.split("TYPE=")[1].split(",")[0].strip().upper() for line in text.upper().splitlines()
            if line.startswith("*ELEMENT") and "TYPE=" in line}


@pytest.mark.parametrize("name", ELEMENT_TYPES)
def test_files_and_decks(tmp_path, name):
    mesh, order = block(10, 2, 2, SIZE), ELEMENT_TYPES[name]
    files.write(mesh, tmp_path / "m.inp", order=order, element=name)
    assert types_in((tmp_path / "m.inp").read_text()) == {name}
    assert read_mesh(tmp_path / "m.inp").order == order
    deck = calculix.static_deck(mesh, force=PULL, order=order, element=name)
    assert types_in(deck) == {name}
    bent = calculix.solve_inp(deck).max_displacement        # 4 N L^3 / E b^4 by Bernoulli, 2 % more by Timoshenko
    assert bent == pytest.approx(4 * 1000 / 210000.0, rel={"C3D8": 0.35, "C3D8R": 0.4}.get(name, 0.02))


@pytest.mark.parametrize(("count", "name"), [((1, 1, 1), "C3D20"), ((10, 1, 1), "C3D20"), ((4, 2, 1), "C3D20R"),
                                              ((3, 3, 3), "C3D20R")])
def test_rows_of_single_hexes_are_integrated_in_full(count, name):
    """They have modes that reduced integration does not resist; bent they would come out many times too soft."""
    mesh = block(*count, SIZE)
    deck = calculix.static_deck(mesh, force=PULL, order=2)
    assert types_in(deck) == {name} and types_in(calculix.static_deck(mesh, force=PULL)) == {"C3D8"}
    assert calculix.solve_inp(deck).max_displacement < 1.1 * 4 * 1000 / 210000.0


@pytest.mark.parametrize(("name", "order"), [("C3D20R", 1), ("C3D8", 2), ("C3D8I", 1), ("C3D10", 2)])
def test_others_are_refused(name, order):
    with pytest.raises(ToolError) as caught:
        calculix.static_deck(block(1, 1, 1), force=PULL, order=order, element=name)
    assert caught.value.code is FaultCode.BAD_OPTION and name in str(caught.value)


def test_through_freecad(doc, box_in):
    solid = box_in(SIZE)
    mesh = block(10, 2, 2, SIZE)
    found = {}
    for name in ("C3D20", "C3D20R"):
        result = calculix.solve(doc, mesh, solid, order=2, element=name, force=PULL)
        with open(result.inp_path, encoding="utf-8") as stream:
            assert types_in(stream.read()) == {name}
        found[name] = result.max_displacement
    assert 0 < found["C3D20R"] / found["C3D20"] - 1 < 0.05
    held = add_to_document(doc, mesh, solid, order=1)
    held.addProperty("App::PropertyEnumeration", "ElementType")
    held.ElementType = list(CHOICES)
    held.ElementType = "C3D8R"
    result = calculix.solve(doc, held, solid, force=PULL)
    with open(result.inp_path, encoding="utf-8") as stream:
        assert types_in(stream.read()) == {"C3D8R"}


@pytest.mark.parametrize("name", ["C3D20", "C3D20R"])
def test_curved_elements_pass_the_patch_test(cylinder_in, name):
    """A linear field prescribed on the boundary of a curved mesh: its stress is exact at every integration point."""
    solid = cylinder_in(3.0, 4.0)
    mesh = hexcon.mesh_solid(solid.Shape, 2.0, order=2)
    assert mesh.report["curved"]["on_faces"] > 0 and mesh.certificate.certified
    boundary = np.unique(elements_of(mesh).quads)
    field = mesh.points @ GRADIENT.T
    result = calculix.solve_inp(calculix.static_deck(mesh, fixed=(), element=name, integration_points=True,
                                                     prescribed=(boundary, field[boundary])))
    right = exact_stress()
    found = result.integration_points[:, [2, 3, 4, 5, 7, 6]]
    assert np.abs(found - right).max() < 1e-5 * np.abs(right).max()
    assert np.abs(result.displacements - field).max() < 1e-5 * np.abs(field).max()


def bent(points):
    """Pure bending of Poisson's ratio 0.3: displacements of degree 2, whose only stress is E y along x."""
    x, y, z = points.T
    return np.column_stack([x * y, -(x ** 2 + 0.3 * (y ** 2 - z ** 2)) / 2, -0.3 * y * z])


@pytest.mark.parametrize("name", ["C3D20", "C3D20R"])
@pytest.mark.parametrize("askew", [False, True])
def test_quadratic_patch(name, askew):
    """Exact on parallelepipeds, whose shape functions hold every quadratic; on crooked ones (straight edges) they do
    not, and the error of displacements falls with a power of the size."""
    def error(count):
        mesh = block(count, count, count)
        points = mesh.points / count
        if askew:
            points += 0.15 * np.sin(np.pi * points[:, [1, 2, 0]]) * np.sin(np.pi * points) * (1, -1, 1)
        mesh.points[:] = points @ np.array([[1.0, 0.2, 0.1], [0.0, 1.0, 0.3], [0.0, 0.0, 1.0]])
        elements = elements_of(mesh, 2)
        boundary, field = np.unique(elements.quads), bent(elements.points)
        deck = calculix.static_deck(mesh, {"young": 1000.0, "poisson": 0.3}, fixed=(), order=2, element=name,
                                    prescribed=(boundary, field[boundary]))
        return np.abs(calculix.solve_inp(deck).displacements - field).max() / np.abs(field).max()
    if askew:
        assert 1e-5 < 4 * error(4) < error(2) < 0.01
    else:
        assert error(2) < 3e-6     # figures of six digits


@pytest.mark.parametrize("name", ["C3D20", "C3D20R"])
def test_calculix_takes_what_is_certified_and_refuses_what_folds(cylinder_in, name):
    """CalculiX looks at its integration points alone: what folds there it refuses."""
    solid = cylinder_in(3.0, 4.0)
    mesh = hexcon.mesh_solid(solid.Shape, 2.0, order=2)
    loads = {"fixed": ("Face2",), "force": {"Face3": (0.0, 0.0, -1.0)}, "element": name}
    assert mesh.certificate.certified and calculix.solve_inp(calculix.static_deck(mesh, **loads)).max_displacement > 0
    one = mesh.hexes[0]
    mesh.points[one[16:]] += 2 * (mesh.points[one[4]] - mesh.points[one[0]])
    assert not hexcon_native.certify(mesh.points, mesh.hexes, mesh.quads).certified
    with pytest.raises(ToolError) as caught:
        calculix.solve_inp(calculix.static_deck(mesh, **loads))
    assert caught.value.code is FaultCode.TOOL_FAILED


STEP = "*STEP\n*STATIC\n{}\n*END STEP\n"


@pytest.mark.parametrize("loads", ["", "*CLOAD\n1, 3, 0.0", "*DLOAD",
                                   "*DLOAD\n** pressure\n3, P1, 0.0", "*BOUNDARY\n4, 1, 3"])
def test_decks_that_load_nothing(loads):
    with pytest.raises(ToolError) as caught:
        check_deck("*BOUNDARY\n1, 1, 3, 0.0\n" + STEP.format(loads))
    assert caught.value.code is FaultCode.BAD_OPTION and "loads nothing" in str(caught.value)


@pytest.mark.parametrize("loads", ["*CLOAD\n1, 3, 1e-9", "*Dload\n3, P1, -2.", "*DLOAD\nEALL, GRAV, 9810., 0., 0., -1.",
                                   "*BOUNDARY\n4, 1, 1, 0.1", "*TEMPERATURE\nNALL, 300.", "*FREQUENCY\n10",
                                   "*INCLUDE, INPUT=loads.inp", "*DSLOAD\nFACE2, P, 1.0"])
def test_decks_that_load_something(loads):
    check_deck("*BOUNDARY\n1, 1, 3, 0.0\n" + STEP.format(loads))
    check_deck("*NODE\n1, 0., 0., 0.\n")


def test_ccx_does_not_start(tmp_path):
    deck = calculix.static_deck(block(1, 1, 1), force=PULL)
    nothing = "\n".join(line[:line.rindex(",")] + ", 0.0" if line.count(",") == 2 and "e" in line and line[0].isdigit()
                        else line for line in deck.splitlines())
    with pytest.raises(ToolError) as caught:
        calculix.solve_inp(nothing + "\n", workdir=str(tmp_path), ccx="/bin/false")
    assert "loads nothing" in str(caught.value) and np.all([not p.name.endswith(".frd") for p in tmp_path.iterdir()])
