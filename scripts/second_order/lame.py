# SPDX-License-Identifier: LGPL-2.1-or-later
"""A thick pipe under inner pressure, plane strain, against Lame: errors of hexes and of quadratic tetrahedra, and how
they fall with the size. PYTHONPATH=.:workbench PYTHON scripts/second_order/lame.py
"""
import sys
import tempfile

import gmsh
import numpy as np
from bodies import quarter_pipe, written

import hexcon
import hexcon_native
from hexcon.calculix import solve_inp
from hexcon.curving.curving_worker.quad_shape import quad_shape
from hexcon.femmesh.elements import elements_of
from hexcon.femmesh.second_order import lower_order

INNER, OUTER, PRESSURE, YOUNG, POISSON = 5.0, 10.0, 100.0, 210000.0, 0.3
NEAR = 1e-6
_G3 = np.polynomial.legendre.leggauss(3)
_TRIANGLE = [((1 / 6, 1 / 6), 1 / 6), ((2 / 3, 1 / 6), 1 / 6), ((1 / 6, 2 / 3), 1 / 6)]


def displacement(radius):
    ratio = INNER ** 2 / (OUTER ** 2 - INNER ** 2)
    return (1 + POISSON) / YOUNG * PRESSURE * ratio * ((1 - 2 * POISSON) * radius + OUTER ** 2 / radius)


HOOP = PRESSURE * (OUTER ** 2 + INNER ** 2) / (OUTER ** 2 - INNER ** 2)      # at the inner wall


def quad_rule(nodes):
    """[(values, slopes (2,n), weight)] of quads of 4 or 8 nodes."""
    rule = []
    for u, wu in zip(*_G3):
        for v, wv in zip(*_G3):
            values, slopes = quad_shape(nodes, u, v)
            rule.append(((values, slopes.T), wu * wv))
    return rule


def triangle_rule():
    rule = []
    for (r, s), weight in _TRIANGLE:
        t = 1 - r - s
        values = np.array([t * (2 * t - 1), r * (2 * r - 1), s * (2 * s - 1), 4 * r * t, 4 * r * s, 4 * s * t])
        dr = np.array([1 - 4 * t, 4 * r - 1, 0, 4 * (t - r), 4 * s, -4 * s])
        ds = np.array([1 - 4 * t, 0, 4 * s - 1, -4 * r, 4 * r, 4 * (t - s)])
        rule.append(((values, np.array([dr, ds])), weight))
    return rule


def pressure_loads(points, facets):
    """(P,3) consistent forces of the pressure on facets that face into the pipe's bore."""
    loads = np.zeros_like(points)
    rule = triangle_rule() if facets.shape[1] == 6 else quad_rule(facets.shape[1])
    for (values, slopes), weight in rule:
        along, across = (np.einsum("n,qnx->qx", s, points[facets]) for s in slopes)
        normal = np.cross(along, across)
        middle = points[facets].mean(axis=1) * (1, 1, 0)
        normal *= np.sign((normal * middle).sum(1))[:, None]        # away from the axis
        np.add.at(loads, facets, PRESSURE * weight * values[None, :, None] * normal[:, None])
    return loads


