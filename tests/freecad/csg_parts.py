# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random non-convex parts by seed: boxes and cylinders joined and cut, some edges rounded. Needs FreeCAD.

Nothing is tuned for them. Half of the seeds draw lengths in whole half millimetres, as a designer does, so that faces
and edges come to lie on one another; the others draw any number. Every seventh part gets a cavity.
"""
import math
from dataclasses import dataclass, field

import numpy as np
from quads_solids import Part, Vector

AXES = (Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1))
CAVITY_EVERY = 7
TRIES = 200     # parts drawn until one is what is wanted
QUADS = (250, 500)    # the range of area / size ** 2


@dataclass
class CsgPart:
    """A valid, non-convex solid; size: wanted edge length in mm; steps: how it was made, one word or two each."""
    seed: int
    shape: object
    size: float
    steps: list = field(default_factory=list)
    cavities: int = 0
    genus: int = 0


def csg_part(seed):
    """The part of a seed; the same for ever."""
    rng = np.random.default_rng([8, seed])
    for _ in range(TRIES):
        shape, steps = _drawn(rng, on_grid=seed % 2 == 0, cavity=seed % CAVITY_EVERY == CAVITY_EVERY - 1)
        if shape is not None and _wanted(shape, seed):
            solid = shape.Solids[0]
            size = math.sqrt(solid.Area / rng.uniform(*QUADS))
            return CsgPart(seed, solid, size, steps, len(solid.Shells) - 1, genus_of(solid))
    raise ValueError(f"no part of seed {seed} in {TRIES} tries")


def _drawn(rng, on_grid, cavity):
    """(shape or None, steps)."""
    def length(low, high):
        value = rng.uniform(low, high)
        return round(2 * value) / 2 if on_grid else value

    shape, steps = _body(rng, length), []
    for _ in range(int(rng.integers(1, 5))):
        join = rng.random() < 0.5
        tool, name = _hole(rng, length, shape.BoundBox) if not join and rng.random() < 0.5 \
            else _tool(rng, length, shape.BoundBox)
        steps.append(("+" if join else "-") + name)
        shape = shape.fuse(tool) if join else shape.cut(tool)
        if len(shape.Solids) != 1:
            return None, steps
        shape = shape.removeSplitter()
    if rng.random() < 0.4:
        shape, rounded = _rounded(shape, rng, length)
        steps += ["fillets"] * rounded
    if cavity:
        shape = _hollowed(shape, rng, length)
        steps.append("cavity")
    return shape, steps


def _body(rng, length):
    if rng.random() < 0.7:
        return Part.makeBox(length(15, 40), length(15, 40), length(6, 30))
    return Part.makeCylinder(length(8, 18), length(8, 30))


def _tool(rng, length, box):
    """(a box or a cylinder that reaches into a bounding box, its name)."""
    where = [length(low, high) for low, high in ((box.XMin, box.XMax), (box.YMin, box.YMax), (box.ZMin, box.ZMax))]
    if rng.random() < 0.5:
        sides = [length(5, 20) for _ in AXES]
        corner = [w - length(0, side) for w, side in zip(where, sides)]
        return Part.makeBox(*sides, Vector(*corner)), "box"
    axis, radius, height = int(rng.integers(3)), length(2.5, 8), length(8, 50)
    where[axis] -= length(0, height)
    return Part.makeCylinder(radius, height, Vector(*where), AXES[axis]), "cylinder"


def _hole(rng, length, box):
    """(a cylinder right through a bounding box, "hole")."""
    low, high = np.array([box.XMin, box.YMin, box.ZMin]), np.array([box.XMax, box.YMax, box.ZMax])
    axis = int(rng.integers(3))
    where = [length(a + 0.2 * (b - a), b - 0.2 * (b - a)) for a, b in zip(low, high)]
    where[axis] = low[axis] - 1
    return Part.makeCylinder(length(1.5, 5), high[axis] - low[axis] + 2, Vector(*where), AXES[axis]), "hole"


def _rounded(shape, rng, length):
    """(shape with up to four edges rounded where Open CASCADE can, 1 or 0)."""
    edges = list(rng.permutation(len(shape.Edges))[:int(rng.integers(1, 5))])
    radius = length(1, 3)
    try:
        made = shape.makeFillet(radius, [shape.Edges[k] for k in edges])
    except Exception:       # Open CASCADE refuses many
        return shape, 0
    good = not made.isNull() and made.isValid() and len(made.Solids) == 1
    return (made, 1) if good else (shape, 0)


def _hollowed(shape, rng, length):
    """A ball or a box taken out where it has room."""
    box = shape.BoundBox
    for _ in range(100):
        centre = Vector(*(rng.uniform(low, high) for low, high in
                          ((box.XMin, box.XMax), (box.YMin, box.YMax), (box.ZMin, box.ZMax))))
        if not shape.isInside(centre, 1e-6, False):
            continue
        room = Part.Vertex(centre).distToShape(shape.Solids[0].OuterShell)[0]
        if room < 4:
            continue
        half = min(length(2, 6), 0.6 * room)
        if rng.random() < 0.5:
            return shape.cut(Part.makeSphere(half, centre))
        half /= math.sqrt(3)
        return shape.cut(Part.makeBox(2 * half, 2 * half, 2 * half, centre - Vector(half, half, half)))
    return shape


def _wanted(shape, seed):
    """One valid closed solid, not convex, with a cavity where the seed asks for one."""
    if shape.isNull() or len(shape.Solids) != 1 or not shape.isValid():
        return False
    solid = shape.Solids[0]
    hollow = seed % CAVITY_EVERY == CAVITY_EVERY - 1
    return (all(shell.isClosed() for shell in solid.Shells) and (len(solid.Shells) > 1) == hollow
            and _is_manifold(solid) and not _is_convex(solid))


def _is_manifold(solid):
    """Every edge between two faces, and the faces round every vertex all joined by edges there: parts that touch in an
    edge or a point only are none that could be made."""
    faces_at_edge, links = {}, {}
    for wire in (wire for face in solid.Faces for wire in face.Wires):
        edges = [_Same(edge) for edge in wire.OrderedEdges if not edge.Degenerated]
        for here, after in zip(edges, edges[1:] + edges[:1]):
            faces_at_edge[here] = faces_at_edge.get(here, 0) + 1
            common = {_Same(v) for v in here.shape.Vertexes} & {_Same(v) for v in after.shape.Vertexes}
            if len(common) > 1:
                common &= {_Same(here.shape.lastVertex(True))}
            for vertex in common:
                links.setdefault(vertex, []).append({here, after})
    return set(faces_at_edge.values()) == {2} and all(_joined(arcs) for arcs in links.values())


def _joined(arcs):
    """Whether sets are one when those with a common element are put together."""
    arcs = list(arcs)
    ring = arcs.pop()
    while arcs:
        near = [arc for arc in arcs if arc & ring]
        if not near:
            return False
        arcs = [arc for arc in arcs if not arc & ring]
        ring = ring.union(*near)
    return True


class _Same:
    """A shape by what it is, whatever its orientation."""

    def __init__(self, shape):
        self.shape = shape

    def __hash__(self):
        return self.shape.hashCode()

    def __eq__(self, other):
        return self.shape.isSame(other.shape)


def _is_convex(solid):
    """Whether the middles between points of its surface are inside, for some 4000 pairs."""
    points = np.array([tuple(p) for p in solid.tessellate(0.5)[0]])
    rng = np.random.default_rng(0)
    for _ in range(4000):
        a, b = points[rng.integers(len(points), size=2)]
        if not solid.isInside(Vector(*((a + b) / 2)), 1e-3, True):
            return False
    return True


def genus_of(solid):
    """Handles of all shells together, from the Euler characteristic of the CAD's own cells."""
    handles = 0
    for shell in solid.Shells:
        faces = sum(2 - len(face.Wires) for face in shell.Faces)       # Euler characteristic of a face: 2 - boundaries
        edges = sum(not edge.Degenerated for edge in shell.Edges)
        handles += (2 - _euler(shell, faces, edges)) // 2
    return handles


def _euler(shell, faces, edges):
    """V - E + F of a shell; a seam or a pole is in V and E and cuts its face to a disc."""
    return len(shell.Vertexes) - edges + faces
