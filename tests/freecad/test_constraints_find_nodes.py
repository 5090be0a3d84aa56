# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's own constraints on faces, edges and vertices, flat and curved, find their nodes at both orders.

By the lines of the decks that FreeCAD writes, and by the reaction forces that CalculiX finds.
"""
import math
import os
import re

import numpy as np
import pytest

import hexcon
from hexcon import freecad_compat
from hexcon.calculix.freecad_deck import nodal_loads
from hexcon.calculix.runner import run_ccx
from hexcon.femmesh import elements_of

FORCE, PRESSURE = 120.0, 3.0
UNITS = {"Force": "N", "Pressure": "MPa"}


@pytest.fixture(scope="module", params=[1, 2])
def part(request, freecad):
    """(document, solid, mesh, mesh object) of a cylinder: faces 1 side, 2 bottom, 3 top; edges 1 seam, 2 top rim."""
    doc = freecad.newDocument("Constraints")
    solid = doc.addObject("Part::Cylinder", "Cylinder")
    solid.Radius, solid.Height = 5, 8
    doc.recompute()
    mesh = hexcon.mesh_solid(solid.Shape, 2.5, order=request.param)
    assert mesh.certificate.certified
    yield doc, solid, mesh, hexcon.femmesh.add_to_document(doc, mesh, solid)
    freecad.closeDocument(doc.Name)


@pytest.fixture
def deck(part, tmp_path):
    """Function: the deck's path for some constraints, (kind, references, properties) each."""
    doc, solid, _, mesh_object = part
    objects = freecad_compat.fem_module("ObjectsFem")

    def make(*constraints, kind="static"):
        analysis, solver = objects.makeAnalysis(doc, "Analysis"), freecad_compat.make_ccx_solver(doc)
        solver.AnalysisType = kind
        material = objects.makeMaterialSolid(doc, "Material")
        material.Material = {"Name": "Steel", "YoungsModulus": "210000 MPa", "PoissonRatio": "0.3",
                             "Density": "7900 kg/m^3", "ThermalConductivity": "43 W/m/K",
                             "ThermalExpansionCoefficient": "12 um/m/K", "SpecificHeat": "590 J/kg/K"}
        made = []
        for name, references, properties in constraints:
            made.append(getattr(objects, "makeConstraint" + name)(doc, "Constraint" + name))
            if references:
                made[-1].References = [(solid, references)]
            for key, value in properties.items():
                if key in UNITS:
                    freecad_compat.set_quantity(made[-1], key, value, UNITS[key])
                else:
                    setattr(made[-1], key, value)
        for member in (solver, material, *made, mesh_object):
            analysis.addObject(member)
        doc.recompute()
        tools = freecad_compat.fem_module("femtools.ccxtools").FemToolsCcx(analysis, solver)
        tools.update_objects()
        tools.setup_working_dir(str(tmp_path))
        assert not tools.check_prerequisites()
        tools.write_inp_file()
        for member in (solver, material, *made, analysis):
            doc.removeObject(member.Name)
        return tools.inp_file_name
    return make


def lines_of(path):
    """{card: data lines}: "*NSET" by its name, numbers counted."""
    found, card = {}, ""
    with open(path, encoding="utf-8") as stream:
        for line in stream:
            if line.startswith("**") or not line.strip():
                continue
            if line.startswith("*"):
                card = line.strip().replace(" ", "")
                card = card if card.startswith(("*NSET", "*SURFACE")) else card.split(",")[0]
                found.setdefault(card, 0)
            else:
                found[card] += 1
    return found


def nodes_on(part, name):
    """Nodes of the mesh on a face, an edge or a vertex, by the cylinder's formulas."""
    points = part[2].points
    side, bottom, top = (np.abs(np.hypot(*points[:, :2].T) - 5) < 1e-7, np.abs(points[:, 2]) < 1e-7,
                         np.abs(points[:, 2] - 8) < 1e-7)
    seam = side & (np.abs(points[:, 1]) < 1e-7) & (points[:, 0] > 0)
    return {"Face1": side, "Face2": bottom, "Face3": top, "Edge1": seam, "Edge2": side & top, "Edge3": side & bottom,
            "Vertex1": seam & top, "Vertex2": seam & bottom}[name].sum()


