# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shortest edges and aspect ratios, by hand and beside the edges of VTK's cells."""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from hex_grids import block, distorted  # noqa: E402

import hexcon_native as hn  # noqa: E402
from hexcon.judging import lengths, words  # noqa: E402
from hexcon.judging.lengths import lengths_of  # noqa: E402
from hexcon.judging.report import check_mesh  # noqa: E402


def test_a_brick_by_hand():
    mesh = block(2, 1, 1, (4.0, 1.0, 0.5))
    found = lengths_of(mesh.points, mesh.hexes)
    assert (found.shortest, found.longest) == (0.5, 2.0) and found.aspect_ratio.tolist() == [4.0, 4.0]
    assert found.as_dict() == {"shortest_edge": 0.5, "longest_edge": 2.0, "shortest_edge_hex": 0,
                               "aspect_ratio": {"max": 4.0, "mean": 4.0, "max_hex": 0}}
    report = check_mesh(mesh)
    assert report.lengths.shortest == 0.5
    said = words.as_text(words.of_check(report)).replace("\u00a0", " ")
    assert "Edges: shortest 0.5, longest 2;" in said and "Aspect ratio: most 4.00, mean 4.00" in said


def test_random_hexes_beside_vtk_s_edges(monkeypatch):
    """The edges are those of VTK's cells, not of a table of ours."""
    from vtkmodules.vtkCommonDataModel import vtkHexahedron
    mesh = distorted(block(4, 3, 3), 0.1)
    monkeypatch.setattr(lengths, "HEXES_AT_ONCE", 7)
    found, cell = lengths_of(mesh.points, mesh.hexes), vtkHexahedron()
    right = []
    for row in mesh.hexes.tolist():
        for corner, point in enumerate(row):
            cell.GetPointIds().SetId(corner, corner)
            cell.GetPoints().SetPoint(corner, mesh.points[point])
        ends = [[cell.GetEdge(k).GetPoints().GetPoint(end) for end in (0, 1)] for k in range(12)]
        right.append(np.sort(np.linalg.norm(np.subtract(*np.swapaxes(ends, 0, 1)), axis=1)))
    right = np.array(right)
    assert np.allclose(found.aspect_ratio, right[:, -1] / right[:, 0], rtol=1e-12)
    assert np.isclose(found.shortest, right.min()) and np.isclose(found.longest, right.max())
    assert found.shortest_hex == right[:, 0].argmin()
    at_order_2 = lengths_of(*hn.raise_order(mesh.points, mesh.hexes))
    assert np.array_equal(at_order_2.aspect_ratio, found.aspect_ratio)


def test_an_edge_of_no_length():
    points = block(1, 1, 1).points.copy()
    points[1] = points[0]
    found = lengths_of(points, block(1, 1, 1).hexes)
    assert found.shortest == 0 and found.aspect_ratio.tolist() == [np.inf]
