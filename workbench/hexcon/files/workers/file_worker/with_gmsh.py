# SPDX-License-Identifier: LGPL-2.1-or-later
"""gmsh's own reader, of every version of .msh."""
import gmsh
import numpy as np

from hexcon.femmesh.node_orders import HEX20, HEX27_GMSH, places_of

from .mesh import joined, mesh_arrays
from .refusal import Refusal

# gmsh's type of element -> meshio's name, and the places of VTK's nodes among gmsh's.
_KINDS = {
    2: ("triangle", 3), 9: ("triangle6", 6), 3: ("quad", 4), 16: ("quad8", 8), 10: ("quad9", 9), 4: ("tetra", 4),
    11: ("tetra10", [*range(8), 9, 8]), 5: ("hexahedron", 8),
    17: ("hexahedron20", places_of(HEX20["gmsh, files of .msh"])),
    12: ("hexahedron27", places_of(HEX27_GMSH)), 6: ("wedge", 6),
    18: ("wedge15", [0, 1, 2, 3, 4, 5, 6, 9, 7, 12, 14, 13, 8, 10, 11]), 7: ("pyramid", 5),
    19: ("pyramid13", [0, 1, 2, 3, 4, 5, 8, 10, 6, 7, 9, 11, 12])}
_PASSED_OVER = {15: "vertex", 1: "line", 8: "line3", 26: "line4", 27: "line5"}
_HEADS = (b"$MeshFormat", b"$NOD", b"$Comments")


def read(path):
    """Arrays of mesh.mesh_arrays. Raises ValueError, and what gmsh raises."""
    with open(path, "rb") as stream:
        head = stream.read(4096)
    if not any(one in head for one in _HEADS):
        raise ValueError("not a file of gmsh")
    gmsh.initialize(["gmsh", "-nopopup"], readConfigFiles=False)
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("General.NumThreads", 1)
    gmsh.option.setNumber("General.AbortOnError", 2)
    gmsh.logger.start()
    try:
        gmsh.merge(path)
    except Exception as error:
        said = [line[len("Error : "):] if line.startswith("Error") else line for line in gmsh.logger.get()]
        raise Refusal("FILE_FORMAT", f"gmsh: {said[-1] if said else error}") from error
    errors = [line for line in gmsh.logger.get() if line.startswith(("Error", "Warning : Unknown", "Fatal"))]
    if errors:
        raise Refusal("FILE_FORMAT", f"gmsh: {errors[0]}")
    return _arrays()


def _arrays():
    tags, places, _ = gmsh.model.mesh.getNodes(includeBoundary=False)
    tags, places = np.asarray(tags, np.int64), np.asarray(places).reshape(-1, 3)
    tags, first = np.unique(tags, return_index=True)
    places = places[first]
    blocks, elements = [], []
    for dimension, entity in gmsh.model.getEntities():
        for kind, ids, nodes in zip(*gmsh.model.mesh.getElements(dimension, entity)):
            blocks.append(_block(kind, len(ids), np.asarray(nodes, np.int64), tags))
            elements.append((dimension, entity))
    if not blocks:
        raise ValueError("gmsh finds no elements in it")
    together, at = joined(blocks)
    groups = _groups(blocks, elements, at)
    return mesh_arrays(places, *_once(together, groups))


def _block(kind, count, nodes, tags):
    if kind in _PASSED_OVER:
        rows = _rows(nodes.reshape(count, -1), tags) if kind == 15 else np.zeros((count, 0), np.int64)
        return _PASSED_OVER[kind], rows
    if kind not in _KINDS:
        name, _, order, size, _, _ = gmsh.model.mesh.getElementProperties(kind)
        raise Refusal("FILE_FORMAT", f"{count} elements of kind {name} (order {order}, {size} nodes); orders 1 and 2 "
                                     "are possible")
    name, places = _KINDS[kind]
    rows = nodes.reshape(count, -1)
    return name, _rows(rows if isinstance(places, int) else rows[:, places], tags)


def _rows(nodes, tags):
    rows = np.minimum(np.searchsorted(tags, nodes), len(tags) - 1)
    if len(tags) == 0 or (tags[rows] != nodes).any():
        raise ValueError("an element names a node that is not defined")
    return rows


def _groups(blocks, elements, at):
    """[(name, kind, members)] of the physical groups; of points: the nodes of their vertices."""
    groups = []
    for dimension, number in gmsh.model.getPhysicalGroups():
        name = gmsh.model.getPhysicalName(dimension, number) or f"physical {number}"
        if dimension == 1:
            continue
        entities = {(dimension, int(e)) for e in gmsh.model.getEntitiesForPhysicalGroup(dimension, number)}
        by_kind = {}
        for (kind, rows), entity, (_, first) in zip(blocks, elements, at):
            if entity in entities:
                members = rows.ravel() if dimension == 0 else first + np.arange(len(rows))
                by_kind.setdefault("nodes" if dimension == 0 else kind, []).append(members)
        groups += [(name, kind, np.concatenate(members)) for kind, members in by_kind.items()]
    return groups


def _once(together, groups):
    """(blocks, groups) with each quad once: an element in two groups is there twice in .msh of versions 1 and 2."""
    kept, rows_of = [], {}
    for kind, rows in together:
        if not kind.startswith(("quad", "hexahedron")) or not any(k == kind for _, k, _ in groups):
            kept.append((kind, rows))
            continue
        _, first, inverse = np.unique(rows, axis=0, return_index=True, return_inverse=True)
        order = np.sort(first)
        place = np.empty(len(first), np.int64)
        place[np.argsort(first)] = np.arange(len(first))
        grouped = np.zeros(len(rows), np.int64)
        for _, k, members in groups:
            if k == kind:
                grouped[members] += 1
        twice = np.setdiff1d(np.arange(len(rows)), order)
        if len(twice) and (grouped[twice] == 0).any():      # not a matter of groups: told as what they are later on
            kept.append((kind, rows))
            continue
        kept.append((kind, rows[order]))
        rows_of[kind] = place[inverse.ravel()]
    return kept, [(name, kind, np.unique(rows_of[kind][members]) if kind in rows_of else members)
                  for name, kind, members in groups]
