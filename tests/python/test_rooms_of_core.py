# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arrows between the rooms of the core run downwards only, and files of a room form no circle."""
import re
from pathlib import Path

SRC = Path(__file__).parents[2] / "hexcon_native" / "src"

# Each room with those it may look into, besides itself.
BELOW = {
    "base": set(),
    "surface": {"base"},
    "pairing": {"base", "surface"},
    "homology": {"base", "surface"},
    "facts": {"base", "surface", "pairing", "homology"},
    "embedding": {"base", "surface"},
    "hexmesh": {"base", "surface"},
    "verify": {"base", "surface", "embedding", "hexmesh"},
    "construct": {"base", "surface", "hexmesh"},
    "shape": {"base", "surface", "hexmesh", "verify"},
    "solve": {"base", "surface", "pairing", "homology", "embedding", "hexmesh", "verify", "construct", "shape"},
}


def includes(path):
    """Files of the core that a file includes, relative to SRC."""
    for name in re.findall(r'^#include "(.+?)"', path.read_text(), re.M):
        beside = (path.parent / name).resolve()
        if beside.exists():
            yield beside.relative_to(SRC).as_posix()
        elif (SRC / name).exists():
            yield name


def test_every_room_is_known():
    assert {path.name for path in SRC.iterdir()} == set(BELOW)


def test_arrows_run_downwards():
    upward = [(path.relative_to(SRC).as_posix(), name) for path in SRC.rglob("*.[ch]") for name in includes(path)
              if name.split("/")[0] not in BELOW[path.relative_to(SRC).parts[0]] | {path.relative_to(SRC).parts[0]}]
    assert upward == []


def test_headers_and_sources_form_no_circle():
    """A source and its header are one idea: what they include, together, must not lead back to them."""
    arrows = {}
    for path in SRC.rglob("*.[ch]"):
        unit = path.relative_to(SRC).with_suffix("").as_posix()
        arrows.setdefault(unit, set()).update(Path(name).with_suffix("").as_posix() for name in includes(path))
    done, circles = set(), []

    def walk(unit, trail):
        if unit in trail:
            circles.append(trail[trail.index(unit):] + [unit])
        elif unit not in done:
            for other in sorted(arrows.get(unit, set()) - {unit}):
                walk(other, trail + [unit])
            done.add(unit)

    for unit in sorted(arrows):
        walk(unit, [])
    assert circles == []
