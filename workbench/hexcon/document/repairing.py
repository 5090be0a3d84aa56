# SPDX-License-Identifier: LGPL-2.1-or-later
"""A FEM mesh object of hexes made good, as another object beside it. For macros; hexcon.gui.actions has it too."""
from hexcon import freecad_compat
from hexcon.femmesh.document import add_to_document
from hexcon.files.femmesh_contents import mesh_of_object
from hexcon.judging.repair import repair_mesh
from hexcon.judging.report import check_mesh


def repair_hex_mesh(mesh_object, *, pillow="auto", merge_tolerance=None):
    """A new mesh object with the repaired hexes, its groups and its solid; the old one stays as it is. One undo step.

    pillow, merge_tolerance: as judging.repair.repair_mesh. The report view tells what was done, and what the mesh was
    worth before and is afterwards. Raises HexconError: BAD_MESH for other elements, and those of repair_mesh.
    """
    found = mesh_of_object(mesh_object)
    before = check_mesh(found)
    done = repair_mesh(found, pillow=pillow, merge_tolerance=merge_tolerance)
    made = add_to_document(mesh_object.Document, done.mesh, freecad_compat.solid_of_mesh_object(mesh_object),
                           "Repaired", found.order, allow_topological=True)
    after = check_mesh(done.mesh)
    tell = freecad_compat.freecad().Console.PrintMessage
    for line in (f"before: {_worth(before)}", *done.notes, f"after: {_worth(after)}"):
        tell(f"HexCon: {mesh_object.Label}: {line}\n")
    return made


def _worth(report):
    proof = "certified" if report.certified else f"not certified, {len(report.nonpositive)} hexes not proved positive"
    return f"{report.counts.hexes} hexes, {proof}, scaled Jacobian at least {report.quality.min:.3f}"
