# SPDX-License-Identifier: LGPL-2.1-or-later
"""Planes in which a region's outline runs along axes: its own, turned; and angle against radius about a centre.

A ring round a centre is cut open along a radius, between a point of its outer loop and one of the loop inside.
"""
from dataclasses import dataclass

import numpy as np

ROUND = 0.2         # of its radius: how far a loop that tells a centre may be off a circle
ARC = np.radians(40.0)      # turning from which an arc tells one
OFF_ARC = 1e-3      # of its radius: how far such an arc may be off a circle
CENTRES = 3


@dataclass(frozen=True)
class ChartLoop:
    """points (n,2) in the chart; source (n,): number of the region's segment, loop after loop, that begins there, -1 on
    a cut; hard (n,) bool: a corner of the outline, or an end of a cut."""

    points: np.ndarray
    source: np.ndarray
    hard: np.ndarray


def charts_of(loops, corner):
    """Iterator over lists of ChartLoop, the region's own plane first.

    loops   list of (N,2) points, outer loop first;  corner: list of (N,) bool, corners of the outline
    """
    angle = _frame_of(loops)
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    first = np.concatenate([[0], np.cumsum([len(p) for p in loops])[:-1]])
    yield [ChartLoop(p @ turn, a + np.arange(len(p)), c) for p, a, c in zip(loops, first, corner)]
    for centre in _centres(loops, corner):
        chart = _polar(loops, corner, first, centre)
        if chart is not None:
            yield chart


def _frame_of(loops):
    """Angle in radians, within a quarter turn, at which most of the outline's length runs straight along axes."""
    ways = np.concatenate([np.roll(p, -1, axis=0) - p for p in loops])
    way = ways[:, 0] + 1j * ways[:, 1]
    length = np.abs(way)
    total = (length * (way / np.maximum(length, 1e-300)) ** 4).sum()
    return float(np.angle(total) / 4) if abs(total) > 1e-9 * length.sum() else 0.0


def _centres(loops, corner):
    """Centres of the loops that are nearly round, and of arcs of the outer loop; the longest first."""
    found = []
    for points in loops:
        centre, radius, off = _circle(points)
        if off < ROUND * radius:
            found.append((np.linalg.norm(points - np.roll(points, 1, axis=0), axis=1).sum(), centre))
    for chain in _smooth_chains(loops[0], corner[0]):
        way = np.diff(chain, axis=0)
        angle = np.arctan2(way[:, 1], way[:, 0])
        turning = np.abs((np.diff(angle) + np.pi) % (2 * np.pi) - np.pi).sum()
        centre, radius, off = _circle(chain)
        if turning > ARC and off < OFF_ARC * radius:
            found.append((np.linalg.norm(way, axis=1).sum(), centre))
    size = np.ptp(loops[0], axis=0).max()
    centres = []
    for _, centre in sorted(found, key=lambda one: -round(float(one[0]), 9)):
        if all(np.linalg.norm(centre - other) > 1e-3 * size for other in centres):
            centres.append(centre)
    return centres[:CENTRES]


def _smooth_chains(points, corner):
    """(k,2) parts of a loop between corners."""
    starts = np.flatnonzero(corner)
    for a, b in zip(starts, np.append(starts[1:], starts[:1] + len(points))):
        if b - a > 3:
            yield points[np.arange(a, b + 1) % len(points)]


def _circle(points):
    """(centre (2,), radius, greatest distance from the circle) by least squares (Kasa 1976)."""
    middle = points.mean(axis=0)
    rel = points - middle
    found = np.linalg.lstsq(np.c_[2 * rel, np.ones(len(rel))], (rel * rel).sum(axis=1), rcond=None)[0]
    radius = float(np.sqrt(max(found[2] + found[:2] @ found[:2], 0.0)))
    off = np.abs(np.linalg.norm(rel - found[:2], axis=1) - radius).max()
    return middle + found[:2], radius, float(off)


def _polar(loops, corner, first, centre):
    """The chart (-angle times mean radius, radius) about a centre; None where the region holds it."""
    rel = [points - centre for points in loops]
    radii = [np.linalg.norm(r, axis=1) for r in rel]
    mean = float(np.concatenate(radii).mean())
    if min(r.min() for r in radii) < 1e-3 * mean:
        return None
    winds = [_winding(r) for r in rel]
    if winds[0] == 0:
        return _open(rel, radii, mean, corner, first) if not any(winds) else None
    inner = [k for k, w in enumerate(winds) if w == -1]
    return _cut(rel, radii, mean, corner, first, inner[0]) if len(inner) == 1 else None


