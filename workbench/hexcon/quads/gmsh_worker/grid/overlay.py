# SPDX-License-Identifier: LGPL-2.1-or-later
"""One try of the grid: cells laid over the solid, its features taken up, sheets put in, all points relaxed."""
from dataclasses import dataclass

import numpy as np

import hexcon_native as hn

from .axes import axes_of
from .capture_most import capture_most
from .captured import NotCaptured
from .cells import cells
from .cells_to_split import for_field, for_gaps, joined
from .fullness import fullness
from .gaps import gaps_of
from .gate import Kept, kept
from .grid_levels import balanced_levels, padded
from .hex_neighbours import HexNeighbours
from .placement import STRUCTURED, evened_inside, placed
from .planes import planes_of
from .refined_grid import refined_grid
from .sheet_plan import sheeted
from .sheets import Pinched
from .sliding import Sliding
from .solid_rays import SolidRays
from .spread_patches import spread
from .tensor_grid import grid_hexes

MOST_CELLS = 3_000_000      # of a grid: what fits into a gigabyte
FLAT = 1e-4             # least scaled Jacobian of what is no flat corner
GOOD = 0.2              # least scaled Jacobian with which nothing else is tried,
ENOUGH = 0.3            # and above which what counts is the mean
MOST_REFINED = 200_000      # and of one whose cells are split
LONGEST = 1.5           # of the size: edges of cells up to which they are not split, as even steps between planes are
MOST_FOLDED, OF_FOLDED = 12, 0.002   # hexes, or part of them: with more left folded, passes over them are lost time
MOST_CROSSINGS = 12         # pairs of quads: with more, polish is lost time
MOST_SETS = 2               # of cells with the solid's topology that are tried
MANY_SHEETS = 1.5           # times the hexes: sheets that go on inside are then too many to be tried first
FEW_PASSES, PASSES, MEAN_PASSES = 3, 9, 4   # of hexcon_native.relax: over folded hexes, over certified ones


@dataclass
class Overlay:
    """mesh: the CapturedMesh before its points were placed; features: those it has; points (P,3): in place; faces (n,):
    CAD face of each quad; quality, certificate: of hexcon_native; kept: gate.Kept."""

    mesh: object
    features: object
    points: np.ndarray
    faces: np.ndarray
    quality: object
    certificate: object
    kept: Kept

    @property
    def good(self):
        """Whether it may be handed on: not either where rounding alone makes a flat corner positive."""
        return self.certificate.certified and self.quality.min > FLAT and not self.kept.faults

    @property
    def rank(self):
        """The greater, the better."""
        return self.good, -self.folded / len(self.mesh.hexes), min(self.quality.min, ENOUGH), self.quality.mean

    @property
    def folded(self):
        """How many hexes are not positive."""
        return len(self.certificate.nonpositive)


@dataclass
class Work:
    """hexes: how many were looked at so far, of all tries: a measure of time that no machine's speed changes."""

    hexes: int = 0


def overlay(features, h, work, report=lambda stage, fraction: None, levels=0, sizes=None, content=False):
    """The Overlay of elements of size h. Raises NotCaptured where cells or paths do not fit the solid.

    features: Features of the solid; work: a Work, added to; report(stage, fraction)
    levels: how often cells may be split in two where the solid is narrower than they are
    sizes: None, or a SizeField: elements smaller than h where it is smaller than its largest size, by as much
    content: whether there is another that may be handed on: then one with folded hexes is not worth the time
    Where hexes are left folded it is no more than a draft: `finished` may yet unfold them. Linear in the cells, but for
    sorting.
    """
    captured, features = _captured(features, h, work, report, levels, sizes)
    best = None
    report("sheets", 0.0)
    for mesh in _with_sheets(captured, features):
        found = _filled(mesh, features, h, work, report, content or (best is not None and best.good))
        if best is None or found.rank > best.rank:
            best = found
        if best.good and best.quality.min > GOOD:
            break
    return best


def _with_sheets(captured, features):
    """[CapturedMesh] with sheets that go on inside at concave curves, and with those that do not: the more promising
    first. Raises NotCaptured where neither go in."""
    found, pinched = [], ""
    for inside in (True, False):
        try:
            found.append(sheeted(captured, features, inside=inside)[0])
        except Pinched as fault:
            pinched = str(fault)
    if not found:
        raise NotCaptured("sheet", pinched)
    if np.array_equal(found[0].hexes, found[-1].hexes):
        return found[:1]
    if len(found[0].hexes) > MANY_SHEETS * len(found[-1].hexes):
        found.reverse()
    return found


def finished(draft, h, report=lambda stage, fraction: None):
    """The Overlay after as many passes over folded hexes as may be of use: slow, for the most promising draft."""
    report("slide", 0.0)
    sliding = Sliding(draft.mesh, draft.features)
    points = sliding.relax(draft.points, passes=PASSES, mean_passes=MEAN_PASSES, threads=1)
    return _judged(draft.mesh, draft.features, points, sliding, h)


