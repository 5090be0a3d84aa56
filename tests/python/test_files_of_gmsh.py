# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that gmsh itself writes of the box 10 x 20 x 30 (8 hexes, 24 quads, volume 6000): versions, orders, groups,
partitions, and the formats of others."""
import gmsh
import numpy as np
import pytest
from quad_figures import volume_of

import hexcon_native as hn
from hexcon.files import read_mesh
from hexcon.quads import surface_from_file


def _box():
    box = gmsh.model.occ.addBox(0, 0, 0, 10, 20, 30)
    gmsh.model.occ.synchronize()
    for _, curve in gmsh.model.getEntities(1):
        gmsh.model.mesh.setTransfiniteCurve(curve, 3)
    for _, face in gmsh.model.getEntities(2):
        gmsh.model.mesh.setTransfiniteSurface(face)
        gmsh.model.mesh.setRecombine(2, face)
    gmsh.model.mesh.setTransfiniteVolume(box)
    gmsh.model.mesh.generate(3)


def _write(path, options, order=1, groups=False, parts=0):
    gmsh.initialize(readConfigFiles=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        _box()
        for name, value in options.items():
            gmsh.option.setNumber(f"Mesh.{name}", value)
        if groups:
            for tag, (faces, name) in enumerate((([1, 2], "ends"), ([2, 3], "in two")), 7):
                gmsh.model.addPhysicalGroup(2, faces, tag)
                gmsh.model.setPhysicalName(2, tag, name)
        if order == 2:
            gmsh.model.mesh.setOrder(2)
        if parts:
            gmsh.model.mesh.partition(parts)
        gmsh.write(str(path))
    finally:
        gmsh.finalize()


_GROUPED = {"groups": True, "options": {"SaveAll": 1}}
# name: (ending, what _write is told)
FILES = {
    "version 1": ("msh", {"options": {"MshFileVersion": 1.0}}),
    "version 2.2, binary": ("msh", {"options": {"MshFileVersion": 2.2, "Binary": 1}}),
    "version 4.0": ("msh", {"options": {"MshFileVersion": 4.0}}),
    "version 4.1, binary": ("msh", {"options": {"Binary": 1}}),
    "parametric": ("msh", {"options": {"SaveParametric": 1}}),
    "partitions": ("msh", {"options": {}, "parts": 3}),
    "partitions, binary 2.2": ("msh", {"options": {"MshFileVersion": 2.2, "Binary": 1}, "parts": 2}),
    "groups, all saved": ("msh", _GROUPED),
    "groups in a deck": ("inp", {**_GROUPED, "options": {"SaveAll": 1, "SaveGroupsOfNodes": 1}}),
    "20 nodes, 4.1": ("msh", {"options": {"SecondOrderIncomplete": 1}, "order": 2}),
    "27 nodes, 4.1": ("msh", {"options": {}, "order": 2}),
    **{f"27 nodes .{ending}": (ending, {"options": {}, "order": 2}) for ending in ("inp", "unv", "mesh", "vtk")},
    **{f"{nodes} nodes .bdf, form {form}": ("bdf", {"options": {"BdfFieldFormat": form,
                                                                "SecondOrderIncomplete": nodes == 20}, "order": 2})
       for nodes in (20, 27) for form in (0, 1, 2)}}


@pytest.mark.parametrize("name", FILES)
def test_what_gmsh_writes(tmp_path, name):
    ending, told = FILES[name]
    path = tmp_path / f"m.{ending}"
    _write(path, **told)
    mesh, surface = read_mesh(path), surface_from_file(path)
    assert len(mesh.hexes) == 8 and len(surface.quads) == 24 and mesh.order == told.get("order", 1)
    assert np.isclose(volume_of(mesh.points, mesh.quads), 6000)
    assert np.isclose(volume_of(surface.points, surface.quads), 6000)
    assert hn.certify(mesh.points, mesh.hexes, mesh.quads).certified
    if told.get("groups"):
        for found in (mesh, surface):
            named = {key.replace("_", " "): len(rows) for key, rows in found.quad_groups.items()}
            assert (named["ends"], named["in two"]) == (8, 8)
