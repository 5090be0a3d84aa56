# SPDX-License-Identifier: LGPL-2.1-or-later
"""A legend in the 3D view: a bar of colours with figures, which stands still whatever the camera does."""
import numpy as np
from pivy import coin
from PySide import QtGui

# In the view's own measures: -1 to 1 from left to right and from below to above.
LEFT, BAR_LEFT, BAR_RIGHT, RIGHT = -0.98, -0.965, -0.93, -0.73
BOTTOM, FOOT, BAR_BOTTOM, BAR_TOP, TITLE, TOP = -0.57, -0.54, -0.45, 0.4, 0.46, 0.53
LETTERS = 11  # points
LIGHT_CARD = (0.96, 0.96, 0.96), (0.1, 0.11, 0.13)  # paper, ink
DARK_CARD = (0.13, 0.14, 0.16), (0.92, 0.92, 0.92)


def legend(title, colours, figures, foot=""):
    """A node with the colours (k,3) one over the other, alike high.

    figures  [(height, words)] beside the bar, height 0 (foot) to 1 (top);  foot: a line below the bar
    The card is dark where FreeCAD's theme is.
    """
    paper, ink = DARK_CARD if _theme_is_dark() else LIGHT_CARD
    bar = coin.SoAnnotation()  # after everything else, over it
    for node in (coin.SoResetTransform(), _camera(), _base_colours(),
                 _rectangles([LEFT], [RIGHT], [BOTTOM], [TOP], [paper])):
        bar.addChild(node)
    heights = np.linspace(BAR_BOTTOM, BAR_TOP, len(colours) + 1)
    bar.addChild(_rectangles([BAR_LEFT] * len(colours), [BAR_RIGHT] * len(colours), heights[:-1], heights[1:], colours))
    for height, text in figures:
        bar.addChild(_words(text, BAR_RIGHT + 0.015, BAR_BOTTOM + height * (BAR_TOP - BAR_BOTTOM) - 0.012, ink))
    for text, bottom in ((title, TITLE), (foot, FOOT)):
        if text:
            bar.addChild(_words(text, BAR_LEFT, bottom, ink))
    return _out_of_bounds(bar)


def _theme_is_dark():
    return QtGui.QApplication.palette().color(QtGui.QPalette.Window).lightness() < 128


def _camera():
    camera = coin.SoOrthographicCamera()
    camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
    camera.aspectRatio, camera.height = 1.0, 2.0
    camera.position = (0.0, 0.0, 1.0)
    camera.nearDistance, camera.farDistance = 0.5, 1.5
    return camera


def _base_colours():
    light = coin.SoLightModel()
    light.model = coin.SoLightModel.BASE_COLOR
    return light


def _rectangles(left, right, bottom, top, colours):
    """A node with upright rectangles, each in its colour."""
    corners = np.array([[(x, b), (r, b), (r, t), (x, t)] for x, r, b, t in zip(left, right, bottom, top)])
    places, material, binding, faces = (coin.SoCoordinate3(), coin.SoMaterial(), coin.SoMaterialBinding(),
                                        coin.SoFaceSet())
    points = np.column_stack([corners.reshape(-1, 2), np.zeros(4 * len(corners))])
    places.point.setValues(0, len(points), points.tolist())
    material.diffuseColor.setValues(0, len(corners), np.asarray(colours, float).tolist())
    binding.value = coin.SoMaterialBinding.PER_FACE
    faces.numVertices.setValues(0, len(corners), [4] * len(corners))
    group = coin.SoSeparator()
    for node in (places, material, binding, faces):
        group.addChild(node)
    return group


def _words(text, left, bottom, ink):
    group, place, colour, font, words = (coin.SoSeparator(), coin.SoTranslation(), coin.SoBaseColor(), coin.SoFont(),
                                         coin.SoText2())
    place.translation = (left, bottom, 0.0)
    colour.rgb = ink
    font.size = LETTERS
    words.string = text
    for node in (place, colour, font, words):
        group.addChild(node)
    return group


def _out_of_bounds(node):
    """The node where "fit all" does not see it: FreeCAD's own kind of group, which has no class in Python."""
    group = coin.SoType.fromName("SoSkipBoundingGroup").createInstance()
    if group is None:
        return node
    group = coin.cast(group, "SoGroup")
    group.addChild(node)
    return group