def quads_on(part, number):
    return int((part[2].face_of_quad == number).sum())


FIXED = ("Fixed", ("Face2",), {})
ONE_SET = {"Fixed": ("*NSET,NSET=ConstraintFixed", {}), "Transform": ("*NSET,NSET=RectConstraintTransform", {}),
           "Displacement": ("*NSET,NSET=ConstraintDisplacement", {"xDisplacement": 0.1, "xFree": False}),
           "Temperature": ("*NSET,NSET=ConstraintTemperature", {"Temperature": 400.0})}


@pytest.mark.parametrize("where", ["Face1", "Face3", "Edge1", "Edge2", "Vertex1"])
def test_node_sets(part, deck, where):
    for name, (card, properties) in ONE_SET.items():
        constraints = [(name, (where,), properties)] + ([] if name == "Fixed" else [FIXED])
        thermal = name == "Temperature"
        if thermal:
            constraints.append(("InitialTemperature", None, {"initialTemperature": 300.0}))
        found = lines_of(deck(*constraints, kind="thermomech" if thermal else "static"))
        assert found[card] == nodes_on(part, where), name


@pytest.mark.parametrize("where", ["Face1", "Face3"])
def test_plane_rotation(part, deck, where):
    found = lines_of(deck(("PlaneRotation", (where,), {}), FIXED))
    assert found["*NSET,NSET=ConstraintPlaneRotation"] == nodes_on(part, where) and found["*MPC"] == 1


@pytest.mark.parametrize("where", ["Face1", "Face3", "Edge1", "Vertex1"])
def test_forces(part, deck, where):
    found = lines_of(deck(("Force", (where,), {"Force": FORCE, "Direction": (part[1], ["Edge1"])}), FIXED))
    assert found["*CLOAD"] == nodes_on(part, where)


@pytest.mark.parametrize("number", [1, 3])
def test_pressures(part, deck, number):
    found = lines_of(deck(("Pressure", (f"Face{number}",), {"Pressure": PRESSURE}), FIXED))
    assert found["*DLOAD"] == quads_on(part, number)


@pytest.mark.parametrize(("name", "prefix"), [("Contact", ""), ("Tie", "TIE_")])
def test_pairs_of_faces(part, deck, name, prefix):
    found = lines_of(deck((name, ("Face3", "Face1"), {}), FIXED))
    assert found[f"*SURFACE,NAME={prefix}DEPConstraint{name}"] == quads_on(part, 3)
    assert found[f"*SURFACE,NAME={prefix}INDConstraint{name}"] == quads_on(part, 1)


def reaction(path):
    """Sum of the reactions of the fixed nodes, as FreeCAD's deck asks ccx to print it."""
    run_ccx(path)
    with open(os.path.splitext(path)[0] + ".dat", encoding="utf-8") as stream:
        found = re.findall(r"total force.*?\n\s*\n\s*(\S+)\s+(\S+)\s+(\S+)", stream.read())
    return np.array(found[-1], float)


def test_reactions_balance_loads(part, deck):
    """A force along the side; a pressure on the flat top, and on the round side, whose sum is nothing."""
    mesh = part[2]
    path = deck(("Force", ("Face1",), {"Force": FORCE, "Direction": (part[1], ["Edge1"])}), FIXED)
    with open(path, encoding="utf-8") as stream:
        loads = nodal_loads(stream.read(), np.arange(1, len(mesh.points) + 1))[:, 2]
    pulled = reaction(path)
    # FreeCAD spreads it by mesh area over CAD area
    assert abs(loads.sum()) == pytest.approx(FORCE, rel=5e-3 if mesh.order == 2 else 0.05)
    free = loads[mesh.points[:, 2] > 1e-7].sum()    # ccx leaves out what is loaded and held
    assert pulled[2] == pytest.approx(-free, rel=1e-5) and np.abs(pulled[:2]).max() < 1e-4 * FORCE
    pressed = reaction(deck(("Pressure", ("Face3",), {"Pressure": PRESSURE}), FIXED))
    corners = elements_of(mesh)
    top = corners.points[corners.quads[mesh.face_of_quad == 3]][:, :, :2]
    if mesh.order == 1:
        x, y = top[:, :, 0], top[:, :, 1]
        area = sum(x[:, k] * y[:, (k + 1) % 4] - y[:, k] * x[:, (k + 1) % 4] for k in range(4)).sum() / 2
    else:
        area = math.pi * 25
    assert pressed[2] == pytest.approx(PRESSURE * area, rel=1e-3 if mesh.order == 2 else 1e-5)
    squeezed = reaction(deck(("Pressure", ("Face1",), {"Pressure": PRESSURE}), FIXED))
    assert np.abs(squeezed).max() < 1e-3 * PRESSURE * area


