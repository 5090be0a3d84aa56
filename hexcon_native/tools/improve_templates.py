# SPDX-License-Identifier: LGPL-2.1-or-later
"""Raise the worst scaled Jacobian of template files by moving their interior points.

    PYTHONPATH=. python3 hexcon_native/tools/improve_templates.py resources/templates/*.txt

A file is rewritten only if its worst hex gets better and every hex is proved positive; its boundary
points, labels, hexes and order of lines stay.
"""
import argparse
import os
from pathlib import Path

import numpy as np

import hexcon_native as hn


def read(lines):
    """Points (P, 3), hexes (H, 8), the mask of interior points, and the outward quads (n, 4)."""
    rows = [line.split() for line in lines if line.strip()]
    points = np.array([row[2:5] for row in rows if row[0] == "v"], float)
    inside = np.array([row[5] == "int" for row in rows if row[0] == "v"])
    hexes, quads = (np.array([row[1:] for row in rows if row[0] == kind], np.int32) for kind in "hq")
    return points, hexes, inside, quads


def rewritten(lines, points):
    """The lines with interior points replaced; 17 digits give them back bit for bit."""
    for line in lines:
        row = line.split()
        if row and row[0] == "v" and row[5] == "int":
            x = " ".join(repr(float(c)) for c in points[int(row[1])])
            line = f"v {row[1]} {x} int\n"
        yield line


def improve(path):
    lines = path.read_text().splitlines(keepends=True)
    points, hexes, inside, quads = read(lines)
    better = hn.optimize(points, hexes, ~inside, rounds=20)
    before, after = hn.quality(points, hexes), hn.quality(better, hexes)
    gain = hn.certify(better, hexes, quads).certified and after.min > before.min + 1e-6
    print(f"{path.name:32} worst {before.min:.4f} -> {after.min:.4f}  mean {before.mean:.4f} -> "
          f"{after.mean:.4f}  {'rewritten' if gain else 'kept'}")
    if gain:
        beside = path.with_suffix(".new")
        beside.write_text("".join(rewritten(lines, better)))
        os.replace(beside, path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="+", type=Path)
    for path in parser.parse_args().files:
        improve(path)


if __name__ == "__main__":
    main()
