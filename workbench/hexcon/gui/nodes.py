# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coin nodes of what is drawn: faces, lines, balls, from arrays."""
import numpy as np
from pivy import coin

EDGE_COLOUR = (0.16, 0.18, 0.22)
SHADE = np.array([0.74, 0.87, 1.0])  # brightness of faces across x, y, z


def in_object_space(mesh_object):
    """A node that takes points as FemMesh.Nodes gives them, in the document's space, into the object's own,
    which its view provider moves back by the Placement."""
    node = coin.SoMatrixTransform()
    matrix = mesh_object.Placement.inverse().toMatrix()
    columns = np.array(matrix.A).reshape(4, 4).T
    node.matrix = coin.SbMatrix(*columns.ravel().tolist())
    return node


def _set(field, values, kind):
    """A multiple-value field holding exactly these values."""
    values = np.ascontiguousarray(values, kind)
    field.setNum(len(values))
    if len(values):
        field.setValues(0, len(values), values)


def _indices(cells):
    """Rows of equal length, each closed by -1, one after the other."""
    return np.column_stack([cells, np.full(len(cells), -1)]).ravel()


class Faces:
    """Quads, each in one colour, with their edges; node is what to draw.

    widest  pixels of the widest line on them: they step back so far that slanted ones do not hide half of it
    """

    def __init__(self, widest=1):
        self._points, self._colours = coin.SoCoordinate3(), coin.SoMaterial()
        self._faces, self._edges = coin.SoIndexedFaceSet(), coin.SoIndexedLineSet()
        hints, light, binding, back = (coin.SoShapeHints(), coin.SoLightModel(), coin.SoMaterialBinding(),
                                       coin.SoPolygonOffset())
        hints.faceType = coin.SoShapeHints.CONVEX  # else Coin cuts every quad into triangles first
        light.model = coin.SoLightModel.BASE_COLOR  # see _shaded
        binding.value = coin.SoMaterialBinding.PER_FACE
        back.factor, back.units = max(1.0, widest / 2), 1.0
        self.node = _separator(hints, self._points,
                               _separator(light, back, binding, self._colours, self._faces),
                               _separator(*_plain_lines(EDGE_COLOUR, 1), self._edges))
        self._of = None

    def show(self, points, quads, colours, edges):
        """points (p,3), quads (q,4), colours (q,3), edges (e,2)."""
        if points is not self._of:  # while a mesh is cut only the faces change
            _set(self._points.point, points, np.float32)
            self._of = points
        # never indices without their colours
        self._faces.coordIndex.setNum(0)
        _set(self._colours.diffuseColor, _shaded(points, quads, colours), np.float32)
        _set(self._faces.coordIndex, _indices(quads), np.int32)
        _set(self._edges.coordIndex, _indices(edges), np.int32)

    @property
    def count(self):
        """How many quads are drawn."""
        return self._faces.coordIndex.getNum() // 5


def _shaded(points, quads, colours):
    """The colours (q,3) darker by where the quads face, whatever the camera.

    FreeCAD's one lamp, on the viewer's head, would leave slanted faces so dark that the legend says nothing, and
    all sides of a box in the usual view alike.
    """
    normals = np.cross(points[quads[:, 2]] - points[quads[:, 0]], points[quads[:, 3]] - points[quads[:, 1]]) ** 2
    sums = normals.sum(axis=1)
    shade = np.divide(normals @ SHADE, sums, out=np.ones(len(quads)), where=sums > 0)
    return colours * shade[:, None]


def _filled(group, *children):
    for child in children:
        group.addChild(child)
    return group


def _separator(*children):
    return _filled(coin.SoSeparator(), *children)


def _places(points):
    node = coin.SoCoordinate3()
    _set(node.point, points, np.float32)
    return node


def _plain_lines(colour, width):
    """Nodes before lines of one colour, whatever the light."""
    light, binding, base, style = (coin.SoLightModel(), coin.SoMaterialBinding(), coin.SoBaseColor(),
                                   coin.SoDrawStyle())
    light.model = coin.SoLightModel.BASE_COLOR
    binding.value = coin.SoMaterialBinding.OVERALL  # a mesh before it may have a colour a face
    base.rgb = tuple(float(c) for c in colour)
    style.lineWidth = width
    return light, binding, base, style


def polylines(lines, colours, width):
    """A node with lines, each through its places (k,3), and a colour (n,3) for each."""
    drawn, binding, material = coin.SoLineSet(), coin.SoMaterialBinding(), coin.SoMaterial()
    binding.value = coin.SoMaterialBinding.PER_FACE  # of a line set: per line
    _set(material.diffuseColor, colours, np.float32)
    _set(drawn.numVertices, [len(line) for line in lines], np.int32)
    places = np.concatenate(lines) if len(lines) else np.zeros((0, 3))
    return _separator(*_plain_lines(EDGE_COLOUR, width), binding, material, _places(places), drawn)


def underlay():
    """A node for lines under other lines of the same place: those that are drawn later win."""
    depth = coin.SoDepthBuffer()
    depth.write = False
    return _separator(depth)


def balls(places, colour, radius):
    """A node with a ball at each place (k,3)."""
    material, copies, coarse, ball = (coin.SoMaterial(), coin.SoMultipleCopy(), coin.SoComplexity(),
                                      coin.SoSphere())
    material.diffuseColor = material.ambientColor = tuple(float(c) for c in colour)
    coarse.value = 0.35
    ball.radius = float(radius)
    copies.matrix.setNum(len(places))
    for row, place in enumerate(np.asarray(places, float).tolist()):
        matrix = coin.SbMatrix()
        matrix.setTranslate(coin.SbVec3f(*place))
        copies.matrix.set1Value(row, matrix)
    return _separator(material, coarse, _filled(copies, ball))


def edges_on_top(points, edges, colour, width):
    """A node with edges (e,2) between points (p,3), drawn last and hidden by nothing."""
    lines = coin.SoIndexedLineSet()
    _set(lines.coordIndex, _indices(edges), np.int32)
    return _filled(coin.SoAnnotation(), *_plain_lines(colour, width), _places(points), lines)
