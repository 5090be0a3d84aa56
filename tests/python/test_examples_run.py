# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scripts of examples/ run as their README says, and print what they are there to show.

Those for freecadcmd are run by tests/freecad/test_examples_in_freecad.py, the C program by test_installed_library.py.
"""
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "examples"
IN_FREECAD, IMPORTED = {"solve_in_freecad"}, {"grids"}

# What a script is there to show, as patterns: several of them, in this order.
SHOWN = {
    "batch": [r"^ok     box\.step: \d+ hexes, .* certified", r"^written: box\.inp, box\.vtu, bracket\.inp",
              r"^answer: \(4, 0\)$"],
    "certify": [r"^as it is +<certified>$", r"1 hexes not positive", r"hex 13: its Jacobian is not positive at",
                r"boundary exact: False"],
    "fill_surface": [r"52 quads, genus 0", r"24 hexes by method swept", r"<certified>", r"bit for bit: True"],
    "formats": [r"on 6 CAD faces", *(rf"^\{ending} .* read back: \d+ points, 80 hexes$"
                                     for ending in (".inp", ".msh", ".vtu", ".vtk", ".unv")),
                r"^for solvers: +box\.exo.* box\.re2, box\.specfem3d",
                r"^written only: \.re2, \.specfem3d$"],
    "literature": [r"^schneiders   16 quads", r"smallest    36 hexes, <certified>", r"octahedron    8 quads",
                   r"smallest    40 hexes, <certified>", r"UNFILLABLE_QUAD"],
    "morph": [r"twisted by  90  reached 100%: <certified>", r"twisted by 180  reached 100%: <certified>"],
    "optimize": [r"tangled +\d+ of 512 hexes are inverted", r"optimised +<certified>", r"boundary kept True"],
    "progress_and_cancel": [r"Hexes: untangling", r"Certificate: Jacobians", r"done: <cells mesh",
                            r"cancelled: CANCELLED", r"within 30 seconds: \w+, <certified>"],
    "refusals": ["NOT_CLOSED", "INCONSISTENT_ORIENTATION", "SELF_INTERSECTING", "NOT_DICED", "BAD_ARGUMENT"],
    "solid": [r"424 quads by sweep", r"480 hexes of 20 nodes by swept", r"<certified>",
              r"CAD faces +6", r"part\.inp, \d+"],
    "tetrahedralise": [r"asked +32 triangles, answered 32 tetrahedra", r"mesh +\d+ hexes, <certified>"],
}


def test_every_script_is_run_and_listed():
    scripts = {path.stem for path in FOLDER.glob("*.py")}
    assert scripts == set(SHOWN) | IN_FREECAD | IMPORTED
    listed = set(re.findall(r"\]\((\w+)\.py\)", (FOLDER / "README.md").read_text(encoding="utf-8")))
    assert listed == scripts - IMPORTED


@pytest.mark.parametrize("name", SHOWN)
def test_example(name, tmp_path):
    path = os.pathsep.join([str(ROOT), str(ROOT / "workbench")])
    done = subprocess.run([sys.executable, str(FOLDER / f"{name}.py")], cwd=tmp_path,
                          env={**os.environ, "PYTHONPATH": path}, stdin=subprocess.DEVNULL, capture_output=True,
                          text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    rest = done.stdout
    for pattern in SHOWN[name]:
        found = re.search(pattern, rest, re.MULTILINE)
        assert found, f"{pattern}: not in what is left of\n{done.stdout}"
        rest = rest[found.end():]
    assert list(tmp_path.iterdir()) == []       # an example leaves nothing behind
