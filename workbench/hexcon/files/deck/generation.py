# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nodes and elements that a card makes of others: *NGEN, *ELGEN, *NCOPY, *ELCOPY."""
import numpy as np

from ..text import real
from .instances import rotation

MOST = 20_000_000   # nodes or elements that one card may make


def generate(card, scope):
    """Add what the card makes to a scope. Raises the card's fault."""
    {"NGEN": _ngen, "ELGEN": _elgen, "NCOPY": _ncopy, "ELCOPY": _elcopy}[card.name](card, scope)


def _numbers(card, kind, least, most):
    """Rows of numbers of a card's data lines; fields left out are None."""
    for number, parts in card.fields():
        try:
            row = [kind(part) if part else None for part in parts]
            if not all(abs(value) < 1e300 for value in row if value is not None):
                raise ValueError("a number that is not finite")
        except ValueError as error:
            raise card.fault(f"{', '.join(parts)[:80]!r}: numbers are needed", number) from error
        if not least <= len(row) <= most or None in row[:least]:
            raise card.fault(f"{least} to {most} numbers are needed, not {len(row)}", number)
        yield number, row


# ------------------------------------------------------------------------------ nodes between two

def _ngen(card, scope):
    line = card.value("LINE", "").upper()[:1]
    if "SYSTEM" in card.parameters and card.value("SYSTEM", "").upper()[:1] not in ("R", ""):
        raise card.fault("SYSTEM=C or S is not understood here")
    made = []
    for number, row in _numbers(card, real, 2, 10):
        first, last, step = int(row[0]), int(row[1]), int(row[2] or 1) if len(row) > 2 else 1
        count, rest = divmod(last - first, step) if step else (0, 1)
        if rest or not 1 <= count <= MOST:
            raise card.fault(f"from {first} to {last} by steps of {step} is not possible", number)
        ends = scope.node_places(np.array([first, last]), card)
        parts = np.arange(1, count)[:, None] / count
        ids = first + step * np.arange(1, count)
        scope.add_node_block(ids, _between(card, scope, line, ends, parts, row, number))
        made += [np.array([first, last]), ids]
    if card.value("NSET"):
        scope.add_to_set("nodes", card.value("NSET"), scope, np.unique(np.concatenate([np.zeros(0, np.int64), *made])))


def _between(card, scope, line, ends, parts, row, number):
    """(n,3) places between two: on the straight line, a parabola (LINE=P) or a circular arc (LINE=C)."""
    start, end = ends
    if not line:
        return start + (end - start) * parts
    third = _third_point(card, scope, row, number)
    if line == "P":     # through start, third in the middle, end
        return (1 - parts) * (1 - 2 * parts) * start + 4 * parts * (1 - parts) * third + parts * (2 * parts - 1) * end
    if line != "C":
        raise card.fault(f"LINE={card.value('LINE')} is not known; P and C are possible", number)
    normal = np.array([v or 0.0 for v in row[7:10]]) if len(row) > 7 else np.cross(start - third, end - third)
    a, b = start - third, end - third
    if not np.linalg.norm(normal) > 0:
        raise card.fault("an arc of 180 degrees needs the normal of its plane", number)
    normal = normal / np.linalg.norm(normal)
    angle = np.arctan2(np.dot(np.cross(a, b), normal), np.dot(a, b)) % (2 * np.pi)
    radius = np.linalg.norm(a) + (np.linalg.norm(b) - np.linalg.norm(a)) * parts
    turned = np.cos(angle * parts) * a + np.sin(angle * parts) * np.cross(normal, a)
    return third + turned / np.linalg.norm(a) * radius


def _third_point(card, scope, row, number):
    if len(row) > 3 and row[3] is not None:
        return scope.node_places(np.array([int(row[3])]), card)[0]
    if len(row) < 7 or any(v is None for v in row[4:7]):
        raise card.fault("the middle of a curved line is missing: a node's number, or x, y, z", number)
    return np.array(row[4:7], float)


# ------------------------------------------------------------------------------ elements after one

