# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of order 1 raised to order 2 on the solid they were made of."""
import copy

import numpy as np

import hexcon_native
from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh.second_order import RAISED, is_raised

from . import curve

_WITHOUT_IT = (FaultCode.TOOL_FAILED, FaultCode.TOOL_TIMEOUT, FaultCode.TOOL_MISSING, FaultCode.FILE_IO,
               FaultCode.FILE_FORMAT)


def raised(mesh, order):
    """(mesh at an order, why its edges are straight all the same: words, or None).

    mesh  mesh-like; order: 1, 2 or None, its own
    A mesh of order 1 that hexcon.mesh_solid made and that is wanted at order 2 is copied and its edges curved on its
    solid (.solid), as far as no hex folds: see curving.curve. Of others, and where the solid cannot be read any more,
    the mesh itself is handed back, and the words say why. Cost: gmsh's reading of the solid; linear.
    """
    if not is_raised(mesh, order):
        return mesh, None
    solid, faces = getattr(mesh, "solid", None), getattr(mesh, "face_of_quad", None)
    if solid is None or faces is None or not (np.asarray(faces) > 0).all():
        return mesh, RAISED
    made = copy.copy(mesh)
    made.points, made.hexes = hexcon_native.raise_order(mesh.points, mesh.hexes)
    made.order, made.report = 2, dict(mesh.report)
    try:
        curve(made, solid)
    except ToolError as fault:
        if fault.code not in _WITHOUT_IT:
            raise
        return mesh, f"{RAISED}; its solid could not be used: {fault.code.name}: {fault}"
    return made, None
