# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quads drawn into the 3D view over the document: a preview, the quads at fault, or faces that were chosen."""
import FreeCADGui
import numpy as np
from pivy import coin

FILL, EDGE, FAULT = (0.95, 0.76, 0.31), (0.11, 0.17, 0.23), (0.9, 0.1, 0.1)
FAULT_EDGE = (0.4, 0.0, 0.0)
NODE = "HexConOverlay"
LINE_WIDTH, PATH_WIDTH = 2, 5


class Overlay:
    """Quads in one view of a document; nothing of it is saved or undone.

    document_name  FreeCAD's name of the document whose 3D view shows them
    """

    def __init__(self, document_name):
        self._document_name = document_name
        self._view = self._node = None

    def show(self, points, quads, faulty=()):
        """Draw quads (n,4) of points (V,3), those whose rows are in faulty red, instead of what
        is drawn. With faulty ones they alone are drawn, their edges over everything else."""
        self.hide()
        view = _view_of(self._document_name)
        if view is None or not len(quads):
            return
        faulty = np.asarray(sorted({row for row in faulty if 0 <= row < len(quads)}), int)
        node = coin.SoSeparator()
        node.setName(NODE)
        style = coin.SoPickStyle()
        style.style = coin.SoPickStyle.UNPICKABLE  # what lies behind is what is clicked
        node.addChild(style)
        places = coin.SoCoordinate3()
        places.point.setValues(0, len(points), np.asarray(points, float).tolist())
        node.addChild(places)
        drawn = quads[faulty] if len(faulty) else quads
        node.addChild(_faces(drawn, FAULT if len(faulty) else FILL))
        node.addChild(_lines(drawn, FAULT_EDGE if len(faulty) else EDGE, bool(len(faulty))))
        view.getSceneGraph().addChild(node)
        self._view, self._node = view, node

    def show_coloured(self, parts):
        """Draw polygons in colours of their own, instead of what is drawn.

        parts  [(colour (r, g, b), points (V,3), polygons (n,3|4)), ...]; those without polygons are left out
        """
        self.hide()
        view = _view_of(self._document_name)
        parts = [part for part in parts if len(part[2])]
        if view is None or not parts:
            return
        node = coin.SoSeparator()
        node.setName(NODE)
        style = coin.SoPickStyle()
        style.style = coin.SoPickStyle.UNPICKABLE
        node.addChild(style)
        for colour, points, polygons in parts:
            group, places = coin.SoSeparator(), coin.SoCoordinate3()
            places.point.setValues(0, len(points), np.asarray(points, float).tolist())
            group.addChild(places)
            group.addChild(_faces(np.asarray(polygons), colour))
            node.addChild(group)
        view.getSceneGraph().addChild(node)
        self._view, self._node = view, node

    def show_path(self, points, edges):
        """Draw edges (k,2) between points (V,3) in red over everything, instead of what is drawn."""
        self.hide()
        view = _view_of(self._document_name)
        if view is None or not len(edges):
            return
        self._view, self._node = view, _path(points, edges)
        view.getSceneGraph().addChild(self._node)

    def hide(self):
        """Draw nothing. The view may be gone by now, and the node with it."""
        if self._node is not None:
            try:
                self._view.getSceneGraph().removeChild(self._node)
            except RuntimeError:
                pass
        self._view = self._node = None

    def visible(self):
        return self._node is not None


def _path(points, edges):
    node, style, places, lines = coin.SoAnnotation(), coin.SoPickStyle(), coin.SoCoordinate3(), coin.SoIndexedLineSet()
    width = coin.SoDrawStyle()
    node.setName(NODE)
    style.style = coin.SoPickStyle.UNPICKABLE
    width.lineWidth = PATH_WIDTH
    places.point.setValues(0, len(points), np.asarray(points, float).tolist())
    indices = np.hstack([edges, np.full((len(edges), 1), -1)]).ravel().tolist()
    lines.coordIndex.setValues(0, len(indices), indices)
    for child in (style, places, _coloured(FAULT, width, lines)):
        node.addChild(child)
    return node


def _view_of(document_name):
    document = FreeCADGui.getDocument(document_name)
    views = document.mdiViewsOfType("Gui::View3DInventor") if document else []
    return views[0] if views else None


def _coloured(colour, *children):
    """A group of its own colour, without light, as the quads' sense may be what is wrong."""
    group, light, base, binding = (coin.SoSeparator(), coin.SoLightModel(), coin.SoBaseColor(),
                                   coin.SoMaterialBinding())
    light.model = coin.SoLightModel.BASE_COLOR
    binding.value = coin.SoMaterialBinding.OVERALL
    base.rgb = colour
    for child in (light, binding, base, *children):
        group.addChild(child)
    return group


def _faces(quads, colour, style=coin.SoDrawStyle.FILLED, towards_eye=4.0):
    """The quads filled, or their edges; a little towards the eye, before the faces they lie on."""
    faces, offset, drawn = coin.SoIndexedFaceSet(), coin.SoPolygonOffset(), coin.SoDrawStyle()
    # no factor: it grows with the slope, and walls seen edge-on would shine through what hides them
    offset.factor, offset.units = 0.0, -towards_eye
    offset.styles = coin.SoPolygonOffset.FILLED | coin.SoPolygonOffset.LINES
    drawn.style, drawn.lineWidth = style, LINE_WIDTH
    indices = np.hstack([quads, np.full((len(quads), 1), -1)]).ravel().tolist()
    faces.coordIndex.setValues(0, len(indices), indices)
    return _coloured(colour, offset, drawn, faces)


def _lines(quads, colour, on_top):
    """The quads' edges; on top of everything, or hidden by what lies before them."""
    edges = _faces(quads, colour, coin.SoDrawStyle.LINES, 12.0)
    if not on_top:
        return edges
    over = coin.SoAnnotation()
    over.addChild(edges)
    return over
