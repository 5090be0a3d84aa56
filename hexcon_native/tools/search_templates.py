# SPDX-License-Identifier: LGPL-2.1-or-later
"""Search for hex meshes that fill the boundary of a template file, with few hexes and good ones.

    ninja -C build/release hexcon_template_search
    PYTHONPATH=. python3 hexcon_native/tools/search_templates.py \\
        resources/templates/domino_62.txt --slide --seconds 3600

The README beside this file says how it works. Every mesh written is certified.
"""
import argparse
import math
import os
import random
import subprocess
import time
from pathlib import Path

import numpy as np
from improve_templates import read

import hexcon_native as hn

ROOT = Path(__file__).resolve().parents[2]
TOOL = ROOT / "build" / "release" / "hexcon_template_search"
EDGES = np.array([(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4),
                  (0, 4), (1, 5), (2, 6), (3, 7)])


class Target:
    """The boundary to be filled: its lines of the template file, points, labels and quads."""

    def __init__(self, path):
        lines = path.read_text(encoding="ascii").splitlines()
        points, self.hexes, inside, self.quads = read(lines)
        self.path, self.all_points = path, points
        self.points = points[~inside]
        labels = [line.split()[5] for line in lines if line.startswith("v ")]
        self.labels = labels[:len(self.points)]
        self.slides = slides(self.labels)

    def fixed(self, count):
        return np.arange(count) < len(self.points)


def slides(labels):
    """Ways to move the boundary of half-cells and dominoes that keep all sides alike, each as a
    displacement (points, 3): side points in their planes, the inner face's points in theirs."""
    if not {"O0", "O1", "O2", "O3", "I0"} <= set(labels):
        return []
    corners = np.array([(0, 0), (1, 0), (1, 1), (0, 1)], float)
    moves = {}

    def move(name, row, *direction):
        moves.setdefault(name, np.zeros((len(labels), 3)))[row] = direction

    for row, label in enumerate(labels):
        side = -1.0 if label[0] == "b" else 1.0
        name = label.removeprefix("b")
        if name[0] in "CE" and name[1:].isdigit():
            a, b = int(name[1]), int(name[2])
            black, white = (a, b) if a % 2 == 0 else (b, a)
            x, y = corners[white] - corners[black]
            move(name[0] + " along", row, x, side * y, 0)
            if name[0] == "C":
                move("C up", row, 0, 0, 1)
        elif name in ("M0", "M2"):
            move("M up", row, 0, 0, 1)
        elif name in ("Sx", "Sy"):
            move(name + " along", row, 1, 0, 0)
            move(name + " up", row, 0, 0, 1)
        elif name in ("N", "Ga", "Gb", "Ic"):
            move(name + " x", row, 1, 0, 0)
            move(name + " y", row, 0, side, 0)
    return list(moves.values())


class Filling:
    """A mesh of the target: points (the boundary's first), hexes, name, and how good it is."""

    def __init__(self, points, hexes, name=0):
        self.points, self.hexes, self.name = points, hexes, name
        self.scaled = hn.quality(points, hexes).scaled_jacobian
        bad = int((self.scaled <= 0).sum())
        worst = float(self.scaled.min())
        self.score = 0.1 * worst - 0.03 * bad if bad else worst

    @property
    def count(self):
        return len(self.hexes)


def smoothed(points, hexes, moving, sweeps):
    """Moving points to the mean of their neighbours, again and again."""
    pairs = np.unique(np.sort(hexes[:, EDGES].reshape(-1, 2), axis=1), axis=0)
    ends = np.concatenate([pairs, pairs[:, ::-1]])
    ends = ends[moving[ends[:, 0]]]
    degree = np.bincount(ends[:, 0], minlength=len(points))[moving]
    points = points.copy()
    for _ in range(sweeps):
        for axis in range(3):
            total = np.bincount(ends[:, 0], points[ends[:, 1], axis], len(points))
            points[moving, axis] = total[moving] / degree
    return points


def optimised(target, points, hexes, rounds):
    return hn.optimize(points, hexes, target.fixed(len(points)), rounds=rounds, threads=1)


def realised(target, hexes, name=0):
    """A filling from scratch: all inner points in the middle, smoothed, untangled, improved."""
    count = hexes.max() + 1
    points = np.vstack([target.points, np.tile(target.points.mean(axis=0),
                                               (count - len(target.points), 1))])
    points = smoothed(points, hexes, ~target.fixed(count), 100)
    return Filling(optimised(target, points, hexes, 9), hexes, name)


