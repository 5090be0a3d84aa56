# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fill a discrete surface by one of gmsh's algorithms."""
import gmsh
import numpy as np

from .shells import shells_of

TETRAHEDRON, TRIANGLE = 4, 2    # gmsh's numbers of the element types


def fill(points, triangles, size, algorithm, threshold):
    """(points (Q,3), tetrahedra (M,4)) as gmsh leaves them: the given points, then its own.

    size       callable for setSizeCallback
    algorithm  Mesh.Algorithm3D
    threshold  Mesh.OptimizeThreshold: tetrahedra worse than this are worked on
    Raises Exception with gmsh's message where gmsh gives up.
    """
    gmsh.clear()
    for name, value in (("Algorithm3D", algorithm), ("Optimize", 1), ("OptimizeThreshold", threshold),
                        ("MeshSizeExtendFromBoundary", 0)):
        gmsh.option.setNumber("Mesh." + name, value)
    shells = shells_of(points, triangles)
    given = np.concatenate([np.unique(triangles[shell]) for shell in shells])    # gmsh numbers points surface by surface
    _surfaces(points[given], np.argsort(given)[triangles], shells)
    gmsh.model.mesh.setSizeCallback(size)
    gmsh.model.mesh.generate(3)
    return _mesh(given)


def _surfaces(points, triangles, shells):
    """A volume whose boundary is the given triangles: each shell a surface of its own. Points have the tags 1, 2, 3, ..."""
    model = gmsh.model
    model.add("inside")
    for tag, shell in enumerate(shells, 1):
        used = np.unique(triangles[shell])
        model.addDiscreteEntity(2, tag)
        model.mesh.addNodes(2, tag, used + 1, points[used].ravel())
        model.mesh.addElementsByType(tag, TRIANGLE, shell + 1, triangles[shell].ravel() + 1)
    model.geo.addVolume([model.geo.addSurfaceLoop([tag]) for tag in range(1, len(shells) + 1)])
    model.geo.synchronize()


def _mesh(given):
    tags, points, _ = gmsh.model.mesh.getNodes()
    _, corners = gmsh.model.mesh.getElementsByType(TETRAHEDRON)
    order = np.argsort(tags)
    tetrahedra = np.searchsorted(tags, corners, sorter=order).reshape(-1, 4)
    rows = np.concatenate([given, np.arange(len(given), len(tags))])
    places = np.empty((len(tags), 3))
    places[rows] = points.reshape(-1, 3)[order]
    return places, rows[tetrahedra]
