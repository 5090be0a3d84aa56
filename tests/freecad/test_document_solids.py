# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which solid of a document is meshed: PartDesign bodies, assemblies, links; what is refused, and by which names.

Each document is made here, saved, and read through a process of its own, as the command line reads it. The box is
10 x 20 x 30 (6000); what is expected is the volume and the lowest corner of the solid, or words of the refusal.
"""
import zipfile

import numpy as np
import pytest

from hexcon.errors import FaultCode, ToolError
from hexcon.files.solid import shape_of_file, solid_as_brep
from hexcon.files.solid_choice import SolidChoice


@pytest.fixture
def app(freecad):
    from hexcon import freecad_compat
    freecad_compat.mod_folders_on_path()
    return freecad_compat.freecad()


def body(doc, name="Body", size=(10, 20, 30), at=(0, 0, 0)):
    made = doc.addObject("PartDesign::Body", name)
    inside = made.newObject("PartDesign::AdditiveBox", name + "Box")
    inside.Length, inside.Width, inside.Height = size
    made.Placement.Base = at
    return made


def box(doc, name="Box", size=(10, 20, 30), at=(0, 0, 0)):
    made = doc.addObject("Part::Box", name)
    made.Length, made.Width, made.Height = size
    made.Placement.Base = at
    return made


def part_with(doc, child, name="Part", at=(0, 0, 0), angle=0):
    import FreeCAD
    part = doc.addObject("App::Part", name)
    part.addObject(child)
    part.Placement = FreeCAD.Placement(FreeCAD.Vector(*at), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), angle))
    return part


def link_to(doc, target, at=(0, 0, 0), name="Link"):
    made = doc.addObject("App::Link", name)
    made.setLink(target)
    made.Placement.Base = at
    return made


def hidden(obj):
    obj.Visibility = False
    return obj


def one_body(doc):
    body(doc)


def body_and_helper(doc):
    body(doc)
    box(doc, "Helper", (5, 5, 5)).Label = "Loose block"


def hidden_helper(doc):
    body(doc)
    hidden(box(doc, "Helper", (5, 5, 5)))


def moved_part(doc):
    part_with(doc, body(doc), at=(100, 0, 0), angle=90)


def nested_parts(doc):
    group = doc.addObject("App::DocumentObjectGroup", "Group")
    group.addObject(box(doc, at=(0, 0, 3)))
    part_with(doc, part_with(doc, group, "Inner", (0, 2, 0)), "Outer", (1, 0, 0))


def boolean_of_bodies(doc):
    cut = body(doc).newObject("PartDesign::Boolean", "Boolean")
    cut.Type = "Cut"
    cut.setObjects([body(doc, "Tool", (5, 5, 5))])


def hole_in_body(doc):
    hole = body(doc).newObject("PartDesign::SubtractiveBox", "Hole")
    hole.Length = hole.Width = hole.Height = 5


def base_feature(doc):
    made = doc.addObject("PartDesign::Body", "Body")
    made.BaseFeature = box(doc)
    hole = made.newObject("PartDesign::SubtractiveBox", "Hole")
    hole.Length = hole.Width = hole.Height = 5


def two_bodies(doc):
    body(doc, "B1").Label = "Housing"
    body(doc, "B2", (5, 5, 5), (50, 0, 0))


def body_and_link(doc):
    link_to(doc, body(doc), (50, 0, 0))


def link_alone(doc):
    link_to(doc, hidden(body(doc)), (50, 0, 0))


def link_to_part(doc):
    link_to(doc, hidden(part_with(doc, body(doc))), (7, 0, 0))


def binder(doc):
    made = doc.addObject("PartDesign::SubShapeBinder", "Binder")
    made.Support = [(body(doc), ("",))]


def cut(doc):
    made = doc.addObject("Part::Cut", "Cut")
    made.Base, made.Tool = box(doc), box(doc, "Tool", (5, 5, 5))


def attached(doc):
    """A box that stands on a face of another one: it is not made from it."""
    base = box(doc)
    made = box(doc, "Upper", (5, 5, 5))
    support = "AttachmentSupport" if hasattr(made, "AttachmentSupport") else "Support"    # 1.0 renamed it
    setattr(made, support, [(base, ("Face6",))])
    made.MapMode = "FlatFace"
    base.Visibility = True


def compound(doc):
    made = doc.addObject("Part::Compound", "Compound")
    made.Links = [box(doc), box(doc, "Second", (5, 5, 5), (50, 0, 0))]


def mirrored(doc):
    import FreeCAD
    made = doc.addObject("Part::Mirroring", "Mirror")
    made.Source, made.Base, made.Normal = box(doc), FreeCAD.Vector(-5, 0, 0), FreeCAD.Vector(1, 0, 0)


def clone_of_body(doc):
    """As PartDesign's Clone makes it: another body, whose first feature is the body."""
    first, other = body(doc), doc.addObject("PartDesign::Body", "Other")
    other.newObject("PartDesign::FeatureBase", "Clone").BaseFeature = first
    other.Placement.Base = (50, 0, 0)


