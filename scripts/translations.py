# SPDX-License-Identifier: LGPL-2.1-or-later
"""Collect the texts of the window into resources/translations/HexCon.ts, and HexCon_de.ts with its translations.

python3 scripts/translations.py [--check]; --check changes nothing and fails if a file is old. What Qt Linguist
has put into a language's file stays; HexCon_de.qm, which FreeCAD loads, is made from it here, as by Qt's lrelease.
Texts are the string literals in translate(context, text) and QT_TRANSLATE_NOOP(context, text), and the words of
the tables of methods and stages: the core must have been built.
"""
import ast
import glob
import os
import struct
import sys
from xml.etree import ElementTree
from xml.sax.saxutils import escape

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
TARGET = os.path.join(ROOT, "resources", "translations", "HexCon.ts")
LANGUAGES = ("de",)
MAGIC = bytes.fromhex("3cb86418caef9c95cd211cbf60a1bddd")
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
    from hexcon.stage_words import FIGURES, HEX_STAGES, STAGES
    for method in (*hexcon_native.METHOD_TABLE.values(), *METHOD_TABLE.values()):
        yield from (method.label, method.purpose, *([method.told] if hasattr(method, "told") else []))
    yield from (*STAGES.values(), *HEX_STAGES.values(), *FIGURES)


def collected():
    """{context: [texts]}, each text once."""
    contexts = {}
    for path in sources():
        for context, text in texts_of(path):
            contexts.setdefault(context, {})[text] = None
    for text in texts_of_tables():
        contexts["HexCon"].setdefault(text)
    return {context: list(contexts[context]) for context in sorted(contexts)}


def document(contexts, language="", known=None):
    """The .ts file's text; known: {(context, text): translation}."""
    lines = ['<?xml version="1.0" encoding="utf-8"?>', "<!DOCTYPE TS>",
             "<!-- SPDX-License-Identifier: LGPL-2.1-or-later -->",
             f'<TS version="2.1" language="{language}">' if language else '<TS version="2.1">']
    for context, texts in contexts.items():
        lines += ["<context>", f"    <name>{escape(context)}</name>"]
        for text in texts:
            said = (known or {}).get((context, text))
            lines += ["    <message>", f"        <source>{escape(text)}</source>",
                      f"        <translation>{escape(said)}</translation>" if said else
                      '        <translation type="unfinished"></translation>', "    </message>"]
        lines.append("</context>")
    return "\n".join([*lines, "</TS>", ""])


def translations_of(path):
    """{(context, text): translation} of a .ts file, those that are there."""
    if not os.path.exists(path):
        return {}
    return {(context.findtext("name"), message.findtext("source")): message.findtext("translation")
            for context in ElementTree.parse(path).getroot().iter("context") for message in context.iter("message")
            if message.findtext("translation")}


def compiled(known):
    """The bytes of Qt's .qm: a table of hashes of the texts, then for each translation, text and context."""
    records = {}
    for (context, text), said in known.items():
        parts = ((3, said.encode("utf-16-be")), (8, b""), (6, text.encode()), (7, context.encode()))
        data = b"".join(struct.pack(">BI", tag, len(part)) + part for tag, part in parts) + b"\x01"
        records[_hash(text.encode()), context, text] = data
    messages, hashes = b"", b""
    for key in sorted(records):
        hashes += struct.pack(">II", key[0], len(messages))
        messages += records[key]
    blocks = ((0x42, hashes), (0x69, messages))
    return MAGIC + b"".join(struct.pack(">BI", tag, len(part)) + part for tag, part in blocks)


def _hash(text):
    """Qt's (qtranslator.cpp, elfHash): that of ELF's symbol tables."""
    value = 0
    for byte in text:
        value = (value << 4) + byte
        high = value & 0xF0000000
        value = (value ^ high >> 24) & ~high & 0xFFFFFFFF
    return value or 1


def files():
    """{path: bytes} of all that is made here."""
    contexts = collected()
    made = {TARGET: document(contexts).encode()}
    there = {(context, text) for context, texts in contexts.items() for text in texts}
    for language in LANGUAGES:
        path = TARGET.replace(".ts", f"_{language}.ts")
        known = {key: said for key, said in translations_of(path).items() if key in there}
        made[path] = document(contexts, language, known).encode()
        made[path.replace(".ts", ".qm")] = compiled(known)
    return made


def main():
    made = files()
    if "--check" in sys.argv:
        old = [os.path.relpath(path, ROOT) for path, data in made.items() if _bytes(path) != data]
        return f"{', '.join(old)}: old; run scripts/translations.py" if old else 0
    os.makedirs(os.path.dirname(TARGET), exist_ok=True)
    for path, data in made.items():
        with open(path, "wb") as stream:
            stream.write(data)
    return 0


def _bytes(path):
    if not os.path.exists(path):
        return None
    with open(path, "rb") as stream:
        return stream.read()


if __name__ == "__main__":
    sys.exit(main())
