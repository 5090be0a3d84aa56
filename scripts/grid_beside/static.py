# SPDX-License-Identifier: LGPL-2.1-or-later
"""One static problem on any mesh: compliance, and stresses at given places.

Compliance, loads times displacements, is twice the energy of deformation; with a force spread evenly over a face it is
the force times that face's mean displacement along it. So one figure is the error of both.
"""
import io

import numpy as np

from hexcon import calculix
from hexcon.calculix.loads import node_areas

YOUNG, POISSON = 210000.0, 0.3
VTK_CELL = {8: 12, 20: 25, 10: 24}     # of elements of so many nodes
TRIANGLE_RULE = ((1 / 6, 1 / 6), (2 / 3, 1 / 6), (1 / 6, 2 / 3))    # places; each weighs 1/6


class Model:
    """points (P,3), elements (n,8|20|10: VTK's order is CalculiX's), kind: CalculiX's name of the element,
    held, loaded (m,4|6|8): facets of two faces, 0-based."""

    def __init__(self, points, elements, kind, held, loaded):
        used, place = np.unique(elements, return_inverse=True)
        new = np.full(len(points), -1)
        new[used] = np.arange(len(used))
        self.points, self.elements, self.kind = points[used], place.reshape(elements.shape), kind
        self.held, self.loaded = new[held], new[loaded]

    def solved(self, force):
        """(compliance, stress (P,6) at the nodes), of a force (3,) spread evenly over the loaded face."""
        areas = _areas(self.points, self.loaded)
        shares = np.bincount(self.loaded.ravel(), weights=areas.ravel(), minlength=len(self.points))
        loads = np.outer(shares / shares.sum(), force)
        result = calculix.solve_inp(self._deck(loads), threads=1, nodes=np.arange(1, len(self.points) + 1))
        return float((loads * result.displacements).sum()), result.stress

    def _deck(self, loads):
        out = io.StringIO()
        out.write("*NODE\n")
        out.writelines("%d, %.12e, %.12e, %.12e\n" % (k, *xyz) for k, xyz in enumerate(self.points.tolist(), 1))
        out.write(f"*ELEMENT, TYPE={self.kind}, ELSET=EALL\n")
        for row, nodes in enumerate((self.elements + 1).tolist(), 1):
            out.write(f"{row}, " + ", ".join(map(str, nodes[:15])) + "\n" * (len(nodes) <= 15))
            if len(nodes) > 15:
                out.write(",\n" + ", ".join(map(str, nodes[15:])) + "\n")
        out.write(f"*MATERIAL, NAME=SOLID\n*ELASTIC\n{YOUNG}, {POISSON}\n"
                  "*SOLID SECTION, ELSET=EALL, MATERIAL=SOLID\n*BOUNDARY\n")
        out.writelines(f"{k + 1}, 1, 3, 0.0\n" for k in np.unique(self.held))
        out.write("*STEP\n*STATIC\n*CLOAD\n")
        out.writelines("%d, %d, %.12e\n" % (k + 1, m + 1, loads[k, m]) for k, m in zip(*np.nonzero(loads)))
        out.write("*NODE FILE\nU\n*EL FILE\nS\n*END STEP\n")
        return out.getvalue()

    def at(self, places, values):
        """(values (n,k) at places (n,3), (n,) bool: which lie in the mesh), by the elements' own shape functions."""
        import vtk
        from vtk.util import numpy_support as convert
        grid, probe, cloud = vtk.vtkUnstructuredGrid(), vtk.vtkProbeFilter(), vtk.vtkPolyData()
        grid.SetPoints(_vtk_points(vtk, convert, self.points))
        cells, corners = vtk.vtkCellArray(), self.elements.shape[1]
        rows = np.column_stack([np.full(len(self.elements), corners), self.elements]).astype(np.int64)
        cells.SetCells(len(rows), convert.numpy_to_vtkIdTypeArray(rows.ravel(), deep=True))
        grid.SetCells(VTK_CELL[corners], cells)
        array = convert.numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        array.SetName("values")
        grid.GetPointData().AddArray(array)
        cloud.SetPoints(_vtk_points(vtk, convert, places))
        probe.SetInputData(cloud)
        probe.SetSourceData(grid)
        probe.Update()
        found = probe.GetOutput().GetPointData()
        inside = convert.vtk_to_numpy(found.GetArray(probe.GetValidPointMaskArrayName())).astype(bool)
        return convert.vtk_to_numpy(found.GetArray("values")), inside


def _vtk_points(vtk, convert, points):
    made = vtk.vtkPoints()
    made.SetData(convert.numpy_to_vtk(np.ascontiguousarray(points, float), deep=True))
    return made


def _areas(points, facets):
    return _triangle_areas(points, facets) if facets.shape[1] == 6 else node_areas(points, facets)


def _triangle_areas(points, facets):
    """(m,6): the integrals of the shape functions of 6-node triangles."""
    corners, areas = points[facets], np.zeros(facets.shape)
    for r, s in TRIANGLE_RULE:
        t = 1 - r - s
        values = np.array([t * (2 * t - 1), r * (2 * r - 1), s * (2 * s - 1), 4 * t * r, 4 * r * s, 4 * s * t])
        slopes = np.array([[1 - 4 * t, 1 - 4 * t], [4 * r - 1, 0], [0, 4 * s - 1],
                           [4 * (t - r), -4 * r], [4 * s, 4 * r], [-4 * s, 4 * (t - s)]])
        tangents = np.einsum("mkx,kd->mdx", corners, slopes)
        areas += np.outer(np.linalg.norm(np.cross(tangents[:, 0], tangents[:, 1]), axis=1) / 6, values)
    return areas