def group_of_links(doc):
    made = doc.addObject("App::LinkGroup", "Group")
    made.ElementList = [box(doc)]
    made.Placement.Base = (50, 0, 0)


def empty(doc):
    doc.addObject("PartDesign::Body", "Body")


BOX = (6000, (0, 0, 0))
RIGHT = {
    one_body: BOX, hidden_helper: BOX, moved_part: (6000, (80, 0, 0)), nested_parts: (6000, (1, 2, 3)),
    boolean_of_bodies: (5875, (0, 0, 0)), hole_in_body: (5875, (0, 0, 0)), base_feature: (5875, (0, 0, 0)),
    link_alone: (6000, (50, 0, 0)), link_to_part: (6000, (7, 0, 0)), binder: BOX, cut: (5875, (0, 0, 0)),
    body_and_helper: ("2 solids count in it (1 Body; 2 Helper (Loose block))", "--object"),
    two_bodies: ("1 B1 (Housing); 2 B2", "--solid"), body_and_link: ("1 Body; 2 Link", "--object"),
    attached: ("1 Box; 2 Upper", "--object"), compound: ("1 Compound, solid 1 of 2; 2 Compound, solid 2 of 2",
                                                         "--solid"),
    clone_of_body: ("1 Body; 2 Other", "--object"), group_of_links: (6000, (50, 0, 0)),
    mirrored: ("2 solids", "Box", "Mirror"), empty: ("0 solids count in it (none)", "Body: recompute")}


def saved(app, make, path):
    doc = app.newDocument("Made", hidden=True)
    try:
        make(doc)
        doc.recompute()
        doc.saveCopy(str(path))
    finally:
        app.closeDocument(doc.Name)
    return str(path)


def found_in(choice):
    shape = shape_of_file(choice)
    low = shape.BoundBox
    return shape.Volume, (low.XMin, low.YMin, low.ZMin)


@pytest.mark.parametrize("make", RIGHT, ids=lambda make: make.__name__)
def test_the_solid_that_counts(app, tmp_path, make):
    path, right = saved(app, make, tmp_path / "part.FCStd"), RIGHT[make]
    if isinstance(right[0], str):
        with pytest.raises(ToolError) as caught:
            solid_as_brep(path, tmp_path / "solid.brep")
        assert caught.value.code is FaultCode.BAD_SHAPE and all(words in str(caught.value) for words in right)
        return
    volume, low = found_in(path)
    assert np.isclose(volume, right[0]) and np.allclose(low, right[1], atol=1e-6)


