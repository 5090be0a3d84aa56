# SPDX-License-Identifier: LGPL-2.1-or-later
"""An independent judge of hex meshes: numpy and scipy only, no code shared with the core.

faults(points, hexes, quads, surface_points) lists what is wrong in words; an empty list means
certified: conforming, proper, boundary exact, every Jacobian positive.
"""
import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

# Corners of VTK_HEXAHEDRON as coordinates, and from them everything else.
CORNERS = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0],
                    [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])


def _face(axis, side):
    """Corners of a face, counter-clockwise seen from outside."""
    on = [i for i in range(8) if CORNERS[i, axis] == side]
    a, b = (axis + 1) % 3, (axis + 2) % 3
    on.sort(key=lambda i: np.arctan2(CORNERS[i, b] - 0.5, CORNERS[i, a] - 0.5))
    return on if side else on[::-1]


FACES = np.array([_face(axis, side) for axis in range(3) for side in (0, 1)])
EDGES = np.array([(i, j) for i in range(8) for j in range(i)
                  if np.abs(CORNERS[i] - CORNERS[j]).sum() == 1])


def _cycles(rows):
    """Rows turned so that the smallest id comes first; direction is kept."""
    start = np.argmin(rows, axis=1)
    return np.take_along_axis(rows, (start[:, None] + np.arange(4)) % 4, axis=1)


def _as_set(rows):
    return {tuple(row) for row in rows.tolist()}


def _face_groups(hexes):
    """Sides (hex, face) as (6 H, 4) ids, and for each the number of its face."""
    sides = hexes[:, FACES].reshape(-1, 4)
    _, number = np.unique(np.sort(sides, axis=1), axis=0, return_inverse=True)
    return sides, number


def boundary_faults(hexes, quads):
    sides, number = _face_groups(hexes)
    lone = np.bincount(number)[number] == 1
    boundary, wanted = _as_set(_cycles(sides[lone])), _as_set(_cycles(np.asarray(quads)))
    found = []
    if len(wanted) != len(quads):
        found.append("a quad occurs twice")
    if boundary != wanted:
        found.append(f"{len(boundary ^ wanted)} boundary faces differ from the quads")
    return found


def conformity_faults(hexes):
    sides, number = _face_groups(hexes)
    count = np.bincount(number)
    if count.max() > 2:
        return ["a face in more than two hexes"]
    order = np.argsort(number, kind="stable")
    inner = order[count[number[order]] == 2].reshape(-1, 2)
    here, there = _cycles(sides[inner[:, 0]]), _cycles(sides[inner[:, 1]][:, ::-1])
    found = [] if (here == there).all() else ["two hexes lie on the same side of a face"]
    return found + _link_faults(hexes, sides, inner, number, count)


def _link_faults(hexes, sides, inner, number, count):
    """Links of points: connected, Euler characteristic 2 inside and 1 on the boundary; links of
    edges: connected. Connected means: one can go from hex to hex through shared faces."""
    found = []
    if _parts_differ(hexes.ravel(), _join_corners(sides, hexes, inner)):
        found.append("a point where hexes meet without a face")
    pairs = np.sort(hexes[:, EDGES], axis=2).reshape(-1, 2)
    _, edge_number = np.unique(pairs, axis=0, return_inverse=True)
    if _parts_differ(edge_number, _join_edges(hexes, sides, inner)):
        found.append("an edge where hexes meet without a face")
    points = hexes.max() + 1
    first = np.unique(edge_number, return_index=True)[1]
    edges = np.bincount(pairs[first].ravel(), minlength=points)
    first = np.unique(number, return_index=True)[1]
    faces = np.bincount(sides[first].ravel(), minlength=points)
    solids = np.bincount(hexes.ravel(), minlength=points)
    outside = np.zeros(points, bool)
    outside[sides[count[number] == 1].ravel()] = True
    link = edges - faces + solids
    if (link != np.where(outside, 1, 2))[solids > 0].any():
        found.append("a point whose link is no sphere and no disc")
    return found


def _parts_differ(groups, parts):
    """True unless every group is one part."""
    pairs = np.unique(np.column_stack([groups, parts]), axis=0)
    return len(pairs) != len(np.unique(groups))


def _components(a, b, size):
    graph = coo_matrix((np.ones(len(a), np.int8), (a, b)), shape=(size, size))
    return connected_components(graph, directed=False)[1]


def _join_corners(sides, hexes, inner):
    """Components of hex corners joined through faces, as one number for each (hex, corner)."""
    a, b = [], []
    for k in range(4):
        ids = sides[inner[:, 0], k]
        for column, into in ((inner[:, 0], a), (inner[:, 1], b)):
            owner = column // 6
            local = np.argmax(hexes[owner] == ids[:, None], axis=1)
            into.append(8 * owner + local)
    return _components(np.concatenate(a), np.concatenate(b), hexes.size)


def _join_edges(hexes, sides, inner):
    """Components of hex edges joined through faces, as one number for each (hex, edge)."""
    a, b = [], []
    pairs = np.sort(hexes[:, EDGES], axis=2)
    for k in range(4):
        ends = np.sort(np.column_stack([sides[inner[:, 0], k], sides[inner[:, 0], (k + 1) % 4]]))
        for column, into in ((inner[:, 0], a), (inner[:, 1], b)):
            owner = column // 6
            local = np.argmax((pairs[owner] == ends[:, None]).all(axis=2), axis=1)
            into.append(12 * owner + local)
    return _components(np.concatenate(a), np.concatenate(b), 12 * len(hexes))


