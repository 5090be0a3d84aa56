# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a FEM mesh object of hexes is worth: certified or not, and where not.

These are calls for macros; hexcon.gui.actions has them too.
"""
from dataclasses import dataclass
from types import SimpleNamespace

import numpy as np

import hexcon_native
from hexcon.femmesh import elements_of, from_femmesh
from hexcon.femmesh.boundary import owners
from hexcon.femmesh.hexahedron import EDGES
from hexcon.topological import is_topological

from . import words
from .prepared import taken


@dataclass
class CheckReport:
    """What is known of a FEM mesh of hexes; str() says it in words.

    counts           namespace: points, hexes, quads, order
    certificate      hexcon_native.Certificate (row numbers)
    quality          hexcon_native.Quality
    nonpositive      FreeCAD's element numbers of the hexes not proved positive
    overlapping      FreeCAD's element numbers of the hexes behind boundary quads that cross or touch others
    surface_known    the boundary was compared with the quads kept in the mesh's face groups
    straight         every middle node is the middle of its edge (True at order 1): the
                     certificate holds for the elements as they are
    topological      the object says that it holds topology only
    """

    counts: SimpleNamespace
    certificate: hexcon_native.Certificate
    quality: hexcon_native.Quality
    nonpositive: list
    overlapping: list
    surface_known: bool
    straight: bool
    topological: bool = False

    def __str__(self):
        return words.as_text(words.of_check(self))


def check_mesh_object(mesh_object):
    """Certify a FEM mesh object made of hexes; returns a CheckReport.

    Changes nothing. Raises HexconError: ToolError(BAD_MESH) for other elements, and those of
    hexcon_native.certify.
    """
    return taken() or check_mesh(read_mesh_object(mesh_object))


def read_mesh_object(mesh_object):
    """The arrays of a FEM mesh object, and its mark, for check_mesh. See femmesh.from_femmesh."""
    found = from_femmesh(mesh_object.FemMesh)
    found.topological = is_topological(mesh_object)
    return found


def check_mesh(found, progress=None):
    """CheckReport of what read_mesh_object gave; needs no FreeCAD, so any thread may call it."""
    own = elements_of(SimpleNamespace(points=found.points, hexes=found.hexes))
    # face groups that cover the boundary are the surface the mesh was made for; fewer of them
    # are somebody's selection and say nothing of the rest
    known = found.quads is not None and len(found.quads) == len(own.quads)
    quads = np.asarray(found.quads if known else own.quads)[:, :4]
    certificate = hexcon_native.certify(found.points, found.hexes, quads, progress=progress)
    hex_ids, behind = np.asarray(found.hex_ids), np.zeros(0, np.int64)
    if len(certificate.crossings):
        behind, _ = owners(found.hexes, quads[np.unique(certificate.crossings)], len(found.points))
    return CheckReport(
        SimpleNamespace(points=len(found.points), hexes=len(found.hexes), quads=len(own.quads),
                        order=found.order),
        certificate, hexcon_native.quality(found.points, found.hexes),
        hex_ids[certificate.nonpositive].tolist(), hex_ids[np.unique(behind)].tolist(), known, _is_straight(found),
        is_topological(found))


def _is_straight(found):
    if found.order == 1:
        return True
    ends = found.points[found.hexes[:, EDGES]]
    off = found.points[found.hexes[:, 8:]] - ends.mean(axis=2)
    lengths = np.linalg.norm(ends[:, :, 1] - ends[:, :, 0], axis=2)
    return bool((np.linalg.norm(off, axis=2) <= 1e-9 * lengths).all())


def mark_hexes(mesh_object, elements):
    """Show these elements (FreeCAD's numbers) in red, inside ones too; none: as before.

    Needs FreeCAD's window. A matter of the view: the document does not change.
    """
    from .marking import mark
    mark(mesh_object, elements)
