# SPDX-License-Identifier: LGPL-2.1-or-later
"""A solid gives one mesh: by mesh_solid, by the call of the window, and by the recompute of its objects."""
import math

import numpy as np
import pytest

import hexcon
import hexcon_native
from hexcon.femmesh import from_femmesh
from hexcon.meshing import Strategy, filling
from hexcon.objects import hex_mesh, quad_surface
from hexcon_native import ErrorCode, HexconError


class _Actions:
    """hexcon.gui.actions, which needs FreeCAD: imported where a test has it."""

    def __getattr__(self, name):
        from hexcon.gui import actions as real
        return getattr(real, name)


actions = _Actions()


def shapes():
    """(name, shape, size) of small solids that every surface method of auto meets."""
    import Part
    from FreeCAD import Vector
    box, cylinder = Part.makeBox, Part.makeCylinder
    return [
        ("box", box(4, 3, 2), 1.0),
        ("cylinder", cylinder(3, 5), 2.0),
        ("ball", Part.makeSphere(3), 2.0),
        ("cone", Part.makeCone(3, 1, 4), 1.5),
        ("tube", cylinder(4, 3).cut(cylinder(2, 3)), 2.0),
        ("wedge", Part.makeWedge(0, 0, 0, 2, 2, 4, 3, 4, 2, 2), 1.7),
        ("step", box(4, 4, 2).fuse(box(2, 2, 2, Vector(0, 0, 2))).removeSplitter(), 2.0),
        ("angle", box(6, 4, 2).cut(box(3, 4, 1, Vector(3, 0, 1))), 2.0),
        ("half ball", Part.makeSphere(3, Vector(0, 0, 0), Vector(0, 0, 1), 0, 90, 360), 2.0),
        ("crossed holes", box(6, 6, 6).cut(cylinder(1.5, 6, Vector(3, 3, 0))).cut(
            cylinder(1.5, 6, Vector(3, 0, 3), Vector(0, 1, 0))), 4.0),
        ("drilled", box(6, 6, 6).cut(cylinder(1.5, 6, Vector(3, 3, 0))), 4.0),
        ("corner cut", box(4, 4, 4).cut(Part.makeSphere(2)), 2.5),
    ]


def wedge():
    """One whose first surfaces differ in the number of quads."""
    return next(row for row in shapes() if row[0] == "wedge")


@pytest.fixture(autouse=True)
def same_tetrahedra(monkeypatch):
    """One answer for one question: gmsh's HXT is not quite the same from run to run, and the roads are tested."""
    real, known = filling.tetrahedralise, {}

    def tetrahedralise(points, triangles, **options):
        asked = (points.tobytes(), triangles.tobytes(), options["coarsening"])
        if asked not in known:
            known[asked] = real(points, triangles, **options)
        return known[asked]
    monkeypatch.setattr(filling, "tetrahedralise", tetrahedralise)


@pytest.fixture
def meshed(doc):
    """(solid, surface, mesh): objects made from a box, whose solid and size the tests change."""
    import Part
    solid = doc.addObject("Part::Feature", "Solid")
    solid.Shape = Part.makeBox(2, 2, 2)
    mesh = actions.mesh_solid_object(solid, 1.0)
    return solid, mesh.Surface, mesh


def same(mesh_object, made):
    """Whether a hex mesh object and its surface hold a mesh, bit for bit."""
    found, surface = from_femmesh(mesh_object.FemMesh), quad_surface.surface_of(mesh_object.Surface)
    return all(np.array_equal(one, other) for one, other in (
        (found.points, made.points), (found.hexes, made.hexes), (surface.points, made.surface.points),
        (surface.quads, made.surface.quads), (surface.face_of_quad, made.face_of_quad)))


def test_solids_by_both_roads(freecad, meshed):
    solid, surface, mesh = meshed
    for name, shape, size in shapes():
        made = hexcon.mesh_solid(shape, size)
        assert made.certificate.certified, name
        solid.Shape, surface.Size = shape, size
        solid.Document.recompute()
        assert mesh.Status == surface.Status == "Up to date", (name, mesh.Status)
        assert same(mesh, made), name
        assert (surface.MethodUsed, mesh.MethodUsed) == (made.surface.method, made.method), name
        assert surface.SizeUsed.Value == made.surface.size and surface.Tried == made.surface.tried, name


