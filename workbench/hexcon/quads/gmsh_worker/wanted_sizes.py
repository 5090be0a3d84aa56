# SPDX-License-Identifier: LGPL-2.1-or-later
"""The size field that a user asks for: sizes of faces, edges, corners, points, balls and boxes, quads round a turn."""
import inspect

import gmsh
import numpy as np

from .fault import WorkerFault
from .size_field import GROWTH, Place, SizeField

STEP = 0.5          # of the size there: between samples of faces and edges
MOST_SAMPLES = 40_000       # of one face or edge; farther apart where it takes more, and smaller by what they miss
LEAST_SAMPLES = 4           # along each parameter of a face
PROBES = 9          # for each parameter, to see how curved a face is
LEAST_TURNING = 0.05        # of the size: no curvature asks for less, as at the tip of a cone
CURVED = 1e-6       # radians that a face turns on a diagonal of the solid, from which on it is curved
# gmsh 4.8 takes parameters as they are, later ones where they are told.
_PARAMETRIC = (True,) if "parametric" in inspect.signature(gmsh.model.isInside).parameters else ()


def wanted_sizes(solid, size, local_sizes=(), per_turn=0):
    """The SizeField of a Solid.

    local_sizes: dicts of "where" (its name in words), "kind", "size", and "tag" of a "face", "edge" or "vertex" of
    the solid, or "at" of a "point" (x, y, z), "ball" (x, y, z, radius) or "box" (six numbers: least, then largest)
    per_turn: round faces get at least about so many quads round a full turn; 0: as many as come by the size
    Raises WorkerFault BAD_OPTION where the solid has no such face, edge or corner.
    """
    parts, places, names = [], [], []
    for one in local_sizes:
        if "tag" in one:
            parts.append((*_samples(solid, one), len(names)))
            names.append(one["where"])
        else:
            places.append(_place(one["kind"], np.array(one["at"], float), one["size"]))
    if per_turn:
        for face in solid.faces:
            if not solid.is_plane(face):
                points, sizes = _turning(solid, face, size, per_turn)
                parts.append((points, sizes, len(names)))
                names.append(f"Face{face} is curved")
    return SizeField(size, np.concatenate([p for p, _, _ in parts]) if parts else (),
                     np.concatenate([s for _, s, _ in parts]) if parts else (), places, names,
                     np.concatenate([np.full(len(p), k) for p, _, k in parts]) if parts else None)


def _samples(solid, one):
    known = {"face": solid.faces, "edge": [*solid.edges, *solid.left_out], "vertex": list(solid.vertex)}[one["kind"]]
    if one["tag"] not in known:
        raise WorkerFault("BAD_OPTION", f"a local size names {one['where']}, which the solid does not have")
    if one["kind"] == "vertex":
        return solid.vertex[one["tag"]][None], np.array([one["size"]])
    if one["kind"] == "edge":
        return _on_edge(solid, one["tag"], one["size"])
    return _on_face(solid, one["tag"], one["size"])


def _on_edge(solid, edge, size):
    if edge in solid.left_out:
        return solid.vertex[solid.left_out[edge]][None], np.array([size])
    count = int(np.clip(np.ceil(solid.length(edge) / (STEP * size)), 1, MOST_SAMPLES))
    points = solid.edge_points(edge, np.arange(count + 1) / count)
    return points, np.full(len(points), _less(size, solid.length(edge) / count))


def _less(size, step):
    """So that between samples, even if they are far apart, the field is not above the size."""
    return max(size - GROWTH * max(step - STEP * size, 0.0) / 2.0, 0.5 * size)


def _inside(solid, face, step):
    """((n, 2) parameters of a face, about step apart, what they are apart where that would be too many)."""
    low, high = (np.array(b) for b in gmsh.model.getParametrizationBounds(2, face))
    u, v = np.meshgrid(*[np.linspace(a, b, PROBES) for a, b in zip(low, high)], indexing="ij")
    probes = solid.face_points(face, np.stack([u, v], -1).reshape(-1, 2)).reshape(PROBES, PROBES, 3)
    lengths = [np.linalg.norm(np.diff(probes, axis=k), axis=2).sum(axis=k).max() for k in (0, 1)]
    step = max(step, np.sqrt(lengths[0] * lengths[1] / MOST_SAMPLES))
    counts = np.clip(np.ceil(np.array(lengths) / step), LEAST_SAMPLES, MOST_SAMPLES // LEAST_SAMPLES).astype(int)
    axes = [a + (b - a) * (np.arange(n) + 0.5) / n for a, b, n in zip(low, high, counts)]
    grid = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 2)
    return grid[[gmsh.model.isInside(2, face, at, *_PARAMETRIC) > 0 for at in grid]], float(step)


def _on_face(solid, face, size):
    grid, step = _inside(solid, face, STEP * size)
    border = [_on_edge(solid, e, size)[0] for e in sorted({abs(e) for e in solid.boundary[face]})]
    points = np.vstack([solid.face_points(face, grid), *border])
    points = points[np.isfinite(points).all(axis=1)]
    return points, np.full(len(points), _less(size, step))


def _turning(solid, face, size, per_turn):
    """(points, sizes) where a face is curved, so that about per_turn of them go round."""
    points, curvature = curved_points(solid, face, size, add=np.maximum)
    return points, np.maximum(2.0 * np.pi / per_turn / curvature, LEAST_TURNING * size)


def curved_points(solid, face, size, add=np.add):
    """(points (n, 3) of a face where it is curved, its curvature there (n,)): both principal ones, by `add`."""
    grid, _ = _inside(solid, face, STEP * size)
    points = solid.face_points(face, grid)
    first, second = (np.abs(np.array(k)) for k in gmsh.model.getPrincipalCurvatures(face, grid.ravel())[:2])
    curvature = add(first, second)
    good = np.isfinite(points).all(axis=1) & np.isfinite(curvature) & (curvature * solid.diagonal > CURVED)
    return points[good], curvature[good]


def _place(kind, at, size):
    return Place(at[:3], at[3:] if kind == "box" else at[:3], float(at[3]) if kind == "ball" else 0.0, size)
