# SPDX-License-Identifier: LGPL-2.1-or-later
"""A reader of quads in Wavefront .obj: what modellers write.

Ours, because meshio stumbles over texture coordinates, normals and negative indices, VTK's parts points at seams of
texture, gmsh has none, and none says in which line a pentagon is. Format: Wavefront, Advanced Visualizer, appendix B1.
"""
import numpy as np

from hexcon.errors import FaultCode, ToolError

from .contents import Contents, Group

_GROUPS = {"g": "group", "o": "object", "usemtl": "material"}


def read_obj(path):
    """Contents: v with or without weight and colour, f of corners v, v/vt, v//vn, v/vt/vn, counted from either end.

    Groups (g), and objects and materials where there are several, are groups of quads. Lines, points, textures, normals
    and smoothing are passed over. Raises ToolError FILE_FORMAT naming the line: other polygons, free-form surfaces.
    """
    file = _Obj(path)
    with open(path, "rb") as stream:
        text = stream.read().decode("utf-8-sig", "replace").replace("\r\n", "\n").replace("\r", "\n")
    for number, line in _lines(text):
        file.take(number, line)
    return file.contents()


def _lines(text):
    """(number, line) of what is no comment; a backslash at the end continues a line."""
    held, begun = "", 0
    for number, line in enumerate(text.split("\n"), 1):
        begun = begun if held else number
        if line.rstrip().endswith("\\"):
            held += line.rstrip()[:-1] + " "
            continue
        whole, held = (held + line).split("#", 1)[0].split(), ""
        if whole:
            yield begun, whole


class _Obj:
    def __init__(self, path):
        self.path, self.points, self.quads, self.triangles = path, [], [], []
        self.current, self.members = {}, {}

    def fault(self, number, words):
        return ToolError(f"{self.path}, line {number}: {words}", FaultCode.FILE_FORMAT)

    def take(self, number, words):
        head = words[0]
        if head == "v":
            self._point(number, words[1:])
        elif head in ("f", "fo"):
            self._face(number, words[1:])
        elif head in _GROUPS:
            names = words[1:] if head == "g" else [" ".join(words[1:])]
            self.current[head] = [name for name in names if name and name != "default"]
        elif head in ("curv", "surf", "cstype", "bmat", "vp"):
            raise self.fault(number, f"a free-form curve or surface ({head}); quads are needed")

    def _point(self, number, words):
        """x y z, then nothing, a weight, a colour, or both."""
        try:
            values = [float(word) for word in words]
        except ValueError as error:
            raise self.fault(number, f"{' '.join(words)[:60]!r} is no point: three numbers are needed") from error
        if len(values) not in (3, 4, 6, 7, 8):
            raise self.fault(number, f"a point has three coordinates, not {len(values)} numbers")
        weight = values[3] if len(values) in (4, 8) else 1.0
        if weight == 0.0:
            raise self.fault(number, "a point with weight 0 lies nowhere")
        self.points.append(values[:3] if weight == 1.0 else [x / weight for x in values[:3]])

    def _face(self, number, words):
        corners = [self._corner(number, word) for word in words]
        if len(corners) not in (3, 4):
            what = f"a {len(corners)}-gon" if len(corners) > 4 else f"a face of {len(corners)} corners"
            raise self.fault(number, f"{what}; HexCon needs quads: divide it")
        if len(corners) == 3:
            self.triangles.append(corners)
            return
        for kind, names in self.current.items():
            for name in names:
                self.members.setdefault((kind, name), []).append(len(self.quads))
        self.quads.append(corners)

    def _corner(self, number, word):
        """Row of the point of v, v/vt, v//vn or v/vt/vn; -1 is the last one so far."""
        try:
            index = int(word.split("/")[0])
        except ValueError as error:
            raise self.fault(number, f"{word!r} is no corner of a face") from error
        row = index - 1 if index > 0 else len(self.points) + index
        if index == 0 or row < 0 or index > 0 and index > 10 ** 9:
            raise self.fault(number, f"corner {word!r} names a point that does not exist; there are "
                                     f"{len(self.points)} so far")
        return row

    def contents(self):
        if not self.quads and not self.triangles:
            raise ToolError(f"{self.path}: there are no faces in it", FaultCode.FILE_FORMAT)
        cells = {"quad": self.quads, "triangle": self.triangles}
        cells = {kind: np.array(rows, np.int64) for kind, rows in cells.items() if rows}
        counts = {kind: sum(one == kind for one, _ in self.members) for kind in _GROUPS}
        groups = [Group(name, "quad", np.array(rows)) for (kind, name), rows in self.members.items()
                  if kind == "g" or counts[kind] > 1]
        return Contents(np.array(self.points, float).reshape(-1, 3), cells, groups)
