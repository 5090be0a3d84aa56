# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random CSG parts (csg_parts.py) from solid to certificate: how many succeed, and why the others do not.

    PYTHONPATH=.:workbench python3 tests/freecad/csg_table.py --first 0 --count 50 [--result output/csg.jsonl]

Every part is meshed in a process of its own, ended after --limit seconds. Its line of the result file is kept: a run
that was stopped goes on where it was; remove the file to measure anew. One line a part, then the rate.
"""
import argparse
import json
import pathlib
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "python"), str(HERE.parents[1] / "scripts")]

from measuring import already, failures, in_a_child, keep  # noqa: E402


def measured(seed, surface_method, method, limit):
    """Figures of one part, in this process."""
    from csg_parts import csg_part
    part = csg_part(seed)
    found = {"seed": seed, "steps": " ".join(part.steps), "faces": len(part.shape.Faces), "genus": part.genus,
             "cavities": part.cavities, "size": part.size}
    start = time.monotonic()
    found |= _outcome(part, surface_method, method, limit)
    return found | {"seconds": time.monotonic() - start}


def _outcome(part, surface_method, method, limit):
    import hexcon
    try:
        mesh = hexcon.mesh_solid(part.shape, part.size, surface_method=surface_method, method=method, timeout=limit)
    except hexcon.HexconError as error:
        return {"code": error.code.name, "message": str(error), "elements": len(error.elements)}
    import mesh_checker
    surface = mesh.surface
    faults = mesh_checker.faults(mesh.points, mesh.hexes, surface.quads, surface.points)
    faults += [] if mesh_euler(mesh) == expected_euler(part) else ["the Euler characteristic is wrong"]
    return {"code": "CERTIFIED" if mesh.certificate.certified and not faults else "WRONG", "message": "; ".join(faults),
            "quads": len(surface.quads), "hexes": len(mesh.hexes), "surface": surface.method, "method": mesh.method,
            "min": mesh.quality.min, "mean": mesh.quality.mean, "notes": surface.notes,
            "log": [str(line) for line in mesh.report.get("log", [])]}


def mesh_euler(mesh):
    """Euler characteristic of the hexes: V - E + F - H, counted here."""
    import numpy as np
    edges = np.array([[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4], [1, 5], [2, 6], [3, 7]])
    faces = np.array([[0, 1, 2, 3], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])
    counts = [len(np.unique(np.sort(mesh.hexes[:, part].reshape(-1, part.shape[1]), axis=1), axis=0))
              for part in (np.arange(8)[:, None], edges, faces)]
    return counts[0] - counts[1] + counts[2] - len(mesh.hexes)


def expected_euler(part):
    """Of a body: half that of its boundary."""
    return 1 + part.cavities - part.genus


def in_its_own_process(seed, options):
    command = [sys.executable, __file__, "--one", str(seed), "--surface-method", options.surface_method,
               "--method", options.method, "--limit", str(options.limit)]
    start = time.monotonic()
    found = in_a_child(command, clock=options.limit)
    return {"seed": seed, "seconds": time.monotonic() - start, **found}


def line_of(found):
    words = "{seed:4d} {code:18s} {seconds:6.1f} s  {steps:52s} {faces:3d} faces  genus {genus} cavities {cavities}".format(
        **{"steps": "", "faces": 0, "genus": 0, "cavities": 0, **found})
    if "hexes" in found:
        words += "  {surface:20s} {quads:5d} quads  {method:8s} {hexes:6d} hexes  {min:.3f} {mean:.3f}".format(**found)
    return words + (" | " + found["message"][:160] if found.get("message") else "")


def summary(found):
    certified = sum(one["code"] == "CERTIFIED" for one in found)
    return "\n".join([f"{certified} of {len(found)} certified", *failures(found, "seed")])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--count", type=int, default=50)
    parser.add_argument("--seeds", type=int, nargs="+")
    parser.add_argument("--limit", type=float, default=300.0)
    parser.add_argument("--surface-method", default="auto")
    parser.add_argument("--method", default="auto")
    parser.add_argument("--result", default="output/csg.jsonl")
    parser.add_argument("--one", type=int)
    options = parser.parse_args()
    if options.one is not None:
        print("\n" + json.dumps(measured(options.one, options.surface_method, options.method, options.limit)), flush=True)
        return
    known, seeds = already(options.result, "seed"), options.seeds or range(options.first, options.first + options.count)
    for seed in seeds:
        if seed not in known:
            known[seed] = in_its_own_process(seed, options)
            keep(options.result, known[seed])
        print(line_of(known[seed]), flush=True)
    print(summary([known[seed] for seed in seeds]))


if __name__ == "__main__":
    main()
