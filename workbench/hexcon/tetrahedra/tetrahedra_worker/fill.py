# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fill a discrete surface by one of gmsh's algorithms."""
import numpy as np

import gmsh

TETRAHEDRON, TRIANGLE = 4, 2    # gmsh's numbers of the element types


def fill(points, triangles, size, algorithm, threshold):
    """(points (Q,3), tetrahedra (M,4)) as gmsh leaves them: points in the order of its tags.

    size       callable for setSizeCallback
    algorithm  Mesh.Algorithm3D
    threshold  Mesh.OptimizeThreshold: tetrahedra worse than this are worked on
    Raises Exception with gmsh's message where gmsh gives up.
    """
    gmsh.clear()
    for name, value in (("Algorithm3D", algorithm), ("Optimize", 1), ("OptimizeThreshold", threshold),
                        ("MeshSizeExtendFromBoundary", 0)):
        gmsh.option.setNumber("Mesh." + name, value)
    _surface(points, triangles)
    gmsh.model.mesh.setSizeCallback(size)
    gmsh.model.mesh.generate(3)
    return _mesh()


def _surface(points, triangles):
    """A volume whose boundary is the given triangles; they carry the tags 1, 2, 3, ..."""
    model = gmsh.model
    model.add("inside")
    model.addDiscreteEntity(2, 1)
    model.mesh.addNodes(2, 1, np.arange(1, len(points) + 1), points.ravel())
    model.mesh.addElementsByType(1, TRIANGLE, np.arange(1, len(triangles) + 1), triangles.ravel() + 1)
    model.geo.addVolume([model.geo.addSurfaceLoop([1])])
    model.geo.synchronize()


def _mesh():
    tags, points, _ = gmsh.model.mesh.getNodes()
    _, corners = gmsh.model.mesh.getElementsByType(TETRAHEDRON)
    order = np.argsort(tags)
    tetrahedra = np.searchsorted(tags, corners, sorter=order).reshape(-1, 4)
    return points.reshape(-1, 3)[order], tetrahedra
