# SPDX-License-Identifier: LGPL-2.1-or-later
"""A solid of revolution as bands: faces that are one surface all the way round, between full circles.

A body whose faces are surfaces of revolution about one axis, and whose edges between different ones are circles
about it, is a body of revolution by a full turn: each face, or the faces joined in meridians, is bounded by full
circles.
"""
from dataclasses import dataclass, field

import gmsh
import numpy as np

from ..fault import WorkerFault
from .axis import SAMPLES

RIM, MERIDIAN, INNER = range(3)


@dataclass
class Band:
    """faces: CAD faces; rims: (radius, height) of its circles, at most two; meridians: CAD edges in it."""

    faces: list
    rims: list = field(default_factory=list)
    meridians: list = field(default_factory=list)
    kind: str = "other"


def bands_of(solid, axis, carriers):
    """list of Band, in the order of their least face. Raises WorkerFault NOT_REVOLVED."""
    kinds = {e: _kind(solid, axis, carriers, e) for e in solid.edges}
    bands = _joined(solid, kinds)
    owner = {f: band for band in bands for f in band.faces}
    for edge, kind in kinds.items():
        first, second = (owner[f] for f in solid.faces_of[edge])
        if kind == MERIDIAN:
            first.meridians.append(edge)
        if kind == RIM and first is not second:
            place = _place(solid, axis, edge)
            for band in (first, second):
                if all(np.linalg.norm(place - rim) > 10 * solid.tolerance for rim in band.rims):
                    band.rims.append(place)
    for band in bands:
        band.kind = carriers[band.faces[0]].kind
        if len(band.rims) > 2:
            raise WorkerFault("NOT_REVOLVED", f"Face{band.faces[0]} has {len(band.rims)} rims", band.faces)
    return bands


def _place(solid, axis, edge):
    return axis.flat(solid.edge_points(edge, np.array([0.0, 0.37, 0.71])))[0].mean(axis=0)


def _kind(solid, axis, carriers, edge):
    """RIM: a circle about the axis; MERIDIAN: in a plane with the axis; INNER: across a ball or a plane,
    in pieces by whatever edges."""
    first, second = solid.faces_of[edge]
    flat, angle = axis.flat(solid.edge_points(edge, np.linspace(0.0, 1.0, SAMPLES)))
    if np.ptp(flat, axis=0).max() <= solid.tolerance and flat[:, 0].max() > solid.tolerance:
        return RIM
    off = np.abs(np.sin(angle - angle[SAMPLES // 2])) * flat[:, 0]
    kinds = {carriers[first].kind, carriers[second].kind}
    same = len(kinds) == 1 or "other" in kinds      # two surfaces of revolution that share a meridian are one
    if off.max() <= solid.tolerance and same:
        return MERIDIAN
    if kinds in ({"Sphere"}, {"Plane"}):
        return INNER
    names = " and ".join(f"Face{f}" for f in (first, second))
    raise WorkerFault("NOT_REVOLVED", f"{names} meet in no circle about the axis", [first, second])


def _joined(solid, kinds):
    """Faces joined over all edges but rims."""
    root = {f: f for f in solid.faces}

    def find(f):
        while root[f] != f:
            root[f] = f = root[root[f]]
        return f
    for edge, kind in kinds.items():
        if kind != RIM:
            first, second = (find(f) for f in solid.faces_of[edge])
            root[max(first, second)] = min(first, second)
    groups = {}
    for f in solid.faces:
        groups.setdefault(find(f), []).append(f)
    return [Band(group) for group in groups.values()]


def moments(band, axis, solid):
    """(area, integral of height over the area) of a band's CAD faces."""
    total = np.zeros(2)
    for face in band.faces:
        area = solid.area(face)
        centre = np.array(gmsh.model.occ.getCenterOfMass(2, face))
        total += area, area * axis.flat(centre[None])[0][0, 1]
    return total
