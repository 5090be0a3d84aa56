# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ruff over all Python files, by ruff.toml.

python3 scripts/lint_python.py [FILE ...]

Debian has no ruff; npm has it as WebAssembly, one version of which is fetched into build/ruff: what it says does not depend
on what else is installed. Editors may use any ruff with the same ruff.toml.
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

# In: {settings, files: {name: text}}. Out: {name: [[row, column, code, message] ..]}.
_NODE = """
const { Workspace, PositionEncoding } = require(process.argv[1]);
const { settings, files } = JSON.parse(require("fs").readFileSync(0, "utf8"));
const workspace = new Workspace(settings, PositionEncoding.Utf32);
const found = {};
for (const [name, text] of Object.entries(files))
  found[name] = workspace.check(text).map(d => [d.start_location.row, d.start_location.column, d.code, d.message]);
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
    subprocess.run(["npm", "install", "--silent", "--no-audit", "--no-fund", "--prefix", FOLDER, f"{PACKAGE}@{VERSION}"],
                   check=True, stdin=subprocess.DEVNULL)
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
    return any(fnmatch.fnmatch(name, pattern) and code.startswith(tuple(codes)) for pattern, codes in exceptions.items())


def main(names):
    said, exceptions = settings()
    texts = {}
    for name in names or python_files():
        with open(os.path.join(ROOT, name), encoding="utf-8") as stream:
            texts[name] = stream.read()
    done = subprocess.run(["node", "-e", _NODE, package()], input=json.dumps({"settings": said, "files": texts}),
                          check=True, stdout=subprocess.PIPE, text=True)
    faults = [f"{name}:{row}:{column}: {code} {message}" for name, found in json.loads(done.stdout).items()
              for row, column, code, message in found if not is_excepted(name, code or "E999", exceptions)]
    print("\n".join(faults), file=sys.stderr if faults else sys.stdout, end="\n" if faults else "")
    return f"ruff: {len(faults)} faults" if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
