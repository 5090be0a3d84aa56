# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scripts for freecadcmd: the batch over a folder of parts, and what `make run` runs."""
import os
import pathlib
import re
import shutil
import subprocess

import meshio
import pytest

from hexcon import batch
from hexcon.files import read_mesh

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "resources" / "examples"


def in_freecadcmd(script, *arguments):
    """(exit status, lines that are no banner, standard error) of a script."""
    done = subprocess.run([os.environ.get("FREECADCMD") or "freecadcmd", str(ROOT / script), "--",
                           *map(str, arguments)], stdin=subprocess.DEVNULL, capture_output=True,
                          encoding="utf-8", check=False)
    _, _, said = done.stdout.rpartition("##\n")  # FreeCAD's banner ends in a picture
    return done.returncode, [line for line in said.splitlines() if line.strip()], done.stderr


def run_batch(*arguments):
    return in_freecadcmd("resources/batch/mesh_folder.py", *arguments)


def hexes_of(line):
    """{part: hexes} of a line of the batch."""
    name, count = re.match(r"ok     (\S+): (\d+) hexes, .* certified, [\d.]+ s$", line).groups()
    return {name: int(count)}


@pytest.fixture
def parts(tmp_path):
    """A folder with two parts, and a file that is none."""
    for name in ("box.step", "wedge.step"):
        shutil.copy(EXAMPLES / name, tmp_path)
    (tmp_path / "notes.txt").write_text("not for the batch\n")
    return tmp_path


def test_a_part_that_fails_fails_alone(freecad, parts):
    (parts / "garbage.step").write_text("this is no CAD file\n")
    status, lines, _ = run_batch(parts, "--size", 5, "--write", ".inp", "--write", ".FCStd")
    assert status == 1
    box, garbage, wedge, summary = lines
    counts = {**hexes_of(box), **hexes_of(wedge)}
    assert garbage.startswith("FAILED garbage.step: ") and garbage.endswith("[FILE_FORMAT]")
    assert summary == f"2 done, 1 failed of 3 parts in {parts}; results in {parts / 'hexcon'}"
    assert sorted(p.name for p in (parts / "hexcon").iterdir()) == [
        "box.FCStd", "box.inp", "wedge.FCStd", "wedge.inp"]
    for part, hexes in counts.items():
        result = parts / "hexcon" / part
        assert len(read_mesh(result.with_suffix(".inp")).hexes) == hexes
        assert_document(freecad, result.with_suffix(".FCStd"), hexes)


def assert_document(freecad, path, hexes):
    """A document with the mesh, linked to its solid."""
    from hexcon.freecad_compat import solid_of_mesh_object
    document = freecad.openDocument(str(path))
    try:
        mesh, = [o for o in document.Objects if o.isDerivedFrom("Fem::FemMeshObject")]
        assert mesh.FemMesh.HexaCount == hexes
        assert len(solid_of_mesh_object(mesh).Shape.Solids) == 1
    finally:
        freecad.closeDocument(document.Name)


def test_all_parts_done(parts):
    status, lines, errors = run_batch(parts, "--size", 8, "--out", parts / "deep" / "down",
                                      "--order", 2)
    assert status == 0 and not errors
    assert [line.split()[0] for line in lines] == ["ok", "ok", "2"]
    assert read_mesh(parts / "deep" / "down" / "wedge.inp").order == 2


@pytest.mark.parametrize("arguments,words", [
    (("{parts}",), "--size"), (("{parts}/none", "--size", "5"), "there is no folder"),
    (("{parts}", "--size", "5", "--write", ".xyz"), ".xyz"),
    (("{parts}", "--size", "5", "--method", "swept", "--layers", "2"), "only for method cells"),
    (("{parts}", "--size", "5", "--out", "{parts}/notes.txt"), "cannot make")])