class Refiller:
    """The search tool as a server: asked for other fillings, it re-fills random parts."""

    def __init__(self, tool, target, **options):
        words = [str(word) for pair in options.items() for word in pair]
        self.process = subprocess.Popen([tool, "refill", target.path, *words], text=True,
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def ask(self, filling, slack, most_hexes, focus=-1, most_part=30, tries=20):
        """Hexes of another filling with ids of the old points kept, and its name; or None."""
        ids = " ".join(map(str, filling.hexes.ravel()))
        self.process.stdin.write(f"{tries} {slack} {most_hexes} {focus} {most_part} "
                                 f"{len(filling.points)} {filling.count} {ids}\n")
        self.process.stdin.flush()
        numbers = self.process.stdout.readline().split()
        if not numbers:
            raise RuntimeError("the search tool ended")
        if numbers[0] == "0":
            return None
        return np.array(numbers[2:], np.int32).reshape(-1, 8), int(numbers[0])

    def close(self):
        self.process.stdin.close()
        self.process.wait()


def found_by_beam(tool, target, **options):
    """Hexes of the fillings that the tool finds from the boundary alone."""
    words = [str(word) for pair in options.items() for word in pair]
    lines = subprocess.run([tool, "fill", target.path, *words], text=True, check=True,
                           stdout=subprocess.PIPE).stdout.splitlines()
    return [np.array(line.split()[1:], np.int32).reshape(-1, 8) for line in lines]


def settled(target, old, hexes, name, bar):
    """The swapped mesh with its points placed; given up early where it stays below the bar."""
    used = np.union1d(np.arange(len(target.points)), hexes)
    new = used >= len(old.points)
    points = np.empty((len(used), 3))
    points[~new] = old.points[used[~new]]
    points[new] = old.points[np.intersect1d(hexes, np.arange(len(old.points)))].mean(axis=0)
    hexes = np.searchsorted(used, hexes).astype(np.int32)
    if new.any():
        points = smoothed(points, hexes, new, 15)
    filling = Filling(optimised(target, points, hexes, 1), hexes, name)
    if filling.score < 0 < bar:
        return filling
    if filling.score < 0:
        filling = Filling(optimised(target, filling.points, hexes, 3), hexes, name)
    if filling.score > max(bar, 0):
        filling = Filling(optimised(target, filling.points, hexes, 6), hexes, name)
    return filling


def slid(target, old, dice, step):
    """The same mesh with its boundary moved a little, sides alike, and what is inside along."""
    shift = np.zeros_like(old.points)
    for way in dice.sample(target.slides, dice.randint(1, 3)):
        shift[:len(target.points)] += step * dice.gauss(0, 1) * way
    shift = smoothed(shift, old.hexes, ~target.fixed(len(shift)), 20)
    points = optimised(target, old.points + shift, old.hexes, 3)
    return Filling(points, old.hexes, old.name)


def polished(target, filling, dice, tries):
    """The boundary moved for as long as that helps, with steps as large as succeed."""
    step = 0.02
    for _ in range(tries if target.slides else 0):
        other = slid(target, filling, dice, step)
        better = other.score > filling.score
        step *= 1.6 if better else 0.93
        filling = other if better else filling
    return filling


class Archive:
    """The best few fillings for each number of hexes; certified bests go to files."""

    def __init__(self, target, folder, size=12):
        self.target, self.folder, self.size = target, folder, size
        self.niches, self.written, self.started = {}, {}, time.monotonic()
        self.stale = {}

    def add(self, filling):
        """Keep it if it is among the best with so many hexes."""
        niche = self.niches.setdefault(filling.count, [])
        same = [other for other in niche if other.name == filling.name]
        alike = [other for other in niche if abs(other.score - filling.score) < 5e-4]
        if len(alike) > 2 or same and same[0].score >= filling.score:
            return
        niche[:] = [other for other in niche if other.name != filling.name] + [filling]
        niche.sort(key=lambda other: -other.score)
        del niche[self.size:]
        if niche[0] is filling:
            self.stale[filling.count] = 0
            self.write(filling)

    def write(self, filling):
        """Improve a best filling further, and write it if it is certified and better."""
        if filling.score < self.written.get(filling.count, 0) + 1e-3:
            return
        better = Filling(optimised(self.target, filling.points, filling.hexes, 20), filling.hexes,
                         filling.name)
        if not hn.certify(better.points, better.hexes, self.target.quads).certified:
            return
        filling.points, filling.scaled, filling.score = better.points, better.scaled, better.score
        self.written[filling.count] = filling.score
        path = self.folder / f"{self.target.path.stem.rsplit('_', 1)[0]}_{filling.count}.txt"
        beside = path.with_suffix(".new")
        beside.write_text(as_text(self.target, filling), encoding="ascii")
        os.replace(beside, path)
        print(f"{time.monotonic() - self.started:7.0f} s  {filling.count} hexes  worst "
              f"{filling.score:.4f}  mean {filling.scaled.mean():.4f}  {path}", flush=True)

    def pick(self, dice, least_hexes, most_hexes):
        """A filling to go on from, rather a good one, and rather with as many hexes as those where
        the best one got better not long ago."""
        counts = [count for count in self.niches if least_hexes <= count <= most_hexes]
        counts = counts or [min(self.niches)]
        count, = dice.choices(counts, [1 / (5 + self.stale[count]) for count in counts])
        self.stale[count] += 1
        niche = self.niches[count]
        return niche[int(len(niche) * dice.random() ** 2)]

    def summary(self):
        return "  ".join(f"{count}: {niche[0].score:.3f} ({len(niche)})"
                         for count, niche in sorted(self.niches.items()))


def as_text(target, filling):
    """Template format; 17 digits give the points back bit for bit."""
    labels = target.labels + ["int"] * (len(filling.points) - len(target.labels))
    lines = ["# see README.md"]
    lines += [f"v {i} {' '.join(repr(float(c)) for c in point)} {label}"
              for i, (point, label) in enumerate(zip(filling.points, labels))]
    lines += ["h " + " ".join(map(str, row)) for row in filling.hexes.tolist()]
    lines += ["q " + " ".join(map(str, row)) for row in target.quads.tolist()]
    return "\n".join(lines) + "\n"


def proposal(target, refiller, old, options, known, dice):
    """Another filling near the old one, or None; `known` has those met before by name."""
    if options.slide and target.slides and old.score > 0 and dice.random() < 0.15:
        return slid(target, old, dice, 0.05 * 10 ** (-1.5 * dice.random()))
    focus = -1
    if dice.random() < 0.6:
        bad = np.flatnonzero(old.scaled <= max(old.scaled.min(), 0) + 0.1 * dice.random())
        focus = int(dice.choice(bad.tolist()))
    slack = dice.choice([0, 0, 0, 2, 2, 4, -1])
    found = refiller.ask(old, slack, options.most_hexes, focus, dice.choice([12, 20, 30]))
    if found is None:
        return None
    hexes, name = found
    if name not in known:
        known[name] = settled(target, old, hexes, name, old.score - 0.1)
    return known[name]


def walk(target, refiller, archive, options, known, dice, steps):
    """Annealing from a filling of the archive; fewer hexes are worth a little."""
    here = archive.pick(dice, options.least_hexes, options.most_hexes)
    temperature = options.temperature * 10 ** dice.uniform(-0.7, 0.7)
    for _ in range(steps):
        there = proposal(target, refiller, here, options, known, dice)
        if there is None:
            continue
        archive.add(there)
        gain = there.score - here.score + options.price * (here.count - there.count)
        if gain > 0 or dice.random() < math.exp(gain / temperature):
            here = there


def search(options):
    target = Target(options.target)
    dice = random.Random(options.seed)
    options.output.mkdir(parents=True, exist_ok=True)
    archive = Archive(target, options.output)
    if len(target.hexes) and not options.scratch:
        archive.add(Filling(target.all_points, target.hexes))
    for path in options.start:
        other = Target(path)
        points = other.all_points.copy()
        if not options.slide:
            points[:len(target.points)] = target.points
        archive.add(Filling(optimised(target, points, other.hexes, 9), other.hexes))
    table = {"quads": options.quads, "entries": options.entries}
    if options.beam_seconds > 0:
        for hexes in found_by_beam(options.tool, target, **table, width=options.width,
                                   seconds=options.beam_seconds, seed=options.seed,
                                   fillings=options.fillings):
            archive.add(realised(target, hexes))
    if not archive.niches:
        raise SystemExit("no filling to begin with")
    refiller = Refiller(options.tool, target, **table, alternatives=options.alternatives,
                        seed=options.seed)
    walks, known = 0, {}
    end = time.monotonic() + options.seconds
    while time.monotonic() < end:
        walk(target, refiller, archive, options, known, dice, 40)
        walks += 1
        if walks % 20 == 0:
            print(f"{time.monotonic() - archive.started:7.0f} s  {len(known)} meshes  "
                  f"{archive.summary()}", flush=True)
    refiller.close()
    for niche in list(archive.niches.values()):
        if options.polish and niche[0].score > 0:
            archive.add(polished(target, niche[0], dice, options.polish))
    return archive


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add = parser.add_argument
    add("target", type=Path, help="template file whose boundary is to be filled")
    add("--start", type=Path, nargs="*", default=[], help="other fillings to begin with")
    add("--scratch", action="store_true", help="do not begin with the target's own hexes")
    add("--output", type=Path, default=Path("output/templates"))
    add("--seconds", type=float, default=600, help="of re-filling")
    add("--beam-seconds", type=float, default=0, help="of search from the boundary alone")
    add("--width", type=int, default=2000, help="of the beam")
    add("--fillings", type=int, default=100, help="wanted from the beam")
    add("--quads", type=int, default=22, help="most boundary quads of the table")
    add("--entries", type=int, default=500_000, help="of the table")
    add("--alternatives", type=int, default=4, help="different meshes for one entry of the table")
    add("--least-hexes", type=int, default=0, help="of the meshes to go on from")
    add("--most-hexes", type=int, default=90)
    add("--price", type=float, default=0.01, help="scaled Jacobian that one hex less is worth")
    add("--temperature", type=float, default=0.02, help="of the annealing, up to five-fold")
    add("--slide", action="store_true", help="also move the boundary, all sides alike")
    add("--polish", type=int, default=0, help="moves of the boundary of the best, at the end")
    add("--seed", type=int, default=1)
    add("--tool", type=Path, default=TOOL)
    search(parser.parse_args())


if __name__ == "__main__":
    main()
