# SPDX-License-Identifier: LGPL-2.1-or-later
"""Method subdivided-triangles: triangles by gmsh, each cut into three quads."""
from .corner_room import GOOD, corner_room, room_words
from .detail_sizes import detail_sizes
from .fault import WorkerFault
from .generate import collect, generate

METHOD = "subdivided-triangles"
# What the bounds of the local size are multiplied with, one after the other; None: the same size everywhere.
SCALES = (None, 2.0, 1.4, 1.0, 0.7)
# gmsh's numbers of Mesh.Algorithm. The frontal one makes the better triangles, but does not end on sharp cones.
FRONTAL, MESH_ADAPT = 6, 1
CROSSING = 2.4      # times the size that thin walls allow


def triangle_surface(solid, size, link, sizes=None, care=0):
    """dict with points (V,3), quads (n,4), faces (n,), notes.

    Where the even size leaves corners without room, elements are smaller at curves, short edges and narrow places;
    the first good surface is taken, or the best. link: a Link; sizes: the SizeField wanted, None: of one size; care: how many of SCALES are left out. Raises WorkerFault NOT_ALL_QUAD, TOOL_FAILED.
    """
    best, last, notes = None, None, []
    scales = SCALES[min(max(care, int(_cross(solid, size))), len(SCALES) - 1):]
    for k, scale in enumerate(scales):
        link.progress("mesh", k / len(scales))
        name = "the even size" if scale is None else f"{scale:g} times the sizes of curves and gaps"
        try:
            local = sizes.scaled(2.0) if sizes is not None and not sizes.even else None
            if scale is not None:
                local, _ = detail_sizes(solid, 2.0 * size, scale, local)
            mesh = _tried(solid, size, local, link, name)
        except WorkerFault as fault:
            last = fault
            continue
        room = corner_room(mesh["points"], mesh["quads"])
        if best is None or room > best[0]:
            best = room, mesh, local
        if room >= GOOD:
            break
        if best[1] is mesh and room > 0.0:
            link.keep(_noted(*best, notes, size))
        notes.append(f"{METHOD}: with {name} {room_words(room)}")
    if best is None:
        raise last
    return _noted(*best, notes, size)


def _cross(solid, size):
    """Whether triangles of the even size cut through a thin wall."""
    return 2.0 * size > CROSSING * detail_sizes(solid, 2.0 * size)[1]


def _tried(solid, size, local, link, name):
    algorithm = FRONTAL if link.risk(f"{METHOD} by algorithm {FRONTAL}") else MESH_ADAPT
    if algorithm == MESH_ADAPT and not link.risk(f"{METHOD} with {name}"):
        raise WorkerFault("TOOL_FAILED", f"gmsh crashed, or did not end, on {METHOD} with {name}")
    try:
        generate(solid, size, METHOD, algorithm, local=local)
    except Exception as error:      # gmsh raises plain Exception
        raise WorkerFault("TOOL_FAILED", f"gmsh: {error}") from error
    triangles, mesh = collect(solid, cut=True)
    if triangles:
        raise WorkerFault("NOT_ALL_QUAD", f"{triangles} triangles are left")
    return mesh


def _noted(room, mesh, local, notes, size):
    smaller = [] if local is None else [f"{METHOD}: smaller where the solid is curved or narrow, down to "
                                        f"{local.least / 2:.3g} instead of {size:.4g}: {room_words(room)}"]
    mesh["notes"] = notes + smaller + [f"{METHOD}: {len(mesh['quads'])} quads"]
    return mesh
