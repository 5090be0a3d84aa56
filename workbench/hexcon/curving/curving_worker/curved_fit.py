# SPDX-License-Identifier: LGPL-2.1-or-later
"""How well curved boundary faces follow the CAD: volume, area, and how far they are off it at most."""
import numpy as np

from .quad_shape import quad_shape

_GAUSS = np.polynomial.legendre.leggauss(5)     # exact for the volume: degree 8 in each direction
_PROBES = np.linspace(-1.0, 1.0, 5)


def curved_fit(carriers, points, hexes, edges, quads, faces):
    """Figures as arrays: volume, area of the mesh; cad_volume, cad_area; chord: greatest distance of the curved faces
    from the CAD surface of their face or one beside it, at 25 places of each."""
    nodes = points[np.hstack([quads, edges.middle[edges.of_quad]])]
    low = nodes.reshape(-1, 3).mean(0)
    volume = area = 0.0
    for u, wu in zip(*_GAUSS):
        for v, wv in zip(*_GAUSS):
            value, slope = quad_shape(8, u, v)
            normal = np.cross(*(np.einsum("n,qnx->qx", slope[:, k], nodes) for k in (0, 1)))
            volume += wu * wv * ((np.einsum("n,qnx->qx", value, nodes) - low) * normal).sum() / 3
            area += wu * wv * np.linalg.norm(normal, axis=1).sum()
    return {"volume": np.float64(volume), "area": np.float64(area), "chord": _chord(carriers, nodes, edges, faces),
            "cad_volume": np.float64(carriers.solid.exact_volume), "cad_area": np.float64(carriers.solid.exact_area)}


def _chord(carriers, nodes, edges, faces):
    probes = np.array([quad_shape(8, u, v)[0] for u in _PROBES for v in _PROBES])
    places = np.einsum("pn,qnx->qpx", probes, nodes)
    off = np.full(places.shape[:2], np.inf)
    beside = np.column_stack([faces, edges.faces[edges.of_quad].reshape(len(faces), -1)])
    for face in np.unique(beside):
        rows = np.flatnonzero((beside == face).any(axis=1))
        here = places[rows].reshape(-1, 3)
        gap = np.linalg.norm(carriers.on_face(int(face), here) - here, axis=1)
        off[rows] = np.fmin(off[rows], gap.reshape(len(rows), -1))
    return np.float64(off.max())
