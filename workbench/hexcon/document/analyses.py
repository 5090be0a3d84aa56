# SPDX-License-Identifier: LGPL-2.1-or-later
"""The hex mesh in the FEM workbench: into an analysis, solved, and its displacements shown.

These are calls for macros; hexcon.gui.actions has them too.
"""
import re
import sys

from hexcon import freecad_compat, preferences, window
from hexcon.calculix import constraint_groups, solve
from hexcon.calculix.by_names import names_of, solve_by_names
from hexcon.calculix.material import material_of
from hexcon.errors import FaultCode, ToolError
from hexcon.topological import refuse_topological


def into_analysis(mesh_object, *, allow_topological=False):
    """Put a hex mesh object into the active analysis; without one, make it, with a CalculiX
    solver, steel, and a fixed and a force constraint whose faces the user fills in.

    Returns the analysis. One undo step. Raises ToolError: TOPOLOGICAL_MESH, BAD_MESH where the
    analysis has another mesh already, FREECAD_MISSING.
    """
    refuse_topological(mesh_object, allow_topological)
    document, analysis = mesh_object.Document, _active_analysis(mesh_object.Document)
    if analysis is not None:
        others = [member.Label for member in analysis.Group
                  if member.isDerivedFrom("Fem::FemMeshObject") and member != mesh_object]
        if others:
            raise ToolError(f"{analysis.Label} has a mesh already ({', '.join(others)}), and CalculiX takes "
                            "one: delete it or take it out first", FaultCode.BAD_MESH)
    with freecad_compat.transaction(document, "Into analysis"):
        if analysis is None:
            analysis = _new_analysis(document)
        if mesh_object not in analysis.Group:
            analysis.addObject(mesh_object)
        document.recompute()
        constraint_groups.watch()
        constraint_groups.name_all(mesh_object)
    _activate(analysis)
    return analysis


def _active_analysis(document):
    """The document's active analysis; without a window its only one."""
    if sys.modules.get("FreeCADGui") and freecad_compat.freecad().GuiUp:
        found = freecad_compat.fem_module("FemGui").getActiveAnalysis()
        return found if found is not None and found.Document == document else None
    all_of_them = [obj for obj in document.Objects if obj.isDerivedFrom("Fem::FemAnalysis")]
    return all_of_them[0] if len(all_of_them) == 1 else None


def _activate(analysis):
    if analysis.ViewObject is not None:
        freecad_compat.fem_module("FemGui").setActiveAnalysis(analysis)


def _new_analysis(document):
    objects = freecad_compat.fem_module("ObjectsFem")
    analysis = objects.makeAnalysis(document, "Analysis")
    material = objects.makeMaterialSolid(document, "Material")
    material.Material = material_of(None).card()
    for member in (freecad_compat.make_ccx_solver(document), material,
                   objects.makeConstraintFixed(document, "ConstraintFixed"),
                   objects.makeConstraintForce(document, "ConstraintForce")):
        analysis.addObject(member)
    return analysis


def load_and_solve(mesh_object, held, force, *, allow_topological=False):
    """Hold and load CAD faces of the mesh's solid, or named groups of the mesh, solve in CalculiX, show displacements.

    held   names of the faces that are held, ["Face1", ...], or of groups of faces and nodes
    force  {"Face2": (fx, fy, fz)}: the total force on each face or group, N
    Groups are taken where one of the names is no face of a solid: see calculix.by_names.
    Returns a calculix.Result. One undo step; on failure the document is as it was. Raises
    ToolError: those of hexcon.solve, BAD_SHAPE where the mesh has neither a solid (any more) nor groups.
    """
    solid = freecad_compat.solid_of_mesh_object(mesh_object)
    in_window = window.is_shown(mesh_object)
    options = {"fixed": list(held), "force": dict(force), "threads": preferences.value("Threads") or None,
               "allow_topological": allow_topological, "waiting": window.waiting() if in_window else None}
    by_faces = solid is not None and all(re.fullmatch(r"Face\d+", str(name)) for name in (*held, *force))
    if not by_faces and not names_of(mesh_object):
        raise ToolError(f"{mesh_object.Label} has no solid (any more), whose faces could be held and "
                        "loaded, and no named groups", FaultCode.BAD_SHAPE)
    if by_faces:
        result = solve(mesh_object.Document, mesh_object, solid, **options)
    else:
        result = solve_by_names(mesh_object.Document, mesh_object, **options)
    if in_window:
        show_displacement(result.document_object)
    return result


def show_displacement(result_object):
    """Colour the result's mesh by displacement, blue to red with a legend in mm, and draw it bent; returns the factor.

    The largest displacement is drawn as a tenth of the model's size. What would lie over it is hidden. A matter of the
    view alone; needs FreeCAD's window.
    """
    return window.show_displacement(result_object)
