# SPDX-License-Identifier: LGPL-2.1-or-later
"""A solid whose rooms are filled from the quads of what is round them, as one mesh."""
import contextlib
import os
import tempfile
from dataclasses import dataclass

import gmsh
import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

import hexcon_native as hn

from .. import cad
from ..boxed.whole import Skin, cad_faces
from ..cad_fit import volume_and_area
from ..layered.fault import NotLayered
from ..layered.roles import Shape
from .cover import covers
from .inside import filled
from .natural import natural
from .refined import refined


@dataclass
class FilledMesh:
    """points (P,3), hexes (H,8), quads (n,4) outward, faces (n,): CAD faces; parts: words about what is natural;
    rooms: how many; methods: of the fillers; filler: their part of the volume; filler_hexes: how many of the hexes, the
    last ones."""

    points: np.ndarray
    hexes: np.ndarray
    quads: np.ndarray
    faces: np.ndarray
    parts: list
    rooms: int
    methods: list
    filler: float
    filler_hexes: int


@dataclass
class _Rest:
    """What rooms leave, as one mesh with every hex in eight; coarse (P,) bool: its points before; owner (n,2): part and
    face of the part of each quad; on_room (n,) bool: quads on sides of rooms, inside the solid; words about it."""

    points: np.ndarray
    hexes: np.ndarray
    quads: np.ndarray
    coarse: np.ndarray
    owner: np.ndarray
    on_room: np.ndarray
    words: list


def filled_mesh(shape, skin, rooms, size, link, end):
    """The FilledMesh of a roles.Shape.

    rooms: [Room]; skin: whole.Skin of the solid; end: of processor time. Raises NotLayered.
    """
    near = 10 * shape.solid.tolerance
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "solid.brep")
        gmsh.write(path)
        rest = _rest(path, os.path.join(folder, "rest.brep"), rooms, skin, size, near, link, end)
        shell = rest.quads[rest.on_room]
        rim = _rim(shell)
        corners = rest.points[rim[rest.coarse[rim]]]
        made = [cover for room in rooms
                for cover in covers(path, room, corners[room.on_sides(corners, near)], skin, size, near)]
    points, quads, owner = _closed(rest, shell, rim, made)
    return _whole(shape, skin, rest, points, quads, owner, len(rooms), near, end)


def _rest(path, rest_path, rooms, skin, size, near, link, end):
    count, meshes = _cut_out(path, rest_path, rooms), []
    for number in range(count):
        with _part(rest_path, number, size) as (part, part_skin):
            mesh, words = natural(part, part_skin, size, link, end)
            points, hexes, quads, faces = refined(part, mesh.points, mesh.hexes, mesh.quads, mesh.faces)
            sides = [f for f in part.solid.faces if part.solid.is_plane(f)
                     and any(room.is_side_of(points[quads[faces == f]].mean(1), skin, near) for room in rooms)]
            meshes.append(_Rest(points, hexes, quads, np.arange(len(points)) < len(mesh.points),
                                np.column_stack([np.full(len(quads), number), faces]), np.isin(faces, sides), [words]))
    return _joined(meshes)


def _cut_out(path, rest_path, rooms):
    """How many solids rooms leave, which are in the other file then."""
    with cad.other_model("rest"):
        solid = gmsh.model.occ.importShapes(path)
        try:
            gmsh.model.occ.cut(solid, [(3, room.block()) for room in rooms])
        except Exception as error:      # gmsh raises Exception itself
            raise NotLayered(f"Open CASCADE does not cut rooms out: {error}") from error
        gmsh.model.occ.synchronize()
        gmsh.write(rest_path)
        count = len(gmsh.model.getEntities(3))
    if not count:
        raise NotLayered("rooms take all of the solid")
    return count


@contextlib.contextmanager
def _part(path, number, size):
    """(roles.Shape, whole.Skin) of the n-th solid of a file, in a model of its own while it lasts."""
    with cad.other_model("part"):
        volumes = gmsh.model.occ.importShapes(path)
        gmsh.model.occ.remove([v for k, v in enumerate(volumes) if k != number], recursive=True)
        gmsh.model.occ.synchronize()
        solid = cad.Solid(gmsh.model.getEntities(3)[0][1])
        yield Shape(solid, size), Skin(solid)


