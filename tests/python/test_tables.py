# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of methods, stages and faults against all that must follow them: header, stub, pages, words, meshes."""
import ast
import importlib.util
import inspect
import pathlib
import re
from pathlib import Path

import numpy as np
import pytest
from cell_surfaces import merged_hull, sphere
from surfaces import box, o_grid, prism, schneiders_pyramid, upright
from test_shelling import rotated_ball

import hexcon_native as hn
from hexcon import quads
from hexcon.cli import arguments
from hexcon.errors import FaultCode
from hexcon.inspection.stages import counts_of
from hexcon.quads.gmsh_worker.methods import tried_by_auto
from hexcon.stage_words import AROUND, FIGURES, HEX_STAGES, STAGES, hex_stage
from hexcon_native import ErrorCode

ROOT = Path(__file__).parents[2]
WORKER = ROOT / "workbench" / "hexcon" / "quads" / "gmsh_worker"
METHODS = list(hn.METHOD_TABLE.values())
SURFACE_METHODS = list(quads.METHOD_TABLE.values())


def read(path):
    return (ROOT / path).read_text(encoding="utf-8")


def script(name):
    spec = importlib.util.spec_from_file_location(name, ROOT / "scripts" / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


# ------------------------------------------------------------------------------------------- pages and stub

def test_pages_and_stub_are_as_the_tables():
    """Run scripts/make_docs.py where this fails."""
    docs = script("make_docs")
    for name in docs.FILES:
        assert docs.renewed(read(name)) == read(name), name
    blocks = {match["name"] for name in docs.FILES for match in docs._BLOCK.finditer(read(name))}
    assert blocks == set(docs.BLOCKS)


def test_a_page_that_differs_is_seen():
    docs = script("make_docs")
    for name, line in (("docs/errors.md", "| `ODD` |"), ("docs/methods.md", "| `cells` |"),
                       ("hexcon_native/__init__.pyi", "    ODD = ")):
        text = read(name)
        assert line in text
        for other in (text.replace(line, line.replace("ODD", "EVEN").replace("cells", "cell")),
                      "\n".join(one for one in text.splitlines() if not one.startswith(line)) + "\n"):
            assert docs.renewed(other) == text


def test_each_method_has_its_section():
    sections = re.findall(r"^#{3,4} (\S+)$", read("docs/methods.md"), re.MULTILINE)
    assert set(sections) >= set(hn.METHODS) and [one for one in sections if one in hn.METHODS] == list(hn.METHODS)


def parameters(function):
    """Names and kinds of a function's parameters, of an inspect.Signature or an ast.arguments."""
    if isinstance(function, ast.FunctionDef):
        given = function.args
        return [one.arg for one in given.args], [one.arg for one in given.kwonlyargs]
    found = inspect.signature(function).parameters.values()
    return ([one.name for one in found if one.kind is one.POSITIONAL_OR_KEYWORD],
            [one.name for one in found if one.kind is one.KEYWORD_ONLY])


def test_stub_has_what_the_module_has():
    stub = ast.parse(read("hexcon_native/__init__.pyi"))
    names = {node.name for node in stub.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
    names |= {node.target.id for node in stub.body if isinstance(node, ast.AnnAssign)} | {"HexconError"}
    assert names == {*hn.__all__, "__version__"}
    for node in stub.body:
        if isinstance(node, ast.FunctionDef):
            positional, keywords = parameters(node)
            assert (positional, sorted(keywords)) == (parameters(getattr(hn, node.name))[0],
                                                      sorted(parameters(getattr(hn, node.name))[1])), node.name
    classes = {node.name: node for node in stub.body if isinstance(node, ast.ClassDef)}
    members = {node.targets[0].id: node.value.value for node in classes["ErrorCode"].body if isinstance(node, ast.Assign)}
    assert members == {code.name: code.value for code in ErrorCode}
    for kind in (hn.Method, hn.MethodTry):
        assert [node.target.id for node in classes[kind.__name__].body] == list(kind.__dataclass_fields__)


def test_window_texts_are_collected():
    """resources/translations/HexCon.ts has the words of every table: scripts/translations.py writes it."""
    translations = script("translations")
    texts = list(translations.texts_of_tables())
    wanted = {word for row in METHODS for word in (row.label, row.purpose, row.told)}
    wanted |= {word for row in SURFACE_METHODS for word in (row.label, row.purpose)}
    assert set(texts) == wanted | set(STAGES.values()) | set(HEX_STAGES.values()) | set(FIGURES)
    assert all(pathlib.Path(path).read_bytes() == data for path, data in translations.files().items())


# -------------------------------------------------------------------------------------------------- methods

def test_numbers_that_macros_hold():
    """Names and numbers that were given out: only new ones may come."""
    given = {"auto": 0, "swept": 1, "cells": 2, "diced": 3, "sheets": 4, "smallest": 5, "four-split": 6, "pyramid": 7,
             "pyramid-alt": 8, "geode": 9, "geode-alt": 10, "pillowed": 11, "shelling": 12}
    assert given.items() <= hn.METHODS.items() and hn.PAIRINGS.items() >= {"all": 0, "fewest": 1, "none": 2}.items()
    assert sorted(hn.METHODS.values()) == list(range(len(hn.METHODS)))
    enum = read("hexcon_native/include/hexcon.h").partition("typedef enum hexcon_method {")[2].partition("}")[0]
    header = dict(re.findall(r"HEXCON_METHOD_(\w+) = (\d+)", enum))
    assert {name.lower().replace("_", "-"): int(number) for name, number in header.items()} == hn.METHODS


def test_order_that_users_see():
    """auto, the methods for solvers, then those of topology only."""
    assert METHODS[0].name == "auto" and [row.topological for row in METHODS] == sorted(row.topological for row in METHODS)
    assert hn.TOPOLOGICAL_METHODS == {row.name for row in METHODS if row.topological}
    assert list(hn.METHODS) == [row.name for row in METHODS]


@pytest.mark.parametrize("row", [*METHODS, *SURFACE_METHODS], ids=lambda row: row.name)
def test_words_of_methods(row):
    assert re.fullmatch(r"[a-z]+(-[a-z]+)*", row.name) and row.label
    assert 20 < len(row.purpose) < 170 and not row.purpose.endswith(".") and row.purpose[0] != " "
    assert row.hexes_a_quad is None or 1 <= row.hexes_a_quad < 200


def test_tries_of_auto():
    tries = sorted((one.turn, row.name, one.no_core) for row in METHODS for one in row.tries)
    assert [turn for turn, _, _ in tries] == list(range(1, len(tries) + 1))
    assert all(hn.METHOD_TABLE[name].core for _, name, no_core in tries if no_core)
    assert not any(row.tries for row in METHODS if row.topological or row.name == "auto")
    mesh = hn.mesh(*rotated_ball(1, 1))  # no method is good enough before shelling
    told = [line.partition(":")[0] for line in mesh.report["log"]]
    turn = told.index("shelling")
    assert told[:turn] == [name for _, name, _ in tries[1:turn + 1]]  # there is no proposal


OPTIONS = {"layers": {"layers": 1}, "core": {"core": False}, "pairing": {"pairing": "none"}, "pillow": {"pillow": 1}}


@pytest.mark.parametrize("option", OPTIONS)
def test_options_are_taken_by_those_that_say_so(option):
    """The refusal names those that take it, but not auto, which turns to them."""
    takers = [row.name for row in METHODS if getattr(row, option)]
    assert takers and len(takers) < len(METHODS)
    for row in METHODS:
        if getattr(row, option):
            hn.check_options(row.name, **OPTIONS[option])
            continue
        with pytest.raises(hn.HexconError) as raised:
            hn.check_options(row.name, **OPTIONS[option])
        assert raised.value.code is ErrorCode.BAD_ARGUMENT
        assert str(raised.value).rpartition("method ")[2].split(", ") == [one for one in takers if one != "auto"]


def torus():
    """4 x 4 quads, few enough for every method."""
    i, j = (a.ravel() for a in np.mgrid[:4, :4])
    u, v = np.pi * i / 2, np.pi * j / 2
    points = np.column_stack([(3 + np.cos(v)) * np.cos(u), (3 + np.cos(v)) * np.sin(u), np.sin(v)])
    k, m = (i + 1) % 4, (j + 1) % 4
    return points, np.column_stack([4 * i + j, 4 * k + j, 4 * k + m, 4 * i + m])


@pytest.mark.parametrize("row", METHODS, ids=lambda row: row.name)
def test_bodies_with_holes(row):
    """Who does not fill them says so; who does may fail for another reason."""
    try:
        hn.mesh(*torus(), row.name, certify=False)
    except hn.HexconError as fault:
        wanting = row.tetrahedralise and row.topological  # without a mesher of tetrahedra
        assert (fault.code is ErrorCode.NOT_A_BALL) == (not row.holes or wanting)
    else:
        assert row.holes


MADE = {"swept": lambda: prism(o_grid(3, 1), np.arange(4.0), upright), "sheets": schneiders_pyramid,
        "diced": lambda: merged_hull(np.random.default_rng(3), 14), "smallest": schneiders_pyramid,
        "shelling": lambda: rotated_ball(1, 1), "cells": lambda: sphere(2)}


@pytest.mark.parametrize("row", [row for row in METHODS if row.name != "auto"], ids=lambda row: row.name)
def test_what_a_mesh_tells(row):
    """Figures that the window's sentence takes, stages of hexes and stages of progress are in the tables."""
    stages = set()

    def progress(told, fraction):
        stages.add(told.partition(", ")[0])
    surface = MADE.get(row.name, schneiders_pyramid)()
    if row.name == "proposal":
        surface = box(2, 2, 2)
    hexes = hn.mesh(*surface).hexes if row.name == "proposal" else None
    mesh = hn.mesh(*surface, row.name, hexes=hexes, progress=progress)
    assert mesh.method == row.name and mesh.topological == row.topological
    assert set(re.findall(r"{(.+?)}", row.told)) <= set(mesh.report)
    assert stages and stages <= set(hn.STAGES)
    assert all(hex_stage(name)[0] in hn.HEX_STAGES for name, _ in counts_of(mesh.report))
    if row.hexes_a_quad and not row.tries:  # topological methods make what the table says, exactly
        assert len(mesh.hexes) == row.hexes_a_quad * len(surface[1])


# --------------------------------------------------------------------------------------------------- stages

def test_words_of_stages():
    assert not set(AROUND) & set(hn.STAGES)
    for words in (STAGES, HEX_STAGES):
        assert all(value and not value.endswith(".") for value in words.values())
        assert len(set(words.values())) == len(words)
    assert hex_stage("split layer 12") == ("split layer", "12") and hex_stage("core") == ("core", None)
    assert hex_stage("core of 7") == ("core of 7", None)


def test_stages_of_the_core_are_used():
    """Each row by its constant; that no other name is told, the compiler sees to."""
    rows = re.findall(r"ROW\((\w+),", read("hexcon_native/src/base/stages.h"))
    source = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "hexcon_native" / "src").rglob("*.[ch]")
                     if path.name != "stages.h")
    assert len(rows) == len(hn.STAGES) + len(hn.HEX_STAGES)
    assert [row for row in rows if not re.search(rf"\b{row}\b", source)] == []
    assert not re.search(r'mesh_note\([^;]*"hexes of ', source)


