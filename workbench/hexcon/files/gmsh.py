# SPDX-License-Identifier: LGPL-2.1-or-later
""".msh through meshio: Gmsh's format 2.2, binary, which every Gmsh and every reader takes."""
import numpy as np

from .through_meshio import import_meshio


def write(path, elements):
    """Physical volume "Solid" (1), physical surfaces "Face3" (3) one per CAD face and by the names of groups, physical
    points by the names of groups of nodes.

    Quads in none form the physical surface "Boundary"; those in several are there once for each, as Gmsh writes them.
    Node i+1 is point i; the boundary quads come first, then the hexahedra.
    """
    meshio = import_meshio(path)
    groups = elements.all_groups()
    rows = np.concatenate([rows for _, _, rows in groups])
    faces = np.concatenate([np.full(len(rows), number) for number, _, rows in groups])
    order = np.argsort(rows, kind="stable")
    names = {name: np.array([number, 2]) for number, name, _ in groups}
    kinds = ("quad8", "hexahedron20") if elements.order == 2 else ("quad", "hexahedron")
    cells = [(kinds[0], elements.quads[rows[order]], faces[order]),
             (kinds[1], elements.hexes, np.ones(len(elements.hexes)))]
    for number, name in enumerate(elements.node_groups, 1):
        nodes = elements.nodes_of_set(name)
        cells.append(("vertex", nodes[:, None], np.full(len(nodes), number)))
        names.setdefault(name, np.array([number, 0]))
    tags = [np.asarray(tag, np.int32) for _, _, tag in cells]
    mesh = meshio.Mesh(elements.points, [(kind, nodes) for kind, nodes, _ in cells],
                       cell_data={"gmsh:physical": tags, "gmsh:geometrical": tags},
                       field_data={**names, "Solid": np.array([1, 3])})
    meshio.write(path, mesh, file_format="gmsh22", binary=True)
