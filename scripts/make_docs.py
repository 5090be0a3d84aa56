# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write what follows from the tables: blocks of docs/methods.md and docs/errors.md, and ErrorCode in the type stub.

python3 scripts/make_docs.py [--check]; --check changes nothing and fails if a file is old. The core must have been
built. A block stands between lines that hold "begin NAME" and "end NAME"; what is outside is written by hand.
"""
import os
import re
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path[:0] = [ROOT, os.path.join(ROOT, "workbench")]

import hexcon_native as hn  # noqa: E402
from hexcon.errors import FaultCode  # noqa: E402
from hexcon.files.formats import FORMATS  # noqa: E402
from hexcon.quads import METHOD_TABLE as SURFACE_METHODS  # noqa: E402
from hexcon.stage_words import HEX_STAGES, STAGES  # noqa: E402

FILES = ("docs/methods.md", "docs/errors.md", "docs/files.md", "hexcon_native/__init__.pyi")


def table(heads, rows):
    """Lines of a Markdown table."""
    lines = ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    return lines + ["| " + " | ".join(str(cell).replace("|", "\\|") for cell in row) + " |" for row in rows]


def sentence(text):
    return text[:1].upper() + text[1:] + "." if text else ""


def figure(number):
    return "by the volume" if number is None else f"{number:g}"


def methods():
    """Name, purpose, hexes a quad."""
    return table(("method", "what it is for", "hexes a quad", "number"),
                 [(f"[`{name}`](#{name})", sentence(row.purpose) + (" *Topology only.*" if row.topological else ""),
                   "as the method taken" if name == "auto" else figure(row.hexes_a_quad), row.number)
                  for name, row in hn.METHOD_TABLE.items()])


def method_facts():
    """What each takes and fills."""
    def yes(value):
        return "yes" if value else "-"
    flags = ("layers", "core", "pairing", "pillow", "tetrahedralise", "proposal", "holes", "cavities", "odd_colours")
    return table(("method", *(f"`{flag}`" for flag in flags[:6]), "holes", "cavities", "odd colours"),
                 [(f"`{name}`", *(yes(getattr(row, flag)) for flag in flags)) for name, row in hn.METHOD_TABLE.items()])


def auto_order():
    """The tries of auto."""
    tries = sorted(((one, row) for row in hn.METHOD_TABLE.values() for one in row.tries), key=lambda t: t[0].turn)
    return table(("turn", "method", "enough, if the worst scaled Jacobian is", "and hexes a quad at most"),
                 [(one.turn, f"`{row.name}`" + (" without a core" if one.no_core else ""),
                   f"{one.good_worst:g}", one.most_hexes or "any number") for one, row in tries])


def surface_methods():
    return table(("surface method", "what it is for", "`auto` tries it", "cavities", "made for"),
                 [(f"`{name}`", sentence(row.purpose), row.turn or "-",
                   "-" if not row.cavities else "yes", f"`{row.filled_by}`" if row.filled_by else "-")
                  for name, row in SURFACE_METHODS.items()])


def stages():
    return table(("stage", "in the window"), [(f"`{name}`", words) for name, words in STAGES.items()])


def hex_stages():
    return table(("stage", "in the window"), [(f"`{name}`", words) for name, words in HEX_STAGES.items()])


def error_codes():
    return table(("code", "number", "meaning", "`elements`", "what you can do"),
                 [(f"`{code.name}`", code.value, sentence(code.meaning), code.listed or "-", sentence(code.advice))
                  for code in hn.ErrorCode])


def fault_codes():
    return table(("code", "word", "meaning", "`elements`", "what you can do"),
                 [(f"`{code.name}`", code.value, sentence(code.meaning), code.listed or "-", sentence(code.advice))
                  for code in FaultCode])


def formats():
    """Format, endings, what is read and by whom, what is written, what is lost."""
    return table(("format", "endings", "read", "by", "written", "lost"),
                 [(row.name, " ".join(f"`{ending}`" for ending in row.endings), row.read or "-", row.reader or "-",
                   row.written or "-", row.lost or "-") for row in FORMATS])


def stub_codes():
    return [f"    {code.name} = {code.value}" for code in hn.ErrorCode]


BLOCKS = {"methods": methods, "method facts": method_facts, "auto": auto_order, "surface methods": surface_methods,
          "stages": stages, "hex stages": hex_stages, "error codes": error_codes, "fault codes": fault_codes,
          "ErrorCode": stub_codes, "formats": formats}
_BLOCK = re.compile(r"(?P<begin>^[^\n]*\bbegin (?P<name>[\w ]+?)(?: -->)?\n)(?P<body>.*?)"
                    r"(?P<end>^[^\n]*\bend (?P=name)\b)",
                    re.MULTILINE | re.DOTALL)


def renewed(text):
    """A file's text with its blocks as the tables have them."""
    def block(found):
        return found["begin"] + "".join(line + "\n" for line in BLOCKS[found["name"]]()) + found["end"]
    return _BLOCK.sub(block, text)


def main():
    old = []
    for name in FILES:
        path = os.path.join(ROOT, name)
        with open(path, encoding="utf-8") as stream:
            text = stream.read()
        if renewed(text) == text:
            continue
        old.append(name)
        if "--check" not in sys.argv:
            with open(path, "w", encoding="utf-8") as stream:
                stream.write(renewed(text))
    if old and "--check" in sys.argv:
        return f"{', '.join(old)}: not as the tables are; run scripts/make_docs.py"
    return 0


if __name__ == "__main__":
    sys.exit(main())
