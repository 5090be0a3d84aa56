# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of a solid a mesh must take up: patches, curves and corners.

A *patch* is a set of CAD faces joined through smooth edges. A *curve* is a chain of sharp CAD edges between corners,
with one patch on its left and one on its right, seen from outside along it. A *corner* is a vertex where other than two
ends of curves meet, where a curve turns or changes from convex to concave, or the tip of a cone.
"""
import math
from dataclasses import dataclass

import gmsh
import numpy as np
from scipy.spatial import cKDTree

from ..segments import on_segments
from .carriers import curve_carrier, surface_carrier, surface_normals
from .edges import edges_of
from .tessellation import Nearest, Tessellation

SMOOTH = 25.0       # degrees between normals up to which an edge is no feature
TURN = 40.0         # degrees by which a curve turns at a corner
APEX = 50.0         # degrees between normals round a vertex without curves that make it a corner
EVERY_EDGE = -1.0   # in place of SMOOTH: all edges between different faces are features


class Cad:
    """What of a solid does not depend on which edges are taken for smooth.

    tolerance  how far triangles may be off curved faces, about
    carriers   CAD face -> Carrier;  curve_carriers: CAD edge -> Carrier
    edges      list of edges.Edge
    """

    def __init__(self, solid, size):
        self.solid, self.size = solid, size
        self.tessellation = Tessellation(solid, size / 2)
        self.tolerance = min(size / 40, solid.diagonal / 400)
        self.carriers = {f: surface_carrier(f, solid.diagonal) for f in solid.faces}
        self.curve_carriers = {e: curve_carrier(e, solid.diagonal) for e in solid.edges}
        self.edges = edges_of(self.tessellation, solid, size)
        self._corner_normals = {}

    def corner_normals(self, face):
        """(t,3,3) normals at the corners of a face's triangles: the triangles' own of closed forms, and where gmsh
        tells no others; asked once."""
        if face not in self._corner_normals:
            self._corner_normals[face] = self._asked_normals(face)
        return self._corner_normals[face]

    def _asked_normals(self, face):
        shape = self.tessellation
        rows = np.flatnonzero(shape.face == face)
        flat = np.repeat(shape.normals_at(rows)[:, None], 3, axis=1)
        if self.carriers[face].kind != "other":
            return flat
        ids, back = np.unique(shape.triangles[rows], return_inverse=True)
        found = surface_normals(face, shape.points[ids])[back.reshape(-1, 3)]
        found = found * np.sign((found * flat).sum(axis=2, keepdims=True))
        return np.where(np.isfinite(found) & (found != 0).any(axis=2, keepdims=True), found, flat)


@dataclass
class Curve:
    """A chain of CAD edges.

    left, right          patches;  start, end: corners, both -1 where it is closed without one
    samples (n,3), s (n,)   points along it and their arc lengths
    parts                [(CAD edge, first arc length, last, parameters, their arc lengths)] in order
    angle                interior dihedral angle in degrees, mean;  angles: (least, greatest)
    edges                indices into Features.edges
    """

    left: int
    right: int
    start: int
    end: int
    samples: np.ndarray
    s: np.ndarray
    parts: list
    angle: float
    angles: tuple
    edges: list

    def __post_init__(self):
        self._tree = cKDTree(self.samples)
        self._starts = np.array([p[1] for p in self.parts])

    @property
    def closed(self):
        return self.start < 0

    @property
    def length(self):
        return float(self.s[-1])

    def _into(self, lengths):
        lengths = np.asarray(lengths, float)
        return np.mod(lengths, self.length) if self.closed else lengths.clip(0.0, self.length)

    def sampled(self, lengths):
        """(n,3) points at arc lengths on the polygon of samples: near the curve, and fast."""
        lengths = self._into(lengths)
        return np.stack([np.interp(lengths, self.s, self.samples[:, k]) for k in range(3)], 1)

    def at(self, lengths):
        """(n,3) points of the CAD at arc lengths."""
        return self._evaluated(lengths, gmsh.model.getValue)

    def tangents(self, lengths):
        """(n,3) unit tangents along it."""
        d = self._evaluated(lengths, gmsh.model.getDerivative)
        ahead = self.sampled(np.asarray(lengths) + 1e-3 * self.length) - \
            self.sampled(np.asarray(lengths) - 1e-3 * self.length)
        d[(d * ahead).sum(1) < 0.0] *= -1.0
        return d / np.maximum(np.linalg.norm(d, axis=1, keepdims=True), 1e-300)

    def _evaluated(self, lengths, ask):
        lengths = self._into(lengths)
        which = (np.searchsorted(self._starts, lengths, side="right") - 1).clip(0)
        out = np.empty((len(lengths), 3))
        for w in np.unique(which):
            tag, _, _, parameters, arc = self.parts[w]
            rows = np.flatnonzero(which == w)
            out[rows] = np.array(ask(1, tag, np.interp(lengths[rows], arc, parameters))).reshape(-1, 3)
        return out

    def lengths_of(self, points):
        """((n,) arc lengths of the nearest points of the polygon of samples, (n,) how far those are)."""
        points = np.asarray(points, float).reshape(-1, 3)
        last = len(self.samples) - 2
        near = self._tree.query(points, min(3, last + 2))[1].reshape(len(points), -1)
        s, best = np.zeros(len(points)), np.full(len(points), np.inf)
        for segment in np.hstack([near, near - 1]).clip(0, last).T:
            q, t = on_segments(points, self.samples[segment], self.samples[segment + 1])
            gap = np.linalg.norm(q - points, axis=1)
            better = gap < best
            best[better] = gap[better]
            s[better] = (self.s[segment] + t * (self.s[segment + 1] - self.s[segment]))[better]
        return s, best

    def is_straight(self, carriers):
        """Whether it is one line. carriers: CAD edge -> Carrier."""
        return len(self.parts) == 1 and carriers[self.parts[0][0]].kind == "Line"

    def evened(self, points):
        """(n,3) evenly spaced for points in order along it, whose first and last are its ends; one, if it is closed:
        then they are turned so that they move least."""
        along = np.linspace(0.0, self.length, len(points))
        if not self.closed:
            return np.vstack([points[:1], self.at(along[1:-1]), points[-1:]])
        s, _ = self.lengths_of(points)
        step = np.diff(s)
        step -= self.length * np.round(step / self.length)
        s = s[0] + np.concatenate([[0.0], np.cumsum(step)])
        along = np.copysign(along, step.sum())
        out = self.at(along + (s - along)[:-1].mean())
        out[-1] = out[0]
        return out

    def project(self, points):
        """(points of the CAD (n,3), unit tangents (n,3)); nearest up to the spacing of samples squared."""
        s, _ = self.lengths_of(points)
        return self.at(s), self.tangents(s)


class Patch:
    """CAD faces that are smooth neighbours: faces (tags, ascending), area, Euler characteristic, rows of triangles."""

    def __init__(self, cad, faces):
        self.faces = sorted(faces)
        self._cad = cad
        shape = cad.tessellation
        self.rows = np.flatnonzero(np.isin(shape.face, self.faces))
        self.area = sum(cad.solid.area(f) for f in self.faces)
        self.euler = shape.euler(self.rows)
        self._nearest = None

    @property
    def nearest(self):
        """Nearest of this patch's triangles; they are numbered within the patch."""
        if self._nearest is None:
            shape = self._cad.tessellation
            self._nearest = Nearest(shape.points, shape.triangles[self.rows])
        return self._nearest

    def faces_at(self, points):
        """(n,) the nearest of the CAD faces."""
        if len(self.faces) == 1:
            return np.full(len(points), self.faces[0])
        return self._cad.tessellation.face[self.rows[self.nearest(points)[1]]]

    def project(self, points):
        """(points of the CAD (n,3), unit normals (n,3) of either sign, the CAD face of each (n,))."""
        points = np.asarray(points, float).reshape(-1, 3)
        shape, carriers = self._cad.tessellation, self._cad.carriers
        near, triangle, _ = self.nearest(points)
        face = shape.face[self.rows[triangle]]
        out, normals = np.empty_like(near), np.empty_like(near)
        for f in np.unique(face):
            rows = np.flatnonzero(face == f)
            q, n = carriers[f].project(points[rows])
            # beyond the face's border, or another sheet of its surface: from the point on the triangles
            allowed = 1e-9 * self._cad.solid.diagonal if carriers[f].kind == "Plane" else 1.2 * self._cad.tolerance
            off = np.linalg.norm(q - near[rows], axis=1) > allowed
            if off.any():
                q[off], n[off] = carriers[f].project(near[rows][off])
            out[rows], normals[rows] = q, n
        unknown = ~np.isfinite(normals).all(1)
        normals[unknown] = shape.normals_at(self.rows[triangle[unknown]])
        return out, normals, face


