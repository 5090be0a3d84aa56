# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the user looks from, and what at."""
import FreeCADGui
import numpy as np
from pivy import coin


def look_at(document, places, around=6.0):
    """Move the camera, its direction kept, until the places (k,3) lie in the middle of the view.

    around  what is seen, times the size of the places. Nothing where the active view is not a 3D one.
    """
    view = FreeCADGui.getDocument(document.Name).ActiveView
    if not hasattr(view, "getCameraNode"):
        return
    camera = view.getCameraNode()
    centre, radius = places.mean(axis=0), np.linalg.norm(np.ptp(places, axis=0)) / 2
    height = 2 * around * (radius or 1.0)
    ahead = camera.orientation.getValue().multVec(coin.SbVec3f(0, 0, -1))
    if isinstance(camera, coin.SoPerspectiveCamera):
        away = height / 2 / np.tan(camera.heightAngle.getValue() / 2)
    else:
        camera.height = height
        away = camera.focalDistance.getValue()
    camera.position = tuple(float(c) for c in centre - away * np.array(ahead.getValue()))
    camera.focalDistance = float(away)


def line_of_sight(document):
    """(3,) the way the user looks; along y where the active view is not a 3D one."""
    view = FreeCADGui.getDocument(document.Name).ActiveView
    return np.array(view.getViewDirection()) if hasattr(view, "getViewDirection") else np.array([0.0, 1.0, 0.0])
