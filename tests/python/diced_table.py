# SPDX-License-Identifier: LGPL-2.1-or-later
"""Method diced on fifteen solids, beside gmsh's own hexes (SubdivisionAlgorithm 2) at the same surface size.

    PYTHONPATH=.:workbench python3 tests/python/diced_table.py --quads 200 1000 4000 [--method subdivided] [--solid ball]

One line a surface, as it is measured: quads, then for HexCon and gmsh hexes, hexes that are not positive, scaled
Jacobian (minimum, mean) and seconds; what HexCon did not certify is marked; how many of the given quads gmsh kept.
"""
import argparse
import subprocess
import tempfile
import time

import numpy as np
from cell_surfaces import SOLIDS, cad_file

import hexcon
import hexcon_native as hn
from hexcon.gmsh_process import gmsh_python
from hexcon.quads import surface_from_solid

_FRUSTUM = """
ids = [occ.addPoint(s * x, s * y, z) for s, z in ((5, 0), (2.5, 8)) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
rings = [occ.addCurveLoop([occ.addLine(ids[k + i], ids[k + (i + 1) % 4]) for i in range(4)]) for k in (0, 4)]
occ.addThruSections(rings, makeSolid=True, makeRuled=True)
"""
BODIES = {name: SOLIDS[name][0] for name in ("ball", "half_ball", "cone", "wedge", "filleted", "skew_tetrahedron", "lens")}
BODIES |= {
    "frustum": _FRUSTUM,
    "box": "occ.addBox(0, 0, 0, 3, 2, 1)",
    "cylinder": "occ.addCylinder(0, 0, 0, 0, 0, 2, 1)",
    "torus": "occ.addTorus(0, 0, 0, 2, 0.8)",
    "L": "occ.fuse([(3, occ.addBox(0, 0, 0, 3, 1, 1))], [(3, occ.addBox(0, 0, 0, 1, 1, 3))])",
    "U": "occ.fuse([(3, occ.addBox(0, 0, 0, 3, 1, 1))],\n"
         "         [(3, occ.addBox(0, 0, 0, 1, 1, 3)), (3, occ.addBox(2, 0, 0, 1, 1, 3))])",
    "two_holes": "occ.cut([(3, occ.addBox(0, 0, 0, 4, 2, 0.8))],\n"
                 "        [(3, occ.addCylinder(x, 1, -1, 0, 0, 3, 0.5)) for x in (1.1, 2.9)])",
    "boss": "occ.fuse([(3, occ.addBox(-2, -2, 0, 4, 4, 1))], [(3, occ.addCylinder(0, 0, 0.5, 0, 0, 2, 1))])",
}
# argv: CAD file, quads wanted, 1 to recombine, result. The size is found so that the boundary has as many quads.
_GMSH = """
import sys, time, gmsh, numpy as np
path, wanted, recombine, result = sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), sys.argv[4]
gmsh.initialize()
def option(name, value): gmsh.option.setNumber(name, value)
option("General.Terminal", 0); option("General.NumThreads", 1); option("Mesh.RecombineAll", recombine)
gmsh.model.occ.importShapes(path)
gmsh.model.occ.synchronize()
def mesh(size, dimension, subdivision):
    gmsh.model.mesh.clear()
    option("Mesh.SubdivisionAlgorithm", subdivision)
    option("Mesh.MeshSizeMin", size); option("Mesh.MeshSizeMax", size)
    gmsh.model.mesh.generate(dimension)
size = 2 * (sum(gmsh.model.occ.getMass(2, tag) for _, tag in gmsh.model.getEntities(2)) / wanted) ** 0.5
for _ in range(3):
    mesh(size, 2, 1)
    size *= (sum(len(ids) for ids in gmsh.model.mesh.getElements(2)[1]) / wanted) ** 0.5
start = time.monotonic()
mesh(size, 3, 2)
seconds = time.monotonic() - start
tags, points, _ = gmsh.model.mesh.getNodes()
row = np.zeros(int(tags.max()) + 1, int)
row[tags.astype(int)] = np.arange(len(tags))
cells = dict(zip(*(lambda kinds, ids, nodes: (kinds, nodes))(*gmsh.model.mesh.getElements(3))))
hexes = row[np.asarray(cells.pop(5, []), int)].reshape(-1, 8)
np.savez(result, points=points.reshape(-1, 3), hexes=hexes, others=len(cells), seconds=seconds)
"""
FACES = np.array([[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])


def area_of(path):
    code = "import sys, gmsh\ngmsh.initialize()\ngmsh.option.setNumber('General.Terminal', 0)\n" \
           "gmsh.model.occ.importShapes(sys.argv[1])\ngmsh.model.occ.synchronize()\n" \
           "print(sum(gmsh.model.occ.getMass(2, tag) for _, tag in gmsh.model.getEntities(2)))"
    return float(subprocess.run([gmsh_python(), "-c", code, path], check=True, capture_output=True, text=True).stdout)


def surface_of(path, wanted, method):
    """About as many quads as wanted: the size is corrected once."""
    size = (area_of(path) / wanted) ** 0.5
    surface = surface_from_solid(path, size, method)
    return surface_from_solid(path, size * (len(surface.quads) / wanted) ** 0.5, method)


def gmsh_hexes(path, wanted, recombine, folder, timeout=300):
    """The worker's arrays, or None: gmsh crashed or hung."""
    result = f"{folder}/hexes.npz"
    try:
        subprocess.run([gmsh_python(), "-c", _GMSH, path, str(wanted), str(int(recombine)), result], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=timeout)
    except (subprocess.CalledProcessError, subprocess.TimeoutExpired):
        return None
    with np.load(result) as arrays:
        return dict(arrays)


def kept(found, surface):
    """How many of the given quads are faces of gmsh's hexes: their corners are where four of its points are."""
    faces = found["points"][found["hexes"][:, FACES].reshape(-1, 4)]
    scale = 1e-6 * np.ptp(surface.points, axis=0).max()

    def keys(corners):
        return {tuple(sorted(map(tuple, quad))) for quad in np.rint(corners / scale).astype(np.int64).tolist()}
    return len(keys(surface.points[surface.quads]) & keys(faces))


def judged(points, hexes):
    """(hexes that are not positive, least and mean scaled Jacobian)."""
    quality = hn.quality(points, hexes)
    return int((quality.scaled_jacobian <= 0).sum()), quality.min, quality.mean


def our_words(surface):
    start = time.monotonic()
    try:
        mesh = hexcon.mesh_surface(surface.points, surface.quads, "diced", allow_uncertified=True)
    except hn.HexconError as error:
        return f"{error.code.name}"
    seconds = time.monotonic() - start
    figures = judged(mesh.points, mesh.hexes)
    words = "{:6d} hexes {:5.1f}/quad {:3d} bad  {:6.3f} {:.3f} {:6.1f} s".format(
        len(mesh.hexes), len(mesh.hexes) / len(surface.quads), *figures, seconds)
    return words + ("  certified" if mesh.certificate.certified else "  NOT CERTIFIED")


def gmsh_words(found, surface):
    if found is None:
        return "gmsh: no mesh"
    if not len(found["hexes"]):
        return f"gmsh: no hexes, {int(found['others'])} other kinds"
    return "gmsh {:6d} hexes {:4d} bad  {:6.3f} {:.3f} {:5.1f} s  other kinds {}  kept {}".format(
        len(found["hexes"]), *judged(found["points"], found["hexes"]), float(found["seconds"]), int(found["others"]),
        kept(found, surface))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quads", type=int, nargs="+", default=[200])
    parser.add_argument("--method", nargs="+", default=["subdivided-triangles", "subdivided"])
    parser.add_argument("--solid", nargs="+", choices=BODIES, default=list(BODIES))
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        paths = {name: cad_file(BODIES[name], f"{folder}/{name}.brep") for name in options.solid}
        for wanted in options.quads:
            for method in options.method:
                for name, path in paths.items():
                    surface = surface_of(path, wanted, method)
                    found = gmsh_hexes(path, len(surface.quads), method == "subdivided", folder)
                    print(f"{name:17s}{method:21s}{len(surface.quads):6d} quads | {our_words(surface)} | "
                          f"{gmsh_words(found, surface)}", flush=True)


if __name__ == "__main__":
    main()
