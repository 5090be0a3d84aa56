# SPDX-License-Identifier: LGPL-2.1-or-later
"""CalculiX's hexahedra to choose from. C3D8I is none of them: it fails the patch test on crooked hexes."""
import numpy as np

from hexcon.errors import FaultCode, ToolError

ELEMENT_TYPES = {"C3D8": 1, "C3D8R": 1, "C3D20": 2, "C3D20R": 2}
"""name: order. R: reduced integration, which is cheaper and less stiff; C3D8R has modes that nothing resists."""

PROPERTY = "ElementType"    # of mesh objects of a document
AUTOMATIC = "automatic"
CHOICES = (AUTOMATIC, *ELEMENT_TYPES)

_OPPOSITE = ((0, 1), (2, 4), (3, 5))    # rows of hexahedron.FACES


def default_type(elements):
    """Of Elements: C3D8; of order 2 C3D20R, which has the smaller error (docs/measured.md), if every hex has
    neighbours in two of its three directions, else C3D20: rows of single hexes have modes that C3D20R does not
    resist."""
    if elements.order == 1:
        return "C3D8"
    free = np.zeros((len(elements.hexes), 6), bool)
    free[elements.hex_of_quad, elements.side_of_quad] = True
    joined = sum((~(free[:, a] & free[:, b])).astype(int) for a, b in _OPPOSITE)
    return "C3D20R" if (joined >= 2).all() else "C3D20"


def element_type(name, order):
    """A type that is asked for, one of ELEMENT_TYPES, if it fits the mesh's order; None stays None: see default_type.

    Raises ToolError BAD_OPTION for another, or one of another order."""
    if name is None:
        return None
    if name not in ELEMENT_TYPES:
        raise ToolError(f"there is no element type {name!r} for hexes here; there are {', '.join(ELEMENT_TYPES)}",
                        FaultCode.BAD_OPTION)
    if ELEMENT_TYPES[name] != order:
        fitting = ", ".join(one for one, its in ELEMENT_TYPES.items() if its == order)
        raise ToolError(f"{name} has order {ELEMENT_TYPES[name]}, the mesh has order {order}: take {fitting}, or "
                        "another order", FaultCode.BAD_OPTION)
    return name


def chosen_type(mesh_object):
    """The type that a mesh object of a document asks for; None: the default, or no such object."""
    chosen = getattr(mesh_object, PROPERTY, AUTOMATIC)
    return None if chosen == AUTOMATIC else chosen
