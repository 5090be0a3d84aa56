# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD for tests. Where it is missing they fail: a skipped test proves nothing."""
import pathlib
import sys

import pytest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))  # hex_grids


@pytest.fixture(scope="session")
def freecad():
    """The FreeCAD module (FREECAD_LIB and FREECAD_HOME are respected)."""
    from hexcon import freecad_compat
    return freecad_compat.freecad()


@pytest.fixture
def doc(freecad):
    """An empty document, closed afterwards."""
    made = freecad.newDocument("HexConTest")
    name = made.Name
    yield made
    if name in freecad.listDocuments():
        freecad.closeDocument(name)


@pytest.fixture
def box_in(doc):
    """Function: a Part::Box of the given size in the test's document."""
    def make(size):
        solid = doc.addObject("Part::Box", "Box")
        solid.Length, solid.Width, solid.Height = size
        doc.recompute()
        return solid
    return make


@pytest.fixture
def cylinder_in(doc):
    """Function: a Part::Cylinder; its faces are 1 side, 2 bottom, 3 top."""
    def make(radius, height):
        solid = doc.addObject("Part::Cylinder", "Cylinder")
        solid.Radius, solid.Height = radius, height
        doc.recompute()
        return solid
    return make