def refuse_surfaces(monkeypatch, counts):
    """Let the core certify no mesh whose surface has one of these numbers of quads."""
    real = hexcon_native.mesh

    def mesh(points, quads, *arguments, **options):
        if len(quads) in counts:
            raise HexconError("refused by the test", ErrorCode.NOT_CERTIFIED, [0])
        return real(points, quads, *arguments, **options)
    monkeypatch.setattr(hexcon_native, "mesh", mesh)


def first_surfaces(shape, size, count):
    """How many quads the first surfaces of a solid have."""
    from hexcon.meshing.strategy import TRIES
    from hexcon.quads import surface_from_solid
    return [len(surface_from_solid(shape, size * one.factor, care=one.care).quads) for one in TRIES[:count]]


def test_the_surface_object_follows_the_tries(freecad, meshed, monkeypatch):
    """It keeps the size asked for, shows the one used, and is not made anew for nothing; by both roads alike."""
    solid, surface, mesh = meshed
    _, shape, size = wedge()
    counts = first_surfaces(shape, size, 2)
    assert counts[0] != counts[1]
    refuse_surfaces(monkeypatch, counts[:1])
    made = hexcon.mesh_solid(shape, size)
    assert made.surface.tried == len(made.report["surface tries"]) == 1
    solid.Shape, surface.Size = shape, size
    solid.Document.recompute()
    assert same(mesh, made) and mesh.Status == surface.Status == "Up to date"
    assert surface.Size.Value == size and math.isclose(surface.SizeUsed.Value, 0.94 * size) and surface.Tried == 1
    assert mesh.Log[0].startswith("1 times the size: NOT_CERTIFIED: ") and "Touched" not in surface.State + mesh.State
    monkeypatch.setattr(quad_surface, "surface_from_solid", lambda *_, **__: pytest.fail("made anew"))
    solid.touch()
    solid.Document.recompute()
    assert same(mesh, made) and mesh.Status == surface.Status == "Up to date"
    monkeypatch.undo()
    mesh.Order = "2"    # goes from the first surface again, which can be filled now
    solid.Document.recompute()
    assert surface.Tried == 0 and surface.SizeUsed.Value == size
    assert same(mesh, hexcon.mesh_solid(shape, size, order=2))


def test_a_surface_that_cannot_be_made_is_tried_again(freecad, meshed, monkeypatch):
    from hexcon.errors import FaultCode, ToolError
    from hexcon.meshing import strategy
    solid, surface, mesh = meshed
    _, shape, size = wedge()
    real = quad_surface.surface_from_solid

    def make(shape_or_file, wanted, *arguments, **options):
        if wanted == size:
            raise ToolError("refused by the test", FaultCode.OFF_CAD, [0])
        return real(shape_or_file, wanted, *arguments, **options)
    monkeypatch.setattr(quad_surface, "surface_from_solid", make)
    monkeypatch.setattr(strategy, "surface_from_solid", make)
    made = hexcon.mesh_solid(shape, size)
    solid.Shape, surface.Size = shape, size
    solid.Document.recompute()
    assert same(mesh, made) and made.surface.tried == 1
    assert mesh.Status == surface.Status == "Up to date" and surface.Tried == 1


def test_a_surface_of_its_own_is_taken_as_it_is(freecad, meshed, monkeypatch):
    """A mesh made from the surface object asks for no other quads; one that others changed is made anew."""
    solid, surface, mesh = meshed
    _, shape, size = wedge()
    second = actions.make_hex_mesh(surface)
    assert mesh.TryOtherSurfaces and not second.TryOtherSurfaces
    from hexcon.quads import surface_from_solid
    another = surface_from_solid(shape, size, "subdivided")
    refuse_surfaces(monkeypatch, [*first_surfaces(shape, size, 1), len(another.quads)])
    solid.Shape, surface.Size = shape, size
    solid.Document.recompute()
    solid.Document.recompute()
    assert surface.Tried == 1 and mesh.Status == second.Status == "Up to date"
    assert same(second, hexcon.meshing.mesh_quad_surface(quad_surface.surface_of(surface)))
    actions.update_quad_surface(surface, method="subdivided")
    assert surface.Status == "Up to date" and surface.Tried == 0
    assert mesh.Status.startswith("Failed: refused by the test")  # no other surfaces are of the method asked for


