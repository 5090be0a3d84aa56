# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids of unit cubes as models with patches, curves and corners, known without any CAD; and hexes that fill them.

And captured_faults: what is wrong with a captured mesh, by code of its own.
"""
from collections import Counter, defaultdict

import numpy as np
from mesh_checker import boundary_faults, conformity_faults

AXES = np.eye(3, dtype=int)


def _boundary(cubes):
    """[(quad of four lattice points, counter-clockwise from outside; its outward normal)]."""
    out = []
    for cube in sorted(cubes):
        for axis in range(3):
            u, v = AXES[(axis + 1) % 3], AXES[(axis + 2) % 3]
            for sign in (1, -1):
                normal = sign * AXES[axis]
                if tuple(np.array(cube) + normal) in cubes:
                    continue
                low = np.array(cube) + (AXES[axis] if sign > 0 else 0)
                ring = [low, low + u, low + u + v, low + v][::sign]
                out.append(([tuple(int(x) for x in p) for p in ring], tuple(int(x) for x in normal)))
    return out


class VoxelCurve:
    def __init__(self, chain, left, right, start, end, angle):
        self.samples, self.left, self.right, self.start, self.end = np.array(chain, float), left, right, start, end
        self.s = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(self.samples, axis=0), axis=1))])
        self.angle, self.angles, self.length = angle, (angle, angle), float(self.s[-1])

    closed = property(lambda self: self.start < 0)

    def sampled(self, s):
        s = np.mod(s, self.length) if self.closed else np.clip(s, 0, self.length)
        return np.stack([np.interp(s, self.s, self.samples[:, k]) for k in range(3)], 1)

    def lengths_of(self, points):
        fine = np.linspace(0, self.length, 1 + 20 * len(self.s))
        gap = np.linalg.norm(np.asarray(points)[:, None] - self.sampled(fine)[None], axis=2)
        return fine[gap.argmin(axis=1)], gap.min(axis=1)


class VoxelPatch:
    def __init__(self, quads):
        self.area = float(len(quads))
        edges = {frozenset(e) for q in quads for e in zip(q, q[1:] + q[:1])}
        self.euler = len({p for q in quads for p in q}) - len(edges) + len(quads)


class VoxelModel:
    """Of a set of cubes (i, j, k) whose boundary is a manifold: of the product's Features what capture asks for."""

    def __init__(self, cubes):
        quads = _boundary(cubes)
        left = {e: q for q, (ring, _) in enumerate(quads) for e in zip(ring, ring[1:] + ring[:1])}
        patch = np.full(len(quads), -1)
        for q in range(len(quads)):
            todo = [q] if patch[q] < 0 else []
            mine = patch.max() + 1
            while todo:
                one = todo.pop()
                if patch[one] >= 0:
                    continue
                patch[one] = mine
                ring, normal = quads[one]
                todo += [o for e in zip(ring, ring[1:] + ring[:1]) if quads[o := left[e[::-1]]][1] == normal]
        self.patches = [VoxelPatch([quads[q][0] for q in np.flatnonzero(patch == p)]) for p in range(patch.max() + 1)]
        names = {p: i for i, p in enumerate(sorted({p for ring, _ in quads for p in ring}))}
        self.points = np.array(sorted(names), float)
        self.triangles = np.array([[names[ring[k]] for k in t] for ring, _ in quads for t in ((0, 1, 2), (0, 2, 3))])
        self.normals = np.repeat(np.array([n for _, n in quads], float), 2, axis=0)
        self.triangle_face, self.patch_of_face = np.repeat(np.arange(len(quads)), 2), patch
        self._find_curves(quads, left, patch, names)

    def _find_curves(self, quads, left, patch, names):
        sharp = {e: (int(patch[q]), int(patch[left[e[::-1]]])) for e, q in left.items()
                 if quads[q][1] != quads[left[e[::-1]]][1]}
        leaving = defaultdict(list)
        for a, b in sharp:
            leaving[a].append(b)
        corners = sorted(v for v, near in leaving.items() if len(near) != 2 or
                         np.any(np.cross(np.subtract(near[0], v), np.subtract(near[1], v))))
        number = {v: k for k, v in enumerate(corners)}
        self.corners = np.array(corners, float).reshape(-1, 3)
        self.corner_vertex = [names[v] for v in corners]
        self.corner_patches = [{int(patch[q]) for q, (ring, _) in enumerate(quads) if v in ring} for v in corners]
        self.corner_degree = np.array([len(leaving[v]) for v in corners], int)
        self.curves, used = [], set()
        for v in corners:
            for w in sorted(leaving[v]):
                chain = [v, w]
                if frozenset(chain) in used:
                    continue
                while chain[-1] not in number:
                    chain.append(next(x for x in leaving[chain[-1]] if x != chain[-2]))
                used |= {frozenset(e) for e in zip(chain, chain[1:])}
                q, other = left[v, w], left[w, v]
                turn = np.dot(np.cross(quads[q][1], np.subtract(w, v)), quads[other][1])
                angle = 90.0 if turn < 0 else 270.0
                self.curves.append(VoxelCurve(chain, *sharp[v, w], number[v], number[chain[-1]], angle))


