# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results of an analysis once its hex mesh is another: kept, and marked as old.

FreeCAD's solvers throw results away when they run again, not when the mesh changes. So those that
stand beside a new mesh say in their labels that they are not its own, and which mesh they had: where
that comes back, so does the label.
"""
from hexcon import freecad_compat

PROPERTY = "OfHexMesh"  # fingerprint of the hex mesh that was solved, where it is not the present one
MEANING = "Fingerprint of the hex mesh that these results belong to, as that has changed since"
SUFFIX = " (of an older mesh)"  # of the label
KINDS = ("Fem::FemResultObject", "Fem::FemPostPipeline")


def mark(mesh_object, before, now):
    """Mark the results beside a hex mesh object whose fingerprint was `before` and is `now`."""
    newly_old = []
    for result in _results_beside(mesh_object):
        if PROPERTY not in result.PropertiesList:
            result.addProperty("App::PropertyString", PROPERTY, "HexCon", MEANING)
            result.setEditorMode(PROPERTY, 2)
        known = getattr(result, PROPERTY)
        own = known or before  # what has no mark yet was made from the mesh that was there until now
        setattr(result, PROPERTY, "" if own == now else own)
        if own != now and not known:
            newly_old.append(result.Label)
        _label(result, own != now)
    if newly_old:
        freecad_compat.freecad().Console.PrintWarning(
            f"HexCon: {mesh_object.Label} was meshed anew: {', '.join(newly_old)} belongs to the mesh as it was. "
            "Run the solver again.\n")


def _results_beside(mesh_object):
    """Result objects of the analyses that hold the mesh."""
    return [member for analysis in mesh_object.InList if analysis.isDerivedFrom("Fem::FemAnalysis")
            for member in analysis.Group if any(map(member.isDerivedFrom, KINDS))]


def _label(result, old):
    for thing in (result, getattr(result, "Mesh", None)):  # the mesh of the results is what is looked at
        if thing is not None:
            plain = thing.Label.replace(SUFFIX, "")
            thing.Label = plain + SUFFIX if old else plain
            thing.purgeTouched()
