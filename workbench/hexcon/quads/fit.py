# SPDX-License-Identifier: LGPL-2.1-or-later
"""How well quads fit the solid that they were made on."""
from dataclasses import asdict, dataclass

_CHORDS = "chords cut round faces; a smaller size, or more quads round a turn, cut less"


@dataclass(frozen=True)
class Fit:
    """Quads beside their CAD; lengths in its units. Measured by the gmsh worker (cad_fit.py says how).

    cad_volume, cad_area   of the solid
    volume, area           of the quads, as bilinear patches, less the solid's, as part of those: 0.01 is 1 % too much
    chord                  greatest distance of a quad's middle from its face (of up to 500 quads a face)
    edge_chord             greatest distance of a sharp CAD edge from the mesh edges between its faces
    lost_faces, lost_edges numbers of faces without quads, and of sharp edges without mesh edges of their own
    """

    cad_volume: float
    cad_area: float
    volume: float
    area: float
    chord: float
    edge_chord: float
    lost_faces: tuple = ()
    lost_edges: tuple = ()

    def as_dict(self):
        """Plain numbers."""
        return asdict(self)

    def words(self):
        """One line."""
        return (f"volume {100 * self.volume:+.2f} %, area {100 * self.area:+.2f} % of the solid's; faces within "
                f"{self.chord:.3g}, edges within {self.edge_chord:.3g}")

    def notes(self, most):
        """What the user should know; most: part of the volume that chords may cut."""
        found = []
        if abs(self.volume) > most:
            found.append(f"{_off(self.volume, most)}: {_CHORDS}")
        for kind, lost, of_own in (("Face", self.lost_faces, "quads"), ("Edge", self.lost_edges, "mesh edges")):
            if lost:
                named = ", ".join(f"{kind}{k}" for k in lost[:10]) + (" ..." if len(lost) > 10 else "")
                found.append(f"smaller than the mesh, without {of_own} of their own: {named}")
        return found


def _off(volume, most):
    return f"the volume is {100 * volume:+.1f} % off, more than {100 * most:g} %"


def notes_of_curved(notes, volume, most):
    """Notes about quads as they hold of hexes of order 2 that are curved as the solid is: no chords are left.

    volume  of the curved hexes, less the solid's, as part of it;  most: as Fit.notes
    """
    kept = [note for note in notes if _CHORDS not in note]
    if abs(volume) > most:
        kept.append(f"{_off(volume, most)}, although edges are curved; a smaller size fits better")
    return kept


def fit_of(found, face_numbers=None):
    """The Fit in the gmsh worker's arrays, None where they hold none; face_numbers: those of the solid's faces in the
    caller's shape, None: the same."""
    if "fit" not in found:
        return None
    faces = found["lost_faces"] if face_numbers is None else sorted(face_numbers[f - 1] for f in found["lost_faces"])
    return Fit(*map(float, found["fit"]), tuple(map(int, faces)), tuple(map(int, found["lost_edges"])))