def _winding(rel):
    angle = np.arctan2(rel[:, 1], rel[:, 0])
    return int(np.rint(((np.roll(angle, -1) - angle + np.pi) % (2 * np.pi) - np.pi).sum() / (2 * np.pi)))


def _angles(rel, towards):
    """(N,) angles along a loop without jumps, the first within half a turn of `towards`."""
    angle = np.arctan2(rel[:, 1], rel[:, 0])
    start = towards + (angle[0] - towards + np.pi) % (2 * np.pi) - np.pi
    return start + np.concatenate([[0.0], np.cumsum((np.diff(angle) + np.pi) % (2 * np.pi) - np.pi)])


def _open(rel, radii, mean, corner, first):
    """A region that does not go round the centre."""
    outer = _angles(rel[0], 0.0)
    middle = (outer.min() + outer.max()) / 2
    made = [outer] + [_angles(r, middle) for r in rel[1:]]
    return [ChartLoop(np.stack([-mean * t, r], -1), a + np.arange(len(r)), c)
            for t, r, a, c in zip(made, radii, first, corner)]


def _cut(rel, radii, mean, corner, first, inner):
    """A ring: outer and inner loop in one, cut where that is clear of other holes and both loops go round."""
    found = _place_of_cut(rel, inner)
    if found is None:
        return None
    a, b = found
    start = float(np.arctan2(rel[0][a, 1], rel[0][a, 0]))
    outer = _angles(np.roll(rel[0], -a, axis=0), start)
    back = _angles(np.roll(rel[inner], -b, axis=0), start) + 2 * np.pi
    rows = [np.roll(np.arange(len(rel[0])), -a), np.roll(np.arange(len(rel[inner])), -b)]
    angle = np.concatenate([outer, [outer[0] + 2 * np.pi], back, [back[0] - 2 * np.pi]])
    radius = np.concatenate([radii[0][rows[0]], radii[0][[a]], radii[inner][rows[1]], radii[inner][[b]]])
    source = np.concatenate([first[0] + rows[0], [-1], first[inner] + rows[1], [-1]])
    hard = np.concatenate([corner[0][rows[0]], [True], corner[inner][rows[1]], [True]])
    hard[[0, len(rows[0]) + 1]] = True
    chart = [ChartLoop(np.stack([-mean * angle, radius], -1), source, hard)]
    for k in range(1, len(rel)):
        if k != inner:
            t = _angles(rel[k], start + np.pi)
            chart.append(ChartLoop(np.stack([-mean * t, radii[k]], -1), first[k] + np.arange(len(t)), corner[k]))
    return chart


def _place_of_cut(rel, inner):
    """(row of the outer loop, row of the inner one) on nearly one radius, farthest from other holes; None: nowhere."""
    angles = [np.arctan2(r[:, 1], r[:, 0]) for r in rel]
    others = [t for k, t in enumerate(angles) if k not in (0, inner)]
    fit = [_goes_round(rel[k]) for k in (0, inner)]
    best = None
    for a in np.flatnonzero(fit[0]):
        gap = np.abs((angles[inner] - angles[0][a] + np.pi) % (2 * np.pi) - np.pi)
        gap[~fit[1]] = np.inf
        b = int(np.argmin(np.round(gap, 9)))
        if gap[b] > 0.5:
            continue
        clear = min((_clearance(t, angles[0][a]) for t in others), default=np.pi)
        score = round(clear - 0.5 * gap[b], 6)
        if clear > 0.0 and (best is None or score > best[0]):
            best = score, int(a), b
    return None if best is None else best[1:]


def _goes_round(rel):
    """(N,) bool: both segments at a point run more across the radius than along it."""
    way = np.roll(rel, -1, axis=0) - rel
    along = np.abs((way * (rel + way / 2)).sum(axis=1))
    across = np.abs(way[:, 0] * rel[:, 1] - way[:, 1] * rel[:, 0])
    fine = across > 2.0 * along
    return fine & np.roll(fine, 1)


def _clearance(angles, angle):
    """How far, in radians, a ray is from the angles that a hole takes up; 0 or less where it meets it."""
    rel = np.sort((angles - angle) % (2 * np.pi))
    return float(min(rel[0], 2 * np.pi - rel[-1])) if 2 * np.pi - (rel[-1] - rel[0]) > np.pi else 0.0
