# SPDX-License-Identifier: LGPL-2.1-or-later
"""The method `blocks`: quads whose loops do not cross themselves, on solids that fall into a few blocks of hexes."""
import gmsh
import numpy as np

from .corner_blocks import corner_surface
from .fault import WorkerFault
from .rims import chain_of
from .round_blocks import round_surface
from .smooth import space_quality

LEAST_SINE = 0.15       # of the corners of quads: some 9 degrees


def blocks_surface(solid, size, link):
    """dict with points, quads, faces, notes.

    Raises WorkerFault NOT_BLOCKS with the reason: a vertex, a face, or quads that would be folded or too sharp.
    """
    try:
        chain = chain_of(solid)
        mesh = round_surface(solid, chain, size) if chain else corner_surface(solid, size, link)
        folded = _folded(solid, mesh)
    except WorkerFault:
        raise
    except Exception as error:      # gmsh raises plain Exception, where it cannot put a point on a face
        if type(error) is not Exception:
            raise
        raise WorkerFault("NOT_BLOCKS", f"gmsh: {error}") from error
    quality = np.where(folded, -1.0, space_quality(mesh["points"], mesh["quads"]))
    bad = quality < LEAST_SINE
    if bad.any():
        faces = np.unique(mesh["faces"][bad])
        names = ", ".join(f"Face{f}" for f in faces[:5])
        raise WorkerFault("NOT_BLOCKS", f"{int(bad.sum())} quads would be folded or have corners near 0 or 180 "
                          f"degrees, on {names}; reentrant or very sharp corners do that", faces)
    mesh["notes"].append(f"blocks: {len(quality)} quads, scaled Jacobian {quality.min():.3f} to mean "
                         f"{quality.mean():.3f}, edges {_edge_range(mesh, size)} of the wanted size")
    return mesh


def _edge_range(mesh, size):
    corners = mesh["points"][mesh["quads"]]
    length = np.linalg.norm(corners - np.roll(corners, -1, axis=1), axis=2) / size
    return f"{length.min():.2f} to {length.max():.2f}"


def _folded(solid, mesh):
    """(n,) bool: quads whose normal, against that of the CAD face, is unlike the most of their face."""
    folded = np.zeros(len(mesh["quads"]), bool)
    for face in solid.faces:
        own = np.flatnonzero(mesh["faces"] == face)
        corners = mesh["points"][mesh["quads"][own]]
        normal = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
        middle = solid.project(2, face, corners.mean(axis=1))
        parameters = gmsh.model.getParametrization(2, face, middle.ravel())
        along = (np.array(gmsh.model.getNormal(face, parameters)).reshape(-1, 3) * normal).sum(axis=1)
        folded[own] = np.sign(along) != np.sign(along.sum())
    return folded
