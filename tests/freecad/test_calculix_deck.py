# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bare decks: patch test, loads, and what ccx says when it fails."""
import os
import stat

import numpy as np
import pytest
from hex_grids import block, cylinder, distorted

import hexcon_native
from hexcon import calculix
from hexcon.calculix.judging import error_lines
from hexcon.calculix.loads import face_force, node_areas
from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh import elements_of

GRADIENT = np.array([(2e-4, 1e-4, -3e-5), (5e-5, -1e-4, 8e-5), (-6e-5, 4e-5, 3e-4)])

PULL = {"Face2": (1.0, 0.0, 0.0)}


def exact_stress(young=210000.0, poisson=0.3):
    strain = (GRADIENT + GRADIENT.T) / 2
    lame = young * poisson / ((1 + poisson) * (1 - 2 * poisson))
    shear = young / (2 * (1 + poisson))
    s = lame * np.trace(strain) * np.eye(3) + 2 * shear * strain
    return s[[0, 1, 2, 0, 1, 2], [0, 1, 2, 1, 2, 0]]  # xx yy zz xy yz zx


def patch_error(mesh, order):
    """Relative errors of a linear field: stress at the integration points, stress at the
    nodes (ccx's extrapolation alone is 4e-5 off on a perfect cube), displacement."""
    elements = elements_of(mesh, order)
    boundary = np.unique(elements.quads)
    field = elements.points @ GRADIENT.T
    deck = calculix.static_deck(mesh, fixed=(), order=order, integration_points=True,
                                prescribed=(boundary, field[boundary]))
    result = calculix.solve_inp(deck)
    right = exact_stress()
    # .dat sequence: xx yy zz xy xz yz
    points = result.integration_points[:, [2, 3, 4, 5, 7, 6]]
    return (np.abs(points - right).max() / np.abs(right).max(),
            np.abs(result.stress - right).max() / np.abs(right).max(),
            np.abs(result.displacements - field).max() / np.abs(field).max())


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("amount", [0.0, 0.07, 0.12])
def test_patch(order, amount):
    """Interior points and those of the top are moved by up to 24 % of an edge."""
    size = (2.0, 2.0, 2.0)
    mesh = distorted(block(4, 4, 4, size), amount, keep=("x", "y", "z0"))
    assert 0.1 < hexcon_native.quality(mesh.points, mesh.hexes).min
    stress, nodal, displacement = patch_error(mesh, order)
    print(f"patch order {order}, moved {amount}: stress {stress:.1e}, at nodes {nodal:.1e}, "
          f"u {displacement:.1e}")
    assert stress < 1e-5
    assert nodal < 1e-4
    assert displacement < 1e-5


@pytest.mark.parametrize("order", [1, 2])
def test_patch_on_a_cylinder(order):
    stress, nodal, displacement = patch_error(cylinder(6, 3, 2.0, 3.0), order)
    print(f"patch order {order}, cylinder: stress {stress:.1e}, at nodes {nodal:.1e}, "
          f"u {displacement:.1e}")
    assert stress < 1e-5 and nodal < 1e-4 and displacement < 1e-5


@pytest.mark.parametrize("order", [1, 2])
def test_patch_on_a_mesh_of_the_core(order):
    """The swept mesh that the core makes from the surface alone."""
    import hexcon_native
    whole = cylinder(6, 3, 2.0, 3.0)
    used, quads = np.unique(whole.quads, return_inverse=True)
    mesh = hexcon_native.mesh(whole.points[used], quads.reshape(-1, 4), "swept")
    stress, nodal, displacement = patch_error(mesh, order)
    print(f"patch order {order}, core's cylinder: stress {stress:.1e}")
    assert stress < 1e-5 and nodal < 1e-4 and displacement < 1e-5


@pytest.mark.parametrize("order", [1, 2])
def test_force_on_skew_quads_is_consistent(order):
    """An even pull on a distorted face gives an even stress: lumped loads would not."""
    mesh = distorted(block(4, 3, 3, (2.0, 1.0, 1.0)), 0.08, keep=("x", "y", "z"))
    deck = calculix.static_deck(mesh, {"young": 210000, "poisson": 0.0}, ["Face1"],
                                {"Face2": (21.0, 0, 0)}, order=order)
    stress = calculix.solve_inp(deck).stress
    assert np.allclose(stress, [21.0, 0, 0, 0, 0, 0], atol=21e-4)


