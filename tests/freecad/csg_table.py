# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random CSG parts (csg_parts.py) from solid to certificate: how many succeed, and why the others do not.

    PYTHONPATH=.:workbench python3 tests/freecad/csg_table.py --first 0 --count 50 [--result output/csg.jsonl]

Every part is meshed in a process of its own, ended after --limit seconds. Its line of the result file is kept: a run
that was stopped goes on where it was; remove the file to measure anew. One line a part, then the rate.
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "python")]


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
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=options.limit, check=False)
    except subprocess.TimeoutExpired:
        return {"seed": seed, "code": "TIME_LIMIT", "message": f"not done in {options.limit} s",
                "seconds": time.monotonic() - start}
    lines = [line for line in done.stdout.splitlines() if line.startswith("{")]
    if done.returncode or not lines:
        return {"seed": seed, "code": "CRASH", "message": f"status {done.returncode}: {done.stderr.strip()[-300:]}",
                "seconds": time.monotonic() - start}
    return json.loads(lines[-1])


def line_of(found):
    words = "{seed:4d} {code:18s} {seconds:6.1f} s  {steps:52s} {faces:3d} faces  genus {genus} cavities {cavities}".format(
        **{"steps": "", "faces": 0, "genus": 0, "cavities": 0, **found})
    if "hexes" in found:
        words += "  {surface:20s} {quads:5d} quads  {method:8s} {hexes:6d} hexes  {min:.3f} {mean:.3f}".format(**found)
    return words + (" | " + found["message"][:160] if found.get("message") else "")


def already(path):
    """seed -> what was found, of an earlier run."""
    if not os.path.exists(path):
        return {}
    with open(path, encoding="utf-8") as stream:
        return {found["seed"]: found for found in map(json.loads, stream)}


def summary(found):
    by_code = {}
    for one in found:
        by_code.setdefault(one["code"], []).append(one["seed"])
    return "\n".join([f"{len(by_code.get('CERTIFIED', []))} of {len(found)} certified"]
                     + [f"  {code}: {len(seeds)} ({', '.join(map(str, seeds))})"
                        for code, seeds in sorted(by_code.items()) if code != "CERTIFIED"])


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
    os.makedirs(os.path.dirname(options.result) or ".", exist_ok=True)
    known, seeds = already(options.result), options.seeds or range(options.first, options.first + options.count)
    for seed in seeds:
        if seed not in known:
            known[seed] = in_its_own_process(seed, options)
            with open(options.result, "a", encoding="utf-8") as stream:
                stream.write(json.dumps(known[seed]) + "\n")
        print(line_of(known[seed]), flush=True)
    print(summary([known[seed] for seed in seeds]))


if __name__ == "__main__":
    main()
