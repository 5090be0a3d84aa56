# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points at one place that should be one point: merging them, and how far open edges are apart."""
import numpy as np

from hexcon.errors import FaultCode, ToolError

from .surface import edges_of

RELATIVE = 1e-7     # of the diagonal: points nearer than this are merged where the surface is open without
_SEAM = 0.2         # of an open edge's length: another one no farther than that is the other side of a seam


class Merging:
    """Points of a file, and which of them become one.

    points (P,3);  tolerance  a length, or None: only seams of open surfaces are merged, to RELATIVE of the diagonal
    """

    def __init__(self, points, tolerance=None):
        self.points, self.tolerance = np.asarray(points, float), tolerance

    def wanted(self, quads, notes):
        """(P,) the row that stands for each one by the tolerance asked for; adds a note. Raises ToolError
        BAD_OPTION."""
        if not self.tolerance or not np.isfinite(self.points).all():
            return np.arange(len(self.points))
        same, count = merged_rows(self.points, quads, self.tolerance)
        broken = collapsed(same[quads])
        if len(broken):
            shortest = np.linalg.norm(np.subtract(*self.points[edges_of(quads)].transpose(1, 0, 2)), axis=1).min()
            raise ToolError(f"a merge tolerance of {self.tolerance:g} would merge corners of {len(broken)} quads "
                            "(listed); the "
                            f"shortest edge is {shortest:.3g}", FaultCode.BAD_OPTION, broken)
        if count:
            notes.append(f"{count} points merged with others nearer than {self.tolerance:g}")
        return same

    def of_seams(self, quads):
        """((P,) the row that stands for each, note) where points at one place are merged; (None, "") if there are
        none."""
        used = np.unique(quads)
        near = RELATIVE * float(np.linalg.norm(np.ptp(self.points[used], axis=0)))
        same, count = merged_rows(self.points, quads, near)
        if not count or len(collapsed(same[quads])):
            return None, ""
        apart = np.linalg.norm(self.points[used] - self.points[same[used]], axis=1).max()
        where = "at the same place" if apart == 0.0 else f"up to {apart:.2g} away"
        return same, f"{count} points merged with others {where}"


def collapsed(cells):
    """Rows of cells (n,k) that have one corner twice."""
    ranked = np.sort(cells, axis=1)
    return np.flatnonzero((ranked[:, 1:] == ranked[:, :-1]).any(axis=1))


def merged_rows(points, cells, tolerance):
    """((P,) the row that stands for each point where coincident ones of the cells become one, how many leave)."""
    used, same = np.unique(cells), np.arange(len(points))
    same[used] = used[coincident(points[used], tolerance)]
    return same, int((same != np.arange(len(points))).sum())


def coincident(points, tolerance):
    """(P,) the first row of those that hang together by steps of at most the tolerance."""
    # scipy takes 0.3 s to load, and is seldom wanted
    from scipy.spatial import cKDTree

    points = np.asarray(points, float)
    same = np.arange(len(points))
    pairs = cKDTree(points).query_pairs(tolerance, output_type="ndarray")
    if len(pairs):
        from scipy.sparse import coo_matrix
        from scipy.sparse.csgraph import connected_components
        graph = coo_matrix((np.ones(len(pairs)), tuple(pairs.T)), shape=(len(points), len(points)))
        _, part = connected_components(graph, directed=False)
        _, first = np.unique(part, return_index=True)
        same = first[part]
    return same


def open_edges(quads):
    """(k,2) edges that are in one quad only."""
    edges = np.sort(edges_of(quads), axis=1)
    found, counts = np.unique(edges, axis=0, return_counts=True)
    return found[counts == 1]


def words_about_open_edges(points, quads):
    """How far apart open edges are, and what could be done; "" without any."""
    edges = open_edges(quads)
    if not len(edges):
        return ""
    ends = points[edges]
    if len(edges) == 1 or not np.isfinite(ends).all():
        return "; the surface has a hole there"
    from scipy.spatial import cKDTree

    lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    middles = ends.mean(axis=1)
    _, near = cKDTree(middles).query(middles, k=min(3, len(edges)))
    apart = np.full(len(edges), np.inf)
    for k in range(1, near.shape[1]):
        other = ends[near[:, k]]
        for way in (other, other[:, ::-1]):
            far = np.linalg.norm(ends - way, axis=2).max(axis=1)
            apart = np.where(near[:, k] != np.arange(len(edges)), np.minimum(apart, far), apart)
    seam = apart <= _SEAM * lengths
    if not seam.any():
        return f"; no other open edge is near (the nearest is {apart.min():.2g} away): there is a hole to close"
    width = float(apart[seam].max())
    advice = 10.0 ** np.ceil(np.log10(max(2 * width, 1e-300)))
    kept = "" if seam.all() else f" of {int(seam.sum())} of them"
    return f"; the ends{kept} are up to {width:.2g} apart: try --merge-tolerance {advice:.0e}"
