# SPDX-License-Identifier: LGPL-2.1-or-later
"""The method `sweep`: quads on one cap, mapped walls, the matching quads on the other cap."""
import numpy as np

from .boundary import orient, outline_of
from .cap import mesh_cap
from .fault import WorkerFault
from .plane_mesh import harmonic
from .recognise import candidates
from .sides import Rings
from .smooth import evenness, scaled_jacobian, space_quality

FOLDED = 0.01      # scaled Jacobian below which a wall quad counts as folded


def sweep_surface(solid, size, link, sizes):
    """dict with points, quads, faces, notes. sizes: SizeField by place, at most `size`.

    Raises WorkerFault NOT_SWEEPABLE with the reason.
    """
    reasons = []
    for choice in candidates(solid):
        try:
            return _sweep(solid, choice, link, sizes)
        except WorkerFault as fault:
            if fault.code != "NOT_SWEEPABLE":
                raise
            reasons.append(f"Face{choice.bottom} -> Face{choice.top}: {fault}")
    raise WorkerFault("NOT_SWEEPABLE", "no sweep gave valid quads: " + "; ".join(reasons[:3]))


def _sweep(solid, choice, link, sizes):
    sweep, plane, top_plane = orient(solid, choice)
    outline = outline_of(solid, sweep, plane, top_plane, sizes)
    cap = mesh_cap(outline, link, f"cap Face{sweep.bottom}")
    rings = Rings(solid, sweep, cap.shares, sizes)
    total = rings.points.shape[1]
    lower = _on_face(solid, sweep.bottom, plane, cap.points, cap.quads, rings.points[0])
    upper = _on_face(solid, sweep.top, top_plane, cap.top, cap.quads, rings.points[-1])
    link.progress("walls", 0.9)
    walls, wall_faces = rings.quads()
    wall_points = rings.points.reshape(-1, 3)
    folded = np.unique(wall_faces[space_quality(wall_points, walls) < FOLDED])
    if len(folded):
        names = ", ".join(f"Face{f}" for f in folded[:5])
        raise WorkerFault("NOT_SWEEPABLE", f"the quads fold over on {names}", folded)
    first = len(wall_points)
    inner = len(lower) - total
    to_lower = np.concatenate([np.arange(total), first + np.arange(inner)])
    to_upper = np.concatenate([first - total + np.arange(total), first + inner + np.arange(inner)])
    ring_count = len(rings.points) - 1
    low, mean = (float(x) for x in cap.quality())
    aspect = 1.0 / float(evenness(cap.points, cap.quads).min())
    return {"points": np.concatenate([wall_points, lower[total:], upper[total:]]),
            "quads": np.concatenate([to_lower[cap.quads[:, ::-1]], walls, to_upper[cap.quads]]),
            "faces": np.concatenate([np.full(len(cap.quads), sweep.bottom), wall_faces,
                                     np.full(len(cap.quads), sweep.top)]),
            "notes": [f"sweep: cap Face{sweep.bottom} -> Face{sweep.top}, {len(cap.quads)} cap quads x "
                      f"{ring_count} rings; cap mesh {cap.name}, scaled Jacobian {low:.3f} to mean {mean:.3f}, "
                      f"edges of a quad up to 1 to {aspect:.1f}"]}


def _on_face(solid, face, plane, flat, quads, outline):
    """Lift plane points to a CAD face: straight up for a plane, else by the outline's height, then projected."""
    fixed = np.arange(len(flat)) < len(outline)
    height = np.zeros((len(flat), 1))
    if not solid.is_plane(face):
        height[fixed, 0] = plane.height(outline)
        height = harmonic(height, quads, fixed)
    points = plane.lift(flat, height[:, 0])
    points[fixed] = outline
    points[~fixed] = solid.project(2, face, points[~fixed])
    if scaled_jacobian(plane.flat(points), quads).min() <= 0.01:
        raise WorkerFault("NOT_SWEEPABLE", f"the quads of cap Face{face} fold over on its CAD face")
    return points
