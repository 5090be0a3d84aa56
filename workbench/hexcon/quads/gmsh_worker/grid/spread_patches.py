# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places of a captured mesh's surface where no quad is folded, found patch by patch before the inside is looked at.

Hexes inside keep a quad that is folded over a concave curve where it is: each of them sees only that it is folded, not
that its neighbours are. A patch alone has nothing but its border in its way: its quads are made a thin layer of hexes
whose points slide on the patch and, where there is one, on a surface parallel to it, or else are free; its border is
held on both. That untangles as any hexes do.
"""
import numpy as np

from .sliding import FREE, STAYS

THICK = 0.5             # of the median edge of a patch's quads, and of a radius at most: its layer of hexes


def spread(mesh, features, sliding, points):
    """(P, 3) points with those of patches moved until hardly any quad is folded; curves' points and the inside stay.

    mesh: a CapturedMesh; sliding: its Sliding; points (P, 3) on what they slide on. Linear, as hexcon_native.relax is.
    """
    layers = [_Layer(mesh, features, sliding, points, p) for p in range(len(features.patches))]
    first = np.cumsum([0, *(2 * len(layer.ids) for layer in layers)])
    carriers, outer = [], []
    for layer in layers:
        above = FREE
        if layer.outer is not None:
            above = len(sliding.carriers) + len(outer)
            outer.append(layer.outer)
        carriers += [np.where(layer.slides, layer.row, STAYS), np.where(layer.slides, above, STAYS)]
    found = sliding.relaxed_hexes(np.vstack([layer.places for layer in layers]),
                                  np.vstack([layer.hexes + at for at, layer in zip(first, layers)]),
                                  np.concatenate(carriers), outer)
    points = points.copy()
    for at, layer in zip(first, layers):
        points[layer.ids[layer.slides]] = found[at:at + len(layer.ids)][layer.slides]
    return sliding.project(points)


class _Layer:
    """Hexes on a patch's quads: ids (n,) of its points; slides (n,) bool: those not of its border; row: its carrier;
    places (2 n, 3): its points and those outside of them; hexes; outer: hexcon_native.Carrier of the latter, or None.
    """

    def __init__(self, mesh, features, sliding, points, p):
        quads, patch = mesh.quads[mesh.patch == p], features.patches[p]
        self.row = len(features.curves) + p
        self.ids, rows = np.unique(quads, return_inverse=True)
        self.slides = sliding.carrier_of_point[self.ids] == self.row
        rows, n, at = rows.reshape(quads.shape), len(self.ids), points[self.ids]
        self.hexes = np.hstack([rows, rows + n])
        outward = features.cad.tessellation.normals_at(patch.rows[patch.nearest(at)[1]])
        thick = THICK * np.median(np.linalg.norm(points[quads] - points[np.roll(quads, -1, axis=1)], axis=2))
        carrier = sliding.carriers[self.row]
        if carrier.kind in ("cylinder", "sphere"):
            thick = min(thick, THICK * carrier.sizes[0])
        self.outer = _parallel(carrier, at[0], thick * outward[0])
        self.places = np.vstack([at, at + thick * outward])


def _parallel(carrier, at, step):
    """A surface parallel to a carrier, a step from one of its points away, or None."""
    if carrier.kind == "plane":
        return carrier._replace(origin=tuple(np.add(carrier.origin, step)))
    if carrier.kind not in ("cylinder", "sphere"):
        return None
    radial = at - np.asarray(carrier.origin)
    if carrier.kind == "cylinder":
        radial -= radial @ carrier.axis * np.asarray(carrier.axis)
    return carrier._replace(sizes=(carrier.sizes[0] + np.copysign(np.linalg.norm(step), radial @ step),))