def test_groups_where_the_distance_test_is_too_tight(doc, cylinder_in, tmp_path, monkeypatch):
    """Straight edges of order 2 leave the cylinder: constraints get node groups by themselves, and FreeCAD's own deck
    has every node and element face; where a reference changes, or is none any more, so does the group. FreeCAD takes
    none for forces, nor for pressures from 1.1 on: that is told, and HexCon's own deck has every element face."""
    from hex_grids import cylinder

    from hexcon import calculix
    from hexcon.calculix import constraint_groups
    from hexcon.femmesh import add_to_document, face_nodes
    solid, mesh = cylinder_in(5.0, 8.0), cylinder(4, 3, 5.0, 8.0)
    held = add_to_document(doc, mesh, solid, order=2)
    objects = freecad_compat.fem_module("ObjectsFem")
    told, pressures_take_groups = [], freecad_compat.version() < (1, 1)
    monkeypatch.setattr(constraint_groups, "_warn", told.append)
    constraint_groups.watch()
    analysis, solver = objects.makeAnalysis(doc, "Analysis"), freecad_compat.make_ccx_solver(doc)
    material = objects.makeMaterialSolid(doc, "Material")
    material.Material = {"Name": "Steel", "YoungsModulus": "210000 MPa", "PoissonRatio": "0.3",
                         "Density": "7900 kg/m^3"}
    fixed, pressure, force = (objects.makeConstraintFixed(doc), objects.makeConstraintPressure(doc),
                              objects.makeConstraintForce(doc))
    for member in (solver, material, held, fixed):
        analysis.addObject(member)
    fixed.References = [(solid, "Face2")]
    assert not any(held.FemMesh.getGroupName(g).startswith(fixed.Name) for g in held.FemMesh.Groups)   # a plane
    pressure.References = [(solid, "Face1")]
    freecad_compat.set_quantity(pressure, "Pressure", 2.0, "MPa")
    assert not told
    analysis.addObject(pressure)                                    # after its references were set
    doc.recompute()
    names = {held.FemMesh.getGroupName(g): g for g in held.FemMesh.Groups}
    side, quads = set((face_nodes(mesh, 1, 2) + 1).tolist()), (mesh.face_of_quad == 1).sum()
    lost = f"FreeCAD will leave {quads} of {quads} element faces out of "
    if pressures_take_groups:
        assert set(held.FemMesh.getGroupElements(names[pressure.Name + constraint_groups.ENDING])) == side and not told
    else:
        assert pressure.Name + constraint_groups.ENDING not in names and told[-1].startswith(lost + pressure.Label)
    tools = freecad_compat.fem_module("femtools.ccxtools").FemToolsCcx(analysis, solver)
    tools.update_objects()
    tools.setup_working_dir(str(tmp_path))
    assert not tools.check_prerequisites()
    tools.write_inp_file()
    assert lines_of(tools.inp_file_name)["*DLOAD"] == (quads if pressures_take_groups else 0)
    told.clear()
    pressure.References = [(solid, "Face3")]
    assert not told                                                 # a plane
    assert not any(held.FemMesh.getGroupName(g).startswith(pressure.Name) for g in held.FemMesh.Groups)
    fixed.References = [(solid, ("Face1", "Face2"))]
    names = {held.FemMesh.getGroupName(g): g for g in held.FemMesh.Groups}
    assert side < set(held.FemMesh.getGroupElements(names[fixed.Name + constraint_groups.ENDING]))
    analysis.addObject(force)
    force.References = [(solid, "Face1")]
    assert told[-1].startswith(lost + force.Label)
    freecad_compat.set_quantity(force, "Force", FORCE, "N")
    force.Direction = (solid, ["Edge1"])
    doc.recompute()
    tools.update_objects()
    tools.write_inp_file()
    assert lines_of(tools.inp_file_name).get("*CLOAD", 0) == 0
    assert force.Name + constraint_groups.ENDING not in {held.FemMesh.getGroupName(g) for g in held.FemMesh.Groups}
    solved = calculix.solve(doc, held, solid, fixed=["Face2"], pressure={"Face1": 2.0})
    assert lines_of(solved.inp_path)["*DLOAD"] == quads and solved.max_displacement > 0


