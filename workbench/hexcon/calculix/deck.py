# SPDX-License-Identifier: LGPL-2.1-or-later
"""A full linear static deck without FreeCAD."""
import io

import numpy as np

from hexcon.curving.raising import raised
from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh.elements import elements_of
from hexcon.files.abaqus import write_mesh
from hexcon.files.text import write_list, write_rows
from hexcon.topological import refuse_topological

from .judging import check_loads
from .loads import face_force, force_vector, pressure_value
from .material import material_of


def face_number(name):
    """3 of "Face3", "FACE3" or 3. Raises ToolError(BAD_OPTION)."""
    digits = str(name).strip()
    digits = digits[4:] if digits.lower().startswith("face") else digits
    if not digits.isdigit() or int(digits) < 1:
        raise ToolError(f"{name!r} names no CAD face; write Face1, Face2, ...",
                        FaultCode.BAD_OPTION)
    return int(digits)


def static_deck(mesh, material=None, fixed=("Face1",), force=None, pressure=None, *,
                order=None, element=None, prescribed=None, integration_points=False,
                allow_topological=False):
    """Text of a deck that ccx runs as it is.

    mesh        see elements_of; order 1 (C3D8), 2 (C3D20R; a mesh of order 1 is curved on the solid it was made of, or
                a comment says why not: see curving.raising), None: the mesh's own
    element     C3D8, C3D8R, C3D20 or C3D20R; None: see femmesh.element_types.default_type
    material    see material.material_of
    fixed       names of CAD faces, or of groups of the mesh, held in x, y, z; so are the names of loads
    force       {"Face2": (fx, fy, fz)} total force in N, as consistent nodal loads
    pressure    {"Face3": p} in MPa, positive onto the face (*DLOAD)
    prescribed  (nodes (k,) 0-based, displacements (k,3) mm) at the given order, optional
    integration_points  print the stresses there to the .dat file
    allow_topological   take a mesh of topology only as well: its results mean nothing
    Raises ToolError: BAD_OPTION (no such face, nothing held, no load but zero), BAD_MESH, TOPOLOGICAL_MESH.
    """
    refuse_topological(mesh, allow_topological)
    mesh, straight = raised(mesh, order)
    elements = elements_of(mesh, order)
    material = material_of(material)
    if not fixed and prescribed is None:
        raise ToolError("nothing is held: name at least one fixed face, or CalculiX finds "
                        "a singular system", FaultCode.BAD_OPTION)
    check_loads(force, pressure, prescribed)
    out = io.StringIO()
    out.write("** HexCon: linear static analysis; N, mm, MPa\n" + (f"** {straight}\n" if straight else ""))
    write_mesh(out, elements, element)
    out.write(f"*MATERIAL, NAME=SOLID\n*ELASTIC\n{material.young!r}, {material.poisson!r}\n"
              f"*DENSITY\n{material.density!r}\n"
              "*SOLID SECTION, ELSET=EALL, MATERIAL=SOLID\n")
    if fixed:
        nodes = np.unique(np.concatenate(
            [elements.nodes_of(f) for f in fixed]))
        out.write("*NSET, NSET=FIXED\n")
        write_list(out, nodes + 1)
        out.write("*BOUNDARY\nFIXED, 1, 3, 0.0\n")
    out.write("*STEP\n*STATIC\n")
    if prescribed is not None:
        _write_prescribed(out, *prescribed)
    write_forces(out, elements, force)
    write_pressures(out, elements, pressure)
    out.write("*NODE FILE\nU\n*EL FILE\nS\n")
    if integration_points:
        out.write("*EL PRINT, ELSET=EALL\nS\n")
    out.write("*END STEP\n")
    return out.getvalue()


def _write_prescribed(out, nodes, displacements):
    nodes, values = np.asarray(nodes), np.asarray(displacements, float)
    out.write("*BOUNDARY\n")
    for dof in range(3):
        write_rows(out, f"%d, {dof + 1}, {dof + 1}, %.12e\n", np.column_stack(
            [nodes.astype(float) + 1, values[:, dof]]))


def write_forces(out, elements, force, node_ids=None):
    """*CLOAD of each {face: (fx, fy, fz)}; loads on shared nodes add up in ccx.

    node_ids (P,): the deck's number of each node; rows + 1 if None."""
    for name, vector in (force or {}).items():
        vector = force_vector(name, vector)
        nodes, loads = face_force(elements, name, vector)
        numbers = nodes + 1.0 if node_ids is None else node_ids[nodes].astype(float)
        out.write(f"** force on {name}\n*CLOAD\n")
        for dof in np.flatnonzero(vector):
            write_rows(out, f"%d, {dof + 1}, %.12e\n",
                       np.column_stack([numbers, loads[:, dof]]))


def write_pressures(out, elements, pressure, hex_ids=None, sides=None):
    """*DLOAD of each {face: MPa}; hex_ids (H,): as node_ids above; sides (6,): the deck's
    label of each row of hexahedron.FACES, 1..6 if None."""
    sides = np.arange(1, 7) if sides is None else sides
    for name, value in (pressure or {}).items():
        value = pressure_value(name, value)
        rows = elements.quads_of(name)
        if not len(rows):
            raise ToolError(f"pressure on {name}: it has no quads, and nodes alone take no pressure",
                            FaultCode.BAD_OPTION)
        hexes = elements.hex_of_quad[rows]
        numbers = hexes + 1 if hex_ids is None else hex_ids[hexes]
        out.write(f"** pressure on {name}\n*DLOAD\n")
        write_rows(out, f"%d, P%d, {value!r}\n",
                   np.column_stack([numbers, sides[elements.side_of_quad[rows]]]))
