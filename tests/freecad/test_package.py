# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD's own parser, which the Addon Manager asks, reads in package.xml."""
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[2]


def test_package_is_read_by_freecad(freecad):
    found = freecad.Metadata(str(ROOT / "package.xml"))
    assert found.Name == "HexCon" and found.FreeCADMin == "0.20.0"
    assert (ROOT / found.Icon).is_file()
    (workbench,) = found.Content["workbench"]
    assert workbench.Classname == "HexConWorkbench" and "class HexConWorkbench" in (ROOT / "InitGui.py").read_text()
    needs = {row["package"]: row.get("optional") for row in found.Depend}     # 0.20 does not know which are optional
    optional = {"fem": False, "numpy": False, "scipy": False, "gmsh": False, "meshio": True, "vtk": True}
    assert needs == (dict.fromkeys(optional) if needs["fem"] is None else optional)
