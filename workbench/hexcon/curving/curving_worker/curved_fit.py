# SPDX-License-Identifier: LGPL-2.1-or-later
"""How well curved boundary faces follow the CAD: volume, area, and how far they are off it at most."""
import gmsh
import numpy as np

_GAUSS = np.polynomial.legendre.leggauss(5)     # exact for the volume: degree 8 in each direction
_PROBES = np.linspace(-1.0, 1.0, 5)


def _shape(u, v):
    """Values (8,) and derivatives (8,2) of the 8-node quad's shape functions; corners, then middles."""
    a, b = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]).T
    value = (1 + a * u) * (1 + b * v) * (a * u + b * v - 1) / 4
    du, dv = a * (1 + b * v) * (2 * a * u + b * v) / 4, b * (1 + a * u) * (a * u + 2 * b * v) / 4
    middle = np.array([(1 - u * u) * (1 - v), (1 + u) * (1 - v * v), (1 - u * u) * (1 + v), (1 - u) * (1 - v * v)]) / 2
    mu = np.array([-2 * u * (1 - v), 1 - v * v, -2 * u * (1 + v), -(1 - v * v)]) / 2
    mv = np.array([-(1 - u * u), -2 * v * (1 + u), 1 - u * u, -2 * v * (1 - u)]) / 2
    return np.concatenate([value, middle]), np.stack([np.concatenate([du, mu]), np.concatenate([dv, mv])], axis=1)


def curved_fit(carriers, points, hexes, edges, quads, faces):
    """Figures as arrays: volume, area of the mesh; cad_volume, cad_area; chord: greatest distance of the curved faces
    from the CAD surface of their face or one beside it, at 25 places of each."""
    nodes = points[np.hstack([quads, edges.middle[edges.of_quad]])]
    low = nodes.reshape(-1, 3).mean(0)
    volume = area = 0.0
    for u, wu in zip(*_GAUSS):
        for v, wv in zip(*_GAUSS):
            value, slope = _shape(u, v)
            normal = np.cross(*(np.einsum("n,qnx->qx", slope[:, k], nodes) for k in (0, 1)))
            volume += wu * wv * ((np.einsum("n,qnx->qx", value, nodes) - low) * normal).sum() / 3
            area += wu * wv * np.linalg.norm(normal, axis=1).sum()
    solid = carriers.solid
    return {"volume": np.float64(volume), "area": np.float64(area), "chord": _chord(carriers, nodes, edges, faces),
            "cad_volume": np.float64(gmsh.model.occ.getMass(3, solid.volume)),
            "cad_area": np.float64(sum(solid.area(f) for f in solid.faces))}


def _chord(carriers, nodes, edges, faces):
    probes = np.array([_shape(u, v)[0] for u in _PROBES for v in _PROBES])
    places = np.einsum("pn,qnx->qpx", probes, nodes)
    off = np.full(places.shape[:2], np.inf)
    beside = np.column_stack([faces, edges.faces[edges.of_quad].reshape(len(faces), -1)])
    for face in np.unique(beside):
        rows = np.flatnonzero((beside == face).any(axis=1))
        here = places[rows].reshape(-1, 3)
        gap = np.linalg.norm(carriers.on_face(int(face), here) - here, axis=1)
        off[rows] = np.fmin(off[rows], gap.reshape(len(rows), -1))
    return np.float64(off.max())
