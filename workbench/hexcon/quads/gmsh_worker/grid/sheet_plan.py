# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which sheets a captured mesh needs, so that no corner of a hex is forced flat.

A sheet lies under patches. Where these meet others at a convex curve it comes out on the other side, as a strip. Over
a flat curve it goes on under the other patch, so patches joined by flat curves are a *group*. At a concave curve it
goes on inside, behind the hexes under the other patch, so that three hexes stay about the curve; where those hexes
are in the way, it takes the other patch in.

Needed is a sheet under a group
 - where an edge inside a patch, or on a flat curve, has not two hexes, or one on a concave curve has one;
 - where a quad across a convex curve has a flat corner, for want of a strip; and round a patch where such a quad
   is at a flat or concave curve: a ring, or where a ring would meet itself, a tape along the curve.
What no placement unfolds even then is mended last: straight corners between convex curves, by a sheet on their other
sides alone, and faces inside with two edges on one patch (chords), by another sheet under it.
"""
from collections import Counter
from dataclasses import dataclass, field

import numpy as np

from .chords import chords
from .sheets import Pinched, along_curve, insert, round_patch

CONVEX, CONCAVE = 140.0, 220.0      # interior dihedral angles in degrees
FLAT_CORNER = 150.0                 # a quad's corner between two curves, in degrees
STRAIGHT_CORNER = 175.0             # with more, no placement will do
PASSES = 5                          # of sheets under groups
RINGS = 3                           # passes of rings
MENDED = 2                          # passes of sheets under patches with chords, which other sheets have left


class Groups:
    """kind (of each curve: "convex", "flat", "concave"), of_patch (group of each patch), corner_angle {(corner, patch):
    degrees}, ends (curves at each corner, twice those that begin and end there)."""

    def __init__(self, model, inside=True):
        self.model = model
        self.kind = ["convex" if c.angle < CONVEX else "concave" if c.angle > CONCAVE else "flat" for c in model.curves]
        parent = list(range(len(model.patches)))

        def root(a):
            while parent[a] != a:
                a = parent[a]
            return a
        for c, kind in zip(model.curves, self.kind):
            if kind == "flat" or (kind == "concave" and not inside):
                parent[max(root(c.left), root(c.right))] = min(root(c.left), root(c.right))
        self.of_patch = np.array([root(k) for k in range(len(parent))], int)
        self.corner_angle = _corner_angles(model)
        self.ends = [[] for _ in model.corners]
        for c in model.curves:
            for k in (c.start, c.end):
                if k >= 0:
                    self.ends[k].append(c)

    def patches(self, group):
        return frozenset(np.flatnonzero(self.of_patch == group).tolist())

    def across(self, c, p):
        """The patch on the other side of curve c than p."""
        curve = self.model.curves[c]
        return curve.right if curve.left == p else curve.left


def _corner_angles(model):
    """(corner, patch) -> angle of the patch there in degrees, by its triangles; of several sectors the mean."""
    corner = np.full(len(model.points), -1)
    corner[np.asarray(model.corner_vertex, int)] = np.arange(len(model.corner_vertex))
    row, at = np.nonzero(corner[model.triangles] >= 0)
    tri = model.triangles[row]
    a, b, c = (model.points[tri[np.arange(len(tri)), (at + j) % 3]] for j in range(3))
    d, e = b - a, c - a
    cosine = (d * e).sum(axis=1) / np.maximum(np.linalg.norm(d, axis=1) * np.linalg.norm(e, axis=1), 1e-300)
    patch = np.asarray(model.patch_of_face)[model.triangle_face[row]]
    out = Counter()
    for k, p, angle in zip(corner[model.triangles[row, at]].tolist(), patch.tolist(),
                           np.degrees(np.arccos(np.clip(cosine, -1, 1))).tolist()):
        out[k, p] += angle
    sectors = Counter(one for curve in model.curves for one in ((curve.start, curve.left), (curve.end, curve.right)))
    return {one: angle / max(sectors[one], 1) for one, angle in out.items()}


@dataclass
class Demands:
    """groups: that need a sheet; across {(curve, patch with flat corners there, or None)}; rings: patches; why."""

    groups: set = field(default_factory=set)
    across: set = field(default_factory=set)
    rings: set = field(default_factory=set)
    why: Counter = field(default_factory=Counter)


def demands(mesh, groups):
    """What of a CapturedMesh wants a sheet. O(H log H)."""
    found = Demands()
    _ask_edges(mesh, groups, found)
    _ask_corners(mesh, groups, found)
    return found


def _ask_edges(mesh, groups, found):
    h = np.flatnonzero(mesh.half_edges.tail < mesh.half_edges.head)
    count, c, group = mesh.hexes_at_half_edge[h], mesh.curve_of_half_edge[h], groups.of_patch[mesh.patch[h // 4]]
    code = np.zeros(len(groups.kind) + 1, int)                # the last for no curve
    code[:-1] = [1 + ("convex", "flat", "concave").index(k) for k in groups.kind]
    kind = code[c]

    def under(rows, why):
        found.groups |= set(np.unique(group[rows]).tolist())
        found.why[why] += int(rows.sum())
    for rows, why in (((kind == 0) & (count == 1), "two quads of a hex on one patch"),
                      ((kind == 0) & (count > 2), "more than two hexes at an edge inside a patch"),
                      ((kind == 2) & (count != 2), "not two hexes at a flat curve")):
        if rows.any():
            under(rows, why)
    rows = (kind == 3) & (count == 1)
    if rows.any():
        under(rows, "one hex at a concave curve")
    rows = (kind == 1) & (count != 1)
    if rows.any():
        found.across |= {(k, None) for k in np.unique(c[rows]).tolist()}
        found.why["more than one hex at a convex curve"] += int(rows.sum())


def _ask_corners(mesh, groups, found):
    for p, _, *curves in flat_corners(mesh, groups):
        found.why["a quad with a flat corner on a curve"] += 1
        for c in set(curves):
            if groups.kind[c] == "convex" and groups.of_patch[groups.across(c, p)] != groups.of_patch[p]:
                found.across.add((c, p))
            else:
                found.rings.add(p)


def flat_corners(mesh, groups):
    """[(patch, angle in degrees, curve, curve)] of each quad's corner of FLAT_CORNER or more between two edges on
    curves; one curve that goes on counts as 180."""
    h = np.arange(4 * len(mesh.quads))
    before = np.where(h % 4, h - 1, h + 3)
    c1, c2 = mesh.curve_of_half_edge[before], mesh.curve_of_half_edge[h]
    found = []
    for at in np.flatnonzero((c1 >= 0) & (c2 >= 0)).tolist():
        p, k = int(mesh.patch[at // 4]), int(mesh.corner_of_vertex[mesh.half_edges.tail[at]])
        if c1[at] != c2[at] and k < 0:
            continue
        angle = groups.corner_angle.get((k, p), 90.0) if k >= 0 else 180.0
        if angle >= FLAT_CORNER:
            found.append((p, angle, int(c1[at]), int(c2[at])))
    return found


def sheeted(mesh, model, inside=True):
    """(CapturedMesh with the sheets it needs, Counter of sheets by kind). Raises Pinched where none of them goes in.

    inside: sheets go on inside at concave curves; else they take in the patch beyond, as at flat ones
    """
    plan = _Plan(mesh, model, Groups(model, inside))
    for _ in range(PASSES):
        if not plan.put_groups():
            break
    for _ in range(RINGS):
        if not plan.put_rings():
            break
    for _ in range(MENDED):
        if not plan.put_strips() | plan.put_under_chords():
            break
    return plan.mesh, plan.count


class _Plan:
    def __init__(self, mesh, model, groups):
        self.mesh, self.model, self.groups = mesh, model, groups
        self.count, self.done, self.ringed, self.parted = Counter(), set(), set(), set()

    def put_groups(self):
        """Whether any sheet went under a group that had none."""
        wanted = demands(self.mesh, self.groups)
        need = set(wanted.groups)
        for c, p in sorted(wanted.across, key=lambda one: (one[0], -1 if one[1] is None else one[1])):
            sides = [int(self.groups.of_patch[x]) for x in (self.model.curves[c].left, self.model.curves[c].right)]
            if p is not None:
                need.add(int(self.groups.of_patch[self.groups.across(c, p)]))
            elif not set(sides) & (need | self.done):
                need.add(min(sides, key=lambda g: (sum(self.model.patches[k].area for k in self.groups.patches(g)), g)))
        need -= self.done
        for patches in self._apart([self._fitting(self.groups.patches(g)) for g in sorted(need)]):
            self._put_under(patches)
        return bool(need)

    def _apart(self, sets):
        """Sets of patches, those joined that overlap."""
        out = []
        for one in sets:
            while True:
                met = [other for other in out if other & one]
                if not met:
                    break
                out = [other for other in out if not other & one]
                one = self._fitting(one.union(*met))
            out.append(one)
        return out

    def _put_under(self, patches, without=frozenset()):
        """A sheet under patches, and those that have to be taken in with them. Raises Pinched where that needs one of
        `without`."""
        while True:
            patches = self._fitting(patches, without)
            if patches & without:
                raise Pinched(f"a sheet beside patches {sorted(without)} would go under them too", np.zeros(3))
            behind = self._behind(patches)
            in_the_way = self._in_the_way(patches, behind)
            if in_the_way:
                patches = patches | self._whole(in_the_way)
                continue
            try:
                self.mesh = self._sheet(patches, behind)
                break
            except Pinched:
                if not behind:
                    raise
                patches = patches | self._whole(behind)
        self.count["groups"] += 1
        self.count["behind"] += bool(behind)
        self.done |= {int(g) for g in self.groups.of_patch[list(patches)]}

    def _whole(self, patches):
        return frozenset().union(*(self.groups.patches(int(self.groups.of_patch[p])) for p in patches))

    def _behind(self, patches):
        """Patches across a concave curve from these."""
        found = set()
        for c, kind in zip(self.model.curves, self.groups.kind):
            if kind == "concave" and (c.left in patches) != (c.right in patches):
                found.add(c.right if c.left in patches else c.left)
        return frozenset(found)

    def _in_the_way(self, patches, behind):
        """Of the patches behind, those with a hex that the sheet's patches have too."""
        mine = np.zeros(len(self.mesh.hexes), bool)
        mine[self.mesh.under[np.isin(self.mesh.patch, list(patches))]] = True
        return {p for p in behind if mine[self.mesh.under[self.mesh.patch == p]].any()}

    def _sheet(self, patches, behind):
        pulled = np.ones(len(self.mesh.hexes), bool)
        pulled[self.mesh.under[np.isin(self.mesh.patch, list(behind))]] = False
        return insert(self.mesh, pulled, np.isin(self.mesh.patch, list(patches)))

    def _fitting(self, patches, without=frozenset()):
        """Patches with those that must be taken in: at a corner they must be one fan, with those behind, and leave at
        most one curve uncovered, or two curves would be squeezed into one. Over the flattest curve, but rather not
        one of `without`."""
        while True:
            covered = patches | self._behind(patches)
            k = next((k for k in range(len(self.model.corners)) if not self._fits(covered, k)), None)
            if k is None:
                return patches
            ends = [c for c in self.groups.ends[k] if (c.left in patches) != (c.right in patches)]
            if not ends:
                return patches
            c = min(ends, key=lambda c: (bool({c.left, c.right} & without), abs(c.angle - 180.0)))
            patches = patches | self._whole({c.left, c.right})

    def _fits(self, patches, k):
        inside = [(c.left in patches) + (c.right in patches) for c in self.groups.ends[k]]
        return not any(inside) or (inside.count(1) in (0, 2) and inside.count(0) <= 1)

    def put_strips(self):
        """Whether quads with straight corners between convex curves were parted: by a sheet under all that is across
        these curves, but not under the quads' own patch."""
        before, across = self.mesh, {}
        for p, angle, *curves in flat_corners(self.mesh, self.groups):
            if angle > STRAIGHT_CORNER and {self.groups.kind[c] for c in curves} == {"convex"} and p not in self.parted:
                across.setdefault(p, set()).update(self.groups.across(c, p) for c in curves)
        for p, others in sorted(across.items()):
            self.parted.add(p)
            try:
                self._put_under(self._whole(others), self._whole({p}))
                self.count["strips"] += 1
            except Pinched:
                self.count["pinched"] += 1
        return self.mesh is not before

    def put_under_chords(self):
        """Whether any sheet went under a group with chords, whether it has one or not: then it has none, but at its
        border."""
        before, (_, vertices, patches) = self.mesh, chords(self.mesh)
        corners = self.mesh.corner_of_vertex[vertices]
        patches = {p for k, p in zip(corners.tolist(), patches.tolist())
                   if self.groups.corner_angle.get((k, p), 0.0) < STRAIGHT_CORNER}
        for group in sorted({int(self.groups.of_patch[p]) for p in patches}):
            try:
                self._put_under(self.groups.patches(group))
                self.count["mended"] += 1
            except Pinched:
                self.count["pinched"] += 1
        return self.mesh is not before

    def put_rings(self):
        """Whether a ring or tape went round a patch that had none."""
        wanted = demands(self.mesh, self.groups)
        todo = (wanted.rings | {p for _, p in wanted.across if p is not None}) - self.ringed
        for p in sorted(todo):
            if int(self.groups.of_patch[p]) not in self.done:
                self._put_under(self.groups.patches(int(self.groups.of_patch[p])))
            try:
                self.mesh = round_patch(self.mesh, p)
                self.count["rings"] += 1
            except Pinched:
                self._put_tapes(p)
            self.ringed.add(p)
        return bool(todo)

    def _put_tapes(self, p):
        """A sheet along each curve of a patch that has a quad with two edges on it."""
        for c, curve in enumerate(self.model.curves):
            if p not in (curve.left, curve.right):
                continue
            for turn in (1, -1):
                chain = self.mesh.chain(self.model, c)[::turn]
                quads = self.mesh.half_edges.find(chain[:-1], chain[1:]) // 4
                if len(np.unique(quads)) == len(quads) or (self.mesh.patch[quads] != p).any():
                    continue
                try:
                    self.mesh = along_curve(self.mesh, chain)
                    self.count["tapes"] += 1
                except Pinched:
                    self.count["pinched"] += 1
