# SPDX-License-Identifier: LGPL-2.1-or-later
"""FEM on hexes (the grid's and diced ones, or those of auto) beside quadratic tetrahedra at like numbers of nodes.

    PYTHONPATH=.:workbench python3 scripts/grid_beside/fem_table.py [grid|round|machined] [--body NAME ...]
                                                                    [--result FILE]

A linear static problem a body: one face held, a force spread over another. Errors are against C3D10 of some 40,000
nodes: of compliance (energy, and displacement of the load), and of stress, the root of the mean square at 2000 places
inside, a size away from the held and the loaded face, over that of the stress. A body's line of the result file is
kept; remove the file to measure anew.
"""
import os
import sys

import numpy as np

sys.path[:0] = [os.path.dirname(os.path.dirname(os.path.abspath(__file__)))]

from bodies import face_at, made  # noqa: E402
from fem_bodies import SETS  # noqa: E402
from measured import fem_rows  # noqa: E402
from measuring import table_of_bodies  # noqa: E402
from static import Model  # noqa: E402
from tetrahedra import tetrahedra  # noqa: E402

import hexcon  # noqa: E402
from hexcon.femmesh.elements import elements_of  # noqa: E402

HEXES = {"grid": {"surface_method": "grid"}, "auto": {},
         "diced": {"surface_method": "subdivided-triangles", "method": "diced"}}
REFERENCE, FINER = 40000, 0.55   # nodes; size of the finer hexes
PLACES, SEED = 2000, 18
LIKE = 1.12     # numbers of nodes are alike, if within this factor


def like(nodes, build, size):
    """What build(size) makes with about so many nodes: five tries, the nearest."""
    best = None
    for _ in range(5):
        found = build(size)
        ratio = len(found.points) / nodes
        if best is None or abs(np.log(ratio)) < abs(np.log(best[0])):
            best = ratio, found
        if 1 / LIKE < ratio < LIKE:
            break
        size *= min(1.6, max(0.6, ratio ** 0.4))
    return best[1]


def hex_models(mesh, held, loaded):
    """{kind: Model} of one hex mesh of order 2: of its 8-node hexes, and of 20 nodes, straight edges or its own."""
    corners = elements_of(mesh, 1)
    return {name: Model(elements.points, elements.hexes, name.split()[0],
                        *(elements.quads[elements.quads_of_face(face)] for face in (held, loaded)))
            for name, elements in (("C3D8", corners), ("C3D20 straight", elements_of(corners, 2)),
                                   ("C3D20", elements_of(mesh)), ("C3D20R", elements_of(mesh)))}


def measured(name, body, natural, folder):
    """Figures of one body: a row for each of its meshes. natural: "grid", beside diced ones, or "auto" alone."""
    shape, path = made(body, folder)
    held, loaded = face_at(shape, body.held), face_at(shape, body.loaded)

    def hexes(what, size):
        return hexcon.mesh_solid(path, size, order=2, threads=1, timeout=600, **HEXES[what])

    def tets(nodes):
        return like(nodes, lambda size: tetrahedra(path, size, held, loaded, folder), body.size)
    against = Reference(tets(REFERENCE), body)
    meshes = {natural: hexes(natural, body.size), natural + ", finer": hexes(natural, FINER * body.size)}
    if natural == "grid":
        meshes["diced"] = like(len(meshes["grid, finer"].points), lambda size: hexes("diced", size), FINER * body.size)
    coarser = tets(REFERENCE // 3).solved(body.force)[0]
    return {"body": name, "bending": body.bending, "reference nodes": len(against.model.points),
            "reference change": against.compliance / coarser - 1,
            "rows": [row_of(what, mesh, held, loaded, tets, against) for what, mesh in meshes.items()]}


def row_of(what, mesh, held, loaded, tets, against):
    """Figures of one hex mesh, and of tetrahedra with as many nodes at either order."""
    models = hex_models(mesh, held, loaded)
    for order, kind in ((1, "C3D8"), (2, "C3D20")):
        models[f"C3D10 {order}"] = tets(len(models[kind].points))
    return {"mesh": what, "surface": mesh.report["surface method"], "hexes": len(mesh.hexes),
            "min": mesh.quality.min, "mean": mesh.quality.mean,
            **{kind: {"nodes": len(model.points), **against.errors(model)} for kind, model in models.items()}}


class Reference:
    """What a fine model says: its compliance, and its stresses at places inside, far from where they are infinite."""

    def __init__(self, model, body):
        self.model, self.force = model, body.force
        self.compliance, nodal = model.solved(body.force)
        self.places = places_inside(model, body.size)
        self.stress = model.at(self.places, nodal)[0]

    def errors(self, model):
        """{"compliance", "stress"}: relative errors of a model, or {"fault"}: what CalculiX says."""
        try:
            compliance, nodal = model.solved(self.force)
        except hexcon.HexconError as error:
            return {"fault": str(error)[:200]}
        found, inside = model.at(self.places, nodal)
        off = ((found - self.stress)[inside] ** 2).sum() / (self.stress[inside] ** 2).sum()
        return {"compliance": compliance / self.compliance - 1, "stress": float(off ** 0.5),
                "places": int(inside.sum())}


def places_inside(reference, away):
    """(n,3) random places in a mesh, so far from the held and the loaded face's nodes."""
    from scipy.spatial import cKDTree
    random, low, high = np.random.default_rng(SEED), reference.points.min(axis=0), reference.points.max(axis=0)
    near = cKDTree(reference.points[np.unique(np.concatenate([reference.held.ravel(), reference.loaded.ravel()]))])
    places = np.empty((0, 3))
    while len(places) < PLACES:
        more = random.uniform(low, high, (4 * PLACES, 3))
        more = more[reference.at(more, reference.points)[1] & (near.query(more)[0] > away)]
        places = np.vstack([places, more])
    return places[:PLACES]


def main():
    chosen = sys.argv.pop(1) if sys.argv[1:2] and sys.argv[1] in SETS else "grid"
    bodies, natural = SETS[chosen], "grid" if chosen == "grid" else "auto"
    table_of_bodies(__doc__, bodies, list(bodies), f"output/fem_{chosen}.jsonl",
                    lambda name, folder: measured(name, bodies[name], natural, folder), fem_rows)


if __name__ == "__main__":
    main()
