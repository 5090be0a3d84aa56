# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed even quad surfaces of many shapes, for cells to be put on. One inner point sees nearly
all of them whole: check_surface's star_center tells.

A surface is (points (V, 3), quads (n, 4)), quads counter-clockwise seen from outside.
"""
import itertools
import subprocess

import numpy as np
from scipy.spatial import ConvexHull
from surfaces import box, diced_hull, grid, o_grid, prism, schneiders_pyramid, upright, used_only

from hexcon.gmsh_process import gmsh_python
from hexcon.quads import surface_from_solid


def sphere(n):
    """A cube of n * n quads a face, on the unit sphere."""
    points, quads = box(n, n, n)
    points = np.tan((points / n - 0.5) * np.pi / 2)    # nearly equal angles
    return points / np.linalg.norm(points, axis=1)[:, None], quads


def zonohedron(rng, directions):
    """A convex body of directions * (directions - 1) parallelograms, all planar."""
    tries = rng.normal(size=(30, directions, 3))
    tries /= np.linalg.norm(tries, axis=2)[:, :, None]
    triples = list(itertools.combinations(range(directions), 3))
    fattest = np.abs(np.linalg.det(tries[:, triples])).min(axis=1).argmax()
    vectors = tries[fattest] * rng.uniform(0.7, 1.4, (directions, 1))
    rows = []
    for i, j in itertools.combinations(range(directions), 2):
        normal = np.cross(vectors[i], vectors[j])
        for side in (1, -1):
            signs = np.sign(vectors @ normal) * side
            for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))[::side]:
                signs[[i, j]] = a, b
                rows.append(signs.copy())
    signs, quads = np.unique(rows, axis=0, return_inverse=True)
    return signs @ vectors, quads.reshape(-1, 4)


def projected(rng, surface, strength=0.3):
    """Under a random affine map, then a projective one: planes stay planes, convex stays convex."""
    points, quads = surface
    points = points - points.mean(axis=0)
    points = points / np.abs(points).max() @ (np.eye(3) + rng.uniform(-0.4, 0.4, (3, 3)))
    slope = rng.normal(size=3)
    slope *= strength / np.abs(points @ slope).max()
    return points / (1 + points @ slope)[:, None], quads


def shaken(rng, surface, amount):
    """Points moved in any direction by up to about `amount` times the shortest edge there."""
    points, quads = surface
    ends = np.stack([quads, np.roll(quads, -1, axis=1)], axis=2).reshape(-1, 2)
    length = np.linalg.norm(points[ends[:, 0]] - points[ends[:, 1]], axis=1)
    shortest = np.full(len(points), np.inf)
    np.minimum.at(shortest, ends[:, 0], length)
    return points + amount * shortest[:, None] * rng.uniform(-1, 1, points.shape), quads


def round_hull(rng, count, jitter=0.2):
    """The diced hull of points spread over the unit sphere, moved in and out a little."""
    k = np.arange(count) + 0.5
    z, turn = 1 - 2 * k / count, np.pi * (1 + 5 ** 0.5) * k
    ring = np.sqrt(1 - z * z)
    points = np.column_stack([ring * np.cos(turn), ring * np.sin(turn), z])
    points += rng.normal(size=points.shape) * jitter * (4 / count) ** 0.5
    return diced_hull(points / np.linalg.norm(points, axis=1)[:, None] ** 0.7)


def merged_hull(rng, count, share=0.5):
    """As round_hull, but about a share of the triangles are joined two by two, flattest first, and
    cut into 4: some edges run over a fold, as on a CAD body's curved face."""
    points, _ = round_hull(rng, count)
    points = points[:count]
    hull = ConvexHull(points)
    inward = np.linalg.det(points[hull.simplices] - points.mean(axis=0)) < 0
    triangles = np.where(inward[:, None], hull.simplices[:, ::-1], hull.simplices)
    free, faces = np.ones(len(triangles), bool), []
    pairs = [(a, b) for a, row in enumerate(hull.neighbors) for b in row if a < b]
    folds = [hull.equations[a, :3] @ hull.equations[b, :3] for a, b in pairs]
    for k in np.argsort(folds)[::-1]:
        a, b = pairs[k]
        if free[a] and free[b] and free.mean() > 1 - share:
            free[[a, b]] = False
            tip = set(triangles[a]) - set(triangles[b])
            first = np.roll(triangles[a], -list(triangles[a]).index(*tip))
            other = set(triangles[b]) - set(triangles[a])
            faces.append([first[0], first[1], *other, first[2]])
    return cut_about_middles(points, [*faces, *triangles[free]])


def cut_about_middles(points, faces):
    """Every edge halved, every face of k corners cut into k quads about its mean."""
    places, numbers, quads = list(points), {}, []

    def middle(*ends):
        key = frozenset(ends)
        if key not in numbers:
            numbers[key] = len(places)
            places.append(points[list(ends)].mean(axis=0))
        return numbers[key]
    for face in faces:
        face = [int(v) for v in face]
        after, center = face[1:] + face[:1], len(places)
        places.append(points[face].mean(axis=0))
        middles = [middle(a, b) for a, b in zip(face, after)]
        quads += [[face[k], middles[k], center, middles[k - 1]] for k in range(len(face))]
    return used_only(np.array(places), np.array(quads))


def bent_cube(n, angle):
    """n * n * n, bent about an axis outside it."""
    points, quads = box(n, n, n)
    x, y, z = (points / n - 0.5).T
    radius = 2 / angle + z
    return np.column_stack([radius * np.sin(angle * x), y, radius * np.cos(angle * x)]), quads


