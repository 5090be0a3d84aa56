# SPDX-License-Identifier: LGPL-2.1-or-later
"""Given quad surfaces filled by `auto`, each beside a public hex mesh of the same boundary: docs/scoreboard.md.

    PYTHONPATH=.:workbench python3 scripts/scoreboard.py FOLDER [--limit 60] [--result output/scoreboard.jsonl] [--page]

FOLDER holds .npz files with points (V, 3) float and quads (n, 4) int, 0-based, closed and outward, and perhaps an
INDEX.md with a table: file, repository, quads, genus, and of the public mesh hexes, min, mean, inverted.

Every surface is filled in a process of its own, in one thread, with a limit of processor time and of memory. What is
called certified is judged once more by tests/python/mesh_checker.py, which shares no code with the core. A line of the
result file is kept: a run that was stopped goes on where it was; remove the file to measure anew. --page writes the
page's table, medians and picture from the result file.
"""
import argparse
import json
import os
import sys
import time
from concurrent import futures

from measuring import already, in_a_child, judged, keep, processor_seconds

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
GRACE = 3.0     # times the limit, in processor seconds: what a signal ends, should the budget not have ended it before


def measured(path, limit):
    """Figures of one surface, in this process."""
    import numpy as np

    import hexcon
    import hexcon_native as hn
    with np.load(path, allow_pickle=False) as arrays:
        points, quads = arrays["points"].astype(float), arrays["quads"].astype(np.int64)
    found, before = {"quads": len(quads)}, processor_seconds()
    try:
        facts = hn.check_surface(points, quads)
        found |= {"genus": int(facts.genus), "cavities": int(facts.cavities)}
        mesh = hexcon.mesh_surface(points, quads, threads=1, budget=limit * _busy())
    except hexcon.HexconError as error:
        return found | {"code": error.code.name, "message": str(error)[:300], "seconds": processor_seconds() - before}
    found["seconds"] = processor_seconds() - before
    return found | judged(mesh, points, quads)


def _busy():
    """Seconds of the clock that a second of processor time takes on this machine now: budgets go by the clock."""
    start, used = time.monotonic(), time.process_time()
    while time.process_time() - used < 0.2:
        sum(range(1000))
    return max(1.0, (time.monotonic() - start) / (time.process_time() - used))


def in_its_own_process(path, options):
    """Figures of one surface, whatever becomes of the process."""
    most = int(GRACE * options.limit) + 5
    command = [sys.executable, __file__, "--one", path, "--limit", str(options.limit)]
    found = in_a_child(command, processor=most, memory=options.memory, clock=60 * options.limit + 600)
    return {"seconds": float(most) if found["code"] == "TIME_LIMIT" else 0.0, **found}


def witnesses(folder):
    """{file: repository and figures of its public mesh} of the folder's INDEX.md; nothing where there is none."""
    path = os.path.join(folder, "INDEX.md")
    if not os.path.isfile(path):
        return {}
    found = {}
    with open(path, encoding="utf-8") as stream:
        for line in stream:
            cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
            if len(cells) == 8 and cells[0].endswith(".npz"):
                found[cells[0]] = {"repository": cells[1]} | ({"witness": {
                    "hexes": int(cells[4]), "min": float(cells[5]), "mean": float(cells[6])}} if cells[4] else {})
                if cells[2]:
                    found[cells[0]] |= {"quads": int(cells[2]), "genus": int(cells[3])}
    return found


def run(options):
    """Measure what is not in the result file yet, small surfaces first, some at once; prints a line each."""
    known, index = already(options.result, "name"), witnesses(options.folder)
    files = sorted((name for name in os.listdir(options.folder) if name.endswith(".npz")),
                   key=lambda name: (os.path.getsize(os.path.join(options.folder, name)), name))
    left = [file for file in files if file[:-len(".npz")] not in known]
    with futures.ThreadPoolExecutor(options.jobs) as pool:
        running = {pool.submit(in_its_own_process, os.path.join(options.folder, file), options): file for file in left}
        for done in futures.as_completed(running):
            file = running[done]
            name = file[:-len(".npz")]
            known[name] = {"name": name, "quads": 0, "genus": 0, "cavities": 0, "limit": options.limit,
                           **index.get(file, {}), **done.result()}
            keep(options.result, known[name])
            print(f"{len(known):3d} of {len(files)}  {line_of(known[name])}", flush=True)
    return [known[file[:-len(".npz")]] for file in files]


def line_of(one):
    words = "{name:42s} {quads:6d} quads genus {genus:2d} {code:14s} {seconds:6.1f} s".format(**one)
    if "hexes" in one:
        words += f"  {one['method']:9s} {one['hexes']:7d} hexes {one['min']:.3f} {one['mean']:.3f}"
    return words + (f"  (public: {one['witness']['hexes']} {one['witness']['min']:.3f} {one['witness']['mean']:.3f})"
                    if "witness" in one else "")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", nargs="?", help="of .npz files")
    parser.add_argument("--limit", type=float, default=60.0, help="processor seconds for a surface (default 60)")
    parser.add_argument("--memory", type=int, default=8192, help="MiB for a surface (default 8192)")
    parser.add_argument("--jobs", type=int, default=1, help="surfaces at once (default 1)")
    parser.add_argument("--result", default=os.path.join(ROOT, "output", "scoreboard.jsonl"))
    parser.add_argument("--page", action="store_true", help="write docs/scoreboard.md and its picture")
    parser.add_argument("--one", help=argparse.SUPPRESS)
    options = parser.parse_args()
    sys.path[:0] = [os.path.join(ROOT, "tests", "python")]
    if options.one is not None:
        print("\n" + json.dumps(measured(options.one, options.limit)), flush=True)
        return 0
    if not options.folder or not os.path.isdir(options.folder):
        print(f"scoreboard: there is no folder {options.folder!r}: name one of .npz files with points and quads "
              "(make scoreboard SCOREBOARD_SURFACES=FOLDER)", file=sys.stderr)
        return 2
    found = run(options)
    print(f"{sum(one['code'] == 'CERTIFIED' for one in found)} of {len(found)} certified")
    if options.page and found:
        from scoreboard_page import write_page
        write_page(found, options.result)
    return 0


if __name__ == "__main__":
    sys.exit(main())
