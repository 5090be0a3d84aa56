# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a FreeCAD FemMesh holds, with its groups."""
import numpy as np

from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh.convert import FREECAD_HEX, refuse_other_elements
from hexcon.labels import Labels
from hexcon.topological import is_topological

from .contents import NODES, Contents, Group
from .hex_contents import hexes_of, mesh_of

_FACES = {3: "triangle", 6: "triangle6", 4: "quad", 8: "quad8", 9: "quad9"}
_VOLUMES = {4: "tetra", 10: "tetra10", 5: "pyramid", 13: "pyramid13", 6: "wedge", 15: "wedge15", 8: "hexahedron",
            20: "hexahedron20", 27: "hexahedron27"}


def contents_of_femmesh(femmesh):
    """Contents of a Fem.FemMesh. About 2 us per node and element in FreeCAD's Python interface.

    Raises ToolError BAD_MESH for elements of no known kind."""
    nodes = femmesh.Nodes
    ids = sorted(nodes)
    points, labels = np.array([tuple(nodes[n]) for n in ids], float).reshape(-1, 3), Labels(ids)
    listed, places = {}, {}
    for elements, kinds in ((femmesh.Faces, _FACES), (femmesh.Volumes, _VOLUMES)):
        for element in elements:
            row = femmesh.getElementNodes(element)
            kind = kinds.get(len(row))
            if kind is None:
                raise ToolError(f"element {element} has {len(row)} nodes, which is of no known kind",
                                FaultCode.BAD_MESH)
            places[element] = (kind, len(listed.setdefault(kind, [])))
            listed[kind].append(row)
    cells = {kind: _vtk_order(kind, labels.rows_of(rows)) for kind, rows in listed.items()}
    return Contents(points, cells, list(_groups(femmesh, labels, places)))


def mesh_of_object(mesh_object):
    """The hexes of a document's FEM mesh object with their groups, as hex_contents.mesh_of, and the mark of topology
    only. Raises ToolError BAD_MESH for other elements."""
    refuse_other_elements(mesh_object.FemMesh)
    found = contents_of_femmesh(mesh_object.FemMesh)
    mesh = mesh_of(found.points, hexes_of(mesh_object.Label, found), found)
    mesh.topological = is_topological(mesh_object)
    return mesh


def _vtk_order(kind, rows):
    if kind not in ("hexahedron", "hexahedron20"):
        return rows
    turned = np.empty_like(rows)
    turned[:, FREECAD_HEX[:rows.shape[1]]] = rows
    return turned


def _groups(femmesh, labels, places):
    for number in femmesh.Groups:
        name, members = femmesh.getGroupName(number), femmesh.getGroupElements(number)
        if femmesh.getGroupElementType(number) == "Node":
            yield Group(name, NODES, labels.rows_of(members))
            continue
        by_kind = {}
        for element in members:
            if element in places:
                by_kind.setdefault(places[element][0], []).append(places[element][1])
        for kind, rows in by_kind.items():
            yield Group(name, kind, np.array(rows, np.int64))
