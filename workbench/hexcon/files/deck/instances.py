# SPDX-License-Identifier: LGPL-2.1-or-later
"""Instances of parts: moved, then turned about an axis, as the data lines of *INSTANCE say."""
import numpy as np

from ..text import real
from .scope import Scope


def placed(card, name, part):
    """The Scope of an instance that begins with a part's mesh, or with none."""
    scope = Scope(card.path, name, _movement(card))
    if part is not None:
        scope.copy_of(part)
    return scope


def _movement(card):
    """Callable (n,3) -> (n,3), or None."""
    lines = []
    for number, parts in card.fields():
        try:
            lines.append([real(part) for part in parts])
        except ValueError as error:
            raise card.fault(f"numbers are needed ({error})", number) from error
    if not lines:
        return None
    shift = np.array((lines[0] + [0.0] * 3)[:3])
    turn = _rotation(card, lines[1]) if len(lines) > 1 else None
    if len(lines) > 2 or len(lines[0]) > 3:
        raise card.fault("one line of a translation and one of a rotation are possible")
    return lambda places: (places + shift) if turn is None else turn(places + shift)


def _rotation(card, values):
    if len(values) != 7:
        raise card.fault(f"a rotation has two points and an angle, 7 numbers, not {len(values)}")
    return rotation(card, np.array(values[:3]), np.array(values[3:6]), values[6])


def rotation(card, start, end, degrees):
    """Callable (n,3) -> (n,3): a turn about the axis from start to end (right-hand rule); Rodrigues' formula."""
    axis = end - start
    if not np.linalg.norm(axis) > 0:
        raise card.fault("the two points of its axis are one")
    axis, angle = axis / np.linalg.norm(axis), np.radians(degrees)

    def turn(places):
        arms = places - start
        along = np.outer(arms @ axis, axis)
        return start + along + (arms - along) * np.cos(angle) + np.cross(axis, arms) * np.sin(angle)
    return turn