@pytest.mark.parametrize("order", [1, 2])
def test_loads_sum_to_the_force_and_areas_to_the_area(order):
    elements = elements_of(distorted(block(3, 3, 3), 0.05, keep=("x", "y", "z")), order)
    nodes, loads = face_force(elements, 6, (1.0, -2.0, 3.0))
    assert np.allclose(loads.sum(axis=0), (1.0, -2.0, 3.0), atol=1e-12)
    assert np.array_equal(nodes, elements.nodes_of_face(6))
    areas = node_areas(elements.points, elements.quads[elements.quads_of_face(6)])
    assert areas.sum() == pytest.approx(1.0, abs=1e-12)


def test_pressure_on_a_closed_surface_is_hydrostatic():
    """Pressure on all faces: the element faces of every side are the right ones."""
    mesh = distorted(block(3, 3, 3), 0.06)
    deck = calculix.static_deck(mesh, fixed=(), prescribed=(
        [0], [(0, 0, 0)]), pressure={f"Face{k}": 10.0 for k in range(1, 7)})
    # hold the rigid rotations as well: nodes along the x and y axes
    deck = deck.replace("*STEP", "*BOUNDARY\n4, 2, 3\n13, 3, 3\n*STEP", 1)
    stress = calculix.solve_inp(deck).stress
    assert np.allclose(stress, [-10, -10, -10, 0, 0, 0], atol=1e-3)


def test_forces_on_two_faces_add_up_on_their_common_edge():
    mesh = block(2, 2, 2)
    deck = calculix.static_deck(mesh, fixed=["Face1"],
                                force={"Face2": (5.0, 0, 0), "Face6": (0, 0, 7.0)})
    from hexcon.calculix.freecad_deck import nodal_loads
    assert np.allclose(nodal_loads(deck, np.arange(1, 28)).sum(axis=0), (5.0, 0, 7.0))


def test_nodal_loads_are_sized_by_count():
    from hexcon.calculix.freecad_deck import nodal_loads
    deck = "*CLOAD\n900000001,1,2.0\n7,3,1.0\n900000001,1,0.5\n"
    assert nodal_loads(deck, np.array([900000001, 7, 3])).tolist() == [[2.5, 0, 0], [0, 0, 1.0], [0, 0, 0]]
    with pytest.raises(ToolError, match="number 900000001 is named") as raised:
        nodal_loads(deck, np.array([7, 3]))
    assert raised.value.code is FaultCode.TOOL_FAILED


def test_failure_in_ccx_words():
    deck = calculix.static_deck(block(2, 1, 1), force=PULL)
    with pytest.raises(ToolError, match="no material was assigned") as raised:
        calculix.solve_inp(deck.replace("*SOLID SECTION, ELSET=EALL, MATERIAL=SOLID\n", ""))
    assert raised.value.code is FaultCode.TOOL_FAILED
    mesh = block(2, 1, 1)
    mesh.hexes[1] = mesh.hexes[1, [4, 5, 6, 7, 0, 1, 2, 3]]
    with pytest.raises(ToolError, match="nonpositive jacobian") as raised:
        calculix.solve_inp(calculix.static_deck(mesh, force=PULL))
    assert raised.value.elements == [1]


def fake_ccx(folder, script):
    path = folder / "fake_ccx"
    path.write_text("#!/bin/sh\n" + script)
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return str(path)


def test_error_with_exit_status_zero(tmp_path):
    ccx = fake_ccx(tmp_path, "echo ' *ERROR reading *STEP:'; echo '   so it is'; exit 0\n")
    with pytest.raises(ToolError, match="so it is"):
        calculix.solve_inp(calculix.static_deck(block(1, 1, 1), force=PULL), ccx=ccx)


def test_no_results_and_no_words(tmp_path):
    ccx = fake_ccx(tmp_path, "echo 'Segmentation something'; exit 0\n")
    with pytest.raises(ToolError, match="Segmentation something"):
        calculix.solve_inp(calculix.static_deck(block(1, 1, 1), force=PULL), ccx=ccx)


