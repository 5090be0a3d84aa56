# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reader of resources/templates/*.txt; the README beside them tells the format and the labels."""
import dataclasses
import pathlib

import numpy as np

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "resources" / "templates"


@dataclasses.dataclass(frozen=True)
class Template:
    """A hex mesh with named boundary points.

    points          (P, 3) float64; the boundary's come first
    labels          P strings, "int" for every point inside
    hexes           (H, 8) int64, VTK order, positive
    quads           (n, 4) int64, the boundary, counter-clockwise seen from outside
    boundary_count  rows 0 .. boundary_count - 1 of points are on the boundary
    """
    name: str
    points: np.ndarray
    labels: tuple
    hexes: np.ndarray
    quads: np.ndarray
    boundary_count: int

    @property
    def fixed(self):
        """(P,) bool: on the boundary."""
        return np.arange(len(self.points)) < self.boundary_count

    @property
    def collapsed(self):
        """(P, 3): every point inside moved to the centroid of all of them."""
        inside = self.points[~self.fixed].mean(axis=0)
        return np.where(self.fixed[:, None], self.points, inside)


def names():
    return sorted(path.stem for path in FOLDER.glob("*.txt"))


def load_template(name):
    """The Template of resources/templates/<name>.txt."""
    rows = {"v": [], "h": [], "q": []}
    with open(FOLDER / f"{name}.txt", encoding="ascii") as stream:
        for line in stream:
            kind, *fields = line.split()
            if kind != "#":
                rows[kind].append(fields)
    labels = tuple(fields[4] for fields in rows["v"])
    boundary_count = sum(label != "int" for label in labels)
    if [int(fields[0]) for fields in rows["v"]] != list(range(len(labels))):
        raise ValueError(f"{name}: the points are not numbered 0, 1, 2 ...")
    if "int" in labels[:boundary_count]:
        raise ValueError(f"{name}: the boundary's points do not come first")
    return Template(name, np.array([fields[1:4] for fields in rows["v"]], float), labels,
                    np.array(rows["h"], int), np.array(rows["q"], int), boundary_count)
