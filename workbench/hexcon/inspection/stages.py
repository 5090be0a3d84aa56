# SPDX-License-Identifier: LGPL-2.1-or-later
"""The stages in which a method puts hexes in: boundary layers, cells, what is inside of them."""
import re

import numpy as np

from hexcon.errors import FaultCode, ToolError
from hexcon.stage_words import ALL

_STAGE = re.compile(r"hexes of (.+)")


def counts_of(report):
    """[(name, hexes)] that a mesh's report tells, from outside to inside; without those that put none in."""
    found = [(match[1], int(count)) for key, count in report.items() if (match := _STAGE.fullmatch(key))]
    return [(name, count) for name, count in found if count]


def stages_of(mesh):
    """[(name, slice of mesh.hexes)] of the stages that put hexes in, by "hexes of NAME" in mesh.report.

    They lie one after the other. A mesh that names none is one stage, ALL.
    Raises ToolError BAD_MESH if they do not add up to the mesh.
    """
    counts = counts_of(mesh.report) or [(ALL, len(mesh.hexes))]
    ends = np.cumsum([count for _, count in counts]).tolist()
    if ends[-1] != len(mesh.hexes):
        raise ToolError(f"the stages have {ends[-1]} hexes in all, and the mesh {len(mesh.hexes)}: its report is not "
                        "of these hexes", FaultCode.BAD_MESH)
    return [(name, slice(end - count, end)) for (name, count), end in zip(counts, ends)]


def stage_of_hex(counts, hex_ids):
    """(H,) int64: the row in counts, [(name, hexes)], of the stage of each hex; hex_ids (H,) rise with the stages.

    None if the counts do not add up to H.
    """
    numbers = np.array([count for _, count in counts], np.int64)
    if numbers.sum() != len(hex_ids):
        return None
    stage = np.empty(len(hex_ids), np.int64)
    stage[np.argsort(hex_ids, kind="stable")] = np.repeat(np.arange(len(counts)), numbers)
    return stage