def _joined(meshes):
    starts = np.cumsum([0] + [len(m.points) for m in meshes])
    points, hexes, quads, coarse, owner, on_room = map(np.concatenate, zip(*(
        (m.points, m.hexes + s, m.quads + s, m.coarse, m.owner, m.on_room) for m, s in zip(meshes, starts))))
    return _Rest(points, hexes, quads, coarse, owner, on_room, [word for m in meshes for word in m.words])


def _rim(quads):
    """Ids of points on edges that one quad has."""
    edges = np.sort(np.stack([quads, np.roll(quads, -1, axis=1)], -1).reshape(-1, 2), axis=1)
    found, count = np.unique(edges, axis=0, return_counts=True)
    return np.unique(found[count == 1])


def _closed(rest, shell, rim, made):
    """(points: the rest's, then those of covers; quads of rooms: the shell, turned, then the covers; owner (n,2) of
    the covers' quads: number and face, counted on from the rest's parts).

    Covers' points on the rim become the shell's. Raises NotLayered."""
    points, quads, owner = [rest.points], [shell[:, ::-1]], []
    total, parts = len(rest.points), int(rest.owner[:, 0].max()) + 1
    tree = cKDTree(rest.points[rim])
    taken = []
    for k, cover in enumerate(made):
        ids = total + np.arange(len(cover.points))
        edge = _rim(cover.quads)
        if len(edge):
            found = rim[tree.query(cover.points[edge])[1]]
            taken.append(found)
            ids[edge] = found
        points.append(cover.points)
        quads.append(ids[cover.quads])
        owner.append(np.column_stack([np.full(len(cover.quads), parts + k), cover.faces]))
        total += len(cover.points)
    if not np.array_equal(np.sort(np.concatenate([*taken, np.empty(0, int)])), np.sort(rim)):
        raise NotLayered("the quads in a room do not meet those beside it")
    return np.concatenate(points), np.concatenate(quads), np.concatenate(owner)


def _whole(shape, skin, rest, points, quads, owner, rooms, near, end):
    turned, hexes, methods, filler = _outward(points, quads), [rest.hexes], [], 0.0
    for k, rows in enumerate(_bodies(turned)):
        ids, packed = np.unique(turned[rows], return_inverse=True)
        mesh = filled(points[ids], packed.reshape(-1, 4), f"room {k + 1}", end)
        names = np.concatenate([ids, len(points) + np.arange(len(mesh.points) - len(ids))])
        points = np.concatenate([points, mesh.points[len(ids):]])
        hexes.append(names[mesh.hexes])
        methods.append(mesh.method)
        filler += volume_and_area(points[turned[rows]])[0]
    outer = np.concatenate([rest.quads[~rest.on_room], turned[len(turned) - len(owner):]])
    owner, hexes = np.concatenate([rest.owner[~rest.on_room], owner]), np.concatenate(hexes)
    used, packed = np.unique(hexes, return_inverse=True)
    outer = np.searchsorted(used, outer)
    faces = cad_faces(shape, skin, points[used], outer, owner, near)
    return FilledMesh(points[used], packed.reshape(-1, 8), outer, faces, rest.words, rooms, methods,
                      filler / shape.volume, len(hexes) - len(rest.hexes))


def _outward(points, quads):
    """Closed quads as seen from outside of what they bound."""
    used, packed = np.unique(quads, return_inverse=True)
    try:
        return used[hn.orient(points[used], packed.reshape(-1, 4))[0]]
    except hn.HexconError as fault:
        raise NotLayered(f"the quads round a room do not close: {fault}") from fault


def _bodies(quads):
    """Rows of quads that hang together, for each body."""
    count, ring = int(quads.max()) + 1, np.roll(quads, -1, axis=1)
    graph = coo_matrix((np.ones(quads.size), (quads.ravel(), ring.ravel())), shape=(count, count))
    label = connected_components(graph, directed=False)[1][quads[:, 0]]
    return [np.flatnonzero(label == one) for one in np.unique(label)]