def is_manifold(cubes):
    """Whether no two quads of the boundary touch in an edge or point only; by their links."""
    quads = [ring for ring, _ in _boundary(cubes)]
    edges = Counter(frozenset(e) for q in quads for e in zip(q, q[1:] + q[:1]))
    if max(edges.values()) > 2:
        return False
    ahead = {(q[k], q[k - 1]): q[(k + 1) % 4] for q in quads for k in range(4)}
    around = Counter(v for v, _ in ahead)
    for v, count in around.items():
        first = here = next(b for a, b in ahead if a == v)
        steps = 0
        while steps == 0 or here != first:
            here, steps = ahead[v, here], steps + 1
        if steps != count:
            return False
    return True


def random_cubes(rng, size=3):
    """A connected solid of cubes with a manifold boundary without a cavity, of a few boxes."""
    while True:
        inside = np.zeros((size,) * 3, bool)
        for _ in range(rng.integers(1, 5)):
            low = rng.integers(0, size, 3)
            high = low + 1 + rng.integers(0, size, 3)
            inside[tuple(slice(a, b) for a, b in zip(low, high))] ^= rng.random() < 0.9
        cubes = {tuple(int(x) for x in c) for c in np.argwhere(inside)}
        if cubes and is_manifold(cubes) and _joined(cubes):
            return cubes


def _joined(cubes):
    seen, todo = set(), [min(cubes)]
    while todo:
        c = todo.pop()
        if c in cubes and c not in seen:
            seen.add(c)
            todo += [tuple(int(x) for x in np.array(c) + s * AXES[k]) for k in range(3) for s in (1, -1)]
    return seen == cubes


def hexes_of(cubes, parts, rng=None, noise=0.0):
    """(points, hexes): each cube in parts^3 hexes; points moved by up to noise / parts."""
    names, hexes = {}, []
    ring = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    for cube in sorted(cubes):
        for cell in np.ndindex(parts, parts, parts):
            at = [tuple(int(parts * cube[k] + cell[k] + r[k]) for k in range(3)) for r in ring]
            hexes.append([names.setdefault(p, len(names)) for p in at])
    points = np.array(list(names), float) / parts
    if rng is not None:
        points += noise / parts * rng.uniform(-1, 1, points.shape)
    return points, np.array(hexes)


