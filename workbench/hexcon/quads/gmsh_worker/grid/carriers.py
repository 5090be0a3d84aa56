# SPDX-License-Identifier: LGPL-2.1-or-later
"""What CAD faces and edges lie on, in closed form where there is one, and the nearest points on it.

Open CASCADE's parametrisations (gp_Pln, gp_Cylinder ... in its reference) tell the closed forms from a few values; each
is checked against others before it is believed.
"""
import math
from dataclasses import dataclass, field

import gmsh
import numpy as np

import hexcon_native as hn

FLAT = 7            # places each way, by which a face is found flat
_AGREES = 1e-9      # part of the size of what is described: a closed form that is farther off is none


@dataclass(frozen=True)
class Carrier:
    """A surface or a curve without its border.

    kind     "Plane" (origin, axis: normal), "Cylinder" (origin, axis, radius), "Sphere" (origin: centre, radius),
             "Cone" (origin: apex, axis into the half that counts, slope: radius / height),
             "Torus" (origin, axis, radius, minor); "Line" (origin, axis), "Circle" (origin, axis, radius);
             "other": asks gmsh
    origin   (3,);  axis: (3,) unit;  radius, minor, slope: floats
    """

    dim: int
    tag: int
    kind: str
    origin: np.ndarray = field(default_factory=lambda: np.zeros(3))
    axis: np.ndarray = field(default_factory=lambda: np.array([0.0, 0.0, 1.0]))
    radius: float = 0.0
    minor: float = 0.0
    slope: float = 0.0

    @property
    def core(self):
        """The hexcon_native.Carrier of a closed form."""
        sizes = {"Cone": (math.atan(self.slope),), "Torus": (self.radius, self.minor), "Plane": (),
                 "Line": ()}.get(self.kind, (self.radius,))
        return hn.Carrier(self.kind.lower(), tuple(self.origin), tuple(self.axis), sizes=sizes)

    def project(self, points):
        """(nearest points (n,3), unit normals of a surface or tangents of a curve (n,3), of either sign)."""
        points = np.asarray(points, float).reshape(-1, 3)
        if not len(points):
            return points.copy(), points.copy()
        if self.kind != "other":
            return hn.project_points(points, np.zeros(len(points), int), [self.core])
        return _by_gmsh(self, points)


def surface_carrier(face, scale):
    """Carrier of a CAD face; scale: a length to compare errors with."""
    kind = gmsh.model.getType(2, face)
    # a surface that is trimmed in itself, as some unions leave it, is unknown to gmsh
    for name in (kind,) if kind in _SURFACES else _SURFACES if kind == "Unknown" else ():
        found = _SURFACES[name](face)
        if found is None:
            continue
        made = Carrier(2, face, name, **found)
        low, high = (np.array(b) for b in gmsh.model.getParametrizationBounds(2, face))
        at = low + _PROBES * (high - low)
        if _agrees(made, np.array(gmsh.model.getValue(2, face, at.ravel())).reshape(-1, 3), scale):
            return made
    return _flat(face, scale) or Carrier(2, face, "other")


def _flat(face, scale):
    """The plane that a face of another kind lies in, as those of ruled bodies and of some files do, or None."""
    low, high = (np.array(b) for b in gmsh.model.getParametrizationBounds(2, face))
    share = np.stack(np.meshgrid(*[np.linspace(0.0, 1.0, FLAT)] * 2), -1).reshape(-1, 2)
    points = _values(face, low + share * (high - low))
    middle = points.mean(0)
    axis = np.linalg.svd(points - middle)[2][2]
    flat = np.abs((points - middle) @ axis).max() <= _AGREES * scale
    return Carrier(2, face, "Plane", middle, axis) if flat else None


def curve_carrier(edge, scale):
    """Carrier of a CAD edge."""
    kind = gmsh.model.getType(1, edge)
    found = _CURVES[kind](edge) if kind in _CURVES else None
    if found is not None:
        made = Carrier(1, edge, kind, **found)
        low, high = (float(b[0]) for b in gmsh.model.getParametrizationBounds(1, edge))
        points = np.array(gmsh.model.getValue(1, edge, low + _PROBES[:, 0] * (high - low))).reshape(-1, 3)
        if _agrees(made, points, scale):
            return made
    return Carrier(1, edge, "other")


_PROBES = np.array([[0.0, 0.0], [1.0, 0.3], [0.13, 1.0], [0.41, 0.57], [0.72, 0.19], [0.93, 0.86], [0.29, 0.77]])


