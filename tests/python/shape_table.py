# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of what untangling, optimisation and homotopy reach: Markdown on standard output.

PYTHONPATH=.:workbench:tests/python python3 tests/python/shape_table.py fits --count 1000
"""
import argparse
import pathlib
import time

import numpy as np
from cell_meshes import build_cells
from cell_surfaces import PLAIN
from deformed_boxes import BINS, deformed_cells
from impossible import impossible_reason
from mesh_checker import nonpositive
from scrambled import scramble, swept_meshes
from template_files import load_template, names

import hexcon_native as hn

FITTED = ("domino_62", "halfcell_diced_41", "geode_26", "schneiders_pyramid_36")


def timed(call, *arguments, **options):
    """(result, seconds)"""
    start = time.perf_counter()
    return call(*arguments, **options), time.perf_counter() - start


def print_row(*cells):
    print("| " + " | ".join(f"{cell:.4g}" if isinstance(cell, float) else str(cell)
                            for cell in cells) + " |", flush=True)


def print_head(*cells):
    print_row(*cells)
    print_row(*["---"] * len(cells))


# -------------------------------------------------------------------------------------------- fits

def fit(template, start, target, folder, name):
    """One homotopy: (outcome, seconds, worst scaled Jacobian). A failure that is not proved to be
    none is kept in the folder."""
    (points, reached), seconds = timed(hn.morph, start, template.hexes, target, template.fixed)
    exact = points[template.fixed].tobytes() == target[template.fixed].tobytes()
    bad = len(nonpositive(points, template.hexes))
    if reached == 1 and exact and not bad:
        return "fitted", seconds, hn.quality(points, template.hexes).min
    reason = impossible_reason(target, template.hexes, template.fixed)
    if reason is not None and not bad:
        return "impossible", seconds, np.nan
    np.savez(folder / f"fail_{name}.npz", start=start, target=target, hexes=template.hexes,
             fixed=template.fixed)
    with open(folder / "FAILS.txt", "a", encoding="ascii") as stream:
        print(f"fail_{name}.npz: reached {reached:.6f}, fixed points at the goal: {exact}, "
              f"{bad} hexes not positive", file=stream)
    return "failed", seconds, np.nan


def print_fits(options):
    folder = pathlib.Path(options.failures)
    folder.mkdir(parents=True, exist_ok=True)
    print_head("template", "measure", "cells", "impossible", "failed", "success of the others",
               "ms mean", "ms max", "worst SJ min", "worst SJ mean")
    for name in options.names or FITTED:
        template = load_template(name)
        rows = [(value, *fit(template, start, target, folder, f"{name}_{k}"))
                for k, (start, target, value) in enumerate(deformed_cells(name, options.count,
                                                                          options.seed))]
        value, outcome, seconds, worst = (np.array(column) for column in zip(*rows))
        for low, high in [*zip(BINS[:-1], BINS[1:]), (BINS[0], BINS[-1])]:
            here = (value >= low) & (value <= high)
            if here.any():
                _print_fit_row(f"{name} | {low:.1f} .. {high:.1f}", outcome[here],
                               1000 * seconds[here], worst[here])


def _print_fit_row(title, outcome, milliseconds, worst):
    count, impossible, failed = (int((outcome == word).sum()) for word in
                                 ("fitted", "impossible", "failed"))
    share = f"{100 * count / (count + failed):.2f} %" if count + failed else "-"
    reached = worst[outcome == "fitted"]
    print_row(title, len(outcome), impossible, failed, share, float(milliseconds.mean()),
              float(milliseconds.max()), *((float(reached.min()), float(reached.mean()))
                                           if count else ("-", "-")))


# ------------------------------------------------------------------------------ the other subjects

def print_templates(options):
    print_head("template", "hexes", "file min", "file mean", "ours min", "ours mean", "difference",
               "not positive", "seconds")
    for name in options.names or names():
        template = load_template(name)
        points, seconds = timed(hn.optimize, template.collapsed, template.hexes, template.fixed,
                                threads=options.threads)
        file, ours = (hn.quality(p, template.hexes) for p in (template.points, points))
        print_row(name, len(template.hexes), file.min, file.mean, ours.min, ours.mean,
                  ours.min - file.min, len(nonpositive(points, template.hexes)), seconds)


def print_scrambles(options):
    print_head("mesh", "hexes", "bad before", "bad after", "original min", "ours min", "ratio",
               "seconds")
    for name, (points, hexes, fixed) in swept_meshes(options.size):
        if options.names and name not in options.names:
            continue
        start = scramble(points, hexes, fixed, options.amount, options.seed)
        moved, seconds = timed(hn.optimize, start, hexes, fixed, threads=options.threads)
        original, ours = hn.quality(points, hexes).min, hn.quality(moved, hexes).min
        print_row(name, len(hexes), len(nonpositive(start, hexes)), len(nonpositive(moved, hexes)),
                  original, ours, ours / original, seconds)


def print_cells(options):
    print_head("surface", "cells", "hexes", "bad before", "bad after", "min", "q05", "mean",
               "seconds")
    for name in options.names or PLAIN:
        points, quads = PLAIN[name](np.random.default_rng([options.seed, *name.encode()]))
        for kind in ("domino", "halfcell"):
            start, hexes, fixed = build_cells(points, quads, kind)
            moved, seconds = timed(hn.optimize, start, hexes, fixed, threads=options.threads)
            after = hn.quality(moved, hexes)
            print_row(name, kind, len(hexes), len(nonpositive(start, hexes)),
                      len(nonpositive(moved, hexes)), after.min, after.q05, after.mean, seconds)


def main():
    subjects = {"fits": print_fits, "templates": print_templates, "scrambles": print_scrambles,
                "cells": print_cells}
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("subject", choices=subjects)
    parser.add_argument("names", nargs="*", help="templates, meshes or surfaces; default: all")
    parser.add_argument("--count", type=int, default=96, help="deformed cells of each template")
    parser.add_argument("--size", type=int, default=1000, help="hexes of a scrambled mesh, about")
    parser.add_argument("--amount", type=float, default=5, help="of scrambling, in edge lengths")
    parser.add_argument("--threads", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--failures", default="/tmp/shape-data",
                        help="folder for fits that fail and are not proved impossible")
    options = parser.parse_args()
    subjects[options.subject](options)


if __name__ == "__main__":
    main()
