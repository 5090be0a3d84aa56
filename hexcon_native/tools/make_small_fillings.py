# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make resources/fillings/smallest.txt: a hex mesh for every quadrangulation of the sphere that a convex
polyhedron with few quads can have.

    ninja -C build/release hexcon_template_search
    PYTHONPATH=. python3 hexcon_native/tools/make_small_fillings.py search spread search realise

Steps, in any order and as often as wanted: `search` looks for fillings of each class, and shrinks those known;
`spread` glues hexes to known ones, which fills other classes; `realise` gives the smallest ones a geometry and
writes the table. All fillings met are kept in a pool, a file. The README beside this file says more.
"""
import argparse
import multiprocessing
import os
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
from improve_templates import read
from search_templates import EDGES, TOOL, Filling, smoothed

import hexcon_native as hn

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "python"))
from polyhedra import canonical_polyhedron  # noqa: E402  (found by the line above)
from quadrangulations import Moves, all_quadrangulations  # noqa: E402

DIGITS = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz-_"
VALUES = {digit: i for i, digit in enumerate(DIGITS)}
CLASSES = {6: 1, 8: 1, 10: 3, 12: 11, 14: 58, 16: 451}
FACES = np.array([(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)])
STEPS = 64 ** 3 - 1    # of a coordinate, from -1 to 1
HEADER = """\
# SPDX-License-Identifier: LGPL-2.1-or-later
# Hex meshes of small quadrangulations of the sphere; README.md beside this file says how to read them.
"""


# ---------------------------------------------------------------------------------- classes and records

def rings_of(quads):
    """Neighbours of each point, counter-clockwise seen from outside."""
    moves = Moves(quads)
    first = {}
    for a, b in moves.after:
        first.setdefault(b, a)
    return [moves.around(point, first[point])[::-1] for point in range(len(first))]


def walk(rings, a, b):
    """(code, points in the order of first sight): the walk that begins with the edge a, b."""
    number, entry, order, code = {a: 0, b: 1}, {a: b, b: a}, [a, b], []
    for point in order:
        start = rings[point].index(entry[point])
        for other in rings[point][start:] + rings[point][:start]:
            if other not in number:
                number[other] = len(order)
                entry[other] = point
                order.append(other)
            code.append(chr(ord("a") + number[other]))
        code.append(".")
    return "".join(code), order


def canonical(quads):
    """(code, points in its order, mirrored): the least code of all walks, in both senses."""
    rings = rings_of(quads)
    senses = (False, rings), (True, [ring[::-1] for ring in rings])
    walks = (walk(sense, a, b) + (mirrored,)
             for mirrored, sense in senses for a in range(len(rings)) for b in sense[a])
    return min(walks, key=lambda found: (found[0], found[2]))


def quad_count(code):
    return code.count(".") - 2


def quads_of(code):
    """The quads of a class, numbered as its code has them, outward."""
    rings = [[ord(letter) - ord("a") for letter in ring] for ring in code.split(".")[:-1]]
    quads = set()
    for a, ring in enumerate(rings):
        for b in ring:
            quad = [a, b]
            for _ in range(2):
                around = rings[quad[-1]]
                quad.append(around[around.index(quad[-2]) - 1])
            start = quad.index(min(quad))
            quads.add(tuple(quad[start:] + quad[:start]))
    return np.array(sorted(quads), np.int32)


def boundary_quads(hexes):
    """Faces met by one hex only, outward, their points numbered 0, 1, 2 ...; and those points."""
    faces = hexes[:, FACES].reshape(-1, 4)
    _, number, count = np.unique(np.sort(faces, axis=1), axis=0, return_inverse=True, return_counts=True)
    lone = faces[count[number.ravel()] == 1]
    points = np.unique(lone)
    return np.searchsorted(points, lone), points


def normalised(hexes):
    """(code, hexes): any filling numbered and turned as its class is, boundary points first."""
    quads, points = boundary_quads(hexes)
    code, order, mirrored = canonical(quads)
    inner = np.setdiff1d(hexes, points)
    number = np.empty(hexes.max() + 1, np.int32)
    number[points[order]] = np.arange(len(order))
    number[inner] = len(order) + np.arange(len(inner))
    hexes = number[hexes]
    return code, hexes[:, [4, 5, 6, 7, 0, 1, 2, 3]] if mirrored else hexes


def worth(hexes):
    """The smaller the better: hexes, and then edges of the boundary with one hex only, where the surface must not
    be flat."""
    edges, count = np.unique(np.sort(hexes[:, EDGES].reshape(-1, 2), axis=1), axis=0, return_counts=True)
    faces = np.sort(hexes[:, FACES].reshape(-1, 4), axis=1)
    _, number, uses = np.unique(faces, axis=0, return_inverse=True, return_counts=True)
    outside = np.unique(faces[uses[number.ravel()] == 1])
    return len(hexes), int(((count == 1) & np.isin(edges, outside).all(axis=1)).sum())


def ids_text(hexes):
    return "".join(DIGITS[i // 64] + DIGITS[i % 64] for i in hexes.ravel().tolist())


def read_ids(text):
    digits = np.array([VALUES[digit] for digit in text]).reshape(-1, 8, 2)
    return (digits @ [64, 1]).astype(np.int32)


class Record:
    """A filling of a class: its boundary points first, numbered as the code has them; points (P, 3) of the
    canonical polyhedron and inside it, the largest coordinate 1."""

    def __init__(self, code, certified, hexes, points):
        self.code, self.certified, self.hexes, self.points = code, certified, hexes, points

    @classmethod
    def read(cls, line):
        code, flag, ids, places = line.split()
        digits = np.array([VALUES[digit] for digit in places]).reshape(-1, 3, 3)
        return cls(code, flag == "1", read_ids(ids), digits @ [4096, 64, 1] * (2 / STEPS) - 1)

    def line(self):
        steps = np.rint((self.points + 1) * (STEPS / 2)).astype(int)
        places = "".join(DIGITS[i // 4096] + DIGITS[i // 64 % 64] + DIGITS[i % 64]
                         for i in steps.ravel().tolist())
        return f"{self.code} {int(self.certified)} {ids_text(self.hexes)} {places}"

    def rank(self):
        """The smaller the better: certified ones first."""
        return not self.certified, *worth(self.hexes)


def as_record(target, filling):
    """Certified as it is written: rounded."""
    points = filling.points / np.abs(filling.points).max()
    record = Record.read(Record(target.code, False, filling.hexes, points).line())
    proof = hn.certify(record.points, record.hexes, target.quads)
    if not (proof.proper and proof.conforming and proof.boundary_exact):
        raise RuntimeError(f"a filling of {target.code} is not proper")
    record.certified = bool(proof.certified)
    return record


def read_table(path):
    lines = path.read_text(encoding="ascii").splitlines() if path.exists() else []
    records = [Record.read(line) for line in lines if not line.startswith("#")]
    return {record.code: record for record in records}


def write_table(path, table):
    path.parent.mkdir(parents=True, exist_ok=True)
    beside = path.with_suffix(".new")
    lines = [table[code].line() for code in sorted(table)]
    beside.write_text(HEADER + "".join(line + "\n" for line in lines), encoding="ascii")
    os.replace(beside, path)


class Pool:
    """The smallest fillings met of each class: {code: [[tried, hexes], ...]}, fewest hexes first. A file keeps it;
    `tried` tells whether it had a geometry already that did not succeed."""

    def __init__(self, path, room):
        self.path, self.room, self.fillings = path, room, {}
        for line in path.read_text(encoding="ascii").splitlines() if path.exists() else []:
            code, tried, ids = line.split()
            self.fillings.setdefault(code, []).append([tried == "1", read_ids(ids)])
        for known in self.fillings.values():
            known.sort(key=lambda filling: worth(filling[1]))

    def add(self, hexes):
        """Of any numbering. Returns the code."""
        code, hexes = normalised(hexes)
        known = self.fillings.setdefault(code, [])
        if len(known) == self.room and worth(hexes) >= worth(known[-1][1]):
            return code
        ids = ids_text(hexes)
        if not any(len(other) == len(hexes) and ids_text(other) == ids for _, other in known):
            known.append([False, hexes])
            known.sort(key=lambda filling: worth(filling[1]))
            del known[self.room:]
        return code

    def write(self):
        self.path.parent.mkdir(parents=True, exist_ok=True)
        beside = self.path.with_suffix(".new")
        beside.write_text("".join(f"{code} {int(tried)} {ids_text(hexes)}\n" for code in sorted(self.fillings)
                                  for tried, hexes in self.fillings[code]), encoding="ascii")
        os.replace(beside, self.path)

    def print_figures(self):
        for n in range(6, 17, 2):
            sizes = [len(known[0][1]) for code, known in self.fillings.items() if quad_count(code) == n]
            if sizes:
                print(f"  {n} quads: {len(sizes)} of {CLASSES[n]} classes, hexes {min(sizes)} / "
                      f"{np.mean(sizes):.1f} / {max(sizes)}", flush=True)


# ------------------------------------------------------------------------------------ search and geometry

class Target:
    """A class as its canonical polyhedron."""

    def __init__(self, code):
        self.code, self.quads = code, quads_of(code)
        self.points = canonical_polyhedron(self.quads)

    def fixed(self, count):
        return np.arange(count) < len(self.points)

    def write(self, path):
        lines = [f"v {i} {' '.join(map(repr, point))} p" for i, point in enumerate(self.points.tolist())]
        lines += ["q " + " ".join(map(str, quad)) for quad in self.quads.tolist()]
        path.write_text("\n".join(lines) + "\n", encoding="ascii")


def as_words(hexes):
    return f"{len(hexes)} {' '.join(map(str, hexes.ravel().tolist()))}\n"


def as_hexes(line):
    return np.array(line.split()[1:], np.int32).reshape(-1, 8)


def run_tool(options, mode, text, **words):
    """Lines of its answer, as they come."""
    words = [str(word) for pair in words.items() for word in pair]
    process = subprocess.Popen([options.tool, mode, *words], text=True, stdin=subprocess.PIPE,
                               stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    writer = threading.Thread(target=lambda: (process.stdin.write(text), process.stdin.close()))
    writer.start()
    yield from process.stdout
    writer.join()
    if process.wait():
        raise RuntimeError("the search tool failed")


def search(pool, options):
    """Look for fillings of each class, and shrink the known ones."""
    codes = [code for code in options.codes if not options.missing or code not in pool.fillings]
    text = []
    for i, code in enumerate(codes):
        path = options.pool.parent / f"target{i}.txt"
        Target(code).write(path)
        known = [hexes for _, hexes in pool.fillings.get(code, [])]
        text.append(f"{path} {len(known)}\n" + "".join(map(as_words, known)))
    done = 0
    for line in run_tool(options, "batch", "".join(text), quads=options.quads, entries=options.entries,
                         alternatives=options.alternatives, width=options.width, seconds=options.seconds,
                         shrink=options.shrink, cavity_quads=options.quads, keep=options.keep,
                         seed=options.seed):
        if line.strip() == "0":
            done += 1
            if done % 20 == 0:
                pool.write()
        else:
            pool.add(as_hexes(line))
    pool.write()


def spread(pool, options):
    """Glue hexes to known fillings."""
    text = "".join(as_words(hexes) for known in pool.fillings.values() for _, hexes in known)
    for line in run_tool(options, "spread", text, quads=options.spread_quads, alternatives=1,
                         entries=options.spread_entries, table_hexes=80, keep=options.keep,
                         small=options.most_quads):
        pool.add(as_hexes(line))
    pool.write()


def realised(target, hexes, rounds):
    """A filling with its inner points smoothed and untangled, until every hex is clearly positive: the core
    improves it further where it is used."""
    count = hexes.max() + 1
    inner = np.tile(target.points.mean(axis=0), (count - len(target.points), 1))
    points = smoothed(np.vstack([target.points, inner]), hexes, ~target.fixed(count), 100)
    return Filling(hn.optimize(points, hexes, target.fixed(count), rounds=rounds, target=0.05, threads=1), hexes)


def template_fillings():
    """{code: hexes} of shipped templates with a small boundary: they suit its flat sides, as others of the same
    size may not."""
    found = {}
    for name in ("schneiders_pyramid_36", "trapezohedron_40"):
        lines = (ROOT / "resources" / "templates" / f"{name}.txt").read_text(encoding="ascii").splitlines()
        code, hexes = normalised(read(lines)[1])
        found[code] = hexes
    return found


def best_record(task):
    """(code, tried hexes, record or None): the first filling that can be certified, or the smallest one."""
    code, fillings, rounds = task
    target, best, tried = Target(code), None, 0
    for hexes in fillings:
        tried += 1
        record = as_record(target, realised(target, hexes, rounds))
        if best is None or record.rank() < best.rank():
            best = record
        if best.certified:
            break
    return code, tried, best


def realise(pool, options):
    """Give the smallest fillings a geometry, where the table has none as small."""
    table = read_table(options.table)
    tasks, templates = [], template_fillings()
    for code in options.codes:
        most = worth(table[code].hexes) if code in table and table[code].certified else (1000, 0)
        fillings = [hexes for tried, hexes in pool.fillings.get(code, []) if not tried and worth(hexes) < most]
        if code in templates and not (code in table and len(table[code].hexes) < len(templates[code])):
            fillings = [hexes for hexes in fillings if len(hexes) < len(templates[code])] + [templates[code]]
        if fillings:
            tasks.append((code, fillings[:options.tries], options.rounds))
    tasks.sort(key=lambda task: (task[0] not in templates, task[0] in table))
    with multiprocessing.Pool(options.processes) as workers:
        for number, (code, tried, record) in enumerate(workers.imap_unordered(best_record, tasks)):
            fresh = [filling for filling in pool.fillings[code] if not filling[0]]
            for filling in fresh[:tried]:
                filling[0] = True
            if code not in table or code in templates or record.rank() < table[code].rank():
                table[code] = record
            if number % 20 == 0:
                write_table(options.table, table)
    write_table(options.table, table)
    pool.write()
    print_figures(table)


def print_figures(table):
    for n in range(6, 17, 2):
        records = [record for record in table.values() if quad_count(record.code) == n]
        sizes = [len(record.hexes) for record in records]
        if sizes:
            print(f"  {n} quads: {len(records)} of {CLASSES[n]} classes, hexes {min(sizes)} / "
                  f"{np.mean(sizes):.1f} / {max(sizes)}, certified "
                  f"{sum(record.certified for record in records)}", flush=True)


STEPS_OF_WORK = {"search": search, "spread": spread, "realise": realise}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add = parser.add_argument
    add("work", nargs="+", choices=STEPS_OF_WORK)
    add("--table", type=Path, default=ROOT / "resources" / "fillings" / "smallest.txt")
    add("--pool", type=Path, default=Path("output/fillings/pool.txt"))
    add("--tool", type=Path, default=TOOL)
    add("--least-quads", type=int, default=6)
    add("--most-quads", type=int, default=16)
    add("--missing", action="store_true", help="search: only classes without a filling")
    add("--quads", type=int, default=22, help="of the search's table and cavities")
    add("--entries", type=float, default=5e5)
    add("--alternatives", type=int, default=3)
    add("--width", type=int, default=300, help="of the beam")
    add("--seconds", type=float, default=8, help="of the beam, for each class")
    add("--shrink", type=float, default=4, help="seconds of re-filling, for each class")
    add("--spread-quads", type=int, default=20)
    add("--spread-entries", type=float, default=1e6)
    add("--keep", type=int, default=12, help="fillings of each class in the pool")
    add("--tries", type=int, default=12, help="fillings of each class that are given a geometry")
    add("--rounds", type=int, default=9, help="of untangling: one is quick and mostly enough")
    add("--processes", type=int, default=1)
    add("--seed", type=int, default=1)
    options = parser.parse_args()
    classes = all_quadrangulations(options.most_quads)
    options.codes = [canonical(quads)[0] for n in range(options.least_quads, options.most_quads + 1, 2)
                     for quads in classes[n]]
    pool = Pool(options.pool, options.keep)
    started = time.monotonic()
    for step in options.work:
        STEPS_OF_WORK[step](pool, options)
        print(f"{time.monotonic() - started:.0f} s: {step}", flush=True)
        pool.print_figures()


if __name__ == "__main__":
    main()
