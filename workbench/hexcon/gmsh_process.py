# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run gmsh in a process of its own: it may crash, hang, or be cancelled without harm to the caller.

The interpreter is $HEXCON_GMSH_PYTHON, or else the one in FreeCAD's preferences for HexCon, or else this one if it has gmsh, numpy and SciPy, or else /usr/bin/python3.
"""
import functools
import importlib.util
import json
import os
import subprocess
import sys
import time

import numpy as np

from hexcon import disk, preferences
from hexcon.errors import FaultCode, ToolError

HERE = os.path.dirname(os.path.abspath(__file__))
WORKERS = [os.path.join(HERE, name) for name in ("quads", "tetrahedra")]     # where the workers' packages are
# HXT's work depends on the order of addresses in memory: with these it is nearly always the same from run to run.
SAME_MEMORY = {"PYTHONHASHSEED": "0", "MALLOC_MMAP_THRESHOLD_": "1000000000", "MALLOC_TOP_PAD_": "268435456"}
POLL = 0.03     # seconds between looks at the subprocess
CRASHES = 30    # so often a job is started again without the step that killed it


@functools.lru_cache(maxsize=None)
def gmsh_python(named=None):
    """Path of a Python that can `import gmsh, numpy, scipy`. named: the value of HEXCON_GMSH_PYTHON, or of
    FreeCAD's preference for HexCon, if set.

    Raises ToolError TOOL_MISSING. The answer is kept for the life of the process.
    """
    if named:
        if _has_gmsh(named):
            return named
        raise ToolError(f"HEXCON_GMSH_PYTHON (or HexCon's preference) is {named}, which cannot import gmsh, numpy and scipy", FaultCode.TOOL_MISSING)
    is_python = os.path.basename(sys.executable or "").lower().startswith("python")
    if is_python and all(importlib.util.find_spec(m) for m in ("gmsh", "numpy", "scipy")):
        return sys.executable
    if _has_gmsh("/usr/bin/python3"):
        return "/usr/bin/python3"
    raise ToolError("no Python with gmsh, numpy and scipy was found: install python3-gmsh and python3-scipy, or set "
                    "HEXCON_GMSH_PYTHON to the interpreter that has them", FaultCode.TOOL_MISSING)


def _has_gmsh(python):
    try:
        return subprocess.run([python, "-c", "import gmsh, numpy, scipy"], stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL, timeout=60, check=False).returncode == 0
    except (OSError, subprocess.TimeoutExpired):
        return False


def run_job(worker, write_input, job, timeout, progress=None):
    """Mesh in a subprocess; returns the arrays of result.npz as a dict.

    worker       name of the package that is run with -m: gmsh_worker or tetrahedra_worker
    write_input  callable(folder) -> path of the file to mesh, in the temporary folder or anywhere
    job          dict of what else the worker wants
    timeout      seconds, for the subprocess alone
    progress     callable(stage, fraction); whatever it raises stops the work and comes out here
    Where gmsh crashes in a step that has an alternative, the work is done again without that step.
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
            code = _run(python, job_path, folder, worker, limit, timeout, progress)
            risk = _crashed_in(folder, code)
            if risk is None or len(job["avoid"]) >= CRASHES:
                with disk.naming(folder, f"work in {folder}"):
                    return _result(folder, code)
            job["avoid"].append(risk)


def _crashed_in(folder, code):
    """Name of the step in which the subprocess was killed, once; None if it ended by itself."""
    path = os.path.join(folder, "risk.txt")
    if code in (0, 1) or not os.path.exists(path):
        return None
    with open(path, encoding="utf-8") as stream:
        name = stream.read()
    os.remove(path)
    return name


def _run(python, job_path, folder, worker, limit, timeout, progress):
    """Start, watch, and in any case end the subprocess; its exit status."""
    env = dict(os.environ, PYTHONPATH=os.pathsep.join(WORKERS), PYTHONDONTWRITEBYTECODE="1",
               OMP_NUM_THREADS="1", **SAME_MEMORY)
    with open(os.path.join(folder, "log.txt"), "wb") as log:
        try:
            process = subprocess.Popen([python, "-m", worker, job_path], stdin=subprocess.DEVNULL, stdout=log,
                                       stderr=subprocess.STDOUT, cwd=folder, env=env)
        except OSError as error:
            raise ToolError(f"cannot start {python}: {error}", FaultCode.TOOL_MISSING) from error
    try:
        return watch(process, "gmsh", limit, timeout, os.path.join(folder, "progress.txt"), progress)
    finally:
        if process.poll() is None:
            process.kill()
        process.wait()


def watch(process, program, limit, timeout, progress_path, progress):
    """Wait for a process, passing progress on, until the monotonic clock shows `limit`; its exit status.

    program        its name, for words
    timeout        seconds that there were
    progress_path  file of lines "stage fraction"; there need be none
    progress       callable (stage, fraction), or None; whatever it raises comes out here
    Raises ToolError TOOL_TIMEOUT; to end the process then is the caller's.
    """
    while True:
        if time.monotonic() > limit:
            raise ToolError(f"{program} did not finish within {timeout:g} seconds", FaultCode.TOOL_TIMEOUT)
        try:
            return process.wait(POLL)
        except subprocess.TimeoutExpired:
            pass
        if progress is not None:
            _pass_on(progress_path, progress)


def _pass_on(path, progress):
    """Call progress with the newest line; without news too, so that it can cancel."""
    try:
        with open(path, encoding="utf-8") as stream:
            lines = stream.read().splitlines()
    except OSError:
        lines = []
    stage, fraction = lines[-1].split() if lines and len(lines[-1].split()) == 2 else ("start", "0")
    progress(stage, float(fraction))


def _result(folder, code):
    fault = os.path.join(folder, "fault.json")
    if os.path.exists(fault):
        with open(fault, encoding="utf-8") as stream:
            found = json.load(stream)
        raise ToolError(found["message"], FaultCode[found["code"]], found["elements"])
    result = os.path.join(folder, "result.npz")
    if code != 0 or not os.path.exists(result):
        raise ToolError(f"gmsh {_how_it_ended(code)}: {last_words(folder)}", FaultCode.TOOL_FAILED)
    with np.load(result) as arrays:
        return dict(arrays)


def _how_it_ended(code):
    return f"was ended by signal {-code}" if code < 0 else f"failed with status {code}"


def last_words(folder, most=12):
    """The error lines of log.txt in a folder, or its end."""
    with open(os.path.join(folder, "log.txt"), encoding="utf-8", errors="replace") as stream:
        lines = [line.rstrip() for line in stream if line.strip()]
    errors = [line for line in lines if line.startswith("Error")] or lines
    return "\n".join(errors[-most:]) or "it said nothing"
