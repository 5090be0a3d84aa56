# SPDX-License-Identifier: LGPL-2.1-or-later
"""The solids that count in a FreeCAD document, each at its place in the whole, and whether FreeCAD opened all of it.

Counted are solids of bodies, Part features, compounds and links, at the places that the App::Parts around them give;
not what another one is made from (the tools of a cut, the features of a body), nor copies for reference (binders).
Hidden ones count where nothing else does. Runs where FreeCAD's modules are.
"""
import xml.etree.ElementTree as ElementTree
import zipfile
from dataclasses import dataclass

from hexcon.errors import FaultCode, ToolError
from hexcon.freecad_compat import freecad, freecad_module, shape_in_whole

# Links of these names use an object up; others (supports, paths, "up to" faces, expressions) only look at it.
_USES_UP = ("Base", "Tool", "Tools", "Shapes", "Links", "Source", "Sources", "Objects", "BaseFeature", "Profile",
            "Sections", "Additions", "Subtractions", "Shape1", "Shape2")
_REFERENCES = ("PartDesign::ShapeBinder", "PartDesign::SubShapeBinder")
_LOOKS_ONLY = ("Part::Mirroring", *_REFERENCES)     # what these look at stays a solid of its own
_LINKS = ("App::Link", "App::LinkPython", "App::LinkElement", "App::LinkGroup")
_LISTED = 20    # solids, in words


@dataclass
class Place:
    """An object's shape where it is in the whole: words is its name, with the containers around it."""

    words: str
    object: object
    shape: object
    shown: bool


def choose(document, choice):
    """(Place, row of the solid in its shape.Solids, notes) of the one that a SolidChoice means.

    Raises ToolError BAD_SHAPE (none, several: listed), BAD_OPTION (no such object, no such number)."""
    places, notes = _counted(document) if choice.object_name is None else (_of_object(document, choice.object_name), [])
    solids = [(place, row) for place in places for row in range(len(place.shape.Solids))]
    if choice.number is not None and not 1 <= choice.number <= len(solids):
        raise ToolError(f"there is no solid {choice.number}; there are {len(solids)}{_list_of(solids)}",
                        FaultCode.BAD_OPTION)
    if choice.number is None and len(solids) != 1:
        raise ToolError(f"{len(solids)} solids count in it{_list_of(solids)}{_empty(document)}; exactly one is needed"
                        + (": choose it by --object NAME or --solid N" if solids else ""), FaultCode.BAD_SHAPE)
    place, row = solids[(choice.number or 1) - 1]
    return place, row, [f"solid {_words(place, row)} of the document", *notes]


def _words(place, row):
    label = "" if place.object.Label == place.object.Name else f" ({place.object.Label})"
    number = f", solid {row + 1} of {len(place.shape.Solids)}" if len(place.shape.Solids) > 1 else ""
    return f"{place.words}{label}{number}"


def _list_of(solids):
    if not solids:
        return " (none)"
    told = "; ".join(f"{n} {_words(*one)}" for n, one in enumerate(solids[:_LISTED], 1))
    return f" ({told}{'; ...' if len(solids) > _LISTED else ''})"


def _empty(document):
    """Words about objects that have no shape, which may be why there is no solid."""
    names = [o.Name for o in document.Objects if _broken(o) or _own_shape(o) is not None and _own_shape(o).isNull()]
    return f"; no shape have {', '.join(names[:_LISTED])}: recompute and save the document" if names else ""


def _broken(obj):
    return obj.TypeId in _LINKS and hasattr(obj, "LinkedObject") and obj.LinkedObject is None


def _own_shape(obj):
    """The shape that an object has as a property, or None; FreeCAD makes one up for containers, too."""
    shape = obj.Shape if "Shape" in obj.PropertiesList else None
    return shape if hasattr(shape, "Solids") else None


def _has_solids(obj):
    shape = _own_shape(obj)
    return shape is not None and not shape.isNull() and bool(shape.Solids)


def _counted(document):
    """(places that count, notes)."""
    places = [p for p in _all_places(document) if not _is_used_up(p.object) and p.object.TypeId not in _REFERENCES]
    shown = [p for p in places if p.shown]
    if not shown or len(shown) == len(places):
        return places, []
    hidden = [p.words for p in places if not p.shown]
    return shown, [f"hidden, and not meshed: {', '.join(hidden[:_LISTED])}"]


def _of_object(document, name):
    """Places of the object of that name, or else label, or of what is in it."""
    named = [o for o in document.Objects if o.Name == name] or [o for o in document.Objects if o.Label == name]
    if len(named) != 1:
        known = ", ".join(o.Name for o in document.Objects if _has_solids(o))
        found = f"{len(named)} objects have the label {name!r}" if named else f"there is no object {name!r}"
        raise ToolError(f"{found}; solids have {known or 'none'}", FaultCode.BAD_OPTION)
    obj, = named
    inside = [p for p in _all_places(document) if obj.Name in p.words.split(".") and p.object.TypeId not in _REFERENCES]
    if len(inside) > 1:
        inside = [p for p in inside if p.object is obj or not _is_used_up(p.object)]
    if not inside and _has_solids(obj):   # a feature of a body, say
        inside = [Place(obj.Name, obj, shape_in_whole(obj), True)]
    return inside