def solved(points, cells, kind, facets):
    """(largest error of the radial displacement at the inner wall, of the hoop stress there), relative."""
    lines = ["*NODE, NSET=NALL"] + [f"{n}, {x:.15g}, {y:.15g}, {z:.15g}" for n, (x, y, z) in enumerate(points, 1)]
    lines.append(f"*ELEMENT, TYPE={kind}, ELSET=EALL")
    for number, cell in enumerate(cells + 1, 1):
        words = [str(number), *map(str, cell)]
        lines += [", ".join(words[:16]) + ",", ", ".join(words[16:])] if len(words) > 16 else [", ".join(words)]
    lines += [f"*MATERIAL, NAME=M\n*ELASTIC\n{YOUNG}, {POISSON}", "*SOLID SECTION, ELSET=EALL, MATERIAL=M", "*BOUNDARY"]
    for rows, freedom in ((np.abs(points[:, 0]) < NEAR, 1), (np.abs(points[:, 1]) < NEAR, 2),
                          ((np.abs(points[:, 2]) < NEAR) | (np.abs(points[:, 2] - 2) < NEAR), 3)):
        lines += [f"{n}, {freedom}, {freedom}" for n in np.flatnonzero(rows) + 1]
    lines += ["*STEP\n*STATIC\n*CLOAD"]
    loads = pressure_loads(points, facets)
    for n, d in zip(*np.nonzero(loads)):
        lines.append(f"{n + 1}, {d + 1}, {loads[n, d]:.12e}")
    lines += ["*NODE FILE\nU\n*EL FILE\nS\n*END STEP\n"]
    result = solve_inp("\n".join(lines))
    rows = result.node_ids - 1
    radius = np.hypot(*points[rows, :2].T)
    wall = np.abs(radius - INNER) < 1e-3
    across = points[rows, :2] / radius[:, None]
    moved = (result.displacements[:, :2] * across).sum(1)
    xx, yy, _, xy = result.stress.T[:4]
    hoop = xx * across[:, 1] ** 2 + yy * across[:, 0] ** 2 - 2 * xy * across[:, 0] * across[:, 1]
    return (np.abs(moved[wall] / displacement(INNER) - 1).max(), np.abs(hoop[wall] / HOOP - 1).max())


def tetrahedra(path, size):
    """(points, C3D10 cells, tri6 facets of the inner wall): gmsh, curved, high-order optimised."""
    gmsh.initialize([], False)
    for name, value in (("General.Terminal", 0), ("Mesh.MeshSizeMax", size), ("Mesh.MeshSizeMin", size),
                        ("Mesh.ElementOrder", 2), ("Mesh.HighOrderOptimize", 2)):
        gmsh.option.setNumber(name, value)
    gmsh.model.occ.importShapes(path)
    gmsh.model.occ.synchronize()
    gmsh.model.mesh.generate(3)
    tags, places, _ = gmsh.model.mesh.getNodes()
    row = np.zeros(int(tags.max()) + 1, int)
    row[tags.astype(int)] = np.arange(len(tags))
    points = places.reshape(-1, 3)
    cells = row[gmsh.model.mesh.getElementsByType(11)[1].astype(int)].reshape(-1, 10)[:, [*range(8), 9, 8]]
    facets = row[gmsh.model.mesh.getElementsByType(9)[1].astype(int)].reshape(-1, 6)
    gmsh.finalize()
    return points, cells, facets[on_the_wall(points, facets[:, :3])]


def on_the_wall(points, corners):
    """(n,) whether all corners of facets lie on the inner wall."""
    return (np.abs(np.hypot(*points[corners, :2].transpose(2, 0, 1)) - INNER) < NEAR).all(axis=1)


def main():
    rows = {}
    with tempfile.TemporaryDirectory() as folder:
        path = written("quarter pipe", quarter_pipe, folder)
        for size in map(float, sys.argv[1:] or (4, 2, 1)):
            curved = hexcon.mesh_solid(path, size, order=2)
            points, hexes, _ = lower_order(curved.points, curved.hexes)
            straight = hexcon_native.raise_order(points, hexes)
            for what, (p, h), kind in (("C3D8", (points, hexes), "C3D8"), ("C3D20 straight", straight, "C3D20"),
                                       ("C3D20", (curved.points, curved.hexes), "C3D20"),
                                       ("C3D20R", (curved.points, curved.hexes), "C3D20R")):
                mesh = type("Mesh", (), {"points": p, "hexes": h})
                quads = elements_of(mesh).quads
                wall = quads[on_the_wall(p, quads[:, :4])]
                rows.setdefault(what, []).append((size, len(p), *solved(p, h, kind, wall)))
            p, t, facets = tetrahedra(path, size * 0.9)
            rows.setdefault("C3D10", []).append((size, len(p), *solved(p, t, "C3D10", facets)))
    print("elements         size   nodes  displacement  order   hoop stress  order")
    for what, found in rows.items():
        before = None
        for size, nodes, moved, hoop in found:
            orders = [""] * 2 if before is None else \
                [f"{np.log(b / a) / np.log(before[0] / size):.2f}" for b, a in ((before[2], moved), (before[3], hoop))]
            print(f"{what:16} {size:4g} {nodes:7d}  {moved:12.2e} {orders[0]:>6}  {hoop:12.2e} {orders[1]:>6}")
            before = size, nodes, moved, hoop


main()
