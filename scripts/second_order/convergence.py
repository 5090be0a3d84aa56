# SPDX-License-Identifier: LGPL-2.1-or-later
"""How errors of displacement and stress fall with the size, of hexes of either order and of quadratic tetrahedra.

    PYTHONPATH=.:workbench PYTHON scripts/second_order/convergence.py [--levels 4] [--picture docs/convergence.png]

Problems of exact_problems; errors are roots of the mean square over all nodes, relative; stresses as CalculiX
extrapolates them to nodes. Peak: the greatest error of the largest principal stress where the exact one is greatest.
"""
import argparse
import os
import sys
import tempfile

import gmsh
import numpy as np
from bodies import written
from exact_problems import NEAR, PROBLEMS, YOUNG

sys.path[:0] = [os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "grid_beside")]

import hexcon  # noqa: E402
import hexcon_native  # noqa: E402
from hexcon.calculix import solve_inp  # noqa: E402
from hexcon.curving.curving_worker.quad_shape import quad_shape  # noqa: E402
from hexcon.femmesh.elements import elements_of  # noqa: E402
from hexcon.femmesh.second_order import lower_order  # noqa: E402

KINDS = ("C3D8", "C3D20 straight", "C3D20", "C3D20R", "C3D10")
TETRAHEDRA = 0.9        # of the size, for about as many nodes at the finer levels
_G3 = np.polynomial.legendre.leggauss(3)
_TRIANGLE = [((1 / 6, 1 / 6), 1 / 6), ((2 / 3, 1 / 6), 1 / 6), ((1 / 6, 2 / 3), 1 / 6)]


def quad_rule(nodes):
    """[(values, slopes (2,n), weight)] of quads of 4 or 8 nodes."""
    return [((values, slopes.T), wu * wv) for u, wu in zip(*_G3) for v, wv in zip(*_G3)
            for values, slopes in (quad_shape(nodes, u, v),)]


def triangle_rule():
    rule = []
    for (r, s), weight in _TRIANGLE:
        t = 1 - r - s
        values = np.array([t * (2 * t - 1), r * (2 * r - 1), s * (2 * s - 1), 4 * r * t, 4 * r * s, 4 * s * t])
        dr = np.array([1 - 4 * t, 4 * r - 1, 0, 4 * (t - r), 4 * s, -4 * s])
        ds = np.array([1 - 4 * t, 0, 4 * s - 1, -4 * r, 4 * r, 4 * (t - s)])
        rule.append(((values, np.array([dr, ds])), weight))
    return rule


def exact_loads(problem, points, facets):
    """(P,3) consistent forces of the exact stress on facets."""
    loads = np.zeros_like(points)
    for (values, slopes), weight in triangle_rule() if facets.shape[1] == 6 else quad_rule(facets.shape[1]):
        along, across = (np.einsum("n,qnx->qx", s, points[facets]) for s in slopes)
        normal = np.cross(along, across)
        place = np.einsum("n,qnx->qx", values, points[facets])
        normal *= np.sign((normal * problem.outwards(place)).sum(1))[:, None]
        xx, yy, zz, xy, yz, zx = problem.stress(place).T
        force = np.einsum("qxy,qy->qx", np.array([[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]]).transpose(2, 0, 1), normal)
        np.add.at(loads, facets, weight * values[None, :, None] * force[:, None])
    return loads


def deck_of(problem, points, cells, kind, loads):
    lines = ["*NODE, NSET=NALL"] + [f"{n}, {x:.12e}, {y:.12e}, {z:.12e}" for n, (x, y, z) in enumerate(points, 1)]
    lines.append(f"*ELEMENT, TYPE={kind}, ELSET=EALL")
    for number, cell in enumerate(cells + 1, 1):
        words = [str(number), *map(str, cell)]
        lines += [", ".join(words[:16]) + ",", ", ".join(words[16:])] if len(words) > 16 else [", ".join(words)]
    lines += [f"*MATERIAL, NAME=M\n*ELASTIC\n{YOUNG}, {problem.poisson}", "*SOLID SECTION, ELSET=EALL, MATERIAL=M",
              "*BOUNDARY"]
    for axis, place in problem.held:
        lines += [f"{n}, {axis + 1}, {axis + 1}" for n in np.flatnonzero(np.abs(points[:, axis] - place) < NEAR) + 1]
    lines += ["*STEP\n*STATIC\n*CLOAD"]
    lines += [f"{n + 1}, {d + 1}, {loads[n, d]:.12e}" for n, d in zip(*np.nonzero(loads))]
    return "\n".join([*lines, "*NODE FILE\nU\n*EL FILE\nS\n*END STEP\n"])


