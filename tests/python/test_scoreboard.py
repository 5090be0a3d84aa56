# SPDX-License-Identifier: LGPL-2.1-or-later
"""scripts/scoreboard.py on a few small surfaces: each in its own process, kept, and put on a page."""
import json
import os
import pathlib
import subprocess
import sys

import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "scripts" / "scoreboard.py"
sys.path[:0] = [str(ROOT / "tests"), str(ROOT / "scripts")]
import scoreboard_page  # noqa: E402
from hex_grids import block  # noqa: E402

INDEX = """| file | repository | quads | genus | hexes | min | mean | inverted |
|---|---|---|---|---|---|---|---|
| bar.npz | some/body | 18 | 0 | 8 | 0.5 | 0.75 | 0 |
| odd.npz | Another/one | 10 | 0 | | | | |
"""


@pytest.fixture(scope="module")
def measured(tmp_path_factory):
    """The folder of surfaces, the result file's path, and what was printed."""
    folder = tmp_path_factory.mktemp("surfaces")
    bar = block(4, 1, 1)
    np.savez(folder / "bar.npz", points=bar.points, quads=bar.quads)
    np.savez(folder / "open.npz", points=bar.points, quads=bar.quads[1:])
    (folder / "damaged.npz").write_bytes(b"no archive")
    (folder / "INDEX.md").write_text(INDEX, encoding="utf-8")
    result = folder / "new" / "result.jsonl"
    return folder, result, run(folder, result)


def run(folder, result):
    command = [sys.executable, str(PROGRAM), str(folder), "--result", str(result), "--limit", "20"]
    done = subprocess.run(command, env={**os.environ, "PYTHONPATH": f"{ROOT}{os.pathsep}{ROOT / 'workbench'}"},
                          capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_every_surface_has_its_line(measured):
    _, result, said = measured
    found = {one["name"]: one for one in map(json.loads, result.read_text(encoding="utf-8").splitlines())}
    assert set(found) == {"bar", "open", "damaged"} and "1 of 3 certified" in said
    bar = found["bar"]
    assert (bar["code"], bar["quads"], bar["genus"], bar["hexes"], bar["method"]) == ("CERTIFIED", 18, 0, 4, "swept")
    assert bar["min"] == bar["mean"] == pytest.approx(1.0) and bar["seconds"] > 0
    assert bar["witness"] == {"hexes": 8, "min": 0.5, "mean": 0.75} and bar["repository"] == "some/body"
    assert found["open"]["code"] == "NOT_CLOSED" and found["damaged"]["code"] == "CRASH"


def test_what_is_measured_is_kept(measured):
    folder, result, _ = measured
    before = result.read_text(encoding="utf-8")
    first, *others = before.splitlines(keepends=True)
    result.write_text("".join(others), encoding="utf-8")
    run(folder, result)     # goes on with the one that is missing
    lines = result.read_text(encoding="utf-8").splitlines(keepends=True)
    assert lines[:2] == others and json.loads(lines[2])["name"] == json.loads(first)["name"]


def test_a_page_of_them(measured, tmp_path):
    pytest.importorskip("matplotlib")
    folder, result, _ = measured
    found = [json.loads(line) for line in result.read_text(encoding="utf-8").splitlines()]
    found.append({"name": "ring", "repository": "some/body", "code": "CERTIFIED", "genus": 1, "cavities": 0,
                  "quads": 10, "hexes": 90, "min": 0.2, "q05": 0.3, "mean": 0.5, "seconds": 3.0, "method": "cells",
                  "limit": 20.0, "message": "", "witness": {"hexes": 30, "min": 0.25, "mean": 0.6}})
    page = tmp_path / "page.md"
    page.write_text((ROOT / "docs" / "scoreboard.md").read_text(encoding="utf-8"), encoding="utf-8")
    scoreboard_page.write_page(found, result, page, tmp_path / "page.png")
    made = page.read_text(encoding="utf-8")
    rows = {line.split("|")[1].strip(): [cell.strip() for cell in line.split("|")[2:-1]]
            for line in made.splitlines() if line.startswith("|")}
    assert rows["balls"][:4] == ["1 of 3", "1 of 1", "0.22", "0.50 times"]
    assert rows["genus 1 to 10"][:4] == ["1 of 1", "0 of 1", "9.00", "3.00 times"]
    assert rows["genus 1 to 10"][6] == "0 of 1"
    assert rows["bar"][:6] == ["18", "0", "swept", "4", "0.2", "1.00; 1.00; 1.00"]
    assert "- open: NOT_CLOSED" in made and "https://github.com/some/body" in made
    assert (tmp_path / "page.png").read_bytes()[:4] == b"\x89PNG"
    scoreboard_page.write_page(found, result, page, tmp_path / "page.png")
    assert page.read_text(encoding="utf-8") == made


def test_it_says_where_there_is_no_folder(tmp_path):
    done = subprocess.run([sys.executable, str(PROGRAM), str(tmp_path / "none")],
                          capture_output=True, text=True, check=False)
    assert done.returncode == 2 and "there is no folder" in done.stderr
