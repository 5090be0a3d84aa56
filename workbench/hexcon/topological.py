# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of topology only: known everywhere by one mark, and kept from solvers by one refusal.

The paper's methods give conforming meshes with the exact boundary whose doublets force some
Jacobians to be zero or negative. CalculiX may solve such a mesh in silence, and wrongly: it looks
at its own integration points alone. So nothing here relies on the solver to notice.
"""
from hexcon_native import TOPOLOGICAL_METHODS

from .errors import FaultCode, ToolError

MEANING = ("topology only: the hexes meet face to face and end in exactly the given quads, but "
           "some of their Jacobians are zero or negative; no solver must be given this mesh")
PROPERTY = "Topological"  # of a document object; saved documents name it: never rename it
BY_KEYWORD = "pass allow_topological=True"
BY_OPTION = "give --allow-topological"


def is_topological(mesh):
    """True for a mesh of a topological method, and for a document object that holds one.

    What has no such mark (arrays, a mesh read from a file, somebody's object) is not topological.
    """
    return bool(getattr(mesh, "topological", False) or getattr(mesh, PROPERTY, False))


def refuse_topological(mesh, allowed, override=BY_KEYWORD):
    """Raise ToolError(TOPOLOGICAL_MESH) for a topological mesh, unless the caller allowed it.

    mesh      a mesh, or a document object that holds one
    allowed   what the caller's allow_topological says
    override  how it can be allowed, for the words
    """
    if is_topological(mesh) and not allowed:
        raise _refusal(getattr(mesh, "Label", None) or _of_method(mesh), override)


def refuse_topological_method(method, allowed, override=BY_KEYWORD):
    """As refuse_topological for the mesh that a method would make: before the work, not after."""
    if method in TOPOLOGICAL_METHODS and not allowed:
        raise _refusal(f"a mesh of method {method}", override)


def _of_method(mesh):
    method = getattr(mesh, "method", None)
    return f"this mesh of method {method}" if method else "this mesh"


def _refusal(name, override):
    return ToolError(
        f"{name} is topology only: some of its Jacobians are zero or negative, so CalculiX must "
        f"not be given it; choose method cells, or {override} to get it anyway",
        FaultCode.TOPOLOGICAL_MESH)
