# SPDX-License-Identifier: LGPL-2.1-or-later
"""One surface, one method: the core's mesh, with gmsh at hand for tetrahedra inside."""
import time

import hexcon_native

from ..errors import ToolError
from ..tetrahedra import tetrahedralise
from ..topological import is_topological
from .progress import deadline_of, raising

# How fast tetrahedra inside grow, up to this many triangles and beyond: slow growth makes a fifth
# more hexes, somewhat better ones, and takes twice as long to improve.
_FINE, _FINE_TRIANGLES, _COARSE = 0.5, 1000, 1.0


def mesh_surface(points, quads, method="auto", *, timeout=120.0, progress=None, **options):
    """Fill a quad surface; arguments, result and errors as hexcon_native.mesh.

    The mesh of a topological method says so in report["topological"]; with certify=False its
    certificate and quality are None.
    Where cells or diced need tetrahedra inside, gmsh is asked for them (timeout: seconds for each call), as
    long as it is there; report["gmsh"] lists what it said where it found none. A budget ends its work, too.
    """
    said = []
    mesher = _gmsh_tetrahedra(timeout, deadline_of(options), progress, said)
    mesh = hexcon_native.mesh(points, quads, method, progress=progress, tetrahedralise=mesher, **options)
    if said:
        mesh.report["gmsh"] = said
    mesh.report["topological"] = is_topological(mesh)
    return mesh


def _gmsh_tetrahedra(timeout, deadline, progress, said):
    """A tetrahedral mesher for the core, which goes on without where gmsh finds nothing."""
    def fill(points, triangles):
        coarsening = _FINE if len(triangles) <= _FINE_TRIANGLES else _COARSE
        left = timeout if deadline is None else min(timeout, deadline - time.monotonic())
        if left <= 0.0:
            return None     # the core finds out by itself
        try:
            filled, tetrahedra = tetrahedralise(points, triangles, timeout=left, coarsening=coarsening,
                                                deadline=deadline, progress=_as_one_stage(progress))
        except ToolError as fault:
            said.append(str(fault))
            return None
        return filled[len(points):], tetrahedra
    return fill


def _as_one_stage(progress):
    """gmsh's stages are not the surface's of the same names: they are all "tetrahedra inside"."""
    report = raising(progress)
    return report and (lambda _, fraction: report("tetrahedra inside", fraction))
