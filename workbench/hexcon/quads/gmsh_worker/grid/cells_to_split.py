# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which cells of a tensor grid are too large: for a size field, and to tell a solid's narrow places apart."""
import numpy as np

from .fullness import fullness
from .gaps import KINDS
from .grid_levels import AROUND
from .tensor_grid import indices, places

LEVELS = 3          # splits at most, one in the other
APART = {"wall": 1.5, "slot": 1.5, "curves": 1.3, "curve and face": 1.3, "short curve": 1.0, "hole": 1.5}
"""Cells that must lie between two places, by kind of gap."""
ON_PLANE = 0.05     # of a cell: how near a place must be to a plane to count as on it
SLIVER = 0.05       # of the size: gaps narrower than this are left alone


def for_gaps(planes, gaps, size, levels=LEVELS):
    """(cells (m, 3) to be split on each level, rows of gaps too narrow to be told apart on the last).

    planes in the frame of the gaps (a Gaps, turned there); size: of the elements wanted
    Two places are told apart by APART cells between them along some axis, or by one if both are on planes there. Cells
    round the narrow ones are split too: sheets want room, and transitions are better off where nothing else is.
    """
    a, b = indices(planes, gaps.a), indices(planes, gaps.b)
    needed = np.array([APART[name] for name in KINDS])[gaps.kind]
    left = np.flatnonzero(gaps.width > SLIVER * size)
    wanted = []
    for level in range(levels):
        left = left[~_apart(2 ** level * a[left], 2 ** level * b[left], needed[left])]
        at = 2 ** level * np.vstack([(1 - t) * a[left] + t * b[left] for t in (0, 0.5, 1)])
        cells = np.unique(np.floor(at).astype(int), axis=0)
        wanted.append(np.unique((cells[:, None] + AROUND).reshape(-1, 3), axis=0))
    return wanted, left[~_apart(2 ** levels * a[left], 2 ** levels * b[left], needed[left])]


def _apart(a, b, needed):
    way = np.abs(a - b)
    on_planes = (np.abs(a - np.rint(a)) < ON_PLANE) & (np.abs(b - np.rint(b)) < ON_PLANE)
    return ((way >= needed[:, None]) | (on_planes & (way > 1 - 2 * ON_PLANE))).any(axis=1)


def for_field(planes, field, solid=None, levels=LEVELS):
    """Cells (m, 3) to be split on each level: those with an edge longer than the field (points -> sizes) allows; of a
    solid (SolidRays in the planes' frame) only those that hold some of it.

    Asked at middles and corners of cells, of all on the first level and of the parts of split ones on the others.
    """
    shape = np.array([len(p) - 1 for p in planes])
    cells = np.stack(np.unravel_index(np.arange(np.prod(shape)), shape), axis=1)
    wanted = []
    for level in range(levels):
        corners = np.stack([places(planes, (cells + t) / 2 ** level) for t in _PROBES], axis=1)
        longest = np.ptp(corners, axis=1).max(axis=1)
        sizes = field(corners.reshape(-1, 3)).reshape(len(cells), len(_PROBES)).min(axis=1)
        large = np.flatnonzero(longest > sizes * (1 + 1e-9))
        if solid is not None:
            eight = corners[large, :8].reshape(-1, 3), np.arange(8 * len(large)).reshape(-1, 8)[:, _VTK]
            large = large[fullness(*eight, solid) > 0.0]
        wanted.append(cells[large])
        cells = (2 * wanted[-1][:, None] + _HALVES).reshape(-1, 3)
    return wanted


def joined(one, other):
    """Cells to be split for either reason, level by level."""
    return [np.unique(np.vstack([w[k] for w in (one, other) if k < len(w)]), axis=0)
            for k in range(max(len(one), len(other)))]


_HALVES = np.stack(np.meshgrid(*[[0, 1]] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
_VTK = [0, 4, 6, 2, 1, 5, 7, 3]     # of _HALVES, in the order of a hex's corners
_PROBES = np.vstack([_HALVES, [[0.5, 0.5, 0.5]]])
