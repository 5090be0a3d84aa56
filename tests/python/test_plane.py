# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quads of plane regions whose boundary is given. Needs gmsh importable, as the worker does."""
import numpy as np
import pytest

from hexcon.quads.gmsh_worker.plane.mesher import NoPlaneMesh, mesh_plane
from hexcon.quads.gmsh_worker.plane.region import PlaneRegion
from hexcon.quads.gmsh_worker.plane.split import split_mesh
from hexcon.quads.gmsh_worker.plane.wishes import wishes
from hexcon.quads.gmsh_worker.templates import TEMPLATES

pytestmark = pytest.mark.usefixtures("gmsh_running")


def polygon(corners, counts):
    """(N,2) points of a polygon with so many intervals on each side."""
    corners = np.array(corners, float)
    sides = np.roll(corners, -1, axis=0) - corners
    return np.concatenate([a + np.arange(n)[:, None] / n * s for a, s, n in zip(corners, sides, counts)])


def circle(x, y, radius, count, sense=-1):
    angle = sense * 2 * np.pi * np.arange(count) / count
    return np.column_stack([x + radius * np.cos(angle), y + radius * np.sin(angle)])


def faults(region, mesh):
    """What is wrong with a PlaneMesh, in words; shares nothing with the mesher."""
    found, given = [], np.concatenate(region.loops)
    if not np.array_equal(mesh.points[:len(given)], given):
        found.append("boundary points moved")
    seen = {}
    for quad in mesh.quads.tolist():
        for a, b in zip(quad, quad[1:] + quad[:1]):
            seen[a, b] = seen.get((a, b), 0) + 1
    start, outline = 0, set()
    for loop in region.loops:
        outline |= {(start + k, start + (k + 1) % len(loop)) for k in range(len(loop))}
        start += len(loop)
    if max(seen.values()) > 1 or {e for e in seen if e[::-1] not in seen} != outline:
        found.append("no partition")
    area = 0.0
    for quad in mesh.points[mesh.quads]:
        for k in range(4):
            (ax, ay), (bx, by), (cx, cy) = quad[k - 1], quad[k], quad[(k + 1) % 4]
            if (bx - ax) * (cy - by) - (by - ay) * (cx - bx) <= 0.0:
                found.append("a corner is not convex")
        x, y = quad.T
        area += (x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2
    if abs(area / region.area - 1.0) > 1e-9:
        found.append(f"area {area} for {region.area}")
    return found


SQUARE = [(0, 0), (6, 0), (6, 6), (0, 6)]
# name: (loops, what makes it, quads, least scaled Jacobian)
REGIONS = {
    "square": ([polygon(SQUARE, [6] * 4)], "mapped", 36, 0.999),
    "L": ([polygon([(0, 0), (8, 0), (8, 3), (3, 3), (3, 9), (0, 9)], [8, 3, 5, 6, 3, 9])], "mapped", 42, 0.999),
    "disc": ([circle(0, 0, 3, 16, 1)], "o-grid", 32, 0.85),
    "triangle": ([polygon([(0, 0), (6, 0), (3, 5)], [4, 4, 4])], "midpoint", 12, 0.85),
    "ring": ([circle(0, 0, 3, 16, 1), circle(0, 0, 1, 16)], "ring", None, 0.95),
}


@pytest.mark.parametrize("name", REGIONS)
def test_regions(name):
    loops, road, quads, least = REGIONS[name]
    region = PlaneRegion(loops)
    mesh = mesh_plane(region, 1.0)
    assert not faults(region, mesh)
    assert mesh.name == road and mesh.low >= least and (quads is None or len(mesh.quads) == quads)


LENS = [np.array([(0, 0), (2, -1), (4, 0), (2, 1)], float)], [np.array([2.0, 0.0, 2.0, 0.0])]
OTHERS = {"lens": PlaneRegion(*LENS), "notched lens": PlaneRegion(LENS[0], [-LENS[1][0]]),
          **{name: PlaneRegion(loops) for name, (loops, *_) in REGIONS.items()},
          **{f"uneven rectangle from {k}": PlaneRegion([np.roll(polygon(SQUARE, [2, 4, 5, 1]), k, axis=0)])
             for k in range(12)}}


@pytest.mark.parametrize("name", OTHERS)
def test_templates_leave_what_is_not_theirs(name):
    """They give points with the boundary first, or None; none fails."""
    region = OTHERS[name]
    ones = [np.ones(len(loop), int) for loop in region.loops]
    made = {road: build(region.outline(1.0), ones, region.boundary) for road, (_, build) in TEMPLATES.items()
            if not road.startswith("lattice")}
    assert all(mesh is None or np.array_equal(mesh[0][:len(region.boundary)], region.boundary)
               for mesh in made.values())
    assert name not in REGIONS or made[REGIONS[name][1]] is not None
    assert "uneven" not in name or made["mapped"] is None


def random_region(seed):
    """A rectangle or an L, turned, with up to three round holes; even divisions that suit no lattice in particular."""
    rng = np.random.default_rng(seed)
    w, h = rng.uniform(8, 14), rng.uniform(5, 9)
    corners = [(0, 0), (w, 0), (w, h), (0, h)] if seed % 2 else [(0, 0), (w, 0), (w, 0.6 * h), (0.5 * w, 0.6 * h),
                                                                (0.5 * w, h), (0, h)]
    counts = np.rint(np.linalg.norm(np.roll(corners, -1, axis=0) - corners, axis=1) / rng.uniform(0.7, 1.1)).astype(int)
    if seed % 3:        # opposite sides alike; else only an even sum
        counts[2] = counts[0] - (0 if seed % 2 else counts[4])
        counts[3] = counts[1] - (0 if seed % 2 else counts[3])
        counts = np.maximum(counts, 1) if seed % 2 else np.r_[counts[2] + counts[4], counts[1], counts[2], counts[3],
                                                              counts[4], counts[1] + counts[3]]
    counts[0] += counts.sum() % 2
    holes = [circle(x, 0.3 * h, rng.uniform(0.5, 0.7), 2 * int(rng.integers(4, 7)))
             for x in np.arange(1, 1 + seed % 4) * w / 4]
    angle = rng.uniform(0, 6)
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    loops = [polygon(corners, counts), *holes]
    turns = [np.zeros(len(loop)) for loop in loops]
    turns[0] = PlaneRegion(loops).turns[0]
    return PlaneRegion([loop @ turn for loop in loops], turns)


@pytest.mark.parametrize("seed", range(12))
def test_random_regions(seed):
    region = random_region(seed)
    mesh = mesh_plane(region, 1.0)
    print(seed, mesh.name, len(mesh.quads), mesh.low, mesh.mean)
    assert not faults(region, mesh) and mesh.low > 0.3 and mesh.mean > 0.75
    again = mesh_plane(region, 1.0)
    assert np.array_equal(mesh.points, again.points) and np.array_equal(mesh.quads, again.quads)


@pytest.mark.parametrize("loops,words", [([polygon(SQUARE, [1, 1, 1, 2])], "odd"),
                                         ([polygon(SQUARE[:3], [1] * 3)], "fewer"),
                                         ([polygon(SQUARE, [2] * 4)[::-1]], "no area"),
                                         ([polygon(SQUARE, [2] * 4), circle(3, 3, 1, 2)], "fewer"),
                                         ([polygon(SQUARE, [4] * 4), circle(2, 0.9, 1, 8)], "cross or touch in 2"),
                                         ([polygon(SQUARE, [4] * 4), circle(2, 1, 1, 8)], "cross or touch in 2")])
def test_regions_without_quads_are_refused(loops, words):
    with pytest.raises(NoPlaneMesh, match=words):
        mesh_plane(PlaneRegion(loops), 1.0)


def test_a_cusp_has_quads():
    """Where an arc meets a line along it, the corner of the chords counts, not the curves' angle of 0."""
    straight = polygon([(0, 0), (5, 0), (5, 4), (2, 4), (2, 2)], [5, 4, 3, 3, 1])[:-1]
    loop = np.concatenate([straight, [(2 * np.sin(t), 2 - 2 * np.cos(t)) for t in np.linspace(np.pi / 2, 0, 4)[:-1]]])
    turns = [np.zeros(len(loop))]
    turns[0][[0, 5, 9, 12]] = np.pi, np.pi / 2, np.pi / 2, np.pi / 2
    region = PlaneRegion([loop], turns)
    assert 0.2 < region.limit < 0.3
    mesh = mesh_plane(region, 1.0)
    assert not faults(region, mesh) and mesh.low > 0.5 * region.limit


def test_wishes_of_a_square_a_disc_and_a_ring():
    right = np.full(4, np.pi / 2)
    even, across, along = wishes([right], [np.array([4.0, 3, 4, 3])])
    assert (even.multiple, even.hard) == (2, True) and set(even.terms.values()) == {1}
    assert {frozenset(row.terms) for row in (across, along)} == {frozenset({(0, k), (0, k + 2)}) for k in (0, 1)}
    assert sorted(across.terms.values()) == sorted(along.terms.values()) == [-1, 1]
    assert not (across.hard or along.hard) and across.multiple == along.multiple == 0
    assert [row.multiple for row in wishes([np.zeros(1)], [np.array([12.0])])] == [2, 4]
    rows = wishes([np.zeros(1)] * 2, [np.array([12.0]), np.array([8.0])])
    assert [row.multiple for row in rows] == [2, 2, 0] and rows[2].terms == {(0, 0): 1, (1, 0): -1}


# ------------------------------------------------------------------------------------------------------ splits

def star(rng, count, low, high, sense=1):
    """(count,2) points round the origin at random distances, at even angles."""
    angle = sense * 2 * np.pi * np.arange(count) / count
    return rng.uniform(low, high, count)[:, None] * np.column_stack([np.cos(angle), np.sin(angle)])


@pytest.mark.parametrize("seed", range(6))
def test_splits_of_ragged_regions(seed):
    """Each edge in two quads or on the boundary, no other boundary, no point unused."""
    rng = np.random.default_rng(seed)
    loops = [star(rng, 2 * rng.integers(6, 14), 2.5, 4.0)] + \
        [star(rng, 2 * rng.integers(4, 7), 0.8, 1.6, -1)] * int(seed % 2)
    points, quads = split_mesh(loops)
    given = np.concatenate(loops)
    assert np.array_equal(points[:len(given)], given) and set(quads.ravel()) == set(range(len(points)))
    edges = [(a, b) for quad in quads.tolist() for a, b in zip(quad, quad[1:] + quad[:1])]
    assert len(set(edges)) == len(edges)
    start, outline = 0, set()
    for loop in loops:
        outline |= {(start + k, start + (k + 1) % len(loop)) for k in range(len(loop))}
        start += len(loop)
    assert {e for e in edges if e[::-1] not in set(edges)} == outline


def test_a_narrow_bend_is_meshed_without_gmsh():
    """Rounded by fillets at both sides, less than an element wide: no template has it."""
    bend = [(0, 0), (2, 0), (4, 0), (4, 1.5), (4, 3), (3.2, 3), (2.9, 2.9), (2.8, 2.6), (2.8, 1.3), (2.6, 0.9),
            (2.2, 0.7), (0, 0.7)]
    region = PlaneRegion([np.array(bend, float)])
    mesh = mesh_plane(region, 2.0, paving=False)
    assert not faults(region, mesh) and mesh.low > 0.2
