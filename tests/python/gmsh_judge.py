# SPDX-License-Identifier: LGPL-2.1-or-later
"""gmsh's own analysis of hexes of 20 nodes (Johnen, Remacle, Geuzaine 2013), in a process: python gmsh_judge.py IN OUT.

IN: .npy of nodes (n,20,3) in VTK's order; OUT: .npy (n,) of the least over the greatest Jacobian of each, as gmsh
bounds them.
"""
import sys

import gmsh
import numpy as np

# Ends of gmsh's edges, whose middle nodes are 8 .. 19 of its hex20, in its order; and of VTK's.
GMSH_EDGES = ((0, 1), (0, 3), (0, 4), (1, 2), (1, 5), (2, 3), (2, 6), (3, 7), (4, 5), (4, 7), (5, 6), (6, 7))
VTK_EDGES = ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))
TO_GMSH = [*range(8), *(8 + [frozenset(e) for e in VTK_EDGES].index(frozenset(edge)) for edge in GMSH_EDGES)]
HEX20 = 17

if __name__ == "__main__":
    nodes = np.load(sys.argv[1])
    gmsh.initialize([], False)
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.model.addDiscreteEntity(3, 1)
    tags = np.arange(1, 20 * len(nodes) + 1)
    gmsh.model.mesh.addNodes(3, 1, tags, nodes[:, TO_GMSH].ravel())
    gmsh.model.mesh.addElementsByType(1, HEX20, np.arange(1, len(nodes) + 1), tags)
    for name, value in (("JacobianDeterminant", 1), ("IGEMeasure", 0), ("ICNMeasure", 0), ("CreateView", 1),
                        ("DimensionOfElements", 3), ("Recompute", 1)):
        gmsh.plugin.setNumber("AnalyseMeshQuality", name, value)
    gmsh.plugin.run("AnalyseMeshQuality")
    _, elements, data, _, _ = gmsh.view.getModelData(gmsh.view.getTags()[0], 0)
    least = np.full(len(nodes), np.nan)
    least[np.array(elements, int) - 1] = np.ravel(data)
    np.save(sys.argv[2], least)
    gmsh.finalize()