class Features:
    """Patches, curves and corners of a Cad.

    smooth  degrees between normals up to which an edge is no feature; EVERY_EDGE
    soft    indices of edges that are no features, though sharp
    corners (k,3);  corner_degree (k,): ends of curves there;  corner_patches: list of sets
    patch_of_face   indexed by CAD face
    """

    def __init__(self, cad, smooth=SMOOTH, soft=()):
        self.cad, self.size, self.smooth, self.soft = cad, cad.size, smooth, frozenset(soft)
        shape = cad.tessellation
        self.points, self.triangles, self.triangle_face = shape.points, shape.triangles, shape.face
        self.normals, self.edges = shape.normals(), cad.edges
        self._find_patches()
        self._find_curves()

    def handles(self):
        """Euler characteristic of the solid's whole boundary."""
        return self.cad.tessellation.euler()

    def is_feature(self, k):
        edge = self.edges[k]
        if k in self.soft or (self.smooth < 0.0 and edge.left == edge.right):
            return False
        return max(abs(edge.least - 180.0), abs(edge.greatest - 180.0)) > self.smooth

    def _find_patches(self):
        parent = {f: f for f in self.cad.solid.faces}

        def root(f):
            while parent[f] != f:
                parent[f] = parent[parent[f]]
                f = parent[f]
            return f
        self.feature = [self.is_feature(k) for k in range(len(self.edges))]
        for edge, feature in zip(self.edges, self.feature):
            if not feature:
                parent[root(edge.left)] = root(edge.right)
        groups = {}
        for f in self.cad.solid.faces:
            groups.setdefault(root(f), []).append(f)
        self.patches = [Patch(self.cad, faces) for faces in groups.values()]
        self.patch_of_face = np.full(max(self.cad.solid.faces) + 1, -1)
        for k, patch in enumerate(self.patches):
            self.patch_of_face[patch.faces] = k

    def _find_curves(self):
        ends_at = {}                                          # vertex -> [(edge, 0 at its start, 1 at its end)]
        for k, edge in enumerate(self.edges):
            if self.feature[k]:
                ends_at.setdefault(edge.start, []).append((k, 0))
                ends_at.setdefault(edge.end, []).append((k, 1))
        vertices = sorted({v for e in self.edges for v in (e.start, e.end)})
        found = [v for v in vertices if self._is_corner(v, ends_at.get(v, []))]
        corner = {v: n for n, v in enumerate(found)}
        self.corner_vertex, self.corners = found, self.points[found].reshape(-1, 3)
        starts = [one for v in found for one in ends_at.get(v, [])]
        starts += [(k, 0) for k in range(len(self.edges)) if self.feature[k]]
        used = set()
        self.curves = [self._curve(_chain(one, self.edges, ends_at, corner, used), corner) for one in starts
                       if one[0] not in used]
        self.corner_degree = np.zeros(len(found), int)
        self.corner_patches = [set() for _ in found]
        for curve in self.curves:
            for v in (curve.start, curve.end):
                if v >= 0:
                    self.corner_degree[v] += 1
        for edge in self.edges:
            for v in {edge.start, edge.end} & set(corner):
                self.corner_patches[corner[v]] |= {int(self.patch_of_face[f]) for f in (edge.left, edge.right)}

    def _is_corner(self, vertex, ends):
        if len(ends) == 2:
            return self._turns(ends)
        return bool(ends) or self._is_apex(vertex)

    def _turns(self, ends):
        """Whether two sharp edges that meet in a vertex turn there, or change from convex to concave."""
        out = []
        for k, side in ends:
            p = self.edges[k].samples
            d = p[1] - p[0] if side == 0 else p[-2] - p[-1]
            out.append(d / max(np.linalg.norm(d), 1e-300))
        convex = [self.edges[k].angle < 180.0 for k, _ in ends]
        return math.degrees(math.acos(np.clip(-out[0] @ out[1], -1.0, 1.0))) > TURN or convex[0] != convex[1]

    def _is_apex(self, vertex):
        n = self.cad.tessellation.normals_at(self._rows_round(vertex))
        return len(n) > 2 and math.degrees(math.acos(np.clip((n @ n.T).min(), -1.0, 1.0))) > APEX

    def _rows_round(self, vertex):
        return np.flatnonzero((self.triangles == vertex).any(1))

    def _curve(self, chain, corner):
        samples, s, parts, total = [], [], [], 0.0
        for k, side in chain:
            edge = self.edges[k]
            turn = -1 if side else 1
            p, t = edge.samples[::turn], edge.parameters[::turn]
            arc = total + (edge.length - edge.lengths[::-1] if side else edge.lengths)
            parts.append((edge.tag, arc[0], arc[-1], t, arc))
            samples.append(p[1:] if samples else p)
            s.append(arc[1:] if s else arc)
            total = arc[-1]
        edges = [self.edges[k] for k, _ in chain]
        (first, side), (last, last_side) = chain[0], chain[-1]
        left, right = (int(self.patch_of_face[f]) for f in (self.edges[first].left, self.edges[first].right))
        if side:
            left, right = right, left
        start = corner.get(self.edges[first].end if side else self.edges[first].start, -1)
        end = corner.get(self.edges[last].start if last_side else self.edges[last].end, -1)
        angle = float(np.average([e.angle for e in edges], weights=[max(e.length, 1e-300) for e in edges]))
        return Curve(left, right, start, end, np.vstack(samples), np.concatenate(s), parts, angle,
                     (min(e.least for e in edges), max(e.greatest for e in edges)), [k for k, _ in chain])

    def slivers(self, h, width=0.4):
        """Indices of edges to leave out for patches narrower than width h: of each the border with that neighbour
        with which it has most in common, and most smoothly."""
        out = set()
        for k, patch in enumerate(self.patches):
            borders = [c for c in self.curves if k in (c.left, c.right)]
            around = sum(c.length for c in borders)
            if not around or 2.0 * patch.area / around > width * h:
                continue
            shared = {}
            for c in borders:
                other = c.left if c.right == k else c.right
                if other != k:
                    shared[other] = shared.get(other, 0.0) + c.length * (1.5 - abs(c.angle - 180.0) / 180.0)
            if shared:
                best = max(shared, key=shared.get)
                out |= {e for c in borders if best in (c.left, c.right) for e in c.edges}
        return out


def _chain(first, edges, ends_at, corner, used):
    """[(edge, 0: along it, 1: against it)] from one end of an edge to the next corner, or round; adds to used."""
    chain, here = [], first
    while True:
        used.add(here[0])
        chain.append(here)
        edge = edges[here[0]]
        v = edge.start if here[1] else edge.end
        if v in corner:
            return chain
        ahead = [one for one in ends_at[v] if one[0] != here[0]]
        if not ahead or ahead[0][0] in used:
            return chain
        here = ahead[0]
