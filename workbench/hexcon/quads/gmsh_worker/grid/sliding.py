# SPDX-License-Identifier: LGPL-2.1-or-later
"""What each point of a captured mesh lies on, as the core's relaxation takes it."""
import numpy as np

import hexcon_native as hn

FREE, STAYS = -1, -2        # of hexcon.h


class FeatureCarriers:
    """What points slide on that lie on the features' curves and patches.

    rows      list of hexcon_native.Carrier: of the curves first, then of the patches
    curves    number of curves
    """

    def __init__(self, features):
        self._features, self.curves = features, len(features.curves)
        self.rows = [_of_curve(features, c) for c in range(self.curves)] + \
            [_of_patch(features, p, self.curves) for p in range(len(features.patches))]

    def relaxed_on(self):
        """Carriers and hexcon_native.Facets for a relaxation, which needs no exact places: patches of several faces,
        and of others than closed forms, are told by their triangles, so that nobody is asked."""
        rows, parts = list(self.rows), []
        for p, patch in enumerate(self._features.patches):
            row = self.curves + p
            if rows[row].kind == "surface":
                rows[row], part = _faceted(self._features.cad, patch, row)
                parts.append(part)
        if not parts:
            return rows, None
        return rows, hn.Facets(self._features.cad.tessellation.points, *(np.concatenate(c) for c in zip(*parts)))

    def project(self, points, tags):
        """Places and directions on those without a closed form, as hexcon_native.relax asks for them."""
        places, directions = np.empty_like(points), np.empty_like(points)
        for tag in np.unique(tags):
            rows = np.flatnonzero(tags == tag)
            if tag < self.curves:
                places[rows], directions[rows] = self._features.curves[tag].project(points[rows])
            else:
                places[rows], directions[rows], _ = self._features.patches[tag - self.curves].project(points[rows])
        return places, directions


class Sliding:
    """Corners stay, points of curves and patches slide on them, all others are free.

    mesh: a CapturedMesh; features: its Features
    chains             list of the vertices of each curve, in order along it
    carrier_of_point   (P,) rows of carriers: curves first, then patches; FREE, STAYS
    """

    def __init__(self, mesh, features):
        self._features, self._corners, self._on = features, features.corners, FeatureCarriers(features)
        curves = self._on.curves
        self.chains = [mesh.chain(features, c) for c in range(curves)]
        self.carrier_of_point = np.full(len(mesh.points), FREE)
        self.carrier_of_point[mesh.quads] = curves + mesh.patch[:, None]
        for c, chain in enumerate(self.chains):
            self.carrier_of_point[chain] = c
        self.carrier_of_point[mesh.corner_vertex] = STAYS
        self._hexes, self.corner_vertex, self._fast = mesh.hexes, mesh.corner_vertex, None

    def polished(self, points, **options):
        """hexcon_native.relax with the points of round curves held, evenly spaced: left to slide they crowd together,
        as shapes of hexes do not feel that long chords cut the solid."""
        features, carriers, points = self._features, self.carrier_of_point.copy(), points.copy()
        for c, chain in enumerate(self.chains):
            if not features.curves[c].is_straight(features.cad.curve_carriers):
                points[chain] = features.curves[c].evened(points[chain])
                carriers[chain] = STAYS
        return self._relaxed(self.project(points), carriers, options)

    def _relaxed(self, points, carriers, options):
        return self.project(self.relaxed_hexes(points, self._hexes, carriers, **options))

    @property
    def carriers(self):
        """hexcon_native.Carrier of each row: curves first, then patches."""
        return self._on.rows

    def relaxed_hexes(self, points, hexes, carriers, more=(), **options):
        """hexcon_native.relax of any hexes whose points lie on these carriers, or on more of them."""
        if self._fast is None:
            self._fast = self._on.relaxed_on()
        rows, facets = self._fast
        return hn.relax(points, hexes, carriers, [*rows, *more], project=self._on.project, facets=facets, **options)

    def on_patch(self):
        """(n,) points that slide on patches."""
        return np.flatnonzero(self.carrier_of_point >= self._on.curves)

    def project(self, points):
        """(P,3) with every point of the boundary on what it slides on, corners at their places."""
        points = points.copy()
        points[self.corner_vertex] = self._corners
        return hn.project_points(points, self.carrier_of_point, self._on.rows, project=self._on.project)[0]

    def relax_inside(self, points, **options):
        """hexcon_native.relax with the whole boundary held."""
        return self._relaxed(points, np.where(self.carrier_of_point >= 0, STAYS, self.carrier_of_point), options)

    def relax(self, points, curves_held=(True, False), **options):
        """hexcon_native.relax of these points, once for each of `curves_held`: whether points of curves are held, all
        alike or each (P,). At first they are best held: they would slide together."""
        on_curves = (self.carrier_of_point >= 0) & (self.carrier_of_point < self._on.curves)
        for held in curves_held:
            carriers = np.where(on_curves & held, STAYS, self.carrier_of_point)
            points = self._relaxed(points, carriers, options)
        return points


def _faceted(cad, patch, row):
    """(pieces, (triangles, carriers, pieces, normals) of Facets) of a patch."""
    shape, carriers = cad.tessellation, [cad.carriers[f] for f in patch.faces]
    pieces = [hn.Carrier("facets") if c.kind == "other" else c.core for c in carriers]
    triangles, face = shape.triangles[patch.rows], shape.face[patch.rows]
    normals = np.empty((len(triangles), 3, 3))
    for f in patch.faces:
        normals[face == f] = cad.corner_normals(f)
    return pieces, (triangles, np.full(len(triangles), row), np.searchsorted(patch.faces, face), normals)


def _of_curve(features, c):
    curve = features.curves[c]
    carrier = features.cad.curve_carriers[curve.parts[0][0]]
    if len(curve.parts) > 1 or carrier.kind == "other":
        return hn.Carrier("curve", tag=c)
    if curve.closed:
        return carrier.core
    start, end = curve.at([0.0, curve.length])
    if carrier.kind == "Line":
        return hn.Carrier("line", tuple(start), tuple(end - start), sizes=(np.linalg.norm(end - start),))
    onward = np.cross(carrier.axis, start - carrier.origin) @ curve.tangents([0.0])[0]
    return hn.Carrier("circle", tuple(carrier.origin), tuple(np.sign(onward) * carrier.axis),
                      tuple(start - carrier.origin), (carrier.radius, curve.length / carrier.radius))


def _of_patch(features, p, curves):
    faces = features.patches[p].faces
    carrier = features.cad.carriers[faces[0]]
    if len(faces) > 1 or carrier.kind == "other":
        return hn.Carrier("surface", tag=curves + p)
    return carrier.core
