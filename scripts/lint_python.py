# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ruff over all Python files, by ruff.toml.

python3 scripts/lint_python.py [--fix] [FILE ...]; --fix sorts imports and mends what is only old-fashioned.

Debian has no ruff; npm has it as WebAssembly, one version of which is fetched into build/ruff: what it says does not
depend on what else is installed. Editors may use any ruff with the same ruff.toml.
"""
import fnmatch
import json
import os
import subprocess
import sys
import tomllib

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
FOLDER = os.path.join(ROOT, "build", "ruff")
PACKAGE, VERSION = "@astral-sh/ruff-wasm-nodejs", "0.17.4"

MENDED = ("I001", "UP033", "W291", "W293")
"""Codes that --fix mends: what a program cannot notice."""

# In: {settings, files: {name: text}}. Out: {name: [[row, column, code, message, edits] ..]}.
_NODE = """
const { Workspace, PositionEncoding } = require(process.argv[1]);
const { settings, files } = JSON.parse(require("fs").readFileSync(0, "utf8"));
const workspace = new Workspace(settings, PositionEncoding.Utf32);
const found = {};
for (const [name, text] of Object.entries(files))
  found[name] = workspace.check(text).map(d =>
    [d.start_location.row, d.start_location.column, d.code, d.message, d.fix ? d.fix.edits : []]);
console.log(JSON.stringify(found));
"""


def package():
    """Where the package is; fetched if it is not."""
    place = os.path.join(FOLDER, "node_modules", *PACKAGE.split("/"))
    known = os.path.join(place, "package.json")
    if os.path.isfile(known):
        with open(known, encoding="utf-8") as stream:
            if json.load(stream)["version"] == VERSION:
                return place
    os.makedirs(FOLDER, exist_ok=True)
    subprocess.run(["npm", "install", "--silent", "--no-audit", "--no-fund", "--prefix", FOLDER,
                    f"{PACKAGE}@{VERSION}"], check=True, stdin=subprocess.DEVNULL)
    return place


def python_files():
    listed = subprocess.run(["git", "ls-files", "*.py"], cwd=ROOT, check=True, capture_output=True, text=True)
    return [name for name in listed.stdout.splitlines() if os.path.isfile(os.path.join(ROOT, name))]


def settings():
    """What ruff.toml says, and its exceptions for single files, which are ours to heed."""
    with open(os.path.join(ROOT, "ruff.toml"), "rb") as stream:
        said = tomllib.load(stream)
    return said, said["lint"].pop("per-file-ignores", {})


def is_excepted(name, code, exceptions):
    return any(fnmatch.fnmatch(name, pattern) and code.startswith(tuple(codes))
               for pattern, codes in exceptions.items())


def checked(said, texts):
    """{name: [[row, column, code, message, edits] ..]} as ruff finds it."""
    done = subprocess.run(["node", "-e", _NODE, package()], input=json.dumps({"settings": said, "files": texts}),
                          check=True, stdout=subprocess.PIPE, text=True)
    return json.loads(done.stdout)


def mended(text, found):
    """The text with the edits of what may be mended without a look at it, from the last to the first."""
    starts = [0]
    for line in text.splitlines(keepends=True):
        starts.append(starts[-1] + len(line))

    def offset(place):
        return starts[place["row"] - 1] + place["column"] - 1
    edits = [edit for _, _, code, _, edits in found if code in MENDED for edit in edits]
    for edit in sorted(edits, key=lambda edit: -offset(edit["location"])):
        text = text[:offset(edit["location"])] + (edit["content"] or "") + text[offset(edit["end_location"]):]
    return text


def fix(said, texts):
    """Write the files that ruff can mend by itself."""
    for name, found in checked(said, texts).items():
        text = mended(texts[name], found)
        if text != texts[name]:
            texts[name] = text
            with open(os.path.join(ROOT, name), "w", encoding="utf-8") as stream:
                stream.write(text)


def main(arguments):
    said, exceptions = settings()
    texts = {}
    for name in [name for name in arguments if name != "--fix"] or python_files():
        with open(os.path.join(ROOT, name), encoding="utf-8") as stream:
            texts[name] = stream.read()
    if "--fix" in arguments:
        fix(said, texts)
    faults = [f"{name}:{row}:{column}: {code} {message}" for name, found in checked(said, texts).items()
              for row, column, code, message, _ in found if not is_excepted(name, code or "E999", exceptions)]
    print("\n".join(faults), file=sys.stderr if faults else sys.stdout, end="\n" if faults else "")
    return f"ruff: {len(faults)} faults" if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
