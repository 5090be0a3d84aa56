# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a grid's surface must keep of the solid before it is handed on: faces, edges, volume, area.

While tries go on; the surface that is handed on is measured as that of every method is: cad_fit.py, nearness.py.
"""
from dataclasses import dataclass

import numpy as np

from ..cad_fit import volume_and_area
from ..segments import distances

MOST_VOLUME = 0.05      # part by which volume and area may differ from the CAD's: chords cut round faces
MOST_CHORD = 0.6        # of the size: how far a CAD edge may be from the mesh's edges
LEAST_EDGE = 1 / 200    # of the size: the mesh's shortest edge; other methods take CAD edges as short for points


@dataclass(frozen=True)
class Kept:
    """volume, area: relative to the CAD's, less 1; chord: greatest distance of a curve from its mesh edges, in sizes;
    curve: which; lost: CAD faces that own no quad; shortest: edge of a quad, in sizes."""

    volume: float
    area: float
    chord: float
    curve: int
    lost: list
    shortest: float = 1.0

    @property
    def faults(self):
        """In words; empty where the surface may be handed on."""
        found = [f"the {name} is {100 * value:+.1f} % off" for name, value in (("volume", self.volume),
                                                                             ("area", self.area))
                 if not abs(value) <= MOST_VOLUME]
        if not self.chord <= MOST_CHORD:
            found.append(f"curve {self.curve} is cut by {self.chord:.2f} sizes")
        if not self.shortest >= LEAST_EDGE:
            found.append(f"an edge is {self.shortest:.2g} sizes short")
        return found


def kept(points, mesh, faces, features, chains, h):
    """Kept of a captured mesh with its points in place.

    faces (n,): CAD face of each quad; chains: of Sliding; h: size of its elements. Linear.
    """
    quads, cad = points[mesh.quads], features.cad
    volume, area = volume_and_area(quads)
    cuts = [distances(curve.samples, points[chain[:-1]], points[chain[1:]]).max() / h
            for curve, chain in zip(features.curves, chains)]
    worst = int(np.argmax(cuts)) if cuts else -1
    return Kept(volume / cad.solid.exact_volume - 1.0, area / cad.solid.exact_area - 1.0,
                float(cuts[worst]) if cuts else 0.0, worst, sorted(set(cad.solid.faces) - set(faces.tolist())),
                float(np.linalg.norm(quads - np.roll(quads, -1, axis=1), axis=2).min() / h))
