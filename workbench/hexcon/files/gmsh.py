# SPDX-License-Identifier: LGPL-2.1-or-later
""".msh through meshio: Gmsh's format 2.2, binary, which every Gmsh and every reader takes."""
import numpy as np

from .through_meshio import import_meshio


def write(path, elements):
    """Physical volume "Solid" (1), physical surfaces "Face3" (3) one per CAD face.

    Quads without a CAD face form the physical surface "Boundary". Node i+1 is point i;
    the boundary quads come first, then the hexahedra.
    """
    meshio = import_meshio(path)
    faces, solid = elements.group_of_quad().astype(np.int32), np.ones(len(elements.hexes), np.int32)
    names = {name: np.array([number, 2]) for number, name, _ in elements.groups()}
    kinds = ("quad8", "hexahedron20") if elements.order == 2 else ("quad", "hexahedron")
    mesh = meshio.Mesh(
        elements.points, [(kinds[0], elements.quads), (kinds[1], elements.hexes)],
        cell_data={"gmsh:physical": [faces, solid], "gmsh:geometrical": [faces, solid]},
        field_data={**names, "Solid": np.array([1, 3])})
    meshio.write(path, mesh, file_format="gmsh22", binary=True)
