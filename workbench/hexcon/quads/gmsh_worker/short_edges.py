# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges of the CAD that are much shorter than the mesh can be left out: each is taken as a point.

An element on such an edge is a needle, and all round it must grow from its width. A strip between two long edges keeps
its short ends: without them it would be a face of no width.
"""
import numpy as np

SHORT = 0.005       # of the size


def short_edges(solid, size):
    """Edges of a Solid to be left out: those shorter than SHORT * size, but for those at narrower faces.

    Groups that meet become one point as long as they lie within SHORT * size. O(E log E).
    """
    limit = SHORT * size
    narrow = {f for f in solid.faces if 2.0 * abs(solid.area(f)) < limit * _perimeter(solid, f)}
    found, group = [], {v: {v} for v in solid.vertex}       # of vertices that become one
    for edge in sorted(solid.edges, key=solid.length):
        first, last = solid.ends[edge]
        if solid.length(edge) >= limit:
            break
        together = group[first] | group[last]
        if first != last and not narrow & set(solid.faces_of[edge]) and _extent(solid, together) < limit:
            found.append(edge)
            group.update(dict.fromkeys(together, together))
    return found


def left_out(solid, edges):
    """[what is said of edges that are left out], empty for none."""
    return _told(solid, edges, "and taken as points")


def kept(solid, size, edges):
    """[what is said of the Solid's edges that are as short and not among those left out]: the mesh is as thin there."""
    short = [e for e in solid.edges if e not in edges and solid.length(e) < SHORT * size]
    return _told(solid, short, "and kept: elements are as thin there, so look whether the CAD means them")


def _told(solid, edges, what):
    told = [f"Edge{e} ({solid.length(e):.2g} long, at "
            + "({:.6g}, {:.6g}, {:.6g}))".format(*solid.vertex[solid.ends[e][0]]) for e in edges[:10]]
    told += [f"{len(edges) - 10} more"] if len(edges) > 10 else []
    return [f"shorter than {SHORT:g} of the size {what}: {', '.join(told)}"] if edges else []


def _extent(solid, vertices):
    return np.linalg.norm(np.ptp([solid.vertex[v] for v in vertices], axis=0))


def _perimeter(solid, face):
    return sum(solid.length(e) for e in solid.boundary[face])
