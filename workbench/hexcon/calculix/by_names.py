# SPDX-License-Identifier: LGPL-2.1-or-later
"""A linear static analysis of a mesh object held and loaded by the names of its groups.

FreeCAD's constraints name faces of a solid; a mesh that was read from a file has groups, and no solid. So the deck is
HexCon's own, and FreeCAD reads the results.
"""
import os

import numpy as np

from hexcon import disk, freecad_compat, keeper
from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh.elements import elements_of
from hexcon.files.femmesh_contents import contents_of_femmesh
from hexcon.files.hex_contents import hexes_of, mesh_of
from hexcon.topological import refuse_topological

from . import frd
from .deck import static_deck
from .material import material_of
from .result import Result
from .runner import find_ccx, run_ccx


def mesh_with_names(mesh_object):
    """The mesh of a document object, with its groups, as files.read_mesh has one. Raises ToolError FILE_FORMAT."""
    found = contents_of_femmesh(mesh_object.FemMesh)
    return mesh_of(found.points, hexes_of(mesh_object.Label, found), found)


def names_of(mesh_object):
    """Names that can be held and loaded: CAD faces, groups of faces, groups of nodes."""
    mesh = mesh_with_names(mesh_object)
    return [name for _, name, _ in elements_of(mesh).named()] + list(mesh.node_groups)


def solve_by_names(doc, mesh_object, *, fixed, force=None, pressure=None, material=None, timeout=3600, threads=None,
                   allow_topological=False, waiting=None):
    """As analysis.solve, fixed and the keys of the loads being names of groups; an analysis with material, mesh and
    results, without constraint objects. One undo step; on any failure the document is as it was.

    Raises ToolError: TOOL_MISSING, TOOL_FAILED with ccx's words, TOOL_TIMEOUT, FILE_IO, BAD_OPTION, TOPOLOGICAL_MESH.
    """
    refuse_topological(mesh_object, allow_topological)
    mesh, material = mesh_with_names(mesh_object), material_of(material)
    text = static_deck(mesh, material, fixed, force, pressure, allow_topological=allow_topological)
    program, folder = find_ccx(freecad_compat.ccx_preference()), disk.new_folder("hexcon-fem-")
    path = os.path.join(folder, "deck.inp")
    with disk.naming(folder, f"work in {folder}"), open(path, "w", encoding="utf-8") as stream:
        stream.write(text)
    keeper.let_folder_go(folder)

    def job(progress):
        return run_ccx(path, timeout=timeout, threads=threads, ccx=program, progress=progress,
                       nodes=np.unique(mesh.hexes) + 1)
    found, log = waiting(job, "CalculiX") if waiting else job(None)
    before = {o.Name for o in doc.Objects}
    with freecad_compat.transaction(doc, "Solve hex mesh"):
        shown = _results_in(doc, mesh_object, material, os.path.splitext(path)[0] + ".frd")
        added = [o for o in doc.Objects if o.Name not in before]
    displacements, stress = np.zeros((len(mesh.points), 3)), np.zeros((len(mesh.points), 6))
    displacements[found["node_ids"] - 1], stress[found["node_ids"] - 1] = found["displacements"], found["stress"]
    report = {"notes": ["held and loaded by groups of the mesh: the analysis has no constraint objects"],
              "force_sum": np.sum([np.zeros(3), *(force or {}).values()], axis=0).tolist()}
    return Result(shown, added, displacements, stress, frd.von_mises(stress), path, os.path.splitext(path)[0] + ".frd",
                  log, report)


def _results_in(doc, mesh_object, material, path):
    """Analysis, material and FreeCAD's result object of a .frd file."""
    objects = freecad_compat.fem_module("ObjectsFem")
    analysis = objects.makeAnalysis(doc, "Analysis")
    card = objects.makeMaterialSolid(doc, "Material")
    card.Material = material.card()
    for member in (card, mesh_object):
        analysis.addObject(member)
    freecad_compat.fem_module("feminout.importCcxFrdResults").importFrd(path, analysis)
    results = [o for o in analysis.Group if o.isDerivedFrom("Fem::FemResultObject")]
    if not results or not results[-1].DisplacementVectors:
        raise ToolError("FreeCAD read no displacements from CalculiX's results", FaultCode.TOOL_FAILED)
    doc.recompute()
    return results[-1]
