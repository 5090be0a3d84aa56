# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading by libraries, where FreeCAD is the caller, and where it must read itself."""
import json
import os
import pathlib
import resource
import subprocess

import numpy as np
from hex_grids import block

from hexcon import files
from hexcon.femmesh import from_femmesh
from hexcon.files import solid
from hexcon.quads import surface_from_solid

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = """
import json, os, sys
sys.path[:0] = {path!r}
found = {{"executable": sys.executable}}
try:
    from hexcon import files
    from hexcon.quads import surface_from_file, surface_from_solid
    for name, read in (("m.vtu", files.read_mesh), ("m.med", files.read_mesh), ("m.msh", surface_from_file),
                       ("cut.vtk", surface_from_file), ("m.FCStd", lambda path: surface_from_solid(path, 1.0))):
        try:
            found[name] = len(read(os.path.join({folder!r}, name)).quads)
        except Exception as fault:
            found[name] = type(fault).__name__ + " " + str(fault)
finally:
    with open(os.path.join({folder!r}, "found.json"), "w") as stream:
        json.dump(found, stream)
    os._exit(0)
"""


def test_freecad_survives(freecad, tmp_path):
    """In FreeCAD's own process: sys.executable is no Python there, and VTK's crash must not be FreeCAD's."""
    import Part
    for ending in ("vtu", "med", "msh"):
        files.write(block(2, 2, 2), tmp_path / f"m.{ending}")
    files.write(block(1, 1, 1), tmp_path / "m.FCStd", solid=Part.makeBox(2, 2, 2))
    (tmp_path / "cut.vtk").write_bytes(b"# vtk DataFile Version 3.0\nq\nASCII\nDATASET POLYDATA\nPOINTS 8 double\n0 0 0\n"
                                       b"POLYGONS 6 30\n4 0 1 2 3\n")
    script = tmp_path / "inside.py"
    script.write_text(PROGRAM.format(path=[str(ROOT), str(ROOT / "workbench")], folder=str(tmp_path)), encoding="utf-8")
    subprocess.run([os.environ.get("FREECADCMD") or "freecadcmd", str(script)], stdin=subprocess.DEVNULL, check=False,
                   stdout=subprocess.DEVNULL)
    found = json.loads((tmp_path / "found.json").read_text(encoding="utf-8"))
    assert "freecad" in os.path.basename(found.pop("executable")).lower()
    assert found.pop("cut.vtk").startswith("ToolError")
    assert found == {"m.vtu": 24, "m.med": 24, "m.msh": 24, "m.FCStd": 24}


def test_freecadcmd_reads_where_python_cannot(freecad, tmp_path, monkeypatch):
    import Part
    files.write(block(1, 1, 1), tmp_path / "m.FCStd", solid=Part.makeBox(2, 2, 2))
    files.write(block(2, 1, 1), tmp_path / "m.med")
    monkeypatch.setenv("FREECAD_LIB", str(tmp_path))
    assert len(surface_from_solid(tmp_path / "m.FCStd", 1.0).quads) == 24
    assert len(files.read_mesh(tmp_path / "m.med").hexes) == 2


def test_the_shape_of_a_file(freecad, tmp_path):
    """As it is written beside a mesh: from STEP, BREP and a document, of several solids where the file is no document."""
    import Part
    box = Part.makeBox(2, 3, 4)
    box.exportStep(str(tmp_path / "box.step"))
    Part.makeCompound([box, Part.makeSphere(1)]).exportBrep(str(tmp_path / "two.brep"))
    files.write(block(1, 1, 1), tmp_path / "m.FCStd", solid=tmp_path / "box.step")
    assert np.isclose(solid.shape_of_file(tmp_path / "m.FCStd").Volume, 24)
    assert len(solid.shape_of_file(tmp_path / "two.brep").Solids) == 2


def test_nodes_of_large_numbers(freecad):
    """20,000,001 and on: arrays of points for each number would be 480 MB. (FreeCAD's own mesh takes 16 bytes for each.)"""
    from hexcon.freecad_compat import fem_module
    mesh, points = fem_module("Fem").FemMesh(), block(1, 1, 1).points
    for k, (x, y, z) in enumerate(points.tolist()):
        mesh.addNode(x, y, z, 20_000_001 + k)
    mesh.addVolume([20_000_001 + k for k in (0, 2, 3, 1, 4, 6, 7, 5)], 1)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    found = from_femmesh(mesh)
    assert len(found.hexes) == 1 and found.hexes.max() == 7
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 100_000
