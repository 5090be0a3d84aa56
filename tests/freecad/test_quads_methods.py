# SPDX-License-Identifier: LGPL-2.1-or-later
"""The methods that let gmsh mesh the whole surface, and solids from documents."""
import os
import sys

import pytest

sys.path[:0] = [os.path.dirname(os.path.abspath(__file__))]

import quads_solids  # noqa: E402
from quads_checks import assert_closed_even_outward, assert_on_faces  # noqa: E402
from quads_solids import FreeCAD, Part, Vector  # noqa: E402

import hexcon  # noqa: E402
from hexcon.errors import FaultCode, ToolError  # noqa: E402
from hexcon.gui import actions  # noqa: E402
from hexcon.quads import surface_from_object, surface_from_solid  # noqa: E402

SOLIDS = {name: maker for name, (maker, _, _) in quads_solids.BRIEF.items()}
SOLIDS.update({"ball": lambda: Part.makeSphere(5), "filleted box": quads_solids.filleted_box,
               "bracket": quads_solids.two_way_bracket, "torus": lambda: Part.makeTorus(8, 3)})


@pytest.mark.parametrize("name", SOLIDS)
@pytest.mark.parametrize("method", ["subdivided", "subdivided-triangles"])
def test_always_all_quad_and_even(name, method):
    shape = SOLIDS[name]()
    surface = surface_from_solid(shape, 2.5, method)
    assert surface.method == method
    assert_closed_even_outward(surface, shape)
    assert_on_faces(surface, shape, most=150)


@pytest.mark.parametrize("name", ["box", "cylinder", "two-hole plate", "ball", "torus", "shaft segment"])
def test_blossom(name):
    """All quads and even, with a note where the size was changed, or one of two faults."""
    shape = SOLIDS[name]()
    try:
        surface = surface_from_solid(shape, 2.0, "blossom")
    except ToolError as fault:
        assert fault.code in (FaultCode.NOT_ALL_QUAD, FaultCode.ODD_SURFACE)
        return
    assert_closed_even_outward(surface, shape)
    assert_on_faces(surface, shape, most=150)


@pytest.mark.parametrize("name", ["box", "pyramid frustum", "sheared prism"])
def test_transfinite(name):
    shape = SOLIDS[name]()
    surface = surface_from_solid(shape, 1.5, "transfinite")
    assert_closed_even_outward(surface, shape)
    assert_on_faces(surface, shape, most=150)


@pytest.mark.parametrize("name", ["cylinder", "hexagonal prism", "ball"])
def test_not_transfinite(name):
    with pytest.raises(ToolError) as caught:
        surface_from_solid(SOLIDS[name](), 2.0, "transfinite")
    assert caught.value.code is FaultCode.NOT_TRANSFINITE


def _fault(shape, size=1.0, **options):
    with pytest.raises(ToolError) as caught:
        surface_from_solid(shape, size, **options)
    return caught.value


def test_solids_are_counted():
    two = Part.makeCompound([Part.makeBox(1, 1, 1), Part.makeBox(1, 1, 1, Vector(5, 0, 0))])
    assert _fault(two).code is FaultCode.BAD_SHAPE and "2 solids" in str(_fault(two))
    assert _fault(Part.makeBox(1, 1, 1).Faces[0]).code is FaultCode.BAD_SHAPE
    assert _fault(Part.Shape()).code is FaultCode.BAD_SHAPE


def test_cavity():
    """The ball's quads face into it; no sweep and no blocks go round it, however like boxes its shells are."""
    shape = Part.makeBox(9, 9, 9).cut(Part.makeSphere(2, Vector(4, 4, 4)))
    surface = surface_from_solid(shape, 2.0)
    assert_closed_even_outward(surface, shape)
    assert surface.method == "grid" and sum("cavities" in note for note in surface.notes) == 2
    hollow = Part.makeBox(9, 9, 9).cut(Part.makeBox(3, 3, 3, Vector(3, 3, 3)))
    assert _fault(hollow, 2.0, method="sweep").code is FaultCode.NOT_SWEEPABLE
    assert _fault(hollow, 2.0, method="blocks").code is FaultCode.NOT_BLOCKS


def test_face_numbers_in_a_compound():
    """Loose faces before the solid: the numbers are those of the compound."""
    box = Part.makeBox(4, 4, 4)
    shape = Part.makeCompound([Part.makePlane(1, 1, Vector(20, 0, 0)), box])
    surface = surface_from_solid(shape, 2.0)
    assert set(surface.face_of_quad) == set(range(2, 8))
    for number in range(2, 8):
        for point in surface.points[surface.quads[surface.face_of_quad == number].ravel()]:
            assert Part.Vertex(Vector(*point)).distToShape(shape.Faces[number - 1])[0] < 1e-7


