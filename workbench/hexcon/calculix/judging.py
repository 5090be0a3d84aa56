# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a run of CalculiX can be believed: the one place where that is decided.

ccx may report an error and end with status 0, may write NaN for a model that moves freely, and does not notice that
its disk is full; and what runs as ccx need not be ccx. So its status, its messages and its files are all looked at.
"""
import os
import re

import numpy as np

from hexcon.errors import FaultCode, ToolError

from . import frd
from .loads import force_vector, pressure_value

_MAX_LINES = 20
_MAX_IDS = 20
_SLACK = 2.0    # seconds by which file systems round times
_ELEMENT = re.compile(r"(?:in|to) element\s+(\d+)")


def check_loads(force, pressure, prescribed=None):
    """Raise BAD_OPTION where every load is zero, or there is none: all results would be zero, and look like an answer.

    force {face: (3,)}, pressure {face: MPa}; prescribed: displacements, which are loads even if they are zero.
    Raises ToolError BAD_OPTION also for what is no force, or no pressure.
    """
    loads = [*(force_vector(name, value).any() for name, value in (force or {}).items()),
             *(pressure_value(name, value) != 0.0 for name, value in (pressure or {}).items())]
    if prescribed is not None or any(loads):
        return
    names = ", ".join(map(str, [*(force or {}), *(pressure or {})]))
    raise ToolError((f"the loads on {names} are all zero" if names else "no load is given")
                    + ": nothing would move; name a face with a force or a pressure that is not zero",
                    FaultCode.BAD_OPTION)


def error_lines(log):
    """CalculiX's own *ERROR messages, each with the lines that continue it."""
    lines, taken, inside = log.splitlines(), {}, False
    for line in lines:
        text = line.strip()
        if "*ERROR" in text:
            inside = True
        elif not text or text.startswith("*"):
            inside = False
        if inside:
            taken[text] = None
    return list(taken)


def failure(log, how):
    """ToolError(TOOL_FAILED) that quotes ccx; how: "ended with status 201", say. .elements are the elements it names,
    rows (element number - 1)."""
    words = error_lines(log)
    if not words:  # killed, or an end without a message: show where it stopped
        words = [line.strip()[:500] for line in log.splitlines() if line.strip()][-5:] or ["it said nothing"]
    more = len(words) - _MAX_LINES
    shown = words[:_MAX_LINES] + ([f"... and {more} more lines"] if more > 0 else [])
    ids = sorted({int(n) - 1 for n in _ELEMENT.findall("\n".join(words)) if len(n) < 19})
    return ToolError(f"CalculiX failed, it {how}:\n" + "\n".join(shown), FaultCode.TOOL_FAILED, ids)


def judged(deck_path, ended, nodes=None):
    """The results of a run (see frd.read), which can be believed.

    deck_path  the .inp file, beside which the results lie;  ended: child.Ended
    nodes      (n,) node numbers that must have displacements and, if any has, stresses; None: those that ccx counts
    Raises ToolError TOOL_FAILED, with ccx's words or with what is wrong with its results.
    """
    path = os.path.splitext(deck_path)[0] + ".frd"
    if ended.status or "*ERROR" in ended.output or not os.path.exists(path):
        raise failure(ended.output, ended.how())
    if os.path.getmtime(path) < os.path.getmtime(deck_path) - _SLACK:
        raise _unbelievable(f"{path} is older than the deck: ccx wrote no results")
    try:
        found = frd.read(path)
    except ValueError as error:
        raise _unbelievable(f"{path} is damaged: {error}") from error
    if found is None:
        raise failure(ended.output, ended.how() + f", and its results ({os.path.basename(path)}) hold no displacements "
                      "or end before their time")
    _check_nodes(found, nodes)
    _check_numbers(found)
    return found


def judged_points(path):
    """frd.read_dat_stress of a file, or None where there is none. Raises ToolError TOOL_FAILED."""
    if not os.path.exists(path):
        return None
    try:
        points = frd.read_dat_stress(path)
    except ValueError as error:
        raise _unbelievable(f"{path} is damaged: {error}") from error
    if points is not None and not np.isfinite(points).all():
        raise _unbelievable(f"{path} has stresses that are not finite")
    return points


def _check_nodes(found, nodes):
    if nodes is None:
        return
    nodes = np.unique(np.asarray(nodes, np.int64))
    strange = np.setdiff1d(found["node_ids"], nodes)
    if len(strange):
        raise _unbelievable(f"results of {len(strange)} nodes that are not in the model, {_listed(strange)}")
    missing = np.setdiff1d(nodes, found["node_ids"])
    if len(missing):
        raise _unbelievable(f"no results of {len(missing)} nodes, {_listed(missing)}")


def _check_numbers(found):
    """Displacements finite; stresses too, where there are any (all of a node's are missing where it has none)."""
    for name in ("displacements", "stress"):
        if found[name] is None:
            continue
        bad = ~np.isfinite(found[name]).all(axis=1)
        if bad.any():
            raise _unbelievable(f"the {name} of {int(bad.sum())} nodes are no finite numbers, "
                                f"{_listed(found['node_ids'][bad])}. The part may be free to move (hold more of it), or "
                                "have hexes without volume (hexcon check tells)")


def _listed(ids):
    return "numbers " + ", ".join(map(str, ids[:_MAX_IDS].tolist())) + (" ..." if len(ids) > _MAX_IDS else "")


def _unbelievable(what):
    return ToolError(f"CalculiX's results cannot be used: {what}", FaultCode.TOOL_FAILED)
