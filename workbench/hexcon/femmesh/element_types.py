# SPDX-License-Identifier: LGPL-2.1-or-later
"""CalculiX's hexahedra to choose from. C3D8I is none of them: it fails the patch test on crooked hexes."""
from hexcon.errors import FaultCode, ToolError

ELEMENT_TYPES = {"C3D8": 1, "C3D8R": 1, "C3D20": 2, "C3D20R": 2}
"""name: order. R: reduced integration, which is cheaper and less stiff; C3D8R has modes that nothing resists."""

PROPERTY = "ElementType"    # of mesh objects of a document
AUTOMATIC = "automatic"
CHOICES = (AUTOMATIC, *ELEMENT_TYPES)

DEFAULTS = {1: "C3D8", 2: "C3D20"}


def element_type(name, order):
    """The type to be written for a mesh of that order; name: one of ELEMENT_TYPES, or None for the default.

    Raises ToolError BAD_OPTION for another, or one of another order."""
    if name is None:
        return DEFAULTS[order]
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
