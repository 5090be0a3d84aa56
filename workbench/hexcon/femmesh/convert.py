# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hex mesh to FreeCAD's FemMesh and back."""
import re
from types import SimpleNamespace

import numpy as np

from hexcon import freecad_compat
from hexcon.errors import FaultCode, ToolError
from hexcon.labels import rows_of
from hexcon.topological import refuse_topological

from .elements import elements_of
from .node_orders import HEX20

# FreeCAD (SMESH) numbers a hexahedron the other way round: entry k is the VTK node that
# stands at FreeCAD's place k. In VTK order ccx ends with "nonpositive jacobian".
FREECAD_HEX = HEX20["FreeCAD (SMESH)"]
_GROUP = re.compile(r"^Face(\d{1,9})$")


def to_femmesh(mesh, order=None, *, allow_topological=False):
    """Fem.FemMesh of a hex mesh.

    mesh   .points, .hexes, .quads, .face_of_quad (see elements.elements_of)
    order  1 (Hexa8, ccx C3D8), 2 (Hexa20, ccx C3D20; of a mesh of order 1: straight edges), None: the mesh's own
    allow_topological  convert a mesh of topology only as well, which no solver must be given
    Node i+1 is point i; volumes are 1..H in the order of hexes; the boundary quads follow
    as faces H+1..H+n, outward. One face group per CAD face, named "Face3".
    Raises ToolError: FREECAD_MISSING, BAD_MESH, BAD_OPTION, TOPOLOGICAL_MESH. About 15 us per
    hexahedron.
    """
    refuse_topological(mesh, allow_topological)
    return femmesh_of_elements(elements_of(mesh, order))


def femmesh_of_elements(elements):
    """Fem.FemMesh of checked Elements; see to_femmesh."""
    femmesh = freecad_compat.fem_module("Fem").FemMesh()
    add_node, add_volume, add_face = femmesh.addNode, femmesh.addVolume, femmesh.addFace
    for node, (x, y, z) in enumerate(elements.points.tolist(), 1):
        add_node(x, y, z, node)
    reordered = elements.hexes[:, FREECAD_HEX[:elements.hexes.shape[1]]] + 1
    for volume, nodes in enumerate(reordered.tolist(), 1):
        add_volume(nodes, volume)
    first_face = len(elements.hexes) + 1
    for face, nodes in enumerate((elements.quads + 1).tolist(), first_face):
        add_face(nodes, face)
    for _, name, rows in elements.named():
        add_group(femmesh, name, "Face", rows + first_face)
    for name in elements.node_groups:
        add_group(femmesh, name, "Node", elements.nodes_of_set(name) + 1)
    return femmesh


def add_group(femmesh, name, kind, ids):
    """A named group of existing ids; kind is FreeCAD's "Node", "Face" or "Volume"."""
    group = femmesh.addGroup(name, kind)
    femmesh.addGroupElements(group, np.asarray(ids).tolist())


def _faces_of_groups(femmesh, node_ids):
    """(quads (n,4), face_of_quad (n,)) from the groups called Face<number>."""
    quads, numbers = [], []
    for group in femmesh.Groups:
        name = _GROUP.match(femmesh.getGroupName(group))
        if name and femmesh.getGroupElementType(group) == "Face":
            for face in femmesh.getGroupElements(group):
                quads.append(femmesh.getElementNodes(face)[:4])
                numbers.append(int(name.group(1)))
    if not quads:
        return None, None
    return rows_of(node_ids, quads), np.array(numbers)


def refuse_other_elements(femmesh):
    """Raise ToolError BAD_MESH unless all volumes of a FemMesh are hexahedra, and there are some."""
    if not femmesh.HexaCount or femmesh.HexaCount != femmesh.VolumeCount:
        raise ToolError(
            f"{femmesh.VolumeCount} volumes of which {femmesh.HexaCount} hexahedra; a mesh "
            "of hexahedra alone is needed", FaultCode.BAD_MESH)


def from_femmesh(femmesh):
    """Mesh-like object of a FemMesh made of hexahedra of one order.

    Returns an object with points (P,3), hexes, quads, face_of_quad (both None where there
    are no Face<number> groups), order, and node_ids (P,), hex_ids (H,): FreeCAD's own
    numbers of the rows. Raises ToolError(BAD_MESH) for other elements.
    """
    refuse_other_elements(femmesh)
    nodes = femmesh.Nodes
    node_ids = np.array(sorted(nodes))
    points = np.array([tuple(nodes[n]) for n in node_ids.tolist()])
    hex_ids = np.array(femmesh.Volumes)
    listed = [femmesh.getElementNodes(v) for v in femmesh.Volumes]
    size = len(listed[0])
    if size not in (8, 20) or any(len(nodes) != size for nodes in listed):
        raise ToolError("hexahedra of mixed order, or not of 8 or 20 nodes",
                        FaultCode.BAD_MESH)
    hexes = np.empty((len(listed), size), np.int64)
    hexes[:, FREECAD_HEX[:size]] = rows_of(node_ids, listed)
    quads, numbers = _faces_of_groups(femmesh, node_ids)
    return SimpleNamespace(points=points, hexes=hexes, quads=quads, face_of_quad=numbers,
                           order=2 if size == 20 else 1, node_ids=node_ids, hex_ids=hex_ids)
