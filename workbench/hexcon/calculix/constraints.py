# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's FEM constraint objects on CAD faces, and what the mesh must know of them."""
import numpy as np

from hexcon import freecad_compat
from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh.convert import add_group

from .deck import face_number


def face_name(solid, name):
    """"Face3" of any spelling; ToolError(BAD_OPTION) where the solid has no such face."""
    number = face_number(name)
    count = len(solid.Shape.Faces)
    if number > count:
        raise ToolError(f"{solid.Label} has Face1 to Face{count}, and no Face{number}",
                        FaultCode.BAD_OPTION)
    return f"Face{number}"


def make_fixed(doc, solid, names):
    constraint = freecad_compat.fem_module("ObjectsFem").makeConstraintFixed(
        doc, "ConstraintFixed")
    constraint.References = [(solid, name) for name in names]
    return constraint


def make_pressure(doc, solid, name, value):
    """value in MPa, positive onto the face."""
    constraint = freecad_compat.fem_module("ObjectsFem").makeConstraintPressure(
        doc, "ConstraintPressure")
    constraint.References = [(solid, name)]
    freecad_compat.set_quantity(constraint, "Pressure", float(abs(value)), "MPa")
    constraint.Reversed = bool(value < 0)
    return constraint


def make_force(doc, solid, name, vector):
    """A ConstraintForce of vector (3,) in N, and the helper line it needed or None.

    FreeCAD takes the direction from an edge or a plane face; a DirectionVector that is
    set by hand is overwritten at the next change. Where the solid has nothing parallel a
    hidden line is added.
    """
    vector = np.asarray(vector, float)
    size = float(np.linalg.norm(vector))
    constraint = freecad_compat.fem_module("ObjectsFem").makeConstraintForce(
        doc, "ConstraintForce")
    constraint.References = [(solid, name)]
    freecad_compat.set_quantity(constraint, "Force", size, "N")
    reference, line = _direction_reference(doc, solid, vector / size)
    constraint.Direction = reference
    doc.recompute([constraint])
    if np.dot(constraint.DirectionVector, vector) < 0:
        constraint.Reversed = not constraint.Reversed
        doc.recompute([constraint])
    got = np.array(constraint.DirectionVector)
    if np.linalg.norm(got - vector / size) > 1e-7:
        raise ToolError(f"force on {name}: FreeCAD turned its direction into {got}",
                        FaultCode.TOOL_FAILED)
    return constraint, line


def _direction_reference(doc, solid, direction):
    """((object, [sub-element]), new line object or None), parallel to the unit vector."""
    for number, edge in enumerate(solid.Shape.Edges, 1):
        if not edge.Degenerated and edge.Curve.TypeId == "Part::GeomLine":     # a pole has no curve
            if _parallel(edge.tangentAt(edge.FirstParameter), direction):
                return (solid, [f"Edge{number}"]), None
    for number, face in enumerate(solid.Shape.Faces, 1):
        if face.Surface.TypeId == "Part::GeomPlane":
            if _parallel(face.Surface.Axis, direction):
                return (solid, [f"Face{number}"]), None
    part = freecad_compat.freecad_module("Part")
    start = solid.Shape.BoundBox.Center
    length = solid.Shape.BoundBox.DiagonalLength
    line = doc.addObject("Part::Feature", "ForceDirection")
    end = np.array(start) + length * direction
    line.Shape = part.makeLine(tuple(start), tuple(end))
    line.Visibility = False
    return (line, ["Edge1"]), line


def _parallel(a, b):
    return np.linalg.norm(np.cross(np.array(a), b)) < 1e-9


def nodes_found_by_freecad(femmesh, solid, name):
    """Set of FreeCAD node numbers that lie on the CAD face, as every constraint seeks them."""
    return set(femmesh.getNodesByFace(freecad_compat.fem_shape_of(solid).getElement(name)))


def ensure_nodes(mesh_object, mesh, elements, solid, constraints):
    """Give the FemMesh a node group where FreeCAD would not find a constraint's nodes.

    constraints  list of (constraint object, [face names])
    FreeCAD seeks nodes within 1e-7 of the CAD face. The middle nodes of straight edges
    (order 2) on a curved face lie off it; then FreeCAD takes a node group whose name
    begins with "<constraint name>_", but for pressures in 1.1. Returns notes for the report.
    """
    notes, femmesh = [], None
    for constraint, names in constraints:
        if freecad_compat.takes_no_node_group(constraint):
            continue
        right, found = set(), set()
        for name in names:
            rows = elements.nodes_of_face(face_number(name))
            right.update(mesh.node_ids[rows].tolist())
            found |= nodes_found_by_freecad(mesh_object.FemMesh, solid, name)
        if found != right:
            femmesh = femmesh or mesh_object.FemMesh.copy()
            add_group(femmesh, f"{constraint.Name}_Nodes", "Node", sorted(right))
            notes.append(f"{constraint.Name}: {len(right)} nodes given as a mesh group "
                         f"(FreeCAD finds {len(found & right)} of them on the CAD face, and "
                         f"{len(found - right)} others)")
    if femmesh is not None:
        mesh_object.FemMesh = femmesh
    return notes
