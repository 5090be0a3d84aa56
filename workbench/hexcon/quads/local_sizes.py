# SPDX-License-Identifier: LGPL-2.1-or-later
"""Local sizes as people write them: Face3, Edge7, Vertex1, or a point, a ball or a box, each with its size."""
import re
from collections.abc import Mapping

from hexcon.errors import FaultCode, ToolError

from .checked_numbers import check_number

_NAMED = re.compile(r"(Face|Edge|Vertex)([1-9][0-9]*)$")
_PLACES = {"point": 3, "ball": 4, "box": 6}
WAYS = "FaceN, EdgeN, VertexN, point:x,y,z, ball:x,y,z,radius or box:x,y,z,x,y,z (its least and its largest corner)"


def parsed(local_sizes):
    """[dict] as the gmsh worker takes them; a "tag" is a number in the caller's shape.

    local_sizes: a mapping of where -> size, or texts "WHERE=SIZE". Raises ToolError BAD_OPTION.
    """
    if isinstance(local_sizes, Mapping):
        pairs = [(str(where), size) for where, size in local_sizes.items()]
    else:
        pairs = [tuple(str(text).rpartition("=")[::2]) for text in local_sizes or ()]
    return [_parsed(where.strip(), size) for where, size in pairs]


def _parsed(where, size):
    check_number(f"the local size at {where!r}", size)
    named = _NAMED.match(where)
    if named:
        return {"where": where, "kind": named[1].lower(), "tag": int(named[2]), "size": float(size)}
    kind, _, rest = where.partition(":")
    try:
        at = [float(part) for part in rest.split(",")]
    except ValueError:
        at = []
    if len(at) != _PLACES.get(kind) or not all(abs(x) < 1e300 for x in at):
        raise ToolError(f"a local size at {where!r}: write WHERE=SIZE, WHERE being {WAYS}", FaultCode.BAD_OPTION)
    if kind == "box":
        at = [min(p) for p in zip(at[:3], at[3:])] + [max(p) for p in zip(at[:3], at[3:])]
    if kind == "ball" and at[3] < 0.0:
        raise ToolError(f"a local size at {where!r}: its radius is below zero", FaultCode.BAD_OPTION)
    return {"where": where, "kind": kind, "at": at, "size": float(size)}


def written(local_sizes):
    """The texts "WHERE=SIZE" of what parsed takes."""
    return [f"{one['where']}={one['size']!r}" for one in parsed(local_sizes)]


def of_the_solid(found, face_numbers):
    """`parsed` with the solid's own numbers. face_numbers: those of its faces in the caller's shape, None: the same.

    Raises ToolError BAD_OPTION for an edge or a corner of a shape that has more than the solid.
    """
    if face_numbers is None:
        return found
    own = {number: tag for tag, number in enumerate(face_numbers, 1)}
    out = []
    for one in found:
        if "tag" in one and (one["kind"] != "face" or one["tag"] not in own):
            raise ToolError(f"a local size at {one['where']}: of a shape that has more than its solid only faces "
                            "of the solid can be named", FaultCode.BAD_OPTION)
        out.append(dict(one, tag=own[one["tag"]]) if "tag" in one else one)
    return out
