# SPDX-License-Identifier: LGPL-2.1-or-later
"""The imported solid as a plain boundary representation: faces, loops, edges, vertices.

Numbers are gmsh's tags. For a file with one solid and nothing else they are the numbers of
FreeCAD's Face1, Face2, ... (both walk the shape with TopExp_Explorer).
Lengths are in the units of the file (millimetres for STEP).
"""
import contextlib
from functools import cached_property

import gmsh
import numpy as np

from .fault import WorkerFault

SAMPLES = 513  # per edge, for its arc length: enough for 1e-6 of the length on a full circle


def load(path):
    """Import one BREP or STEP file into a new gmsh model; returns a Solid.

    Raises WorkerFault BAD_SHAPE unless it holds exactly one closed solid, FILE_FORMAT if unreadable.
    """
    gmsh.option.setString("Geometry.OCCTargetUnit", "MM")
    gmsh.model.add("solid")
    try:
        gmsh.model.occ.importShapes(path, highestDimOnly=False)
        gmsh.model.occ.synchronize()
    except Exception as error:
        raise WorkerFault("FILE_FORMAT", f"gmsh cannot read the CAD file: {error}") from error
    volumes = [tag for _, tag in gmsh.model.getEntities(3)]
    if len(volumes) != 1:
        raise WorkerFault("BAD_SHAPE", f"the shape holds {len(volumes)} solids{_boxes(volumes)}; exactly one is needed"
                          + (": choose it by --solid N" if volumes else ""))
    return Solid(volumes[0])


@contextlib.contextmanager
def other_model(name):
    """A gmsh model of its own while it lasts; then the one before is the current one again."""
    before = gmsh.model.getCurrent()
    gmsh.model.add(name)
    try:
        yield
    finally:
        gmsh.model.remove()
        gmsh.model.setCurrent(before)


def _boxes(volumes):
    """The first solids in words, by their sizes and places, in the order that --solid counts."""
    told = []
    for number, tag in enumerate(volumes[:20], 1):
        low, high = np.array(gmsh.model.getBoundingBox(3, tag)).reshape(2, 3)
        size = " x ".join(f"{length:.4g}" for length in high - low)
        told.append(f"{number}: {size} at ({', '.join(f'{x:.4g}' for x in low)})")
    return f" ({'; '.join(told)}{'; ...' if len(volumes) > 20 else ''})" if told else ""


def count_shells(solid):
    """Number of groups of faces joined by edges: one more than the solid has cavities."""
    left, shells = set(solid.faces), 0
    while left:
        shells += 1
        ring = [left.pop()]
        while ring:
            around = {g for e in solid.boundary[ring.pop()] for g in solid.faces_of[abs(e)]} & left
            left -= around
            ring += around
    return shells


