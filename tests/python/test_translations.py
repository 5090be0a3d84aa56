# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window's texts in German: all of them, with the same figures; and progress lines, whose figures are texts too."""
import pathlib
import re
import struct
import sys

import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "scripts"), str(ROOT / "tests")]
import translations  # noqa: E402
from hex_grids import block  # noqa: E402

import hexcon_native as hn  # noqa: E402
from hexcon.judging import words  # noqa: E402
from hexcon.stage_words import FIGURES, figures_of  # noqa: E402

LANGUAGE = translations.TARGET.replace(".ts", "_de.ts")


def test_every_text_is_translated():
    known, texts = translations.translations_of(LANGUAGE), translations.collected()
    missing = [text for context in texts for text in texts[context] if (context, text) not in known]
    assert not missing and len(known) == sum(map(len, texts.values()))


def test_translations_keep_the_figures():
    def kept(text):
        ends = (text[:1].isspace(), text.endswith((" ", "...")))
        return ends, sorted(re.findall(r"{[^}]+}|\[|\]|<[^>]+>", text))
    for (_, text), said in translations.translations_of(LANGUAGE).items():
        assert kept(text) == kept(said), text


def test_the_compiled_file_holds_them():
    """Read by what Qt's qtranslator.cpp does: a hash, then texts compared."""
    with open(LANGUAGE.replace(".ts", ".qm"), "rb") as stream:
        data = stream.read()
    assert data.startswith(translations.MAGIC)
    blocks, at = {}, len(translations.MAGIC)
    while at < len(data):
        tag, size = struct.unpack_from(">BI", data, at)
        blocks[tag], at = data[at + 5:at + 5 + size], at + 5 + size
    found, before = {}, -1
    for value, place in struct.iter_unpack(">II", blocks[0x42]):
        assert value >= before      # sorted, for Qt halves its way to one
        before, parts = value, {}
        while (tag := blocks[0x69][place]) != 1:
            size, = struct.unpack_from(">I", blocks[0x69], place + 1)
            parts[tag], place = blocks[0x69][place + 5:place + 5 + size], place + 5 + size
        found[parts[7].decode(), parts[6].decode()] = parts[3].decode("utf-16-be")
    assert found == translations.translations_of(LANGUAGE)


@pytest.mark.parametrize("told, template, there", (
    ("3 of 12 hexes inverted", FIGURES[0], {"inverted": "3", "hexes": "12"}), ("12 hexes", FIGURES[1], {"hexes": "12"}),
    ("12 hexes, worst scaled Jacobian 0.250", FIGURES[2], {"hexes": "12", "worst": "0.250"}),
    ("something else", "something else", {})))
def test_figures_of_a_progress_line(told, template, there):
    assert figures_of(told) == (template, there)
    assert words.stage("untangle, " + told)[1] == told


def test_all_that_the_core_tells_is_known():
    seen, box = set(), block(3, 3, 3)
    used, quads = np.unique(box.quads, return_inverse=True)
    hn.mesh(box.points[used], quads.reshape(-1, 4), method="cells",
            progress=lambda stage, part: seen.add(stage) or True)
    rest = {stage.partition(", ")[2] for stage in seen} - {""}
    assert rest and all(figures_of(told)[1] for told in rest), rest
