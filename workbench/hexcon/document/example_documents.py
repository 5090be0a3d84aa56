# SPDX-License-Identifier: LGPL-2.1-or-later
"""Examples as ready documents: the surfaces of the literature, and parts to mesh.

These are calls for macros; hexcon.gui.actions has them too.
"""
import os

from hexcon import examples, freecad_compat
from hexcon.errors import FaultCode, ToolError
from hexcon.objects import quad_surface

PARTS = ("box", "wedge", "bracket", "shaft_segment")
EXAMPLES = PARTS + tuple(examples.ABOUT)  # example_command.py names them too: it works without the core


def open_example(name):
    """A new document with one example, selected: a solid, or a quad surface; returns the object.

    name  one of EXAMPLES. Raises ToolError: BAD_OPTION for another, FILE_IO where HexCon's
    folder resources is missing; then there is no new document.
    """
    if name not in EXAMPLES:
        raise ToolError(f"there is no example {name!r}; there are {', '.join(EXAMPLES)}", FaultCode.BAD_OPTION)
    load = _load_part(name) if name in PARTS else _load_surface(name)
    app = freecad_compat.freecad()
    document = app.newDocument(name.replace("-", "_"))
    with freecad_compat.transaction(document, "Example"):
        made = load(document)
    document.recompute()
    if made.ViewObject is not None:
        _show(made)
    return made


def _load_part(name):
    """Function of a document that adds the part; the file is read before."""
    path = os.path.join(os.path.dirname(examples.FOLDER), f"{name}.step")
    if not os.path.isfile(path):
        raise ToolError(f"there is no file {path}; HexCon's folder resources belongs beside its folder "
                        "workbench", FaultCode.FILE_IO)
    shape = freecad_compat.freecad_module("Part").read(path)

    def add(document):
        solid = document.addObject("Part::Feature", name.capitalize())
        solid.Shape = shape
        return solid
    return add


def _load_surface(name):
    mark, job = quad_surface.job_of(example=name)
    surface = job(None)
    return lambda document: quad_surface.add_quad_surface(document, surface, mark, {"example": name}, "Surface")


def _show(made):
    """Seen from a corner, fitted, and selected for the next command."""
    import FreeCADGui
    freecad_compat.see_all(FreeCADGui.getDocument(made.Document.Name).ActiveView)
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(made)
