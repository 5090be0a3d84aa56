# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run gmsh in a process of its own: it may crash, hang, or be cancelled without harm to the caller.

The interpreter is $HEXCON_GMSH_PYTHON, or else the one in FreeCAD's preferences for HexCon, or else the first that has gmsh, numpy and
SciPy of: this one, FreeCAD's own, the system's, the first on PATH.
"""
import functools
import importlib.util
import json
import os
import shutil
import sys
import time

import hexcon_native
from hexcon import answers, child, disk, interpreter, preferences
from hexcon.errors import FaultCode, ToolError

HERE = os.path.dirname(os.path.abspath(__file__))
WORKERS = [os.path.join(HERE, *name) for name in (("quads",), ("tetrahedra",), ("smoothing",), ("curving",), ("files", "workers"))]  # packages
CORE = os.path.dirname(os.path.dirname(os.path.abspath(hexcon_native.__file__)))    # which the grid asks as well
# HXT's work depends on the order of addresses in memory: with these it is nearly always the same from run to run.
SAME_MEMORY = {"PYTHONHASHSEED": "0", "MALLOC_MMAP_THRESHOLD_": "1000000000", "MALLOC_TOP_PAD_": "268435456"}
MOST_FILES = 8 << 30    # bytes in the worker's folder: ten times what the largest surface takes
ASKING = 60     # seconds in which an interpreter must have imported gmsh
CRASHES = 30    # so often a job is started again without the step that killed it


NEEDED = ("gmsh", "numpy", "scipy")
SYSTEM_PYTHON = "/usr/bin/python3"
_ASK = ("import importlib.util; "
        f"print(*[name for name in {NEEDED} if importlib.util.find_spec(name) is None], flush=True); "
        f"import {', '.join(NEEDED)}")


@functools.cache
def gmsh_python(named=None):
    """Path of a Python that can `import gmsh, numpy, scipy`. named: the value of HEXCON_GMSH_PYTHON, or of
    FreeCAD's preference for HexCon, if set.

    Raises ToolError TOOL_MISSING, which says of each Python that was asked what it lacks. The answer is kept for the life
    of the process, until forget_gmsh_python.
    """
    if named:
        found = shutil.which(os.path.expanduser(named))
        if found and not _lacks(os.path.abspath(found)):
            return os.path.abspath(found)       # work is done in another folder
        raise ToolError(f"HEXCON_GMSH_PYTHON (or HexCon's preference) is {named}, which cannot import gmsh, numpy and scipy", FaultCode.TOOL_MISSING)
    if interpreter.is_python(sys.executable) and all(importlib.util.find_spec(name) for name in NEEDED):
        return sys.executable
    asked = []
    for python in _pythons():
        lacks = _lacks(python)
        if not lacks:
            return python
        asked.append(f"{python} {lacks}")
    raise ToolError(f"no Python with gmsh, numpy and scipy was found: {'; '.join(asked) or 'there is no Python at all'}. "
                    + how_to_get_gmsh(), FaultCode.TOOL_MISSING)


forget_gmsh_python = gmsh_python.cache_clear


def how_to_get_gmsh():
    """Words for the user: where gmsh's Python module comes from."""
    words = ("Install gmsh and scipy from FreeCAD's Addon Manager or by HexCon's preferences, or (Debian) python3-gmsh and "
             "python3-scipy, or set HEXCON_GMSH_PYTHON to the interpreter that has them")
    program = shutil.which("gmsh")
    return f"The program {program} alone is not enough, its Python module is needed. {words}" if program else words


def _pythons():
    """Those to ask, each once: FreeCAD's own, the system's, the first on PATH."""
    seen = []
    for candidate in (interpreter.python(), SYSTEM_PYTHON, "python3", "python"):
        found = shutil.which(candidate)
        if found and not any(os.path.samefile(found, other) for other in seen):
            seen.append(os.path.abspath(found))
    return seen


def _lacks(python):
    """What a Python cannot import, in words; empty if it has all."""
    try:
        # not in the working folder, which Python before 3.11 would search
        ended = child.run([python, "-c", _ASK], "Python", folder=os.sep, environment=child.python_environment(python), timeout=ASKING)
    except ToolError:
        return "does not start"
    if ended.status == 0:
        return ""
    missing = (ended.output.splitlines() or [""])[0].split()
    if missing and set(missing) <= set(NEEDED):
        return f"has no {' and no '.join(missing)}"
    return f"fails to import them ({ended.last_words(1)})"


