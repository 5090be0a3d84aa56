# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of topology only: told by every face of the workbench, kept from every solver.

The meshes are certified ones that are called topological, so that what is tested is the word alone.
"""
import json
import pathlib
import sys

import meshio
import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))
from hex_grids import block  # noqa: E402

import hexcon  # noqa: E402
import hexcon_native  # noqa: E402
from hexcon import batch, calculix, cli, files, meshing  # noqa: E402
from hexcon.errors import FaultCode  # noqa: E402
from hexcon.femmesh import elements_of  # noqa: E402
from hexcon.quads import QuadSurface  # noqa: E402
from hexcon.topological import is_topological  # noqa: E402

WEDGE = str(ROOT / "resources" / "examples" / "wedge.step")
BARE = ("msh", "vtu", "vtk", "unv", "med")


def box_surface():
    """(points, quads) of a box of 3 x 2 x 2."""
    mesh = block(3, 2, 2, (3.0, 2.0, 2.0))
    used, quads = np.unique(mesh.quads, return_inverse=True)
    return mesh.points[used], quads.reshape(-1, 4)


def topological(mesh, method="pyramid"):
    """The mesh under another name."""
    mesh.method, mesh.topological = method, True
    return mesh


@pytest.fixture
def given(tmp_path):
    """Path of a quad surface."""
    points, quads = box_surface()
    path = tmp_path / "box.obj"
    meshio.Mesh(points, [("quad", quads)]).write(str(path))
    return str(path)


@pytest.fixture
def pretended(monkeypatch):
    """The core answers the topological methods with a mesh that is called so; a list of the
    options it was given."""
    real, calls = hexcon_native.mesh, []

    def mesh(points, quads, method="auto", *, certify=True, pairing="all", **options):
        calls.append(dict(options, method=method, certify=certify, pairing=pairing))
        if method not in hexcon_native.TOPOLOGICAL_METHODS:
            return real(points, quads, method, **options)
        made = topological(real(points, quads, "auto", **options), method)
        if not certify:
            made.certificate = made.quality = None
        return made
    monkeypatch.setattr(hexcon_native, "mesh", mesh)
    return calls


def refused(call, *arguments, **options):
    """The words of the refusal, which name the fault, the method and both ways out."""
    with pytest.raises(hexcon.ToolError) as caught:
        call(*arguments, **options)
    assert caught.value.code is FaultCode.TOPOLOGICAL_MESH
    for word in ("topology only", "zero or negative", "CalculiX", "choose method cells"):
        assert word in str(caught.value)
    return str(caught.value)


# ------------------------------------------------------------------------------------------ files

@pytest.mark.parametrize("ending", ["inp", "FCStd"])
def test_a_file_for_solvers_is_refused(tmp_path, ending):
    words = refused(hexcon.write, topological(block(2, 1, 1)), tmp_path / f"x.{ending}")
    assert "method pyramid" in words and "allow_topological=True" in words
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("ending", BARE)
def test_a_bare_mesh_is_to_look_at(tmp_path, ending):
    mesh = topological(block(2, 1, 1))
    hexcon.write(mesh, tmp_path / f"x.{ending}")
    assert np.array_equal(files.read_mesh(tmp_path / f"x.{ending}").hexes, mesh.hexes)


@pytest.mark.parametrize("order", [1, 2])
def test_a_deck_by_override_says_what_it_is(tmp_path, order):
    mesh = topological(block(2, 1, 1))
    hexcon.write(mesh, tmp_path / "x.inp", order=order, allow_topological=True)
    assert (tmp_path / "x.inp").read_text().count("TOPOLOGICAL") == 1
    assert len(files.read_mesh(tmp_path / "x.inp").hexes) == 2
    assert elements_of(elements_of(mesh, 2), 1).topological


@pytest.mark.parametrize("override", [False, True])
def test_other_meshes_know_nothing_of_it(tmp_path, override):
    mesh = block(2, 1, 1)
    assert not hasattr(mesh, "topological") and not is_topological(mesh)
    hexcon.write(mesh, tmp_path / "x.inp", allow_topological=override)
    mesh.topological = False
    hexcon.write(mesh, tmp_path / "y.inp", allow_topological=override)
    assert (tmp_path / "x.inp").read_bytes() == (tmp_path / "y.inp").read_bytes()
    assert "TOPOLOGICAL" not in (tmp_path / "x.inp").read_text()


PULL = {"Face2": (1.0, 0.0, 0.0)}


def test_a_full_deck():
    mesh = topological(block(2, 1, 1))
    refused(calculix.static_deck, mesh)
    assert "** TOPOLOGICAL" in calculix.static_deck(mesh, force=PULL, allow_topological=True)
    mesh.topological = False
    assert "TOPOLOGICAL" not in calculix.static_deck(mesh, force=PULL)


# ---------------------------------------------------------------------------------------- meshing

def test_options_reach_the_core_and_the_report_says_it(pretended):
    points, quads = box_surface()
    made = hexcon.mesh_surface(points, quads, "geode", pairing="fewest", certify=False)
    assert (pretended[-1]["pairing"], pretended[-1]["certify"]) == ("fewest", False)
    assert made.report["topological"] is True and made.certificate is None
    surface = QuadSurface(points, quads, np.zeros(len(quads), np.int64), "given", [])
    assert meshing.mesh_quad_surface(surface, "geode", pairing="none").topological
    assert pretended[-1]["pairing"] == "none"
    assert hexcon.mesh_surface(points, quads).report["topological"] is False
    made = hexcon.mesh_solid(WEDGE, 8.0, method="pyramid", pairing="fewest")
    assert made.report["topological"] is True and pretended[-1]["pairing"] == "fewest"


# ----------------------------------------------------------------------------------- command line

def run(capsys, *arguments):
    """(exit status, standard output, standard error) of the command line."""
    status = cli.main(list(map(str, arguments)))
    return (status, *capsys.readouterr())


def test_the_command_line_says_it(pretended, given, tmp_path, capsys):
    command = ("mesh", given, "--method", "pyramid", "-o", tmp_path / "x.vtu")
    status, said, errors = run(capsys, *command)
    assert status == 0 and not errors
    assert "topological   topology only: " in said and "method pyramid: " in said
    assert "hexes a quad" in said and "no solver must be given" in said
    told = json.loads(run(capsys, *command, "--json")[1])
    assert told["topological"] is True and told["report"]["topological"] is True
    told = json.loads(run(capsys, "mesh", given, "-o", tmp_path / "x.inp", "--json")[1])
    assert told["topological"] is False and told["certificate"]["certified"]
    assert "topological" not in run(capsys, "mesh", given, "-o", tmp_path / "x.inp")[1]


@pytest.mark.parametrize("out", ["x.inp", "x.FCStd"])
def test_the_command_line_refuses_before_it_works(pretended, given, tmp_path, capsys, out):
    command = ("mesh", given, "--method", "geode-alt", "-o", tmp_path / "x.vtu", "-o",
               tmp_path / out)
    status, said, _ = run(capsys, *command, "--json")
    told = json.loads(said)
    assert status == 1 and told["code"] == "TOPOLOGICAL_MESH" and not pretended
    assert "method geode-alt" in told["error"] and "--allow-topological" in told["error"]
    assert [p.name for p in tmp_path.iterdir()] == ["box.obj"]


def test_the_override_of_the_command_line(pretended, given, tmp_path, capsys):
    out = tmp_path / "x.inp"
    status, said, _ = run(capsys, "mesh", given, "--method", "pyramid", "--allow-topological",
                          "-o", out)
    assert status == 0 and "topological   " in said
    assert "** TOPOLOGICAL" in out.read_text()


def test_pairing_is_passed_on_only_where_it_is_asked_for(monkeypatch, given, tmp_path, capsys):
    asked, real = [], meshing.mesh_quad_surface

    def mesh(surface, pairing=None, **options):
        asked.append(pairing)
        return real(surface, **options)
    monkeypatch.setattr(cli.commands, "mesh_quad_surface", mesh)
    for words in ((), ("--pairing", "all"), ("--pairing", "fewest"), ("--pairing", "none")):
        assert run(capsys, "mesh", given, "-o", tmp_path / "x.vtu", *words)[0] == 0
    assert asked == [None, None, "fewest", "none"]
    with pytest.raises(SystemExit) as stop:
        cli.main(["mesh", given, "-o", "x.vtu", "--pairing", "some"])
    assert stop.value.code == 2


def test_a_solid_is_not_solved(pretended, capsys):
    command = ("solve", WEDGE, "--size", 8, "--fixed", "Face1", "--force", "Face2=0,0,-1", "--method", "pyramid")
    status, _, errors = run(capsys, *command)
    assert status == 1 and "[TOPOLOGICAL_MESH]" in errors and not pretended
    status, said, errors = run(capsys, *command, "--allow-topological", "--json")
    assert status == 0, errors
    assert json.loads(said)["topological"] is True


def test_a_file_without_the_mark_is_not_solved_either(tmp_path, capsys):
    """Files do not keep it: the hexes are looked at."""
    mesh = topological(block(3, 1, 1))
    mesh.points[[1, 2]] = mesh.points[[2, 1]]  # no hex is positive any more
    hexcon.write(mesh, tmp_path / "x.vtu")
    command = ("solve", tmp_path / "x.vtu", "--fixed", "Face1", "--force", "Face2=0,0,-1", "--json")
    status, said, _ = run(capsys, *command)
    told = json.loads(said)
    assert status == 1 and told["code"] == "BAD_MESH" and told["elements"]
    assert "not proved positive" in told["error"]
    for override in ("--allow-topological", "--allow-uncertified"):  # CalculiX has its own say
        _, said, _ = run(capsys, *command, override)
        assert json.loads(said).get("code") != "BAD_MESH"


# --------------------------------------------------------------------------- what was not checked

def test_the_command_line_copes_with_what_was_not_checked(pretended, given, tmp_path, capsys,
                                                          monkeypatch):
    real = cli.commands.mesh_quad_surface
    monkeypatch.setattr(cli.commands, "mesh_quad_surface",
                        lambda surface, **options: real(surface, certify=False, **options))
    command = ("mesh", given, "--method", "pyramid", "-o", tmp_path / "x.vtu")
    _, said, _ = run(capsys, *command)
    assert "quality       not checked" in said and "certificate   not checked" in said
    told = json.loads(run(capsys, *command, "--json")[1])
    assert told["certificate"] is None and told["quality"] is None


# ------------------------------------------------------------------------------------------ batch

@pytest.fixture
def parts(tmp_path):
    """A folder with one part."""
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "wedge.step").write_bytes(pathlib.Path(WEDGE).read_bytes())
    return tmp_path / "parts"


def test_the_batch_refuses_before_it_works(pretended, parts, capsys):
    assert batch.main([str(parts), "--size", "8", "--method", "pyramid"]) == 2
    assert "--allow-topological" in capsys.readouterr().err and not pretended
    assert [p.name for p in parts.iterdir()] == ["wedge.step"]


def test_the_batch_by_override_and_for_bare_meshes(pretended, parts, capsys):
    command = [str(parts), "--size", "8", "--method", "pyramid"]
    assert batch.main([*command, "--allow-topological", "--pairing", "none"]) == 0
    assert ", topological (not for solving), " in capsys.readouterr().out
    assert pretended[-1]["pairing"] == "none"
    assert "** TOPOLOGICAL" in (parts / "hexcon" / "wedge.inp").read_text()
    assert batch.main([*command, "--write", ".vtu"]) == 0
    done, line = batch.mesh_part(str(parts / "wedge.step"), [], 8.0, method="geode", certify=False)
    assert done and "not checked, topological" in line
