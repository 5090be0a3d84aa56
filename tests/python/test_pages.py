# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pages: short where they must be, links that lead somewhere, rooms as they are, figures from result files."""
import importlib.util
import json
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGES = sorted([*ROOT.glob("*.md"), *ROOT.glob("docs/*.md"), *ROOT.glob("examples/*.md")])
CORE, PACKAGE = ROOT / "hexcon_native" / "src", ROOT / "workbench" / "hexcon"


def text(path):
    return path.read_text(encoding="utf-8")


def anchors(page):
    """As GitHub makes them of headings."""
    heads = re.findall(r"^#+ (.*)$", re.sub(r"```.*?```", "", text(page), flags=re.DOTALL), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", head.lower()).replace(" ", "-") for head in heads}


def links(page):
    prose = re.sub(r"```.*?```", "", text(page), flags=re.DOTALL)
    return [link for link in re.findall(r"\]\(([^)\s]+)\)", prose) if "://" not in link]


def test_readme_is_short():
    assert len(text(ROOT / "README.md").splitlines()) <= 120


def test_readme_leads_to_every_page():
    found = {(ROOT / link.split("#")[0]).resolve() for link in links(ROOT / "README.md")}
    assert {page.resolve() for page in PAGES if page.parent != ROOT / "examples"} - {ROOT / "README.md"} <= found


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_lead_somewhere(page):
    for link in links(page):
        name, _, anchor = link.partition("#")
        target = (page.parent / name).resolve() if name else page
        assert target.exists(), link
        assert not anchor or anchor in anchors(target), link


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_no_paths_of_one_machine(page):
    assert not re.search(r"(?<![\w./])/(home|root|work|tmp|mnt)/", text(page))


def named_in(heading):
    """Rooms named in the first column of a table of docs/architecture.md, in its order."""
    section = text(ROOT / "docs" / "architecture.md").split(f"\n## {heading}\n")[1].split("\n## ")[0]
    return [name for row in re.findall(r"^\| (`.*?) \|", section, re.MULTILINE) for name in re.findall(r"`(\w+)`", row)]


def folders(place):
    return {path.name for path in place.iterdir() if path.is_dir() and not path.name.startswith("__")}


def test_rooms_of_the_core_are_those_of_the_page_and_arrows_go_down():
    rooms = named_in("Rooms of the core")
    assert set(rooms) == folders(CORE)
    for path in CORE.glob("**/*.[ch]"):
        own = path.relative_to(CORE).parts[0]
        for used in re.findall(r'^#include "(\w+)/', text(path), re.MULTILINE):
            assert rooms.index(used) >= rooms.index(own), f"{path}: {own} must not use {used}"


def test_rooms_of_the_package_are_on_the_page():
    assert folders(PACKAGE) <= set(named_in("Rooms of the package"))


# ------------------------------------------------------------------------------------------------- measured

@pytest.fixture
def measured():
    spec = importlib.util.spec_from_file_location("measured", ROOT / "scripts" / "measured.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_blocks_of_measured_come_from_result_files(measured, tmp_path):
    page = text(ROOT / "docs" / "measured.md")
    assert measured.renewed(page, tmp_path) == page     # nothing was measured
    parts = [{"seed": seed, "code": "CERTIFIED", "quads": 100 + seed, "hexes": 300 + 3 * seed, "min": 0.1 + seed / 1000,
              "mean": 0.5, "seconds": 1.0 + seed} for seed in range(3)]
    parts += [{"seed": 3, "code": "TIME_LIMIT", "message": "not done in 300 s", "seconds": 300.0}]
    (tmp_path / "csg.jsonl").write_text("".join(json.dumps(part) + "\n" for part in parts), encoding="utf-8")
    (tmp_path / "bench.txt").write_text("quads  1014\nswept  0.5\n", encoding="utf-8")
    made = measured.renewed(page, tmp_path)
    assert "| 0 to 3 | 3 of 4 | 100 to 102 | 3.0 to 3.0, median 3.0 | 0.10; 0.50 | 0.100 | 2, 300 |" in made
    assert "- seed 3: TIME_LIMIT, not done in 300 s" in made
    assert "processors.\n\n```\nquads  1014\nswept  0.5\n```\n<!-- end bench -->" in made
    for name in ("compare", "optimizer", "parts"):       # these were not measured anew
        block = rf"<!-- begin {name} -->.*?<!-- end {name} -->"
        assert re.search(block, made, re.DOTALL)[0] == re.search(block, page, re.DOTALL)[0]
    assert measured.renewed(made, tmp_path) == made