def captured_faults(mesh, model):
    """What is wrong with a CapturedMesh, in words: its mesh, or a feature that is not what the model says."""
    found = conformity_faults(mesh.hexes) + boundary_faults(mesh.hexes, mesh.quads)
    if any(set(q) - set(h) for q, h in zip(mesh.quads.tolist(), mesh.hexes[mesh.under].tolist())):
        found.append("a quad that is not on the hex under it")
    curve_of = {frozenset(e): c for e, c in zip(mesh.curve_edges.tolist(), mesh.curve.tolist())}
    if len(curve_of) != len(mesh.curve):
        found.append("an edge on two curves")
    sides = defaultdict(list)
    for q, ring in zip(mesh.patch.tolist(), mesh.quads.tolist()):
        for e in zip(ring, ring[1:] + ring[:1]):
            sides[frozenset(e)].append(q)
    found += [f"patches {p} meet off any curve" for e, p in sides.items() if len(set(p)) > 1 and e not in curve_of]
    for e, c in curve_of.items():
        if sorted(sides.get(e, ())) != sorted((model.curves[c].left, model.curves[c].right)):
            found.append(f"curve {c} between patches {sides.get(e)}")
    for c, curve in enumerate(model.curves):
        found += _curve_faults(mesh, c, curve)
    for p, patch in enumerate(model.patches):
        found += _patch_faults(mesh.quads[mesh.patch == p].tolist(), p, patch.euler)
    return found + _corner_faults(mesh, model)


def _curve_faults(mesh, c, curve):
    degree = Counter(mesh.curve_edges[mesh.curve == c].ravel().tolist())
    ends = sorted(v for v, n in degree.items() if n == 1)
    wanted = [] if curve.start == curve.end else sorted(int(mesh.corner_vertex[k]) for k in (curve.start, curve.end))
    if not degree or max(degree.values()) > 2 or ends != wanted:
        return [f"curve {c} ends at {ends}, not {wanted}"]
    seen, todo = set(), [next(iter(degree))]
    near = defaultdict(list)
    for a, b in mesh.curve_edges[mesh.curve == c].tolist():
        near[a].append(b)
        near[b].append(a)
    while todo:
        v = todo.pop()
        if v not in seen:
            seen.add(v)
            todo += near[v]
    return [] if len(seen) == len(degree) else [f"curve {c} is in pieces"]


def _patch_faults(quads, p, euler):
    edges = defaultdict(list)
    for q, ring in enumerate(quads):
        for e in zip(ring, ring[1:] + ring[:1]):
            edges[frozenset(e)].append(q)
    if len({v for ring in quads for v in ring}) - len(edges) + len(quads) != euler:
        return [f"patch {p} has another Euler characteristic than {euler}"]
    seen, todo = set(), [0]
    while todo:
        q = todo.pop()
        if q not in seen:
            seen.add(q)
            todo += [o for e in zip(quads[q], quads[q][1:] + quads[q][:1]) for o in edges[frozenset(e)]]
    return [] if len(seen) == len(quads) else [f"patch {p} is in pieces"]


def _corner_faults(mesh, model):
    found = []
    if len(set(mesh.corner_vertex.tolist())) != len(model.corners):
        found.append("two corners on one vertex")
    on = defaultdict(set)
    degree = Counter()
    for (a, b), c in zip(mesh.curve_edges.tolist(), mesh.curve.tolist()):
        for v in (a, b):
            on[v].add(c)
            degree[v] += 1
    for v, curves in on.items():
        if len(curves) > 1 and v not in set(mesh.corner_vertex.tolist()):
            found.append(f"curves {curves} meet off any corner")
    for k, v in enumerate(mesh.corner_vertex.tolist()):
        if degree[v] != model.corner_degree[k]:
            found.append(f"corner {k} has {degree[v]} edges of curves, not {model.corner_degree[k]}")
    return found


def euler_of_hexes(hexes):
    """Euler characteristic of the whole complex."""
    lattice = list(np.ndindex(2, 2, 2))
    place = {(i, j, k): [[0, 1], [3, 2]][j][i] + 4 * k for i, j, k in lattice}
    edges, faces = set(), set()
    for h in hexes.tolist():
        for a in lattice:
            for b in lattice:
                if a < b and sum(x != y for x, y in zip(a, b)) == 1:
                    edges.add(frozenset((h[place[a]], h[place[b]])))
        for axis in range(3):
            for side in (0, 1):
                faces.add(frozenset(h[place[a]] for a in lattice if a[axis] == side))
    return len(np.unique(hexes)) - len(edges) + len(faces) - len(hexes)
