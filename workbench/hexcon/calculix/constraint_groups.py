# SPDX-License-Identifier: LGPL-2.1-or-later
"""Node groups for FreeCAD's own constraints, where its distance test misses nodes of a hex mesh.

FreeCAD seeks the nodes of a constraint within 1e-7 of its faces, unless the mesh has a node group whose name begins
with the constraint's (constraints of nodes, and before 1.1 pressures). So that users need not know, groups are made
whenever the references of a constraint change in an analysis with a hex mesh. Where FreeCAD takes no group, what it
leaves out is told in its report view.
"""
from hexcon import freecad_compat
from hexcon.femmesh.convert import add_group

from .constraints import nodes_found_by_freecad

ENDING = "_HexCon"      # of the groups made here

_watching = []      # the observer, once there is one


def watch():
    """See to it that constraints get their groups from now on; again and again does no harm."""
    if not _watching:
        _watching.append(_Observer())
        freecad_compat.freecad().addDocumentObserver(_watching[0])


class _Observer:
    """FreeCAD calls it for every change of an object."""

    def slotChangedObject(self, obj, name):
        if name not in ("References", "Group") or _is_busy(obj.Document):
            return
        try:
            if name == "Group" and obj.isDerivedFrom("Fem::FemAnalysis"):
                for mesh_object in _meshes_in(obj):
                    name_all(mesh_object)
            elif name == "References":
                for mesh_object in (one for analysis in analyses_of(obj) for one in _meshes_in(analysis)):
                    name_nodes(mesh_object, [obj])
        except Exception as fault:      # FreeCAD would lose it in a callback, and the user's click is no place to fail
            _warn(f"no node groups for {obj.Label}: {fault}")


def _warn(text):
    freecad_compat.freecad().Console.PrintWarning(f"HexCon: {text}\n")


def _is_busy(document):
    """Whether the change is FreeCAD's own: a file is opened, or a step undone."""
    return any(getattr(document, state, False) for state in ("Restoring", "Transacting"))


def _meshes_in(analysis):
    return [one for one in analysis.Group if one.isDerivedFrom("Fem::FemMeshObject")]


def analyses_of(obj):
    """The FEM analyses that hold an object."""
    return [one for one in obj.InList if one.isDerivedFrom("Fem::FemAnalysis")]


def name_all(mesh_object):
    """Groups for all constraints of the analyses that hold a mesh object."""
    for analysis in analyses_of(mesh_object):
        name_nodes(mesh_object, [one for one in analysis.Group if "References" in one.PropertiesList])


def name_nodes(mesh_object, constraints):
    """Give a mesh object of hexes a node group for each constraint on faces whose nodes FreeCAD would not all find, and
    take those away that are of no use any more; warn where no group helps. Returns the names of the constraints with a
    group.

    Meshes without groups Face1, Face2 ... stay as they are. Cost: FreeCAD's distance test for each referenced face.
    """
    solid, femmesh = freecad_compat.solid_of_mesh_object(mesh_object), mesh_object.FemMesh
    groups = {femmesh.getGroupName(group): group for group in femmesh.Groups}
    if solid is None or not any(name.startswith("Face") for name in groups):
        return []
    wanted = {one: _wanted(femmesh, groups, solid, one) for one in constraints}
    changed = {one: nodes for one, nodes in wanted.items()
               if nodes != _members(femmesh, groups.get(one.Name + ENDING))}
    if changed:
        femmesh, untouched = femmesh.copy(), "Touched" not in mesh_object.State
        for one, nodes in changed.items():
            if one.Name + ENDING in groups:
                femmesh.removeGroup(groups[one.Name + ENDING])
            if nodes:
                add_group(femmesh, one.Name + ENDING, "Node", nodes)
        mesh_object.FemMesh = femmesh
        if untouched:
            mesh_object.purgeTouched()
    return [one.Name for one, nodes in wanted.items() if nodes]


def _members(femmesh, group):
    return None if group is None else sorted(femmesh.getGroupElements(group))


def _wanted(femmesh, groups, solid, constraint):
    """Sorted nodes of the mesh on a constraint's faces; None where FreeCAD finds all of each face by itself, where they
    are not known, where the user has made a group, or where FreeCAD takes none, which is told."""
    useless = freecad_compat.takes_no_node_group(constraint)
    if not useless and any(name.startswith(constraint.Name + "_") and not name.endswith(ENDING) for name in groups):
        return None
    sides, missed = [], 0
    for target, names in constraint.References:
        for name in names:
            if target != solid or not name.startswith("Face") or name not in groups:
                return None
            here = [set(femmesh.getElementNodes(face)) for face in femmesh.getGroupElements(groups[name])]
            found = nodes_found_by_freecad(femmesh, solid, name)
            sides, missed = sides + here, missed + sum(not side <= found for side in here)
    if missed and useless:
        _warn(f"FreeCAD will leave {missed} of {len(sides)} element faces out of {constraint.Label}: it seeks them by "
              "their distance from the CAD face alone, and middle nodes of straight edges, or points off the CAD, are "
              "too far. Mesh again with curved edges (order 2) or at order 1, or solve with HexCon, which loads all")
        return None
    return sorted(set().union(*sides)) if missed else None
