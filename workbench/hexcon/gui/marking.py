# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hexes shown in red in the 3D view."""
import numpy as np
from pivy import coin

from hexcon.femmesh.hexahedron import EDGES

from .nodes import edges_on_top, in_object_space

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
        root.addChild(_edges(mesh_object, elements))


def _colours(mesh_object, elements):
    """A colour for every element: those that get none FreeCAD paints green."""
    colours = dict.fromkeys(mesh_object.FemMesh.Volumes, mesh_object.ViewObject.ShapeColor[:3])
    colours.update(dict.fromkeys(elements, RED))
    return colours


def _edges(mesh_object, elements):
    """A node with the edges of the elements, seen through everything."""
    femmesh = mesh_object.FemMesh
    # FreeCAD's order of corners mirrors VTK's, which keeps the edges
    places = [tuple(femmesh.getNodeById(n)) for element in elements
              for n in femmesh.getElementNodes(element)[:8]]
    edges = (8 * np.arange(len(elements))[:, None, None] + EDGES).reshape(-1, 2)
    node = coin.SoSeparator()
    node.setName(NODE)
    node.addChild(in_object_space(mesh_object))
    node.addChild(edges_on_top(np.array(places), edges, RED, LINE_WIDTH))
    return node