class Solid:
    """One solid of the current gmsh model.

    faces          list of face tags
    boundary[f]    list of signed edge tags in wire order, a seam twice with both signs
    loops[f]       the same cut into closed loops; a face with a seam has one loop
    ends[e]        (vertex at the start of the parametrisation, vertex at the end)
    faces_of[e]    list of face tags, twice the same tag for a seam
    vertex[v]      (3,) float64
    left_out       {edge that is taken as a point, and is in none of the above: vertex it has become}
    """

    def __init__(self, volume):
        self.volume = volume
        self.faces = sorted(abs(t) for _, t in gmsh.model.getBoundary([(3, volume)], oriented=False))
        self.boundary = {f: _signed_edges(f) for f in self.faces}
        self.edges = sorted({abs(e) for b in self.boundary.values() for e in b})
        self.vertex = {}
        self.left_out = {}
        box = self.box()
        self.diagonal = float(np.linalg.norm(box[3:] - box[:3]))
        self.tolerance = 1e-7 * max(1.0, self.diagonal / 1000.0)
        self._drop_degenerate()
        self.ends = {e: self._ends(e) for e in self.edges}
        self.faces_of = {e: [] for e in self.edges}
        for f in self.faces:
            for e in self.boundary[f]:
                self.faces_of[abs(e)].append(f)
        open_edges = [e for e in self.edges if len(self.faces_of[e]) != 2]
        if open_edges:
            raise WorkerFault("BAD_SHAPE", f"the solid is not closed: {len(open_edges)} edges do not lie "
                              "between two faces")
        self.loops = {f: self._loops(f) for f in self.faces}
        self._tables = {}
        self._areas = {}

    def box(self):
        """(6,) least and largest coordinates, of OCC: a little too wide."""
        return np.array(gmsh.model.getBoundingBox(3, self.volume))

    def _drop_degenerate(self):
        """Poles and apexes are edges of length zero in OCC, or nearly, where a file gives them in decimals: they bound
        nothing."""
        dropped = {e for e in self.edges if _spread(e) < self.tolerance}
        if dropped:
            self.edges = [e for e in self.edges if e not in dropped]
            self.boundary = {f: [e for e in b if abs(e) not in dropped] for f, b in self.boundary.items()}

    def leave_out(self, edges):
        """Take edges as points: the vertices at their ends are one from now on. Each face must keep some edge."""
        for edge in edges:
            kept, gone = self.ends.pop(edge)
            del self.faces_of[edge]
            self.left_out[edge] = kept
            self.left_out = {e: kept if v == gone else v for e, v in self.left_out.items()}
            self.ends = {e: tuple(kept if v == gone else v for v in ends) for e, ends in self.ends.items()}
            if gone != kept:
                del self.vertex[gone]
        self.edges = [e for e in self.edges if e not in self.left_out]
        self.boundary = {f: [e for e in b if abs(e) not in self.left_out] for f, b in self.boundary.items()}
        self.loops = {f: self._loops(f) for f in self.faces}

    def _ends(self, edge):
        tags = [t for _, t in gmsh.model.getBoundary([(1, edge)], combined=False, oriented=False)]
        for v in tags:
            if v not in self.vertex:
                self.vertex[v] = np.array(gmsh.model.getValue(0, v, []))
        if not tags:
            raise WorkerFault("BAD_SHAPE", f"edge {edge} of the CAD has no vertex")
        first, last = tags[0], tags[-1]
        start = np.array(gmsh.model.getValue(1, edge, [_bounds(edge)[0]]))
        if np.linalg.norm(start - self.vertex[first]) > np.linalg.norm(start - self.vertex[last]):
            first, last = last, first
        return first, last

    def end_gap(self, edge):
        """How far the curve of an edge ends from the vertices that it is to end in."""
        ends = np.array(gmsh.model.getValue(1, edge, _bounds(edge))).reshape(2, 3)
        return float(np.linalg.norm(ends - [self.vertex[v] for v in self.ends[edge]], axis=1).max())

    def start(self, signed):
        """Vertex where a signed edge begins."""
        return self.ends[abs(signed)][0 if signed > 0 else 1]

    def end(self, signed):
        """Vertex where a signed edge ends."""
        return self.start(-signed)

    def _loops(self, face):
        """Closed loops of signed edges; the signs of closed edges mean nothing."""
        edges = self.boundary[face]
        if len({abs(e) for e in edges}) < len(edges):
            return [list(edges)]
        loops, current = [], []
        for e in edges:
            current.append(e)
            if self.end(e) == self.start(current[0]):
                loops.append(current)
                current = []
        return loops + ([current] if current else [])

    def _table(self, edge):
        """(parameters, arc lengths) of SAMPLES points of an edge, computed once."""
        if edge not in self._tables:
            lo, hi = _bounds(edge)
            t = np.linspace(lo, hi, 2 if self.is_line(edge) else SAMPLES)
            p = np.array(gmsh.model.getValue(1, edge, t)).reshape(-1, 3)
            arc = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(p, axis=0), axis=1))])
            self._tables[edge] = (t, arc, p)
        return self._tables[edge]

    @staticmethod
    def is_line(edge):
        return gmsh.model.getType(1, edge) == "Line"

    @staticmethod
    def type_of(face):
        """"Plane", "Cylinder", "Cone", "Sphere", "Torus", "BSpline surface" ..."""
        return gmsh.model.getType(2, face)

    @staticmethod
    def is_plane(face):
        return Solid.type_of(face) == "Plane"

    @staticmethod
    def plane_normal(face):
        """Unit normal (3,) of a plane face, of either sense."""
        low, high = gmsh.model.getParametrizationBounds(2, face)
        normal = np.array(gmsh.model.getNormal(face, (np.array(low) + np.array(high)) / 2))
        return normal / np.linalg.norm(normal)

    def length(self, edge):
        return float(self._table(abs(edge))[1][-1])

    def area(self, face):
        if face not in self._areas:
            self._areas[face] = gmsh.model.occ.getMass(2, face)
        return self._areas[face]

    @cached_property
    def exact_volume(self):
        """Of OCC, as areas are."""
        return gmsh.model.occ.getMass(3, self.volume)

    @cached_property
    def exact_area(self):
        return sum(self.area(f) for f in self.faces)

    def turning(self, edge):
        """Total angle in radians through which the tangent of an edge turns."""
        p = self._table(abs(edge))[2]
        if len(p) < 3:
            return 0.0
        d = np.diff(p, axis=0)
        d = d / np.maximum(np.linalg.norm(d, axis=1, keepdims=True), 1e-300)
        return float(np.arccos(np.clip((d[1:] * d[:-1]).sum(1), -1.0, 1.0)).sum() * len(d) / (len(d) - 1))

    def edge_points(self, signed, fractions):
        """Points (m,3) of a signed edge at fractions (m,) of its arc length; ends are the CAD vertices."""
        edge = abs(signed)
        f = np.asarray(fractions, float)
        f = f if signed > 0 else 1.0 - f
        points = np.array(gmsh.model.getValue(1, edge, self._parameters(edge, f))).reshape(-1, 3)
        points[f <= 0.0] = self.vertex[self.ends[edge][0]]
        points[f >= 1.0] = self.vertex[self.ends[edge][1]]
        return points

    def _parameters(self, edge, fractions):
        """Curve parameters at fractions of the arc length, along the parametrisation."""
        t, arc, _ = self._table(edge)
        return np.interp(fractions * arc[-1], arc, t)

    def fractions(self, edge, parameters):
        """Fractions of the arc length at curve parameters, along the parametrisation."""
        t, arc, _ = self._table(edge)
        return np.interp(parameters, t, arc) / arc[-1]

    def edge_on_face(self, signed, fractions, face, side=0):
        """(m,2) surface parameters of edge_points on a face; side 0 or 1 of a seam."""
        f = np.asarray(fractions, float)
        t = self._parameters(abs(signed), f if signed > 0 else 1.0 - f)
        return np.array(gmsh.model.reparametrizeOnSurface(1, abs(signed), t, face, side)).reshape(-1, 2)

    @staticmethod
    def is_elementary(face):
        """Plane, quadric or torus: cheap to project on."""
        return Solid.type_of(face) in ("Plane", "Cylinder", "Cone", "Sphere", "Torus")

    @staticmethod
    def face_points(face, parameters):
        """(m,3) points of a face at parameters (m,2)."""
        return np.array(gmsh.model.getValue(2, face, np.asarray(parameters).ravel())).reshape(-1, 3)

    def tangent(self, signed, at_end=False):
        """Unit direction (3,) of a signed edge at its start, or at its end."""
        f = np.array([0.0, 1e-3]) if not at_end else np.array([1.0 - 1e-3, 1.0])
        p = self.edge_points(signed, f)
        return (p[1] - p[0]) / max(np.linalg.norm(p[1] - p[0]), 1e-300)

    @staticmethod
    def project(dim, tag, points):
        """The nearest points (m,3) of a CAD face (dim 2) or edge (dim 1); one call for all of them."""
        points = np.asarray(points, float).reshape(-1, 3)
        if not len(points):
            return points
        near, _ = gmsh.model.getClosestPoint(dim, tag, points.ravel())
        return np.array(near).reshape(-1, 3)


def _signed_edges(face):
    return [t for _, t in gmsh.model.getBoundary([(2, face)], combined=False, oriented=True)]


def _bounds(edge):
    lo, hi = gmsh.model.getParametrizationBounds(1, edge)
    return float(lo[0]), float(hi[0])


def _spread(edge):
    """How far five points of an edge are apart, in the direction of an axis."""
    lo, hi = _bounds(edge)
    p = np.array(gmsh.model.getValue(1, edge, np.linspace(lo, hi, 5))).reshape(-1, 3)
    return float(np.ptp(p, axis=0).max())
