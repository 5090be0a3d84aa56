# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hexes shown in red in the 3D view."""
from pivy import coin

from hexcon.femmesh.hexahedron import EDGES

RED = (0.9, 0.1, 0.1)
NODE = "HexConMarked"
LINE_WIDTH = 3


def mark(mesh_object, elements):
    """Colour the faces of these elements, and draw their edges over everything else.

    FreeCAD colours outer faces only, so what lies inside would stay unseen without the edges.
    """
    view = mesh_object.ViewObject
    view.ElementColor = _colours(mesh_object, elements) if elements else {}
    root = view.RootNode
    old = [child for child in root.getChildren() or () if child.getName() == NODE]
    for child in old:
        root.removeChild(child)
    if elements:
        root.addChild(_edges(mesh_object.FemMesh, elements))


def _colours(mesh_object, elements):
    """A colour for every element: those that get none FreeCAD paints green."""
    colours = dict.fromkeys(mesh_object.FemMesh.Volumes, mesh_object.ViewObject.ShapeColor[:3])
    colours.update(dict.fromkeys(elements, RED))
    return colours


def _edges(femmesh, elements):
    """A node with the edges of the elements; SoAnnotation is drawn last and hidden by nothing."""
    places, lines = [], []
    for element in elements:
        first = len(places)
        # FreeCAD's order of corners mirrors VTK's, which keeps the edges
        places += [tuple(femmesh.getNodeById(n)) for n in femmesh.getElementNodes(element)[:8]]
        for a, b in EDGES.tolist():
            lines += [first + a, first + b, -1]
    node, colour, style = coin.SoAnnotation(), coin.SoBaseColor(), coin.SoDrawStyle()
    points, edges, light = coin.SoCoordinate3(), coin.SoIndexedLineSet(), coin.SoLightModel()
    binding = coin.SoMaterialBinding()
    node.setName(NODE)
    light.model = coin.SoLightModel.BASE_COLOR
    binding.value = coin.SoMaterialBinding.OVERALL  # the mesh before it has a colour a face
    colour.rgb = RED
    style.lineWidth = LINE_WIDTH
    points.point.setValues(0, len(places), places)
    edges.coordIndex.setValues(0, len(lines), lines)
    for child in (light, binding, colour, style, points, edges):
        node.addChild(child)
    return node