@pytest.mark.parametrize("ending", ["step", "brep", "FCStd"])
@pytest.mark.parametrize("name", ["shaft segment", "two-hole plate"])
def test_files(tmp_path, ending, name):
    """The same mesh and the same face numbers by every road."""
    shape, path = SOLIDS[name](), str(tmp_path / f"solid.{ending}")
    if ending == "step":
        shape.exportStep(path)
        shape = Part.read(path)
    elif ending == "brep":
        shape.exportBrep(path)
    else:
        document = FreeCAD.newDocument()
        document.addObject("Part::Feature", "Solid").Shape = shape
        document.saveAs(path)
        FreeCAD.closeDocument(document.Name)
    surface = surface_from_solid(path, 2.0)
    assert_on_faces(surface, shape, most=150)
    assert len(surface.quads) == len(surface_from_solid(shape, 2.0).quads)


def test_document_with_a_cut(tmp_path):
    """The tools of a cut are solids too, but not the one that is meant."""
    document = FreeCAD.newDocument()
    base = document.addObject("Part::Box", "Base")
    tool = document.addObject("Part::Cylinder", "Tool")
    tool.Placement.Base = Vector(5, 5, 0)
    cut = document.addObject("Part::Cut", "Cut")
    cut.Base, cut.Tool = base, tool
    document.recompute()
    path = str(tmp_path / "cut.FCStd")
    document.saveAs(path)
    FreeCAD.closeDocument(document.Name)
    assert len(set(surface_from_solid(path, 2.0).face_of_quad)) == 7


def test_two_solids_in_a_document(tmp_path):
    document = FreeCAD.newDocument()
    document.addObject("Part::Box", "Left")
    document.addObject("Part::Box", "Right")
    document.recompute()
    path = str(tmp_path / "two.FCStd")
    document.saveAs(path)
    FreeCAD.closeDocument(document.Name)
    fault = _fault(path)
    assert fault.code is FaultCode.BAD_SHAPE and "Left" in str(fault) and "Right" in str(fault)


def test_a_mesh_in_a_document_is_no_solid(tmp_path):
    """From 1.0 on a FEM mesh object has a property Shape, the link to its solid."""
    from hexcon.femmesh import add_to_document
    document = FreeCAD.newDocument()
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    made = add_to_document(document, hexcon.mesh_solid(box.Shape, 5.0), box)
    again = actions.make_quad_surface(made)
    assert again.Quads == 24 and surface_from_object(made).method == "given"
    with pytest.raises(hexcon.ToolError, match="0 solids"):
        actions.mesh_solid_object(made, 5.0)
    path = str(tmp_path / "meshed.FCStd")
    document.saveAs(path)
    FreeCAD.closeDocument(document.Name)
    assert len(surface_from_solid(path, 5.0).quads) == 24


class TestObjects:
    """surface_from_object."""

    @pytest.fixture
    def document(self):
        document = FreeCAD.newDocument()
        yield document
        FreeCAD.closeDocument(document.Name)

    def test_femmesh_of_quads(self, document):
        import Fem
        given = surface_from_solid(Part.makeCylinder(5, 12), 2.0)
        mesh = Fem.FemMesh()
        for k, p in enumerate(given.points):
            mesh.addNode(*[float(x) for x in p], k + 1)
        for quad in given.quads:
            mesh.addFace([int(i) + 1 for i in quad])
        obj = document.addObject("Fem::FemMeshObject", "Quads")
        obj.FemMesh = mesh
        surface = surface_from_object(obj)
        assert surface.method == "given" and len(surface.quads) == len(given.quads)
        assert_closed_even_outward(surface)
        assert not surface.face_of_quad.any()

    def test_femmesh_of_a_hex(self, document):
        import Fem
        mesh = Fem.FemMesh()
        corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
        for k, p in enumerate(corners):
            mesh.addNode(*p, k + 1)
        mesh.addVolume([v + 1 for v in (0, 3, 2, 1, 4, 7, 6, 5)])
        obj = document.addObject("Fem::FemMeshObject", "Hex")
        obj.FemMesh = mesh
        surface = surface_from_object(obj)
        assert len(surface.quads) == 6 and surface.notes
        assert_closed_even_outward(surface)

    def test_others_are_refused(self, document):
        import Mesh
        obj = document.addObject("Mesh::Feature", "Triangles")
        obj.Mesh = Mesh.Mesh(Part.makeBox(1, 1, 1).tessellate(0.1))
        with pytest.raises(ToolError) as caught:
            surface_from_object(obj)
        assert caught.value.code is FaultCode.NOT_ALL_QUAD and "12 triangles" in str(caught.value)
        with pytest.raises(ToolError) as caught:
            surface_from_object(document.addObject("Part::Box", "Solid"))
        assert caught.value.code is FaultCode.BAD_OPTION and "surface_from_solid" in str(caught.value)
