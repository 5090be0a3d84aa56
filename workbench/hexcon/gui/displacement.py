# SPDX-License-Identifier: LGPL-2.1-or-later
"""The displacements of a result in the 3D view: its mesh bent and coloured, with a legend, and nothing before it.

FreeCAD's own display of results differs from version to version: 0.20 has no legend, 1.1 shows one whose figures are
those of nothing, and the result's outline in grey over the colours.
"""
import FreeCAD
import numpy as np
from pivy import coin

from hexcon.freecad_compat import DRAWN_BY_FEM, shape_of
from hexcon.judging import words

from .legend import legend

translate = FreeCAD.Qt.translate

SHOWN = 0.1  # of the model's diagonal: how large the largest displacement is drawn
# What FreeCAD colours nodes with, from the lowest value to the highest.
COLOURS = ((0, 0, 1), (0, 1, 1), (0, 1, 0), (1, 1, 0), (1, 0, 0))
STRIPS, PARTS = 64, 4
NODE = "HexConLegend"


def show(result_object):
    """Colour the result's mesh by displacement, blue to red, and draw it bent; returns the factor."""
    mesh_object = result_object.Mesh
    _show_alone(mesh_object)
    view, lengths = mesh_object.ViewObject, result_object.DisplacementLengths
    largest = max(lengths, default=0.0)
    factor = SHOWN * mesh_object.FemMesh.BoundBox.DiagonalLength / largest if largest > 0.0 else 0.0
    # FreeCAD's scale has zero in its green middle: shifted, nothing is blue and the largest red
    view.setNodeColorByScalars(list(result_object.NodeNumbers), [2.0 * length - largest for length in lengths])
    view.setNodeDisplacementByVectors(list(result_object.NodeNumbers), list(result_object.DisplacementVectors))
    view.applyDisplacement(factor)
    _put_legend(view, largest, factor)
    return factor


def _show_alone(mesh_object):
    """What would lie over the result is hidden: other meshes, solids, and FreeCAD's own view of the same result."""
    for other in mesh_object.Document.Objects:
        if any(map(other.isDerivedFrom, DRAWN_BY_FEM)) or shape_of(other) is not None:
            other.ViewObject.Visibility = other == mesh_object
    mesh_object.ViewObject.Visibility = True


def figures_of(largest):
    """The legend's figures: [(height, words)] from 0 to the largest displacement, mm."""
    return [(part / PARTS, f"{largest * part / PARTS:.3g}") for part in range(PARTS + 1)]


def _rounded(factor):
    rough = float(f"{factor:.2g}")
    return words.count(round(rough)) if rough >= 10 else f"{rough:g}"


def _put_legend(view, largest, factor):
    """Seen whenever the mesh is, and gone with it."""
    heights = (np.arange(STRIPS) + 0.5) / STRIPS
    colours = np.column_stack([np.interp(heights, np.linspace(0, 1, len(COLOURS)), channel)
                               for channel in np.array(COLOURS, float).T])
    drawn = legend(translate("HexCon", "displacement, mm"), colours, figures_of(largest),
                   translate("HexCon", "drawn × {factor}").format(factor=_rounded(factor)))
    root, switch = view.RootNode, coin.SoSwitch()
    for old in [child for child in root.getChildren() or () if child.getName() == NODE]:
        root.removeChild(old)
    switch.setName(NODE)
    for _ in range(view.SwitchNode.getNumChildren()):
        switch.addChild(drawn)
    switch.whichChild.connectFrom(view.SwitchNode.whichChild)
    root.addChild(switch)
