# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of the selection a command takes: one object of its kind, or None."""
import FreeCADGui


def _selected():
    """(object, names of its selected parts) if exactly one object is selected, else (None, ())."""
    selection = FreeCADGui.Selection.getSelectionEx()
    if len(selection) != 1 or selection[0].Object is None:
        return None, ()
    return selection[0].Object, selection[0].SubElementNames


def _finished_body(feature):
    """The PartDesign body whose result this feature is, or the object itself."""
    parent = feature.getParentGeoFeatureGroup()
    is_tip = getattr(parent, "Tip", None) == feature
    return parent if is_tip and parent.isDerivedFrom("PartDesign::Body") else feature


def selected_solid():
    """The one selected object with exactly one solid (or one face of it is selected), or None."""
    found, parts = _selected()
    if found is None or len(parts) > 1 or not all(part.startswith("Face") for part in parts):
        return None
    found = _finished_body(found)
    solids = getattr(getattr(found, "Shape", None), "Solids", ())
    return found if len(solids) == 1 else None


def selected_hex_mesh():
    """The one selected FEM mesh object that holds hexes, or None."""
    found, _ = _selected()
    if found is None or not found.isDerivedFrom("Fem::FemMeshObject"):
        return None
    return found if found.FemMesh.HexaCount else None


def selected_quads():
    """The one selected FEM mesh object that has quads, if only on the outside of its hexes, or None."""
    found, _ = _selected()
    if found is None or not found.isDerivedFrom("Fem::FemMeshObject"):
        return None
    return found if found.FemMesh.QuadrangleCount or found.FemMesh.HexaCount else None


def selected_mesh_source():
    """The one selected object to take quads from: a solid, or a FEM mesh."""
    found, _ = _selected()
    if found is not None and found.isDerivedFrom("Fem::FemMeshObject"):
        return None if _has(found, "SelfCrossings") else found
    return selected_solid()


def _has(thing, name):
    """Whether the object has this property, which tells our kinds apart without the core."""
    return thing is not None and name in thing.PropertiesList


def selected_quad_surface():
    """The one selected quad surface object, or None."""
    found, _ = _selected()
    return found if _has(found, "SelfCrossings") else None


def is_ours(thing):
    """Whether an object has a view provider of HexCon, which tells its own menu."""
    return _has(thing, "MadeFrom")
