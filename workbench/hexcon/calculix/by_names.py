# SPDX-License-Identifier: LGPL-2.1-or-later
"""A linear static analysis of a mesh object held and loaded by the names of its groups.

FreeCAD's constraints name faces of a solid; a mesh that was read from a file has groups, and no solid. So the deck is
HexCon's own, and FreeCAD reads the results.
"""
import os
import re

import numpy as np

from hexcon import disk, freecad_compat
from hexcon.femmesh.element_types import chosen_type
from hexcon.files.femmesh_contents import mesh_of_object
from hexcon.topological import refuse_topological

from . import frd
from .deck import static_deck
from .document_run import in_order_of, kept_for_a_reason, result_object_of, run_deck, staying_in_its_group
from .material import material_of
from .result import Result
from .runner import find_ccx


def names_of(mesh_object):
    """Names that can be held and loaded: CAD faces by their numbers, groups of faces, of nodes. Reads no elements."""
    femmesh, found = mesh_object.FemMesh, {"Face": [], "Node": []}
    for group in femmesh.Groups:
        kind = femmesh.getGroupElementType(group)
        if kind in found and len(femmesh.getGroupElements(group)):
            found[kind].append(femmesh.getGroupName(group))
    cad = sorted((name for name in found["Face"] if re.fullmatch(r"Face\d+", name)), key=lambda name: int(name[4:]))
    return cad + [name for name in found["Face"] if name not in cad] + found["Node"]


def solve_by_names(doc, mesh_object, *, fixed, force=None, pressure=None, material=None, timeout=3600, threads=None,
                   allow_topological=False, waiting=None):
    """As analysis.solve, fixed and the keys of the loads being names of groups; an analysis with material, mesh and
    results, without constraint objects. One undo step; on any failure the document is as it was.

    The elements are of the mesh object's ElementType. Raises ToolError: TOOL_MISSING, TOOL_FAILED with ccx's words,
    TOOL_TIMEOUT, FILE_IO, BAD_OPTION, BAD_MESH, TOPOLOGICAL_MESH.
    """
    refuse_topological(mesh_object, allow_topological)
    mesh, material = mesh_of_object(mesh_object), material_of(material)
    text = static_deck(mesh, material, fixed, force, pressure, element=chosen_type(mesh_object),
                       allow_topological=allow_topological)
    program, folder = find_ccx(freecad_compat.ccx_preference()), disk.new_folder("hexcon-fem-")
    path = os.path.join(folder, "deck.inp")
    numbers, before = np.arange(len(mesh.points)) + 1, {o.Name for o in doc.Objects}
    with (kept_for_a_reason(folder), freecad_compat.transaction(doc, "Solve hex mesh"),
          staying_in_its_group(mesh_object)):
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(text)
        found, log = run_deck(path, mesh, np.arange(len(mesh.hexes)) + 1, numbers, waiting, ccx=program,
                              timeout=timeout, threads=threads)
        shown = _results_in(doc, mesh_object, material, os.path.splitext(path)[0] + ".frd")
        added = [o for o in doc.Objects if o.Name not in before]
    displacements, stress = in_order_of(numbers, found)
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
    shown = result_object_of(analysis)
    doc.recompute()
    return shown