def test_time_limit_and_missing_program(tmp_path, monkeypatch):
    ccx = fake_ccx(tmp_path, "exec sleep 600\n")
    with pytest.raises(ToolError) as raised:
        calculix.solve_inp(calculix.static_deck(block(1, 1, 1), force=PULL), ccx=ccx, timeout=0.2)
    assert raised.value.code is FaultCode.TOOL_TIMEOUT
    with pytest.raises(ToolError) as raised:
        calculix.solve_inp("*STEP\n", ccx=str(tmp_path / "none"))
    assert raised.value.code is FaultCode.TOOL_MISSING
    monkeypatch.setenv("PATH", str(tmp_path / "empty"))
    monkeypatch.delenv("HEXCON_CCX", raising=False)
    with pytest.raises(ToolError, match="apt install") as raised:
        calculix.solve_inp("*STEP\n")
    assert raised.value.code is FaultCode.TOOL_MISSING


def test_files_of_a_run(tmp_path):
    calculix.solve_inp(calculix.static_deck(block(1, 1, 1), force=PULL), workdir=str(tmp_path))
    assert {"deck.inp", "deck.frd"} <= set(os.listdir(tmp_path))
    with pytest.raises(ToolError) as raised:
        calculix.solve_inp(tmp_path / "none.inp")
    assert raised.value.code is FaultCode.FILE_IO
    with pytest.raises(ToolError) as raised:
        calculix.solve_inp("*STEP\n", workdir=str(tmp_path / "none"))
    assert raised.value.code is FaultCode.FILE_IO


def test_nothing_held_is_refused():
    with pytest.raises(ToolError, match="held") as raised:
        calculix.static_deck(block(1, 1, 1), fixed=())
    assert raised.value.code is FaultCode.BAD_OPTION


@pytest.mark.parametrize("loads,words", [({}, "no load is given"), ({"force": {"Face2": (0, 0, 0)}}, "Face2 are all zero"),
                                         ({"pressure": {"Face3": 0.0}}, "Face3 are all zero"),
                                         ({"force": {"Face2": "much"}}, "three finite"),
                                         ({"pressure": {"Face3": "much"}}, "a finite number")])
def test_nothing_loaded_is_refused(loads, words):
    with pytest.raises(ToolError, match=words) as raised:
        calculix.static_deck(block(1, 1, 1), **loads)
    assert raised.value.code is FaultCode.BAD_OPTION


@pytest.mark.parametrize("sets,held,words", [
    ("*NSET,NSET=Held\n1,\n2,\n", "Held,1", None), ("*NSET,NSET=Held\n", "Held,1", "node set HELD has no nodes"),
    ("", "Held,1", "HELD has no nodes"), ("", "7,1", None), ("*NSET,NSET=Other\n1\n", "", "holds nothing")])
def test_a_deck_that_holds_nothing(sets, held, words):
    from hexcon.calculix.freecad_deck import _cards, check_held
    cards = _cards(f"*NODE\n1,0,0,0\n{sets}*STEP\n*BOUNDARY\n{held}\n*END STEP\n")
    if words is None:
        check_held(cards)
        return
    with pytest.raises(ToolError, match=words):
        check_held(cards)


def test_error_lines_join_continuations():
    log = " ok\n *ERROR in e_c3d: nonpositive jacobian\n         determinant in element  3\n\n x"
    assert error_lines(log) == ["*ERROR in e_c3d: nonpositive jacobian",
                                "determinant in element  3"]


def test_frd_numbers_of_three_digit_exponents(tmp_path):
    rows = [" -1         1 1.00000E+00-2.00000E+00 3.00000E-01",
            " -1         2-1.00000E-100 2.50000E+00 0.00000E+00"]
    (tmp_path / "x.frd").write_text(
        "    1C\n -4  DISP        4    1\n -5  D1          1    2    1    0\n"
        + "\n".join(rows) + "\n -3\n 9999\n")
    from hexcon.calculix import frd
    found = frd.read(tmp_path / "x.frd")
    assert found["node_ids"].tolist() == [1, 2] and found["stress"] is None
    assert found["displacements"].tolist() == [[1, -2, 0.3], [-1e-100, 2.5, 0]]
