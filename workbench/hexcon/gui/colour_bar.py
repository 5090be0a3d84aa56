# SPDX-License-Identifier: LGPL-2.1-or-later
"""The legend of the scaled Jacobians in the 3D view: a bar that stands still whatever the camera does."""
import FreeCAD
import numpy as np
from pivy import coin

from hexcon.pictures.palette import quality_colours

translate = FreeCAD.Qt.translate

# In the view's own measures: -1 to 1 from left to right and from below to above.
LEFT, BAR_LEFT, BAR_RIGHT, RIGHT = -0.98, -0.965, -0.93, -0.73
BOTTOM, BAR_BOTTOM, BAR_TOP, TITLE, TOP = -0.5, -0.45, 0.4, 0.46, 0.53
STRIPS = 64
TICK = 0.25
PAPER, INK = (0.96, 0.96, 0.96), (0.1, 0.11, 0.13)
LETTERS = 11  # points


def colour_bar(lowest):
    """A node with the colours from 0, or from the lowest scaled Jacobian where that is below, to 1."""
    low = min(0.0, float(np.floor(lowest / TICK) * TICK))
    bar = coin.SoAnnotation()  # after everything else, over it
    paper = _rectangles([LEFT], [RIGHT], [BOTTOM], [TOP], [PAPER])
    for node in (coin.SoResetTransform(), _camera(), _base_colours(), paper):
        bar.addChild(node)
    limits = np.linspace(low, 1.0, STRIPS + 1)
    heights = _height(limits, low)
    bar.addChild(_rectangles([BAR_LEFT] * STRIPS, [BAR_RIGHT] * STRIPS, heights[:-1], heights[1:],
                             quality_colours((limits[1:] + limits[:-1]) / 2)))
    for value in np.arange(round(low / TICK), round(1 / TICK) + 1) * TICK:
        bar.addChild(_words(f"{value:.2f}".rstrip("0").rstrip("."), BAR_RIGHT + 0.015, _height(value, low) - 0.012))
    bar.addChild(_words(translate("HexCon", "scaled Jacobian"), BAR_LEFT, TITLE))
    return _out_of_bounds(bar)


def _height(value, low):
    return BAR_BOTTOM + (value - low) / (1.0 - low) * (BAR_TOP - BAR_BOTTOM)


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


def _words(text, left, bottom):
    group, place, colour, font, words = (coin.SoSeparator(), coin.SoTranslation(), coin.SoBaseColor(), coin.SoFont(),
                                         coin.SoText2())
    place.translation = (left, bottom, 0.0)
    colour.rgb = INK
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