def test_undo_of_a_try(freecad, meshed, monkeypatch):
    solid, surface, mesh = meshed
    document, (_, shape, size) = solid.Document, wedge()
    solid.Shape, surface.Size = shape, size
    document.recompute()
    document.UndoMode = 1
    first = hexcon.mesh_solid(shape, size)
    refuse_surfaces(monkeypatch, [surface.Quads])
    actions.update_hex_mesh(mesh, order=2)
    assert surface.Tried == 1 and not same(mesh, first)
    document.undo()
    assert surface.Tried == 0 and same(mesh, first)
    document.redo()
    assert surface.Tried == 1 and mesh.Order == "2"


def test_large_triangle_surfaces_are_diced_by_both_roads(freecad, meshed):
    solid, surface, mesh = meshed
    _, shape, size = next(row for row in shapes() if row[0] == "crossed holes")
    solid.Shape, surface.Size, surface.Method = shape, size, "subdivided-triangles"
    solid.Document.recompute()
    made = hexcon.mesh_solid(shape, size, surface_method="subdivided-triangles")
    assert surface.Quads > 600 and made.method == mesh.MethodUsed == "diced" and same(mesh, made)
    assert same(mesh, Strategy().of_surface(quad_surface.surface_of(surface)))


def test_a_proposal_lives_in_the_document(freecad, meshed, tmp_path):
    solid, surface, mesh = meshed
    hexes = np.arange(24).reshape(3, 8)
    assert np.array_equal(quad_surface.unpacked(quad_surface.packed(hexes)), hexes)
    inner, again = quad_surface.unpacked(quad_surface.packed((np.eye(3), hexes)))
    assert np.array_equal(inner, np.eye(3)) and np.array_equal(again, hexes)
    assert quad_surface.unpacked(quad_surface.packed(None)) is None and surface.Proposal == ""
    surface.Proposal = quad_surface.packed(hexes)
    assert np.array_equal(quad_surface.surface_of(surface).hexes, hexes)


def test_documents_of_older_versions_open(freecad, meshed, tmp_path):
    """What they do not have is unknown, and nothing is meshed anew."""
    solid, surface, mesh = meshed
    box = mesh.Document.addObject("Part::Box", "Box")
    box.Length = box.Width = box.Height = 2
    surface.Source = box
    mesh.Document.recompute()
    for obj, names in ((surface, ("SizeUsed", "Tried", "Proposal")), (mesh, ("TryOtherSurfaces",))):
        for name in names:
            obj.removeProperty(name)
    path = str(tmp_path / "old.FCStd")
    mesh.Document.saveAs(path)
    document = freecad.openDocument(path)
    try:
        surface, mesh = document.QuadSurface, document.HexMesh
        assert (surface.SizeUsed.Value, surface.Tried, surface.Proposal) == (0.0, -1, "")
        assert not mesh.TryOtherSurfaces
        document.Box.touch()
        document.recompute()
        assert surface.Status == mesh.Status == "Up to date" and surface.Tried == -1
        mesh.TryOtherSurfaces, mesh.Order = True, "2"
        document.recompute()
        assert mesh.Status == "Up to date" and surface.Tried == 0 and surface.SizeUsed.Value == 1.0
        assert hex_mesh.is_hex_mesh(mesh)
    finally:
        freecad.closeDocument(document.Name)


def test_local_sizes_live_in_the_document(freecad, box_in):
    """The call's mesh has them, its surface object keeps them, and a recompute goes the same road."""
    solid = box_in((6, 4, 2))
    with pytest.raises(HexconError, match="WHERE=SIZE"):
        actions.mesh_solid_object(solid, 2.0, local_sizes={"face1": 1.0})
    mesh = actions.mesh_solid_object(solid, 2.0, local_sizes={"Face1": 1.0})
    surface, hexes = mesh.Surface, mesh.Hexes
    assert surface.LocalSizes == ["Face1=1.0"] and hexes > 3 * 2
    assert same(mesh, hexcon.mesh_solid(solid.Shape, 2.0, local_sizes=["Face1=1.0"]))
    surface.LocalSizes = []
    solid.Document.recompute()
    assert mesh.Hexes == 3 * 2 and surface.MethodUsed == "sweep"
    surface.LocalSizes = ["Face1=1.0"]
    solid.Document.recompute()
    assert mesh.Hexes == hexes
