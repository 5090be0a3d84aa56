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
from .placement import placed
from .planes import grid_hexes, planes_of
from .refined_grid import refined_grid
from .sheet_plan import sheeted
from .sheets import Pinched
from .sliding import Sliding
from .solid_rays import SolidRays

MOST_CELLS = 3_000_000      # of a grid: what fits into a gigabyte
GOOD = 0.2              # least scaled Jacobian with which nothing else is tried,
ENOUGH = 0.3            # and above which what counts is the mean
MOST_REFINED = 200_000      # and of one whose cells are split
LONGEST = 1.5           # of the size: edges of cells up to which they are not split, as even steps between planes are
FINE = 0.95                 # least scaled Jacobian of first places that are taken as they are
MOST_FOLDED = 0.02          # part of the hexes: with more left folded, passes over them are lost time
PASSES, MEAN_PASSES = 9, 4  # of hexcon_native.relax


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
        """Whether it may be handed on."""
        return self.certificate.certified and not self.kept.faults

    @property
    def rank(self):
        """The greater, the better."""
        return self.good, min(self.quality.min, ENOUGH), self.quality.mean


@dataclass
class Work:
    """hexes: how many were looked at so far, of all tries: a measure of time that no machine's speed changes."""

    hexes: int = 0


def overlay(features, h, work, report=lambda stage, fraction: None, levels=0, sizes=None):
    """The Overlay of elements of size h. Raises NotCaptured where cells or paths do not fit the solid.

    features: Features of the solid; work: a Work, added to; report(stage, fraction)
    levels: how often cells may be split in two where the solid is narrower than they are
    sizes: None, or a SizeField: elements smaller than h where it is smaller than its largest size, by as much
    Linear in the cells, but for sorting.
    """
    captured, features = _captured(features, h, work, report, levels, sizes)
    best, pinched = None, ""
    for inside in (True, False):
        try:
            found = _filled(captured, features, h, inside, work, report)
        except Pinched as fault:
            pinched = str(fault)
            continue
        if best is None or found.rank > best.rank:
            best = found
        if best.good and best.quality.min > GOOD:
            break
    if best is None:
        raise NotCaptured("sheet", pinched)
    return best


def _filled(mesh, features, h, inside, work, report):
    """The Overlay of a captured mesh, with sheets that go on inside at concave curves, or not."""
    report("sheets", 0.0)
    mesh, _ = sheeted(mesh, features, inside=inside)
    work.hexes += len(mesh.hexes)
    report("slide", 0.0)
    sliding = Sliding(mesh, features)
    points = _in_place(mesh, features, sliding)
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
    fault = NotCaptured("cells", "no set of cells is one body")
    for found in cells(neighbours, full, wanted[0]):
        if (found.shells, found.euler) != wanted:
            fault = NotCaptured("cells", f"{found.shells} closed surfaces of Euler characteristic {found.euler}, not "
                                f"{wanted[0]} of {wanted[1]}: walls or gaps thinner than the elements")
            continue
        report("capture", 0.0)
        work.hexes += int(found.inside.sum())
        used, packed = np.unique(hexes[found.inside], return_inverse=True)
        try:
            return capture_most(features, points[used], packed.reshape(-1, 8), h)
        except NotCaptured as error:
            fault = error
    raise fault


def _grid(features, frame, h, levels, sizes, rays):
    """(points, hexes) of a tensor grid of size h, its cells split for levels and sizes."""
    planes = planes_of(features, frame, h)
    count = np.prod([float(len(p)) for p in planes])
    if count > MOST_CELLS:
        raise NotCaptured("size", f"{count:.2g} cells; at most {MOST_CELLS:.2g} are laid")
    even = sizes is None or sizes.even
    if not levels and even:
        return grid_hexes(planes, frame)
    planes = padded(planes)
    wanted = [] if even else for_field(planes, lambda at: LONGEST * h / sizes.size * sizes(at @ frame), rays)
    if levels:
        gaps = gaps_of(features, h).turned(frame)
        wanted = joined(wanted, for_gaps(planes, gaps, h, levels)[0])
    blocks, dropped = balanced_levels([len(p) - 1 for p in planes], wanted, MOST_REFINED)
    if (not blocks and (levels or dropped)) or (dropped and not even):
        raise NotCaptured("size", f"more than {MOST_REFINED} hexes, were cells split" if dropped else
                          "nothing narrower than the elements, where cells could be split")
    points, hexes = refined_grid(planes, blocks)
    return points @ frame, hexes


def _in_place(mesh, features, sliding):
    """(P,3) all points relaxed and improved, while those of the boundary slide; first places that are good enough are
    taken as they are: blocky parts stay on the grid."""
    start = placed(mesh, features, sliding)
    if hn.quality(start, mesh.hexes).min >= FINE:
        return start
    points = sliding.relax(start, threads=1)
    folded = np.count_nonzero(hn.quality(points, mesh.hexes).scaled_jacobian <= 0.0)
    if folded > MOST_FOLDED * len(mesh.hexes):
        return points
    return sliding.relax(points, passes=PASSES, mean_passes=MEAN_PASSES, threads=1)
