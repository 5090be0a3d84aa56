# SPDX-License-Identifier: LGPL-2.1-or-later
"""The gate of every surface method: how well the quads keep the solid. Their points are measured by nearness.py."""
import gmsh
import numpy as np

from .segments import distances

SHARP = 25.0        # degrees between normals from which an edge must lie on mesh edges
SAMPLES = 33        # of an edge, at most
MIDDLES = 500       # quads of one face whose middles are measured, at most


def cad_fit(solid, mesh):
    """dict of arrays about quads on a Solid, with lengths in its units.

    fit (6,)    the solid's volume and area, of OCC; those of the quads, as bilinear patches, less the solid's, as part
                of those; the greatest distance of a quad's middle from its face, of at most MIDDLES quads a face; and
                that of a sharp CAD edge from the mesh edges between its two faces
    lost_faces  faces that own no quad;  lost_edges: sharp edges without such mesh edges
    Cost: linear, and a projection for each middle.
    """
    quads, faces = np.asarray(mesh["quads"]), np.asarray(mesh["faces"])
    volume, area = volume_and_area(mesh["points"][quads])
    volume = abs(volume)        # not all methods' quads are outward yet
    chord, lost_edges = _edge_chord(solid, mesh["points"], quads, faces)
    found = (solid.exact_volume, solid.exact_area, volume / solid.exact_volume - 1.0, area / solid.exact_area - 1.0,
             _face_chord(solid, mesh["points"], quads, faces, mesh.get("joined", {})), chord)
    return {"fit": np.array(found), "lost_faces": np.setdiff1d(np.array(solid.faces), faces),
            "lost_edges": np.array(lost_edges, int)}


def volume_and_area(corners):
    """Of closed bilinear quads (n, 4, 3), outward: the exact volume, the mean area of both ways to halve them."""
    splits = (corners[:, [0, 1, 2]], corners[:, [0, 2, 3]], corners[:, [0, 1, 3]], corners[:, [1, 2, 3]])
    normals = [np.cross(t[:, 1] - t[:, 0], t[:, 2] - t[:, 0]) for t in splits]
    centre = corners.mean((0, 1))
    volume = sum(((t[:, 0] - centre) * n).sum() for t, n in zip(splits, normals)) / 12.0
    return float(volume), float(sum(np.linalg.norm(n, axis=1).sum() for n in normals) / 4.0)


def _face_chord(solid, points, quads, faces, joined):
    """joined: face -> faces that are one smooth face with it: the nearest counts."""
    worst = 0.0
    for face in solid.faces:
        rows = np.flatnonzero(faces == face)
        if solid.is_plane(face) and len(joined.get(face, ())) < 2 or not len(rows):
            continue
        middles = points[quads[rows[::-(-len(rows) // MIDDLES)]]].mean(axis=1)
        off = np.full(len(middles), np.inf)
        for one in joined.get(face, (face,)):
            off = np.minimum(off, np.linalg.norm(solid.project(2, one, middles) - middles, axis=1))
        worst = max(worst, float(off.max()))
    return worst


def _edge_chord(solid, points, quads, faces):
    """(greatest distance, edges without mesh edges of their own)."""
    borders, worst, lost = _borders(quads, faces), 0.0, []
    for edge in solid.edges:
        a, b = sorted(solid.faces_of[edge])
        if a == b or not _is_sharp(solid, edge):
            continue
        line = borders.get((a, b))
        if line is None:
            lost.append(edge)
            continue
        at = solid.edge_points(edge, np.linspace(0.0, 1.0, SAMPLES))
        worst = max(worst, float(distances(at, points[line[:, 0]], points[line[:, 1]]).max()))
    return worst, lost


def _borders(quads, faces):
    """(face, face) ascending -> (k, 2) mesh edges between quads of both."""
    edges = np.stack([quads, np.roll(quads, -1, axis=1)], -1).reshape(-1, 2)
    edges, face = np.sort(edges, axis=1), np.repeat(faces, 4)
    order = np.lexsort((edges[:, 1], edges[:, 0]))
    first, second = order[::2], order[1::2]
    sides = np.sort(np.stack([face[first], face[second]], 1), axis=1)
    rows = np.flatnonzero(sides[:, 0] != sides[:, 1])
    pairs, which = np.unique(sides[rows], axis=0, return_inverse=True)
    return {tuple(pair): edges[first[rows[which == k]]] for k, pair in enumerate(pairs.tolist())}


def _is_sharp(solid, edge):
    """Whether the normals of its two faces differ, at three places, wherever their senses point."""
    ways = [np.array(gmsh.model.getNormal(f, solid.edge_on_face(edge, [0.2, 0.5, 0.8], f).ravel())).reshape(-1, 3)
            for f in solid.faces_of[edge]]
    cosine = np.abs((ways[0] * ways[1]).sum(axis=1))
    return bool(np.nanmin(np.append(cosine, 1.0)) < np.cos(np.radians(SHARP)))
