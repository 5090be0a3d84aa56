# SPDX-License-Identifier: LGPL-2.1-or-later
"""Collect the texts of the window into resources/translations/HexCon.ts, for Qt Linguist.

python3 scripts/translations.py [--check]; --check changes nothing and fails if the file is old.
Texts are the string literals in translate(context, text) and QT_TRANSLATE_NOOP(context, text), and the words of
the tables of methods and stages: the core must have been built.
"""
import ast
import glob
import os
import sys
from xml.sax.saxutils import escape

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
TARGET = os.path.join(ROOT, "resources", "translations", "HexCon.ts")
CALLS = ("translate", "QT_TRANSLATE_NOOP")


def sources():
    """The Python files that hold texts, in a fixed order."""
    yield os.path.join(ROOT, "InitGui.py")
    folder = os.path.join(ROOT, "workbench", "hexcon")
    paths = glob.glob(os.path.join(folder, "**", "*.py"), recursive=True)
    yield from sorted(paths, key=lambda path: os.path.relpath(path, folder).split(os.sep))


def texts_of(path):
    """(context, text) pairs of one file in the order of its lines."""
    with open(path, encoding="utf-8") as stream:
        tree = ast.parse(stream.read(), path)
    calls = [node for node in ast.walk(tree) if isinstance(node, ast.Call) and len(node.args) == 2]
    for call in sorted(calls, key=lambda node: (node.lineno, node.col_offset)):
        name = getattr(call.func, "attr", getattr(call.func, "id", ""))
        values = [arg.value if isinstance(arg, ast.Constant) else None for arg in call.args]
        if name in CALLS and all(isinstance(value, str) for value in values):
            yield tuple(values)


def texts_of_tables():
    """The texts in the tables that the window shows: methods of hexes and of surfaces, stages."""
    sys.path[:0] = [ROOT, os.path.join(ROOT, "workbench")]
    import hexcon_native
    from hexcon.quads import METHOD_TABLE
    from hexcon.stage_words import HEX_STAGES, STAGES
    for method in (*hexcon_native.METHOD_TABLE.values(), *METHOD_TABLE.values()):
        yield from (method.label, method.purpose, *([method.told] if hasattr(method, "told") else []))
    yield from (*STAGES.values(), *HEX_STAGES.values())


def document():
    """The .ts file's text: contexts and messages, each once, sorted by context."""
    contexts = {}
    for path in sources():
        for context, text in texts_of(path):
            contexts.setdefault(context, {})[text] = None
    for text in texts_of_tables():
        contexts["HexCon"].setdefault(text)
    lines = ['<?xml version="1.0" encoding="utf-8"?>', "<!DOCTYPE TS>",
             "<!-- SPDX-License-Identifier: LGPL-2.1-or-later -->", '<TS version="2.1">']
    for context in sorted(contexts):
        lines += ["<context>", f"    <name>{escape(context)}</name>"]
        for text in contexts[context]:
            lines += ["    <message>", f"        <source>{escape(text)}</source>",
                      '        <translation type="unfinished"></translation>', "    </message>"]
        lines.append("</context>")
    return "\n".join([*lines, "</TS>", ""])


def main():
    new = document()
    if "--check" in sys.argv:
        with open(TARGET, encoding="utf-8") as stream:
            return 0 if stream.read() == new else "resources/translations/HexCon.ts is old: run scripts/translations.py"
    os.makedirs(os.path.dirname(TARGET), exist_ok=True)
    with open(TARGET, "w", encoding="utf-8") as stream:
        stream.write(new)
    return 0


if __name__ == "__main__":
    sys.exit(main())