def _elgen(card, scope):
    made = []
    for number, row in _numbers(card, int, 2, 10):
        row = [1 if value is None else value for value in row] + [1] * (10 - len(row))
        master, steps = row[0], [row[k:k + 3] for k in (1, 4, 7)]
        if min(count for count, _, _ in steps) < 1 or np.prod([float(count) for count, _, _ in steps]) > MOST:
            raise card.fault("counts of at least 1 are needed", number)
        kind_name, nodes = scope.element_of(master, card)
        ids, shifts = np.zeros(1, np.int64), np.zeros(1, np.int64)
        for count, node_step, element_step in steps:
            turns = np.arange(count)
            ids = (ids + element_step * turns[:, None]).ravel()
            shifts = (shifts + node_step * turns[:, None]).ravel()
        new = np.flatnonzero(ids != 0)
        scope.add_element_block(kind_name, master + ids[new], nodes + shifts[new][:, None])
        made.append(master + ids)
    if card.value("ELSET"):
        scope.add_to_set("elements", card.value("ELSET"), scope, np.concatenate([np.zeros(0, np.int64), *made]))


# ------------------------------------------------------------------------------ copies of sets

def _ncopy(card, scope):
    shift, old = _whole(card, "CHANGE NUMBER"), _old_set(card, scope, "nodes")
    places, made = scope.node_places(old, card), []
    ways = [name for name in ("SHIFT", "REFLECT", "POLE") if name in card.parameters]
    rows = [row for _, row in _numbers(card, real, 1, 9)]
    rows = [[value or 0.0 for value in row] for row in rows]
    if len(ways) != 1 or ways[0] == "POLE":
        raise card.fault("SHIFT or REFLECT is needed; POLE is not understood")
    for turn in range(1, (_whole(card, "MULTIPLE") if "MULTIPLE" in card.parameters else 1) + 1):
        if turn > MOST // max(len(old), 1):
            raise card.fault(f"it makes more than {MOST} nodes")
        places = _shifted(card, rows, places) if ways[0] == "SHIFT" else _reflected(card, rows, places)
        scope.add_node_block(old + turn * shift, places)
        made.append(old + turn * shift)
    if card.value("NEW SET"):
        scope.add_to_set("nodes", card.value("NEW SET"), scope, np.concatenate(made))


def _shifted(card, rows, places):
    if rows and len(rows[0]) > 3:
        raise card.fault("a line of a translation, and one of a rotation, are possible")
    places = places + np.array((rows[0] + [0.0] * 3)[:3]) if rows else places
    if len(rows) > 1:
        values = np.array(rows[1] + [0.0] * 7)[:7]
        places = rotation(card, values[:3], values[3:6], values[6])(places)
    return places


def _reflected(card, rows, places):
    way, values = card.value("REFLECT", "").upper(), np.array([v for row in rows for v in row])
    wanted = {"POINT": 3, "LINE": 6, "MIRROR": 9}.get(way)
    if len(values) != wanted:
        raise card.fault(f"REFLECT=POINT, LINE or MIRROR with 3, 6 or 9 numbers is possible, not {way} with "
                         f"{len(values)}")
    at = values[:3]
    if way == "POINT":
        return 2 * at - places
    first = values[3:6] - at
    direction = first if way == "LINE" else np.cross(first, values[6:9] - at)
    if not np.linalg.norm(direction) > 0:
        raise card.fault("its points lie in one place, or line")
    direction = direction / np.linalg.norm(direction)
    along = np.outer((places - at) @ direction, direction)
    return places - 2 * along if way == "MIRROR" else 2 * (at + along) - places


def _elcopy(card, scope):
    if "REFLECT" in card.parameters:
        raise card.fault("REFLECT is not understood: it would turn the elements inside out")
    element_shift, node_shift = _whole(card, "ELEMENT SHIFT"), _whole(card, "SHIFT NODES")
    old = _old_set(card, scope, "elements")
    for kind_name, ids, nodes in list(scope.elements):
        rows = np.flatnonzero(np.isin(ids, old))
        if len(rows):
            scope.add_element_block(kind_name, ids[rows] + element_shift, nodes[rows] + node_shift)
    if card.value("NEW SET"):
        scope.add_to_set("elements", card.value("NEW SET"), scope, old + element_shift)


def _old_set(card, scope, kind):
    name = card.value("OLD SET")
    members = scope.ids_of_set(kind, name) if name else None
    if members is None:
        raise card.fault(f"OLD SET={name}: there is no such set before")
    return np.unique(np.concatenate([ids for _, ids in members]))


def _whole(card, name):
    try:
        return int(card.parameters[name])
    except (KeyError, ValueError) as error:
        raise card.fault(f"{name}=... with a whole number is needed") from error
