# SPDX-License-Identifier: LGPL-2.1-or-later
"""A solid along one direction: what boxes round its cross features leave, then what is in each box, then all as one."""
import contextlib
import os
import tempfile
import time
from dataclasses import dataclass

import gmsh
import numpy as np

from ..fault import WorkerFault
from ..layered.extrude import LayeredMesh
from ..layered.fault import NotLayered
from ..layered.mesh import Standing
from ..layered.roles import Shape
from . import parts, seam
from .box import ROOMS, boxes_round
from .features import features
from .whole import cad_faces, joined

MOST_ROUNDS = 5     # of finding lines that meet boxes: each is a cut of the solid


@dataclass
class BoxedMesh(LayeredMesh):
    """boxes: how many; levels, rings: outside of them; flat: of the part that is worst.

    pieces: [(name in stage_words.HEX_STAGES, perhaps numbered, how many hexes)], in the sequence of the hexes
    """

    boxes: int = 0
    pieces: tuple = ()


def boxed_mesh(shape, skin, direction, size, link, end=np.inf):
    """The BoxedMesh of a roles.Shape, its inner points not yet improved.

    skin: whole.Skin of the solid; end: of processor time. Raises NotLayered.
    """
    told, across = [], features(shape, direction, shape.roles(direction))
    for room in ROOMS:
        try:
            return _with_boxes(shape, skin, boxes_round(across, shape, size, room), direction, size, link, end)
        except NotLayered as fault:
            told.append(str(fault))
    raise NotLayered("; ".join(dict.fromkeys(told)))


def _with_boxes(shape, skin, boxes, direction, size, link, end):
    near = 10 * shape.solid.tolerance
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "solid.brep")
        gmsh.write(path)
        for number, box in enumerate(boxes, 1):
            with _told(f"box {number}", end):
                _own_stations(path, box, size)
        with _told("outside of the boxes", end):
            rest, rows = _rest(path, boxes, direction, size, link)
        pieces = []
        for number, (box, across) in enumerate(zip(boxes, rows), 1):
            with _told(f"box {number}", end):
                pieces += [(box, mesh) for mesh in _pieces(path, box, rest, across, size, link)]
    points, hexes, quads, owner = joined(rest, pieces, skin, near)
    faces = cad_faces(shape, skin, points, quads, owner, near)
    flats = [mesh.flat for mesh in [*rest, *(mesh for _, mesh in pieces)]]
    return BoxedMesh(points, hexes, quads, faces, sum(m.rings for m in rest), sum(m.levels for m in rest),
                     min(flats, key=lambda flat: flat.limit), rest[0].plane, 0, boxes=len(boxes),
                     pieces=_counted(rest, boxes, pieces))


def _counted(rest, boxes, meshes):
    """BoxedMesh.pieces; a box that the solid divides has several meshes, one after the other."""
    in_box = [sum(len(mesh.hexes) for box, mesh in meshes if box is one) for one in boxes]
    return (("layers round the boxes", sum(len(mesh.hexes) for mesh in rest)),
            *((f"box {number}", count) for number, count in enumerate(in_box, 1)))


@contextlib.contextmanager
def _told(where, end):
    """Faults of parts name the place, and none of their faces: they have other numbers than the solid's."""
    if time.process_time() > end:
        raise NotLayered(f"{where}: no time left")
    try:
        yield
    except NotLayered as fault:
        raise NotLayered(f"{where}: " + ("it is not layered itself" if fault.faces else str(fault))) from fault
    except WorkerFault as fault:
        raise NotLayered(f"{where}: Open CASCADE makes no sound solid of it ({fault.code})") from fault


def _own_stations(path, box, size):
    with parts.inside(path, box, box.corners()) as solids:
        for solid in solids:
            for along in seam.own_stations(box, Standing(Shape(solid, size), box.feature.axis, size)).values():
                box.add_station(along)


def _rest(path, boxes, direction, size, link):
    """([LayeredMesh] of what boxes leave, [places across each box]); boxes get stations where its lines meet them."""
    for _ in range(MOST_ROUNDS):
        with parts.outside(path, boxes) as solids:
            if not solids:
                raise NotLayered("boxes take all of the solid")
            standings = [Standing(Shape(solid, size), direction, size) for solid in solids]
            if any([seam.add_lines(box, standing) for box in boxes for standing in standings]):
                continue
            layers = seam.layers_beside(boxes, standings, size)
            rows = [seam.rows_of(box, standings) for box in boxes]
            return [standing.mesh(link, seam.strip_counts(boxes, rows, standing, size), of_part)
                    for standing, of_part in zip(standings, layers)], rows
    raise NotLayered("lines go on meeting boxes in new places")


def _pieces(path, box, rest, rows, size, link):
    """[LayeredMesh] of what is in a box, with the nodes of the rest on its sides."""
    outline, closed = seam.outline(box, rest, rows, size)
    with parts.inside(path, box, outline) as solids:
        standings = [Standing(Shape(solid, size), box.feature.axis, size) for solid in solids]
        return [s.mesh(link, seam.ones(box, s, closed), seam.layers_along(box, s, size)) for s in standings]