def run_job(worker, write_input, job, timeout, progress=None):
    """Mesh in a subprocess; returns the arrays of result.npz as a dict.

    worker       name of the package that is run with -m: gmsh_worker, tetrahedra_worker, smoothing_worker or curving_worker
    write_input  callable(folder) -> path of the file to mesh, in the temporary folder or anywhere
    job          dict of what else the worker wants
    timeout      seconds, for the subprocess alone
    progress     callable(stage, fraction); whatever it raises stops the work and comes out here
    Where gmsh crashes in a step that has an alternative, or does not come to an end in it, the work is done again without
    that step. When the time is over, the best result until then is taken, if there is one, and a note says so.
    Raises ToolError TOOL_MISSING, TOOL_TIMEOUT, TOOL_FAILED (with gmsh's last words), or what the worker found.
    """
    python = gmsh_python(os.environ.get("HEXCON_GMSH_PYTHON") or preferences.value("GmshPython") or None)
    with disk.working_folder("hexcon-gmsh-") as folder:
        with disk.naming(folder, f"work in {folder}"):
            job = dict(job, file=os.path.abspath(write_input(folder)), timeout=timeout, avoid=[])
        job_path = os.path.join(folder, "job.json")
        limit = time.monotonic() + timeout
        while True:
            with disk.naming(folder, f"work in {folder}"), open(job_path, "w", encoding="utf-8") as stream:
                json.dump(job, stream)
            try:
                ended = _run(python, job_path, folder, worker, limit, timeout, progress)
            except ToolError as fault:
                if fault.code is FaultCode.TOOL_TIMEOUT:
                    return _best_so_far(folder, worker, timeout)
                raise
            risk = _crashed_in(folder, ended.status)
            if risk is None or len(job["avoid"]) >= CRASHES:
                with disk.naming(folder, f"work in {folder}"):
                    return _result(folder, ended, worker)
            job["avoid"].append(risk)


def _crashed_in(folder, code):
    """Name of the step in which the subprocess was killed, once; None if it ended by itself."""
    path = os.path.join(folder, "risk.txt")
    if code in (0, 1) or not os.path.exists(path):
        return None
    with open(path, encoding="utf-8", errors="replace") as stream:
        name = stream.read(1000)
    os.remove(path)
    return name


def _run(python, job_path, folder, worker, limit, timeout, progress):
    """Start, watch, and in any case end the subprocess; a child.Ended."""
    environment = child.python_environment(python, [*WORKERS, CORE], PYTHONDONTWRITEBYTECODE="1", OMP_NUM_THREADS="1",
                                           **SAME_MEMORY)
    # without news too, so that it can cancel
    look = progress and (lambda: progress(*answers.read_progress(os.path.join(folder, "progress.txt"))))
    return child.run([python, "-m", worker, job_path], "gmsh", folder=folder, environment=environment,
                     timeout=timeout, limit=limit, look=look, most_files=MOST_FILES)


def _best_so_far(folder, worker, timeout):
    """What the worker has left for when its time is over; raises TOOL_TIMEOUT where that is nothing."""
    path = os.path.join(folder, "best.npz")
    if not os.path.exists(path):
        raise ToolError(f"gmsh did not finish within {timeout:g} seconds; give it more time (timeout; on the command line "
                        "--timeout), or take a larger size", FaultCode.TOOL_TIMEOUT)
    found = answers.read_arrays(path, "gmsh", answers.RESULTS[worker])
    found["notes"] = [*found["notes"], f"gmsh was ended after {timeout:g} seconds (timeout; on the command line --timeout): "
                      "the best until then"]
    return found


def _result(folder, ended, worker):
    fault = os.path.join(folder, "fault.json")
    if os.path.exists(fault):
        raise answers.read_fault(fault, "gmsh")
    result = os.path.join(folder, "result.npz")
    if ended.status != 0 or not os.path.exists(result):
        raise ToolError(f"gmsh {ended.how()}: {ended.last_words()}", FaultCode.TOOL_FAILED)
    return answers.read_arrays(result, "gmsh", answers.RESULTS[worker])