def _filled(mesh, features, h, work, report, content):
    """The Overlay of a captured mesh with sheets. It is polished where nothing is folded, or, unless one is content
    with another, hardly anything, and hardly any quads cross."""
    work.hexes += len(mesh.hexes)
    report("slide", 0.0)
    sliding = Sliding(mesh, features)
    points, fine = _in_place(mesh, features, sliding)
    found = _judged(mesh, features, points, sliding, h)
    if fine or found.folded > (0 if content else 1) or len(found.certificate.crossings) > MOST_CROSSINGS:
        return found
    for polish in (sliding.polished, sliding.relax):
        shiny = _judged(mesh, features, polish(points, passes=PASSES, mean_passes=MEAN_PASSES, threads=1), sliding, h)
        found = max(found, shiny, key=lambda one: one.rank)
        if shiny.good and shiny.quality.min > GOOD:
            return shiny
    return found


def _judged(mesh, features, points, sliding, h):
    faces = _faces_of_quads(mesh, points, features)
    return Overlay(mesh, features, points, faces, hn.quality(points, mesh.hexes),
                   hn.certify(points, mesh.hexes, mesh.quads),
                   kept(points, mesh, faces, features, sliding.chains, h))


def _faces_of_quads(mesh, points, features):
    """(n,) the CAD face that each quad's middle is nearest to, of its patch."""
    faces = np.empty(len(mesh.quads), int)
    for p, patch in enumerate(features.patches):
        rows = np.flatnonzero(mesh.patch == p)
        faces[rows] = patch.faces_at(points[mesh.quads[rows]].mean(1))
    return faces


def _captured(features, h, work, report, levels, sizes=None):
    """(CapturedMesh, the Features it has): of the first set of cells that the features fit on."""
    report("cells", 0.0)
    frame = axes_of(features)
    rays = SolidRays(features.points @ frame.T, features.triangles)
    points, hexes = _grid(features, frame, h, levels, sizes, rays)
    neighbours, full = HexNeighbours(hexes), fullness(points @ frame.T, hexes, rays)
    wanted = features.cad.tessellation.shells, features.handles()
    fault, tried = NotCaptured("cells", "no set of cells is one body"), 0
    for found in cells(neighbours, full, wanted[0]):
        if (found.shells, found.euler) != wanted:
            fault = NotCaptured("cells", f"{found.shells} closed surfaces of Euler characteristic {found.euler}, not "
                                f"{wanted[0]} of {wanted[1]}: walls or gaps thinner than the elements") if not tried \
                else fault
            continue
        tried += 1
        report("capture", 0.0)
        work.hexes += int(found.inside.sum())
        used, packed = np.unique(hexes[found.inside], return_inverse=True)
        try:
            return capture_most(features, points[used], packed.reshape(-1, 8), h)
        except NotCaptured as error:
            fault = error
        if tried >= MOST_SETS:
            break
    raise fault


def _grid(features, frame, h, levels, sizes, rays):
    """(points, hexes) of a tensor grid of size h, its cells split for levels and sizes."""
    planes = planes_of(features, frame, h)
    count = np.prod([float(len(p)) for p in planes])
    if count > MOST_CELLS:
        raise NotCaptured("size", f"{count:.2g} cells; at most {MOST_CELLS:.2g} are laid")
    even = sizes is None or sizes.even
    if not levels and even:
        points, hexes = grid_hexes(planes)
        return points @ frame, hexes
    planes = padded(planes)
    wanted = [] if even else for_field(planes, lambda at: LONGEST * h / sizes.size * sizes(at @ frame), rays)
    if levels:
        narrow, _ = for_gaps(planes, gaps_of(features, h).turned(frame), h, levels)
        if not any(map(len, narrow)):
            raise NotCaptured("size", "nothing narrower than the elements, where cells could be split")
        wanted = joined(wanted, narrow)
    blocks, dropped = balanced_levels([len(p) - 1 for p in planes], wanted, MOST_REFINED)
    if dropped and not (even and blocks):
        raise NotCaptured("size", f"more than {MOST_REFINED} hexes, were cells split")
    points, hexes = refined_grid(planes, blocks)
    return points @ frame, hexes


def _in_place(mesh, features, sliding):
    """((P,3) all points relaxed, while those of the boundary slide; whether they are as good as can be). First places
    that are good enough are taken as they are: blocky parts stay on the grid. Passes over what stays folded are few:
    they seldom help later."""
    start = placed(mesh, features, sliding)
    if hn.quality(start, mesh.hexes).min >= STRUCTURED:
        return start, True
    points = sliding.relax_inside(evened_inside(mesh, spread(mesh, features, sliding, start)), threads=1)
    points = sliding.relax(points, (True,), threads=1)
    return _unfolded(points, mesh, sliding), False


def _folded(points, mesh):
    return hn.quality(points, mesh.hexes).scaled_jacobian <= 0.0


def _unfolded(points, mesh, sliding):
    """Points with passes over hexes that are folded still, if those are few: points of curves are held at first, then
    those near folded hexes slide. After one that brings nothing none is made."""
    before = few(mesh) + 1
    for number, options in enumerate(({"passes": FEW_PASSES}, {}, {"passes": FEW_PASSES})):
        bad = _folded(points, mesh)
        if not 0 < np.count_nonzero(bad) < before:
            break
        before = np.count_nonzero(bad)
        touched = np.zeros(len(points), bool)
        touched[mesh.hexes[bad]] = True
        touched[mesh.hexes[touched[mesh.hexes].any(axis=1)]] = True
        points = sliding.relax(points, (True if number == 0 else ~touched,), threads=1, **options)
    return points


def few(mesh):
    """So many hexes may be folded where passes over them are worth their time."""
    return max(MOST_FOLDED, OF_FOLDED * len(mesh.hexes))
