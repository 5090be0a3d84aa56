# SPDX-License-Identifier: LGPL-2.1-or-later
"""The hex mesh as an object of a FreeCAD document."""
from hexcon import freecad_compat
from hexcon.errors import FaultCode, ToolError
from hexcon.topological import PROPERTY, is_topological
from hexcon.window import attach_view

from .convert import to_femmesh

MEANING = "Topology only: some Jacobians are zero or negative; not for solving"
SUFFIX = " (topological)"  # of the label


class HexMesh:
    """Proxy of a hex mesh object. Saved documents name this class: never rename or move it."""

    Type = "HexCon::HexMesh"

    def __init__(self, obj):
        obj.Proxy = self

    def onDocumentRestored(self, obj):
        """Documents of older versions get today's view provider, which knows a double click."""
        view = getattr(obj, "ViewObject", None)
        if view is not None and getattr(view, "Proxy", None) in (None, 0):
            attach_view(obj, "HexMeshView")

    def dumps(self):
        return None

    def loads(self, state):
        return None

    # FreeCAD before 0.21.2 calls the pickle names
    __getstate__ = dumps

    def __setstate__(self, state):
        return None


def add_to_document(doc, mesh, solid_object, name="HexMesh", order=None, *,
                    allow_topological=False):
    """A mesh object linked to its solid; it survives save and reload, groups included.

    doc           an App.Document, which must hold solid_object
    mesh          see convert.to_femmesh;  order, allow_topological: as there
    Returns the document object (Fem::FemMeshObjectPython); one of a topological mesh says so in
    its label and in the property Topological. One undo step; on any error the document is as it
    was. Raises ToolError: FREECAD_MISSING, BAD_MESH, BAD_OPTION, BAD_SHAPE, TOPOLOGICAL_MESH.
    """
    if solid_object is not None and freecad_compat.shape_of(solid_object) is None:
        raise ToolError(f"{getattr(solid_object, 'Label', solid_object)!r} has no shape; "
                        "give the solid the mesh was made from", FaultCode.BAD_SHAPE)
    # may fail: before the document is touched
    femmesh = to_femmesh(mesh, order, allow_topological=allow_topological)
    with freecad_compat.transaction(doc, "Hex mesh"):
        return insert(doc, femmesh, solid_object, name, is_topological(mesh))


def insert(doc, femmesh, solid_object, name, topological=False):
    """add_to_document without checks and transaction; a FemMesh cannot tell what it came from."""
    mesh_object = freecad_compat.add_mesh_object(doc, name, solid_object)
    HexMesh(mesh_object)
    mesh_object.FemMesh = femmesh
    if topological:
        mark_topological(mesh_object)
    view = getattr(mesh_object, "ViewObject", None)
    if view is not None and getattr(view, "Proxy", 0) is None:
        view.Proxy = 0  # FreeCAD's own display; without this a Python object stays hidden
    mesh_object.purgeTouched()
    return mesh_object


def mark_topological(mesh_object, topological=True):
    """A property for programs and a label for people: both are saved with the document.

    False takes both away again, where the object gets another mesh.
    """
    if PROPERTY not in mesh_object.PropertiesList:
        if not topological:
            return
        mesh_object.addProperty("App::PropertyBool", PROPERTY, "HexCon", MEANING)
        mesh_object.setEditorMode(PROPERTY, 1)  # shown, not to be changed by a click
    setattr(mesh_object, PROPERTY, topological)
    plain = mesh_object.Label.replace(SUFFIX, "")
    mesh_object.Label = plain + SUFFIX if topological else plain