def twisted_prism(n, levels, angle, taper):
    """A square bar whose upper end is turned and smaller."""
    def place(t, xy):
        turn = angle * t / levels
        c, s = np.cos(turn), np.sin(turn)
        return upright(t, (xy - n / 2) * (1 - taper * t / levels) @ [[c, s], [-s, c]])
    return prism(grid(n, n), np.arange(levels + 1.0), place)


_CAD = """
import sys, gmsh
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
occ = gmsh.model.occ
{body}
occ.synchronize()
gmsh.write(sys.argv[1])
"""
BOTH = ("blossom", "subdivided")
# name: (gmsh's code, edge length, methods of hexcon.quads that find an even all-quad surface)
SOLIDS = {
    "ball": ("occ.addSphere(0, 0, 0, 1)", 0.6, BOTH),
    "half_ball": ("occ.addSphere(0, 0, 0, 1, angle1=0)", 0.5, BOTH),
    "cone": ("occ.addCone(0, 0, 0, 0, 0, 1.5, 1, 0.4)", 0.5, BOTH),
    "wedge": ("occ.addWedge(0, 0, 0, 2, 1.5, 1, ltx=0.7)", 0.5, ("subdivided",)),
    "quarter_cylinder": ("occ.addCylinder(0, 0, 0, 0, 0, 1.5, 1, angle=1.5708)", 0.5, BOTH),
    "filleted": ("occ.addBox(0, 0, 0, 2, 2, 1.5)\nocc.synchronize()\n"
                 "occ.fillet([1], [1, 3, 5, 7], [0.5])", 0.6, BOTH),
    "skew_tetrahedron": (
        "ids = [occ.addPoint(*p) for p in ((0, 0, 0), (2, 0, 0), (0, 2, 0), (.3, .3, 2))]\n"
        "line = {(a, b): occ.addLine(ids[a], ids[b]) for b in range(4) for a in range(b)}\n"
        "sides = [occ.addPlaneSurface([occ.addCurveLoop([line[a, b], line[b, c], line[a, c]])])\n"
        "         for a, b, c in ((0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3))]\n"
        "occ.addVolume([occ.addSurfaceLoop(sides)])", 0.8, ("subdivided",)),
    "lens": ("occ.intersect([(3, occ.addSphere(0, 0, -.5, 1))],\n"
             "              [(3, occ.addSphere(0, 0, .5, 1))])", 0.35, BOTH),
}


def cad_file(body, path):
    """Write what gmsh's code makes with `occ`; returns the path."""
    subprocess.run([gmsh_python(), "-c", _CAD.format(body=body), str(path)], check=True)
    return str(path)


def cad_surface(name, folder, method="blossom"):
    """A quad surface that gmsh makes on one of SOLIDS; folder is for its CAD file."""
    body, size, _ = SOLIDS[name]
    path = cad_file(body, f"{folder}/{name}.brep")
    surface = surface_from_solid(path, size, method)
    return surface.points, surface.quads


SKEW = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.2, 0.2, 1]])
# name: builder from a generator of its own, so that one more name changes no other surface
PLAIN = {
    "sphere_2": lambda rng: sphere(2),
    "sphere_3": lambda rng: sphere(3),
    "sphere_4": lambda rng: sphere(4),
    "projected_2": lambda rng: projected(rng, sphere(2)),
    "projected_3": lambda rng: projected(rng, sphere(3), 0.5),
    "shaken_2": lambda rng: shaken(rng, sphere(2), 0.3),
    "shaken_3": lambda rng: shaken(rng, sphere(3), 0.3),
    "shaken_6": lambda rng: shaken(rng, sphere(6), 0.28),
    "shaken_8": lambda rng: shaken(rng, sphere(8), 0.34),
    "parallelepiped": lambda rng: zonohedron(rng, 3),
    "zonohedron_4": lambda rng: zonohedron(rng, 4),
    "zonohedron_5": lambda rng: zonohedron(rng, 5),
    "zonohedron_6": lambda rng: zonohedron(rng, 6),
    "projected_zonohedron_4": lambda rng: projected(rng, zonohedron(rng, 4), 0.4),
    "projected_zonohedron_5": lambda rng: projected(rng, zonohedron(rng, 5), 0.4),
    "tetrahedron": lambda rng: diced_hull(SKEW),
    "round_hull_8": lambda rng: round_hull(rng, 8),
    "round_hull_12": lambda rng: round_hull(rng, 12),
    "round_hull_20": lambda rng: round_hull(rng, 20),
    "round_hull_50": lambda rng: round_hull(rng, 50),
    "shaken_hull": lambda rng: shaken(rng, round_hull(rng, 16), 0.15),
    "merged_hull_10": lambda rng: merged_hull(rng, 10),
    "merged_hull_16": lambda rng: merged_hull(rng, 16),
    "bent_cube_2": lambda rng: bent_cube(2, 0.8),
    "bent_cube_3": lambda rng: bent_cube(3, 1.2),
    "twisted_2": lambda rng: twisted_prism(2, 2, 0.6, 0.0),
    "twisted_3": lambda rng: twisted_prism(2, 3, 0.9, 0.3),
    "cylinder": lambda rng: prism(o_grid(2, 1), np.linspace(0, 4, 3), upright),
    "schneiders_pyramid": lambda rng: schneiders_pyramid(),
}


def plain_surfaces(seed=1):
    """Yields (name, points, quads): all that needs no other program, 6 to 384 quads each."""
    for name, build in PLAIN.items():
        yield name, *build(np.random.default_rng([seed, *name.encode()]))


def cad_surfaces(folder):
    """Yields (name, points, quads): SOLIDS through gmsh, 40 to 240 quads each."""
    for name, (_, _, methods) in SOLIDS.items():
        for method in methods:
            yield f"{name}_{method}", *cad_surface(name, folder, method)