def _all_places(document):
    placement = freecad().Placement()
    found = []
    for obj in document.Objects:
        if obj.getParentGroup() is None and obj.getParentGeoFeatureGroup() is None and not _is_element(obj):
            found += _places_in(obj, placement, True, ())
    return found


def _is_element(obj):
    """An element of a link that shows its elements one by one, or of a group of links: that one holds it."""
    return any(user.TypeId == "App::LinkGroup" and obj in user.ElementList
               or obj.TypeId == "App::LinkElement" and user.TypeId in _LINKS for user in obj.InList)


def _places_in(obj, placement, shown, path):
    """Places of an object, or of all that a container holds; path: names of the containers around it."""
    shown, path = shown and bool(obj.Visibility), (*path, obj.Name)
    if _is_container(obj):
        inner = placement * obj.Placement if hasattr(obj, "Placement") else placement
        held, seen = [], set()
        for child in obj.Group:
            parent = child.getParentGroup()
            if child.Name in seen or child.Name in path or (parent is not None and parent is not obj):
                continue    # an App::Part lists what its groups hold, too
            seen.add(child.Name)
            held += _places_in(child, inner, shown, path)
        return held
    is_link = obj.TypeId in _LINKS
    shape = freecad_module("Part").getShape(obj, transform=True) if is_link else _own_shape(obj)
    if shape is None or shape.isNull() or not shape.Solids:
        return []
    return [Place(".".join(path), obj, _moved(shape, placement), shown)]


def _is_container(obj):
    """Groups and App::Parts, which have no shape of their own; not bodies."""
    return obj.TypeId not in _LINKS and isinstance(getattr(obj, "Group", None), (list, tuple)) \
        and "Shape" not in obj.PropertiesList


def _moved(shape, placement):
    if placement.isIdentity():
        return shape.copy()
    moved = shape.copy()
    moved.Placement = placement * moved.Placement
    return moved


def _is_used_up(obj):
    """Whether another solid is made from this one."""
    return any(_uses_up(user, obj) for user in obj.InList)


def _uses_up(user, obj):
    if not _has_solids(user) or user.TypeId in _LINKS or user.TypeId in _LOOKS_ONLY or _is_clone(user, obj):
        return False
    return any(_links_to(getattr(user, name), obj) for name in _USES_UP if name in user.PropertiesList)


def _is_clone(user, obj):
    """A copy beside which the object stays: a clone of Draft, or of PartDesign, a body that begins with another one."""
    of_body = obj.TypeId == "PartDesign::Body" and user.TypeId in ("PartDesign::FeatureBase", "PartDesign::Body")
    return of_body or {"Objects", "Scale", "Fuse"} <= set(user.PropertiesList)


def _links_to(value, obj):
    """Whether a link's value, (object, parts) or lists of such, names the object."""
    if isinstance(value, (list, tuple)):
        return any(_links_to(entry, obj) for entry in value)
    return getattr(value, "Name", None) == obj.Name and getattr(value, "Document", None) is obj.Document


# ------------------------------------------------------------------------------ is all of it there?

def refuse_dropped(path, document):
    """Raise ToolError FREECAD_MISSING where FreeCAD left out objects that may be, or move, solids.

    It leaves out objects of types that it does not know, says so on its console only, and the rest looks whole."""
    there = {o.Name for o in document.Objects}
    dropped = [(name, kind) for name, kind, matters in _objects_in_file(path) if matters and name not in there]
    if dropped:
        told = ", ".join(f"{name} ({kind})" for name, kind in dropped[:_LISTED])
        raise ToolError(f"FreeCAD {'.'.join(freecad().Version()[:2])} did not open {len(dropped)} objects of it, "
                        f"{told}; they "
                        "may be solids, so the others are not meshed. Open it in the FreeCAD that made it and "
                        "export the solid as STEP", FaultCode.FREECAD_MISSING)


def _objects_in_file(path):
    """(name, type, whether it has a shape or a placement) of the objects that a document lists."""
    with zipfile.ZipFile(path) as archive, archive.open("Document.xml") as stream:
        root = ElementTree.parse(stream).getroot()
    kinds = {o.get("name"): o.get("type") for o in root.iterfind("Objects/Object")}
    for data in root.iterfind("ObjectData/Object"):
        held = {p.get("type") for p in data.iterfind("Properties/Property")}
        matters = bool(held & {"Part::PropertyPartShape", "App::PropertyPlacement"})
        yield data.get("name"), kinds.get(data.get("name"), "?"), matters
