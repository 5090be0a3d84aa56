# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a mesh of hexes is worth: certified or not, and where not."""
from dataclasses import dataclass
from types import SimpleNamespace

import numpy as np

import hexcon_native
from hexcon.femmesh import elements_of, from_femmesh
from hexcon.femmesh.boundary import owners
from hexcon.topological import is_topological

from . import words
from .curved import curved_hexes
from .lengths import Lengths, lengths_of


@dataclass
class CheckReport:
    """What is known of a mesh of hexes; str() says it in words.

    counts           namespace: points, hexes, quads, order
    certificate      hexcon_native.Certificate (row numbers)
    quality          hexcon_native.Quality
    lengths          Lengths: shortest edge, aspect ratios
    nonpositive      element numbers of the hexes not proved positive
    overlapping      element numbers of the hexes behind boundary quads that cross or touch others
    surface_known    the boundary was compared with the quads kept in the mesh's face groups
    curved           element numbers of the hexes of order 2 with an edge that is not straight
    topological      the object says that it holds topology only
    """

    counts: SimpleNamespace
    certificate: hexcon_native.Certificate
    quality: hexcon_native.Quality
    lengths: Lengths
    nonpositive: list
    overlapping: list
    surface_known: bool
    curved: list
    topological: bool = False

    @property
    def straight(self):
        """Every middle node is the middle of its edge."""
        return not self.curved

    @property
    def certified(self):
        """Proved of the elements as they are, curved or not."""
        return bool(self.certificate.certified)

    def __str__(self):
        return words.as_text(words.of_check(self))


def read_mesh_object(mesh_object):
    """The arrays of a FEM mesh object, and its mark, for check_mesh. See femmesh.from_femmesh."""
    found = from_femmesh(mesh_object.FemMesh)
    found.topological = is_topological(mesh_object)
    return found


def check_mesh(found, progress=None, surface=None):
    """CheckReport of a mesh; needs no FreeCAD, so any thread may call it.

    found    mesh-like: .points, .hexes (H,8|20), .order, .quads (n,4|8) that it was made for, or None, .hex_ids (else:
             rows), and the mark of a topological mesh
    surface  quads (n,4) in its numbering that the boundary must be, instead of .quads
    Raises HexconError, as hexcon_native.certify.
    """
    own = elements_of(SimpleNamespace(points=found.points, hexes=found.hexes))
    # face groups that cover the boundary are the surface the mesh was made for; fewer of them
    # are somebody's selection and say nothing of the rest
    known = found.quads is not None and len(found.quads) == len(own.quads)
    quads = np.asarray(found.quads if known else own.quads)[:, :4] if surface is None else surface
    certificate = hexcon_native.certify(found.points, found.hexes, quads, progress=progress)
    hex_ids = np.asarray(getattr(found, "hex_ids", np.arange(len(found.hexes))))
    behind = np.zeros(0, np.int64)
    if len(certificate.crossings) and certificate.boundary_exact:
        behind, _ = owners(found.hexes, quads[np.unique(certificate.crossings)], len(found.points))
    return CheckReport(
        SimpleNamespace(points=len(found.points), hexes=len(found.hexes), quads=len(own.quads),
                        order=found.order),
        certificate, hexcon_native.quality(found.points, found.hexes), lengths_of(found.points, found.hexes),
        hex_ids[certificate.nonpositive].tolist(), hex_ids[np.unique(behind)].tolist(), known or surface is not None,
        hex_ids[curved_hexes(found.points, found.hexes)].tolist(),
        is_topological(found))
