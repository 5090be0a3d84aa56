# SPDX-License-Identifier: LGPL-2.1-or-later
"""A reader of quads in .off. Ours, because meshio and gmsh take triangles only, and VTK 9.1 has none."""
import re

import numpy as np

from hexcon.errors import FaultCode, ToolError

from .contents import Contents

_HEAD = re.compile(r"^(ST)?(C)?(N)?(4)?(n)?OFF$")


def read_off(path):
    """Contents of an ASCII .off file (COFF, NOFF, STOFF too). Raises ToolError FILE_FORMAT naming the line."""
    with open(path, "rb") as stream:
        data = stream.read()
    lines = [(number, line.split("#", 1)[0].split())
             for number, line in enumerate(data.decode("latin-1").replace("\r\n", "\n").split("\n"), 1)]
    lines = [(number, words) for number, words in lines if words]

    def fault(number, words):
        return ToolError(f"{path}, line {number}: {words}", FaultCode.FILE_FORMAT)
    if not lines or not (head := _HEAD.match(lines[0][1][0])) or "BINARY" in lines[0][1]:
        raise fault(1, "no ASCII OFF file")
    if head.group(4) or head.group(5):
        raise fault(1, f"{lines[0][1][0]}: points of other than three dimensions")
    first = lines[0][1][1:] if len(lines[0][1]) > 1 else None
    at = 1 if first else 2
    number, counts = (lines[0][0], first) if first else lines[1] if len(lines) > 1 else (1, [])
    try:
        n_points, n_faces = int(counts[0]), int(counts[1])
    except (ValueError, IndexError) as error:
        raise fault(number, "counts of points and faces are needed") from error
    if n_points < 0 or n_faces < 0 or at + n_points + n_faces > len(lines):
        raise fault(number, f"{n_points} points and {n_faces} faces cannot be in a file of {len(lines)} lines")
    points, cells = [], {}
    for number, words in lines[at:at + n_points]:
        try:
            points.append([float(word) for word in words[:3]])
        except ValueError as error:
            raise fault(number, "three coordinates are needed") from error
        if len(points[-1]) != 3:
            raise fault(number, "three coordinates are needed")
    for number, words in lines[at + n_points:at + n_points + n_faces]:
        try:
            size = int(words[0])
            corners = [int(word) for word in words[1:1 + size]]
        except ValueError as error:
            raise fault(number, "a face is a count, and its corners") from error
        if size not in (3, 4) or len(corners) != size:
            raise fault(number, f"a {size}-gon; HexCon needs quads: divide it")
        if not 0 <= min(corners) <= max(corners) < n_points:
            raise fault(number, "a face names a point that does not exist")
        cells.setdefault("quad" if size == 4 else "triangle", []).append(corners)
    return Contents(np.array(points, float).reshape(-1, 3), {kind: np.array(rows, np.int64) for kind,
                                                             rows in cells.items()})