def largest_principal(stress):
    xx, yy, zz, xy, yz, zx = stress.T
    return np.linalg.eigvalsh(np.array([[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]]).transpose(2, 0, 1))[:, 2]


def errors(problem, points, cells, kind, facets):
    """Relative errors of displacement, of stress, and of the greatest stress."""
    facets = facets[problem.loaded(points[facets[:, :3 if facets.shape[1] == 6 else 4]])]
    result = solve_inp(deck_of(problem, points, cells, kind, exact_loads(problem, points, facets)))
    places = points[result.node_ids - 1]
    moved, stress = problem.moved(places), problem.stress(places)
    peak = problem.peak(places)
    tops = (largest_principal(one[peak]) for one in (result.stress, stress))
    return (np.linalg.norm(result.displacements - moved) / np.linalg.norm(moved),
            np.linalg.norm(result.stress - stress) / np.linalg.norm(stress),
            np.abs(next(tops) / next(tops) - 1).max())


def tetrahedra(path, size):
    """(points, C3D10 cells, tri6 facets): gmsh, curved, high-order optimised."""
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
    cells = row[gmsh.model.mesh.getElementsByType(11)[1].astype(int)].reshape(-1, 10)[:, [*range(8), 9, 8]]
    facets = row[gmsh.model.mesh.getElementsByType(9)[1].astype(int)].reshape(-1, 6)
    gmsh.finalize()
    return places.reshape(-1, 3), cells, facets


def meshes_of(path, size):
    """{kind: (points, cells, CalculiX's element, facets)}"""
    mesh = hexcon.mesh_solid(path, size, order=2)
    points, hexes, _ = lower_order(mesh.points, mesh.hexes)
    own = mesh.points, mesh.hexes
    made = {"C3D8": (points, hexes), "C3D20 straight": hexcon_native.raise_order(points, hexes), "C3D20": own,
            "C3D20R": own}
    made = {kind: (p, h, kind.split()[0], elements_of(type("Mesh", (), {"points": p, "hexes": h})).quads)
            for kind, (p, h) in made.items()}
    points, cells, facets = tetrahedra(path, TETRAHEDRA * size)
    return made | {"C3D10": (points, cells, "C3D10", facets)}


def measured(problem, levels):
    """{kind: [(size, nodes, errors ...)]}"""
    rows = {kind: [] for kind in KINDS}
    with tempfile.TemporaryDirectory() as folder:
        path = written("body", problem.make, folder)
        for size in problem.sizes[:levels]:
            for kind, (points, cells, element, facets) in meshes_of(path, size).items():
                rows[kind].append((size, len(points), *errors(problem, points, cells, element, facets)))
    return rows


def order_of(before, now, column):
    return "" if before is None else f"{np.log(before[column] / now[column]) / np.log(before[0] / now[0]):.1f}"


def table_of(name, rows):
    print(f"{name:18} size   nodes  displacement  order   stress  order     peak  order")
    for kind, found in rows.items():
        for before, now in zip([None, *found], found):
            size, nodes, moved, stress, peak = now
            print(f"  {kind:14} {size:6g} {nodes:7d}  {moved:12.1e} {order_of(before, now, 2):>6} {stress:8.1e} "
                  f"{order_of(before, now, 3):>6} {peak:8.1e} {order_of(before, now, 4):>6}", flush=True)


def draw(found, path):
    """Errors over numbers of nodes: a column a problem, displacement above stress."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(2, len(found), figsize=(5.2 * len(found), 8), squeeze=False, layout="constrained")
    for column, (name, rows) in enumerate(found.items()):
        for row, (part, what) in enumerate(((2, "displacement"), (3, "stress"))):
            plot = axes[row, column]
            for kind, line in rows.items():
                plot.loglog([one[1] for one in line], [one[part] for one in line], marker="o", markersize=4, label=kind)
            plot.set(title=f"{name}: {what}", xlabel="nodes", ylabel="relative error (root of the mean square)")
            plot.grid(True, which="both", alpha=0.25)
    axes[0, 0].legend()
    figure.savefig(path, dpi=90)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--levels", type=int, default=4)
    parser.add_argument("--picture")
    options = parser.parse_args()
    found = {}
    for name, problem in PROBLEMS.items():
        found[name] = measured(problem, options.levels)
        table_of(name, found[name])
    if options.picture:
        draw(found, options.picture)


main()