def improper_pairs(hexes):
    """Pairs of hexes whose common points are not one point, one edge or one face of both."""
    size = hexes.max() + 1
    use = coo_matrix((np.ones(hexes.size, np.int32),
                      (np.repeat(np.arange(len(hexes)), 8), hexes.ravel())),
                     shape=(len(hexes), size)).tocsr()
    common = (use @ use.T).tocoo()
    upper = (common.row < common.col) & (common.data > 1)
    bad = []
    for i, j, count in zip(common.row[upper], common.col[upper], common.data[upper]):
        shared = set(hexes[i]) & set(hexes[j])
        width = {2: 1, 4: 2}.get(int(count))
        for h in (hexes[i], hexes[j]):
            local = CORNERS[[k for k in range(8) if h[k] in shared]]
            if width is None or np.ptp(local, axis=0).sum() != width:
                bad.append((int(i), int(j)))
                break
    return bad


def euler(hexes):
    pairs = np.unique(np.sort(hexes[:, EDGES], axis=2).reshape(-1, 2), axis=0)
    _, number = _face_groups(hexes)
    return len(np.unique(hexes)) - len(pairs) + number.max() + 1 - len(hexes)


# ------------------------------------------------------------------------------------- Jacobians

def _derivatives(corners, at):
    """Of the trilinear map of (H, 8, 3) corners at (M, 3) points of the unit cube: (H, M, 3, 3),
    the last axis says along which axis."""
    weights = np.where(CORNERS[None], at[:, None], 1 - at[:, None])
    columns = []
    for axis in range(3):
        slope = np.where(CORNERS[:, axis], 1.0, -1.0) * np.delete(weights, axis, 2).prod(axis=2)
        columns.append(np.einsum("mc,hck->hmk", slope, corners))
    return np.stack(columns, axis=3)


def jacobians(corners, at):
    """det of the trilinear map of (H, 8, 3) corners at (M, 3) points of the unit cube: (H, M)."""
    return np.linalg.det(_derivatives(corners, at))


def scaled_jacobians(points, hexes):
    """(H,): Verdict's, the smallest at a corner; -1 where an edge there has no length."""
    edges = _derivatives(np.asarray(points)[hexes], CORNERS)
    lengths = np.linalg.norm(edges, axis=2).prod(axis=2)
    scaled = np.linalg.det(edges) / np.where(lengths > 0, lengths, np.inf)
    return np.where(lengths > 0, scaled, -1).min(axis=1)


# Degree 2 in each direction: values at 0, 1/2, 1 to Bernstein coefficients; then halves.
_NODES = np.stack(np.meshgrid(*[[0, 0.5, 1]] * 3, indexing="ij"), axis=3).reshape(-1, 3)
_TO_BERNSTEIN = np.array([[1, 0, 0], [-0.5, 2, -0.5], [0, 0, 1]])
_HALVES = (np.array([[1, 0, 0], [0.5, 0.5, 0], [0.25, 0.5, 0.25]]),
           np.array([[0.25, 0.5, 0.25], [0, 0.5, 0.5], [0, 0, 1]]))


def _apply(matrices, values):
    return np.einsum("ai,bj,ck,hijk->habc", *matrices, values, optimize=True)


def nonpositive(points, hexes, depth=20):
    """Hexes whose Jacobian is not positive everywhere, or not clearly so at this depth."""
    corners = np.asarray(points)[hexes]
    corners = corners - corners.mean(axis=1, keepdims=True)
    size = np.ptp(corners, axis=1).max(axis=1)
    corners = corners / np.where(size > 0, size, 1)[:, None, None]
    values = jacobians(corners, _NODES).reshape(-1, 3, 3, 3)
    values = _apply([_TO_BERNSTEIN] * 3, values)
    owner, bad = np.arange(len(hexes)), np.zeros(len(hexes), bool)
    for _ in range(depth):
        ends = values[:, ::2, ::2, ::2].reshape(len(values), -1)
        bad[owner[ends.min(axis=1) <= 1e-13]] = True
        open_ = (values.reshape(len(values), -1).min(axis=1) <= 1e-13) & ~bad[owner]
        values, owner = values[open_], np.tile(owner[open_], 8)
        if not len(values):
            return np.flatnonzero(bad)
        values = np.concatenate([_apply([_HALVES[i], _HALVES[j], _HALVES[k]], values)
                                 for i in (0, 1) for j in (0, 1) for k in (0, 1)])
    bad[owner] = True
    return np.flatnonzero(bad)


def faults(points, hexes, quads, surface_points):
    """All that is wrong, in words."""
    points, hexes = np.asarray(points), np.asarray(hexes, dtype=np.int64)
    surface_points = np.asarray(surface_points, dtype=np.float64)
    found = []
    if points[:len(surface_points)].tobytes() != surface_points.tobytes():
        found.append("the first points are not those of the surface")
    if not np.isfinite(points).all():
        found.append("a point is not finite")
    if len(np.unique(hexes)) != len(points):
        found.append("a point belongs to no hex")
    found += boundary_faults(hexes, quads) + conformity_faults(hexes)
    found += [f"hexes {i} and {j} meet improperly" for i, j in improper_pairs(hexes)[:3]]
    bad = nonpositive(points, hexes)
    if len(bad):
        found.append(f"{len(bad)} hexes are not positive, such as {bad[0]}")
    return found


def enclosed(surface):
    """The volume inside a surface of quads, as bilinear patches, outward."""
    p = surface.points[surface.quads]
    return (np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 1]) / 2 * p.mean(axis=1)).sum() / 3
