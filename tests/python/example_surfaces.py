# SPDX-License-Identifier: LGPL-2.1-or-later
"""The generators behind resources/examples/surfaces. After a change of one, write the files anew:

    PYTHONPATH=.:workbench:tests/python python3 tests/python/example_surfaces.py
"""
import io
import pathlib
from types import SimpleNamespace

from paper_surfaces import eppsteins_cube, quadrilateral_octahedron
from surfaces import schneiders_pyramid

from hexcon.examples import ABOUT, FOLDER
from hexcon.files.surfaces import write_obj

# The paper's cubes of 16 and 18 quads have sides of 2 and 3, those of 20 and 22 sides of 3 and 4. Of the splits of
# a side of 2, "2ob" has the fewest flat corners, and with two such sides beside each other the face doublet.
GENERATORS = {
    "schneiders": schneiders_pyramid,
    "octahedron": quadrilateral_octahedron,
    "eppstein-16": lambda: eppsteins_cube(("3", "2ob", "2ob", "2ob")),
    "eppstein-18": lambda: eppsteins_cube(("3", "3", "3", "2ob")),
    "eppstein-20": lambda: eppsteins_cube(("4", "3", "3", "3")),
    "eppstein-22": lambda: eppsteins_cube(("4", "4", "4", "3")),
}


def text_of(name):
    """The whole text of an example's file."""
    points, quads = GENERATORS[name]()
    stream = io.StringIO()
    write_obj(stream, SimpleNamespace(points=points, quads=quads), (
        "SPDX-License-Identifier: LGPL-2.1-or-later", ABOUT[name],
        "Made by tests/python/example_surfaces.py; counter-clockwise seen from outside"))
    return stream.getvalue()


if __name__ == "__main__":
    for made in GENERATORS:
        pathlib.Path(FOLDER, f"{made}.obj").write_text(text_of(made), encoding="utf-8")