def _agrees(carrier, points, scale):
    return np.abs(carrier.project(points)[0] - points).max() <= _AGREES * scale


def _values(face, *parameters):
    return np.array(gmsh.model.getValue(2, face, np.ravel(parameters).astype(float))).reshape(-1, 3)


def _unit(vectors):
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-300)


# O + u X + v Y
def _plane(face):
    o, x, y = _values(face, (0, 0), (1, 0), (0, 1))
    return {"origin": o, "axis": _unit(np.cross(x - o, y - o))}


# O + r (cos u X + sin u Y) + v Z
def _cylinder(face):
    here, there, up = _values(face, (0, 0), (np.pi, 0), (0, 1))
    return {"origin": (here + there) / 2, "axis": _unit(up - here), "radius": np.linalg.norm(here - there) / 2}


# O + (R + v sin a)(cos u X + sin u Y) + v cos a Z
def _cone(face):
    a, b, c, d = _values(face, (0, 0), (np.pi, 0), (0, 1), (np.pi, 1))
    low, high, across = (a + b) / 2, (c + d) / 2, _unit(a - b)
    here, there = ((a - b) @ across) / 2, ((c - d) @ across) / 2
    if abs(there - here) < 1e-12:
        return None
    apex = low - here / (there - here) * (high - low)
    bounds = np.array(gmsh.model.getParametrizationBounds(2, face))
    middle = _values(face, bounds.mean(0))[0]
    axis = _unit(high - low)
    return {"origin": apex, "axis": axis if (middle - apex) @ axis > 0.0 else -axis,
            "slope": abs(there - here) / np.linalg.norm(high - low)}


# O + r cos v (cos u X + sin u Y) + r sin v Z
def _sphere(face):
    here, there = _values(face, (0, 0), (np.pi, 0))
    return {"origin": (here + there) / 2, "radius": np.linalg.norm(here - there) / 2}


# O + (R + r cos v)(cos u X + sin u Y) + r sin v Z
def _torus(face):
    out, inner, there, quarter = _values(face, (0, 0), (0, np.pi), (np.pi, 0), (np.pi / 2, 0))
    centre, minor = (out + there) / 2, np.linalg.norm(out - inner) / 2
    radius = np.linalg.norm(out - centre) - minor
    if minor > radius:          # it crosses itself
        return None
    return {"origin": centre, "axis": _unit(np.cross(out - centre, quarter - centre)), "radius": radius,
            "minor": minor}


# O + t X
def _line(edge):
    a, b = np.array(gmsh.model.getValue(1, edge, [0.0, 1.0])).reshape(2, 3)
    return {"origin": a, "axis": _unit(b - a)}


# O + r (cos t X + sin t Y)
def _circle(edge):
    a, b, c = np.array(gmsh.model.getValue(1, edge, [0.0, np.pi / 2, np.pi])).reshape(3, 3)
    o = (a + c) / 2
    return {"origin": o, "axis": _unit(np.cross(a - o, b - o)), "radius": np.linalg.norm(a - o)}


_SURFACES = {"Plane": _plane, "Cylinder": _cylinder, "Cone": _cone, "Sphere": _sphere, "Torus": _torus}
_CURVES = {"Line": _line, "Circle": _circle}


def _by_gmsh(c, p):
    found = np.array(gmsh.model.getClosestPoint(c.dim, c.tag, p.ravel())[0])    # its parameters are 0 in gmsh 4.8
    ask = surface_normals if c.dim == 2 else _tangents
    return found.reshape(-1, 3), ask(c.tag, found.reshape(-1, 3))


def surface_normals(face, points):
    """(n,3) unit normals of gmsh at points of a CAD face, NaN where it finds none."""
    return _at_parameters(2, face, points, lambda uv: gmsh.model.getNormal(face, uv))


def _tangents(edge, points):
    return _at_parameters(1, edge, points, lambda t: gmsh.model.getDerivative(1, edge, t))


def _at_parameters(dim, tag, points, ask):
    """Unit vectors that gmsh gives at points of an entity; NaN where it cannot tell their parameters."""
    try:
        return _unit(np.array(ask(gmsh.model.getParametrization(dim, tag, points.ravel()))).reshape(-1, 3))
    except Exception:       # gmsh raises Exception itself, for one bad point among many
        if len(points) == 1:
            return np.full((1, 3), np.nan)
        half = len(points) // 2
        return np.vstack([_at_parameters(dim, tag, part, ask) for part in (points[:half], points[half:])])