def brep_for_gmsh(doc, solid, path):
    """The solid as FreeCAD's own FEM gives it to gmsh."""
    own = freecad_compat.fem_module("ObjectsFem").makeMeshGmsh(doc, "Own")
    setattr(own, "Shape" if freecad_compat.version() >= (1, 0) else "Part", solid)
    tools = freecad_compat.fem_module("femmesh.gmshtools").GmshTools(own)
    tools.temp_file_geometry = str(path)
    tools.write_part_file()
    doc.removeObject(own.Name)
    return freecad_compat.freecad_module("Part").read(str(path))


def test_a_solid_in_a_moved_part_is_where_fem_has_it(freecad, doc, box_in, tmp_path):
    """Two Parts around it, turned and moved: its surface and hexes lie where FreeCAD's own mesher would put them, so
    that constraints find every node by themselves, and a force keeps its direction."""
    from hexcon.calculix.constraint_groups import ENDING
    from hexcon.calculix.constraints import nodes_found_by_freecad
    from hexcon.document.analyses import into_analysis, load_and_solve
    from hexcon.document.making_hexes import mesh_solid_object
    app, solid = freecad, box_in((4, 2, 6))
    place = app.Placement(app.Vector(100, 20, 3), app.Rotation(app.Vector(1, 2, 3), 40))
    solid.Placement = app.Placement(app.Vector(0, 7, 0), app.Rotation(app.Vector(0, 0, 1), 30))
    held = solid
    for _ in range(2):
        around = doc.addObject("App::Part", "Part")
        around.Placement = place
        around.addObject(held)
        held = around
    doc.recompute()
    own = np.array([tuple(corner.Point) for corner in brep_for_gmsh(doc, solid, tmp_path / "own.brep").Vertexes])
    made = mesh_solid_object(solid, 2.0)
    for femmesh in (made.Surface.FemMesh, made.FemMesh):
        found = np.array([tuple(node) for node in femmesh.Nodes.values()])
        assert np.abs(found.min(axis=0) - own.min(axis=0)).max() < 1e-7
        assert np.abs(found.max(axis=0) - own.max(axis=0)).max() < 1e-7
    groups = {made.FemMesh.getGroupName(g): made.FemMesh.getGroupElements(g) for g in made.FemMesh.Groups}
    for name, faces in groups.items():
        nodes = {node for face in faces for node in made.FemMesh.getElementNodes(face)}
        assert nodes_found_by_freecad(made.FemMesh, solid, name) == nodes
    analysis = into_analysis(made)
    fixed, = [one for one in analysis.Group if one.isDerivedFrom("Fem::ConstraintFixed")]
    fixed.References = [(solid, "Face1")]
    assert not any(made.FemMesh.getGroupName(g).endswith(ENDING) for g in made.FemMesh.Groups)
    analysis.removeObject(made)
    for direction in ((0.0, 0.0, 5.0), (1.0, 2.0, 3.0)):
        result = load_and_solve(made, ["Face1"], {"Face2": direction})
        assert result.report["force_sum"] == pytest.approx(direction) and result.max_displacement > 0
