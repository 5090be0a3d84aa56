# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD's own parser, which the Addon Manager asks, reads in package.xml."""
import os
import pathlib
import sys

import pytest

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


def test_package_is_read_by_the_addon_manager(freecad, monkeypatch):
    """FreeCAD 1.0 and later have a parser of their own there."""
    folders = [os.path.join(home, "Mod", "AddonManager") for home in (freecad.getHomePath(), "/usr/share/freecad")]
    folder = next((one for one in folders if os.path.exists(os.path.join(one, "addonmanager_metadata.py"))), None)
    if folder is None:
        assert freecad.Version()[0] == "0"
        pytest.skip("this FreeCAD's Addon Manager asks FreeCAD")
    monkeypatch.setattr(sys, "path", [*sys.path, folder])
    from addonmanager_metadata import DependencyType, MetadataReader
    found = MetadataReader.from_file(str(ROOT / "package.xml"))
    assert found.name == "HexCon" and found.pythonmin.version_as_list[:2] == [3, 11] and "FEM" in found.tag
    assert found.freecadmin.version_as_list[:2] == [0, 20] and (ROOT / found.license[0].file).is_file()
    (workbench,) = found.content["workbench"]
    assert workbench.classname == "HexConWorkbench" and (ROOT / workbench.icon).is_file()
    kinds = {need.package: (need.dependency_type, need.optional) for need in found.depend}
    python = DependencyType.python
    assert kinds == {"fem": (DependencyType.internal, False), "numpy": (python, False), "scipy": (python, False),
                     "gmsh": (python, False), "meshio": (python, True), "vtk": (python, True)}