def test_wrong_usage(parts, arguments, words):
    before = sorted(parts.iterdir())
    status, lines, errors = run_batch(*(word.format(parts=parts) for word in arguments))
    assert status == 2 and words in errors and "Traceback" not in errors and not lines
    assert sorted(parts.iterdir()) == before


def test_method_and_layers(parts, capsys):
    (parts / "wedge.step").unlink()
    assert batch.main([str(parts), "--size", "10", "--method", "cells", "--layers", "1"]) == 0
    line = capsys.readouterr().out.splitlines()[0]
    assert " hexes, cells, " in line and hexes_of(line)["box.step"] > 24 * 31


def test_no_parts(tmp_path):
    status, lines, _ = run_batch(tmp_path, "--size", 5)
    assert status == 1 and lines[-1].startswith("0 done, 0 failed of 0 parts")


def test_parts_of_one_name_keep_both_results(parts, capsys):
    shutil.copy(parts / "box.step", parts / "box.STP")
    assert batch.main([str(parts), "--size", "10"]) == 0
    assert len(capsys.readouterr().out.splitlines()) == 4
    assert sorted(p.name for p in (parts / "hexcon").iterdir()) == [
        "box.STP.inp", "box.step.inp", "wedge.inp"]


def test_a_part_is_never_overwritten(freecad, tmp_path, capsys):
    from hexcon import mesh_solid, write
    write(mesh_solid(str(EXAMPLES / "box.step"), 10.0), tmp_path / "part.FCStd")
    before = (tmp_path / "part.FCStd").read_bytes()
    folder = str(tmp_path)
    assert batch.main([folder, "--size", "5", "--write", ".FCStd", "--out", folder]) == 1
    assert "overwrite" in capsys.readouterr().out
    assert (tmp_path / "part.FCStd").read_bytes() == before


def test_a_defect_of_ours_costs_one_part(parts, monkeypatch, capsys):
    real = batch.mesh_solid

    def broken(path, *arguments, **options):
        if "box" in path:
            raise ZeroDivisionError("two\nlines")
        return real(path, *arguments, **options)
    monkeypatch.setattr(batch, "mesh_solid", broken)
    assert batch.main([str(parts), "--size", "8"]) == 1
    said = capsys.readouterr()
    assert said.out.startswith("FAILED box.step: ZeroDivisionError: two lines\nok     wedge.step")
    assert "Traceback" in said.err


def test_what_make_run_runs(freecad, tmp_path):
    status, lines, errors = in_freecadcmd("resources/examples/run_bracket.py", tmp_path)
    assert status == 0 and "Traceback" not in errors
    said = "\n".join(lines)
    for word in ("every Jacobian proved positive", "von Mises",
                 *(str(tmp_path / f"bracket{e}") for e in (".FCStd", ".inp", ".vtu", ".png"))):
        assert word in said
    assert float(re.search(r"scaled Jacobian min ([\d.]+)", said).group(1)) > 0.7
    hexes, nodes = map(int, re.search(r"(\d+) hexes, (\d+) nodes, order 2", said).groups())
    written = read_mesh(tmp_path / "bracket.inp")
    assert (len(written.hexes), len(written.points), written.order) == (hexes, nodes, 2)
    moved = meshio.read(tmp_path / "bracket.vtu").point_data["displacement"]
    told = float(re.search(r"deflection +([\d.]+) mm", said).group(1))
    assert (moved ** 2).sum(axis=1).max() ** 0.5 == pytest.approx(told, rel=1e-3)
    assert (tmp_path / "bracket.png").read_bytes().startswith(b"\x89PNG")
    assert_solved(freecad, tmp_path / "bracket.FCStd", nodes)


def assert_solved(freecad, path, nodes):
    document = freecad.openDocument(str(path))
    try:
        result, = [o for o in document.Objects if o.isDerivedFrom("Fem::FemResultObject")]
        assert len(result.DisplacementVectors) == nodes
    finally:
        freecad.closeDocument(document.Name)