def told_stages(folder):
    """Literals that Python files give to a progress as the stage."""
    for path in sorted(folder.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            name = isinstance(node, ast.Call) and getattr(node.func, "attr", getattr(node.func, "id", ""))
            if name in ("progress", "report") and node.args and isinstance(node.args[0], ast.Constant):
                yield node.args[0].value


def test_stages_told_in_python():
    """Those of gmsh's workers and of the package, each of them, and no other."""
    told = set(told_stages(ROOT / "workbench" / "hexcon"))
    started = {"start"}  # what panels show, and gmsh_process tells, before there is news
    assert told <= set(STAGES) and set(AROUND) == (told - set(hn.STAGES)) | started


# --------------------------------------------------------------------------------------------------- faults

def test_numbers_of_faults():
    """Numbers that were given out stay: new codes come at the end."""
    given = """OUT_OF_MEMORY CANCELLED BAD_ARGUMENT TOO_LARGE WRONG_SHAPE WRONG_TYPE EMPTY INDEX_OUT_OF_RANGE
               REPEATED_VERTEX NOT_FINITE UNUSED_POINT NOT_CLOSED NON_MANIFOLD_EDGE NON_MANIFOLD_VERTEX NOT_ORIENTABLE
               INCONSISTENT_ORIENTATION SEVERAL_COMPONENTS ODD NOT_BIPARTITE NO_PAIRING BAD_PAIRING SELF_CROSSING NO_SIDES
               NOT_A_BALL UNFILLABLE_QUAD NOT_STAR_SHAPED NOT_SWEPT NO_SHEETS NOT_DICED NOT_CERTIFIED OUT_OF_TIME
               NO_SMALL_FILLING NO_ROTATIONS NO_HEX_MESH""".split()
    assert [code.name for code in ErrorCode][:len(given)] == given
    assert [code.value for code in ErrorCode] == list(range(1, len(ErrorCode) + 1))


@pytest.mark.parametrize("code", [*ErrorCode, *FaultCode], ids=lambda code: code.name)
def test_words_of_faults(code):
    assert len(code.meaning) > 10 and len(code.advice) > 10
    for words in (code.meaning, code.listed, code.advice):
        assert not words.endswith(".") and words == words.strip() and "  " not in words


def test_words_that_json_has():
    """The values of FaultCode are promised in --json."""
    assert {code.name: code.value for code in FaultCode}.items() >= {
        "TOOL_MISSING": "tool missing", "ODD_SURFACE": "odd surface", "FILE_IO": "file input/output"}.items()
    assert FaultCode("bad mesh") is FaultCode.BAD_MESH


# ------------------------------------------------------------------------------------------ surface methods

def test_surface_methods():
    assert quads.METHODS == tuple(quads.METHOD_TABLE) and quads.METHODS[0] == "auto"
    assert [row.turn for row in tried_by_auto()] == list(range(1, len(tried_by_auto()) + 1))
    codes = {code.name for code in FaultCode}
    for row in SURFACE_METHODS[1:]:
        module, _, function = row.maker.rpartition(".")
        tree = ast.parse(WORKER.joinpath(*module.split(".")).with_suffix(".py").read_text(encoding="utf-8"))
        made = next(node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name == function)
        assert [one.arg for one in made.args.args][:2] == ["solid", "size"]
        assert {"link", *row.takes} <= {one.arg for one in made.args.args}
        assert not row.refusal or row.refusal in codes
        assert not row.filled_by or row.filled_by in hn.METHODS
        assert row.refused or not row.turn or row is tried_by_auto()[-1]
        assert row.cavities or row.refusal


# --------------------------------------------------------------------------------------------- command line

def test_command_line_offers_the_tables(capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "10000")     # no word is broken at its hyphen
    for command in ("mesh", "example", "solve"):
        with pytest.raises(SystemExit):
            arguments.parse([command, "--help"])
        said = " ".join(capsys.readouterr().out.split())
        assert "{" + ",".join(hn.METHOD_CHOICES) + "}" in said and "{" + ",".join(hn.PAIRINGS) + "}" in said
        assert all(f"{name}: {hn.METHOD_TABLE[name].purpose}" in said for name in hn.METHOD_CHOICES)
        if command != "example":
            assert "{" + ",".join(quads.METHODS) + "}" in said
