# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coordinates of nodes that are not x, y, z of the whole: SYSTEM=C or S on a card, and *SYSTEM cards."""
import numpy as np

from ..text import real


def to_cartesian(values, card):
    """(n,3) x, y, z of coordinates as a card's SYSTEM= says: R (or none), C: r, angle, z; S: r, angle, angle above the
    plane; angles in degrees. Raises the card's fault."""
    system = card.value("SYSTEM", "R").upper()[:1] or "R"
    if system == "R":
        return values
    if system not in ("C", "S"):
        raise card.fault(f"SYSTEM={card.value('SYSTEM')} is not known; R, C or S are possible")
    first, around = values[:, 0], np.radians(values[:, 1])
    if system == "C":
        return np.column_stack([first * np.cos(around), first * np.sin(around), values[:, 2]])
    above = np.radians(values[:, 2])
    return np.column_stack([first * np.cos(around) * np.cos(above), first * np.sin(around) * np.cos(above),
                            first * np.sin(above)])


class System:
    """The coordinate system of a *SYSTEM card: origin (3,) and axes (3,3), rows x, y, z."""

    def __init__(self, origin=None, axes=None):
        self.origin, self.axes = origin, axes

    def applied(self, places):
        if self.origin is None:
            return places
        with np.errstate(invalid="ignore"):     # what is not finite is refused later
            return self.origin + places @ self.axes

    @classmethod
    def of(cls, card):
        """Origin, a point on the x axis, and (second line) a point of the x, y plane; without data: the whole's."""
        try:
            values = [real(part) for _, parts in card.fields() for part in parts]
        except ValueError as error:
            raise card.fault(f"numbers are needed ({error})") from error
        if not values:
            return cls()
        if len(values) not in (3, 6, 9):
            raise card.fault(f"3, 6 or 9 numbers are needed, not {len(values)}")
        origin = np.array(values[:3])
        x = np.array(values[3:6]) - origin if len(values) > 3 else np.array([1.0, 0, 0])
        up = np.cross(x, np.array(values[6:9]) - origin) if len(values) > 6 else np.array([0.0, 0, 1])
        y = np.cross(up, x)
        if not np.linalg.norm(x) > 0 or not np.linalg.norm(y) > 0:
            raise card.fault("its three points lie in one line")
        axes = np.array([x / np.linalg.norm(x), y / np.linalg.norm(y), np.zeros(3)])
        axes[2] = np.cross(axes[0], axes[1])
        return cls(origin, axes)
