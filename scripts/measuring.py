# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the scripts that measure many bodies share: a child with limits for each, and a file of lines to go on from."""
import argparse
import json
import os
import resource
import subprocess
import tempfile


def in_a_child(command, *, processor=None, memory=None, clock=None):
    """The last line of JSON that a command prints, or the code of what became of it, and a message.

    processor   seconds of processor time for the child, and for each process that it starts
    memory      MiB of address space;  clock: seconds of the clock
    The codes: TIME_LIMIT, MEMORY_LIMIT, CRASH.
    """
    def limits():
        if processor:
            resource.setrlimit(resource.RLIMIT_CPU, (int(processor), int(processor) + 5))   # SIGXCPU, then SIGKILL
        if memory:
            resource.setrlimit(resource.RLIMIT_AS, (memory << 20,) * 2)
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=clock, check=False, preexec_fn=limits)
    except subprocess.TimeoutExpired:
        return {"code": "TIME_LIMIT", "message": f"not done in {clock:g} seconds of the clock"}
    lines = [line for line in done.stdout.splitlines() if line.startswith("{")]
    if not done.returncode and lines:
        return json.loads(lines[-1])
    if done.returncode in (-24, -9):
        return {"code": "TIME_LIMIT", "message": f"not done in {processor or 0:g} processor seconds"}
    code = "MEMORY_LIMIT" if "MemoryError" in done.stderr else "CRASH"
    return {"code": code, "message": f"status {done.returncode}: {done.stderr.strip()[-300:]}"}


def already(path, key):
    """found[key] -> found, of the lines of an earlier run; the folder of the file is made."""
    os.makedirs(os.path.dirname(path) or ".", exist_ok=True)
    if not os.path.exists(path):
        return {}
    with open(path, encoding="utf-8") as stream:
        return {found[key]: found for found in map(json.loads, stream)}


def keep(path, found):
    """Add a line to the file."""
    with open(path, "a", encoding="utf-8") as stream:
        stream.write(json.dumps(found) + "\n")


def table_of_bodies(words, bodies, usual, result, measured, rows):
    """The main program of a table with some rows for each body: those of the result file are kept, others measured.

    words    the program's own, of which the first line is its help;  bodies: all names;  usual: those it measures
    result   path of the file of lines, where the command line names no other
    measured callable(name, folder) -> what a line holds;  rows: callable([line]) -> the table, its two heads first
    """
    parser = argparse.ArgumentParser(description=words.splitlines()[0])
    parser.add_argument("--body", nargs="+", choices=bodies, default=usual)
    parser.add_argument("--result", default=result)
    options = parser.parse_args()
    known = already(options.result, "body")
    for name in options.body:
        if name not in known:
            with tempfile.TemporaryDirectory() as folder:
                known[name] = measured(name, folder)
            keep(options.result, known[name])
        print(*rows([json.dumps(known[name])])[2:], sep="\n", flush=True)


def processor_seconds():
    """Of this process and of the children that it has waited for."""
    return sum(used.ru_utime + used.ru_stime
               for used in map(resource.getrusage, (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)))


def judged(mesh, points, quads):
    """Figures of a mesh in quads of points; called certified only if tests/python/mesh_checker.py finds no fault."""
    import mesh_checker
    faults = mesh_checker.faults(mesh.points, mesh.hexes, quads, points)
    return {"code": "CERTIFIED" if mesh.certificate.certified and not faults else "NOT_CONFIRMED",
            "message": "; ".join(faults)[:300], "method": mesh.method, "hexes": len(mesh.hexes),
            "min": mesh.quality.min, "q05": mesh.quality.q05, "mean": mesh.quality.mean,
            "log": [str(line) for line in mesh.report.get("log", [])]}


def failures(found, key):
    """Lines: which were not certified, by code."""
    by_code = {}
    for one in found:
        by_code.setdefault(one["code"], []).append(str(one[key]))
    return [f"  {code}: {len(names)} ({', '.join(names)})" for code, names in sorted(by_code.items())
            if code != "CERTIFIED"]