@pytest.mark.parametrize("make, chosen, right", [
    (body_and_helper, {"object_name": "Body"}, BOX), (body_and_helper, {"object_name": "Loose block"}, (125, (0, 0,
        0))),
    (body_and_helper, {"number": 2}, (125, (0, 0, 0))), (hole_in_body, {"object_name": "BodyBox"}, BOX),
    (hidden_helper, {"object_name": "Helper"}, (125, (0, 0, 0))), (moved_part, {"object_name": "Part"}, (6000, (80, 0,
        0))),
    (moved_part, {"object_name": "BodyBox"}, (6000, (80, 0, 0))),
    (one_body, {"scale": 1000.0}, (6e12, (0, 0, 0)))])
def test_a_solid_is_chosen(app, tmp_path, make, chosen, right):
    path = saved(app, make, tmp_path / "part.FCStd")
    volume, low = found_in(SolidChoice(path, **chosen))
    assert np.isclose(volume, right[0]) and np.allclose(low, right[1], atol=1e-6)


def test_a_chosen_solid_of_a_compound_alone(app, tmp_path):
    import Part
    path = saved(app, compound, tmp_path / "part.FCStd")
    numbers, notes = solid_as_brep(SolidChoice(path, number=2), tmp_path / "solid.brep")
    assert np.isclose(Part.read(str(tmp_path / "solid.brep")).Volume, 125)
    assert numbers.tolist() == [7, 8, 9, 10, 11, 12] and "solid 2 of 2" in notes[0]


@pytest.mark.parametrize("chosen", [{"object_name": "Nobody"}, {"number": 3}, {"number": 0}])
def test_what_cannot_be_chosen(app, tmp_path, chosen):
    path = saved(app, two_bodies, tmp_path / "part.FCStd")
    with pytest.raises(ToolError) as caught:
        solid_as_brep(SolidChoice(path, **chosen), tmp_path / "solid.brep")
    assert caught.value.code is FaultCode.BAD_OPTION and "B1" in str(caught.value)


def test_nothing_is_dropped_in_silence(app, tmp_path):
    """An object of a type that this FreeCAD does not know may be a solid: the other one is not meshed without it."""
    path, renamed = saved(app, body_and_helper, tmp_path / "part.FCStd"), tmp_path / "later.FCStd"
    with zipfile.ZipFile(path) as old, zipfile.ZipFile(renamed, "w", zipfile.ZIP_DEFLATED) as new:
        for entry in old.infolist():
            new.writestr(entry.filename, old.read(entry).replace(b'type="PartDesign::Body"',
            b'type="PartDesign::Later"'))
    with pytest.raises(ToolError, match="Body \\(PartDesign::Later\\)") as caught:
        solid_as_brep(renamed, tmp_path / "solid.brep")
    assert caught.value.code is FaultCode.FREECAD_MISSING


def test_iges_is_sewn(app, tmp_path):
    import Part
    Part.makeBox(10, 20, 30).exportIges(str(tmp_path / "box.igs"))
    _, notes = solid_as_brep(tmp_path / "box.igs", tmp_path / "solid.brep")
    assert np.isclose(Part.read(str(tmp_path / "solid.brep")).Volume, 6000) and "sewn" in notes[0]
    Part.makeShell(Part.makeBox(10, 20, 30).Faces[:5]).exportIges(str(tmp_path / "open.iges"))
    with pytest.raises(ToolError, match="do not close") as caught:
        solid_as_brep(tmp_path / "open.iges", tmp_path / "solid.brep")
    assert caught.value.code is FaultCode.BAD_SHAPE


def test_a_model_in_metres_is_told_and_scaled(app, tmp_path):
    import Part

    from hexcon.quads import surface_from_solid
    Part.makeBox(0.01, 0.02, 0.03).exportBrep(str(tmp_path / "small.brep"))
    made = surface_from_solid(tmp_path / "small.brep", 0.01)
    assert any("--scale 1000" in note for note in made.notes)
    made = surface_from_solid(SolidChoice(str(tmp_path / "small.brep"), scale=1000.0), 10.0)
    assert np.allclose(np.ptp(made.points, axis=0), (10, 20, 30)) and any("by 1000" in note for note in made.notes)
